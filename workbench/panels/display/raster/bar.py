"""The strip of the page Raster: mode, what is scanned, depth, time, and what is drawn besides."""

import math

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSlider, QToolButton, QWidget

from workbench.display import RasterTiming, raster_modes
from workbench.display.colour_table import DEPTHS
from workbench.language import _
from workbench.panels.display.raster.buffer_dock import depth_title
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.subjects.raster import SHEET, TYPED, depth_of, typed
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.tips import tell_choice

_PER_DECADE = 20


_FAMILIES = {640: "VGA", 800: "SVGA", 1024: "XGA", 1280: "SXGA"}


def mode_title(name: str) -> str:
    """A mode with its family, its pixels and its rate."""
    timing = RasterTiming.named(name)
    own = {"ntsc": "NTSC", "pal": "PAL", "mda": "IBM 5151"}.get(name.partition("-")[0])
    family = own or _FAMILIES.get(timing.h_active, "")
    said = f"{family} {timing.h_active} \u00d7 {timing.v_active}, {float(timing.refresh_hz):.4g} Hz"
    return _("{mode}, interlaced").format(mode=said) if timing.interlaced else said


class RasterBar(QWidget):
    """Shows and changes what is set; ``actions`` are switches that stand in it too."""

    def __init__(self, setting: RasterSetting, actions: list[QAction]) -> None:
        super().__init__()
        self._setting = setting
        self._showing = False
        self._flow = flowing(self, 10, 6)
        self._labels: list[QLabel] = []
        self._buttons: list[QToolButton] = []
        self.mode = self._box(
            _("Mode"), _("The timing of the beam: a mode that was sold, or numbers of yours")
        )
        self.pixels = self._box(_("Scan"), _("Scan as many pixels as the sheet has, or as the mode has"))
        self.depth_box = self._box(_("Depth"), _("How many bits the frame buffer has for a pixel"))
        self._make_time()
        for action in actions:
            self._button(action)
        give = setting.give
        self.mode.activated.connect(lambda k: self._choose_mode(self.mode.itemData(k)))
        self.pixels.activated.connect(lambda k: give(at_mode=self.pixels.itemData(k)))
        self.depth_box.activated.connect(lambda k: give(depth=self.depth_box.itemData(k), own_table=False))

    def _box(self, name: str, tip: str) -> QComboBox:
        box = QComboBox()
        box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        box.setAccessibleName(name)
        box.setToolTip(tip)
        tell_choice(box)
        label = QLabel(name)
        label.setProperty("role", "muted")
        label.setBuddy(box)
        self._labels.append(label)
        group = QWidget()
        row = QHBoxLayout(group)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(6)
        row.addWidget(label)
        row.addWidget(box)
        self._flow.addWidget(group)
        return box

    def _button(self, action: QAction) -> None:
        button = ActionButton(action, style=Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._buttons.append(button)
        self._flow.addWidget(button)

    def _make_time(self) -> None:
        group = QWidget()
        row = QHBoxLayout(group)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(6)
        label = QLabel(_("Slow motion"))
        label.setProperty("role", "muted")
        self.slow = QSlider(Qt.Orientation.Horizontal)
        self.slow.setRange(0, 6 * _PER_DECADE)
        self.slow.setPageStep(_PER_DECADE)
        self.slow.setMinimumWidth(90)
        self.slow.setAccessibleName(_("Slow motion"))
        self.slow.setToolTip(_("How many times slower the tube runs, from 1 to 1,000,000"))
        label.setBuddy(self.slow)
        self._labels.append(label)
        self.factor = QLabel()
        self.factor.setMinimumWidth(self.fontMetrics().horizontalAdvance("1 : 1,000,000"))
        for widget in (label, self.slow, self.factor):
            row.addWidget(widget)
        self.slow.valueChanged.connect(lambda value: self._set(slow_motion=10.0 ** (value / _PER_DECADE)))
        self._flow.addWidget(group)

    def be_compact(self, on: bool) -> None:
        """Do without the names of what has a tooltip, where there is little room."""
        styles = Qt.ToolButtonStyle
        for label in self._labels:
            label.setVisible(not on)
        for button in self._buttons:
            button.setToolButtonStyle(styles.ToolButtonIconOnly if on else styles.ToolButtonTextBesideIcon)

    def _set(self, **changes: object) -> None:
        if not self._showing:
            session = self._setting.session
            session.update_state(tube=replace(session.state.tube, **changes))

    def _choose_mode(self, mode: str) -> None:
        """A named mode, or its numbers to be typed."""
        self._setting.give(**(typed(self._setting.mode) if mode == TYPED else {"mode": mode}))

    def refresh(self) -> None:
        """Show what is set now."""
        self._showing = True
        setting = self._setting
        tube, sheet = setting.session.state.tube, setting.session.sheet
        modes = [(SHEET, _("as VGA, for the sheet"))]
        modes += [(name, mode_title(name)) for name in raster_modes()]
        modes.append((TYPED, _("Typed numbers")))
        fill_choices(self.mode, modes, setting.value("mode"))
        mode = setting.mode
        pixels = [(False, _("the sheet's {w} \u00d7 {h}").format(w=sheet.width_px, h=sheet.height_px))]
        if setting.value("mode") != SHEET:
            pixels.append((True, _("the mode's {w} \u00d7 {h}").format(w=mode.h_active, h=mode.v_active)))
        fill_choices(self.pixels, pixels, bool(setting.value("at_mode")))
        fill_choices(self.depth_box, [(d, depth_title(d)) for d in DEPTHS], depth_of(setting.subject))
        self.slow.setValue(round(_PER_DECADE * math.log10(max(tube.slow_motion, 1.0))))
        real = tube.slow_motion == 1.0
        self.factor.setText(_("real time") if real else f"1 : {tube.slow_motion:,.0f}")
        self._showing = False
