"""The dock of a mode's numbers: clock, picture, porches and sync, read or typed, and which are uncertain."""

from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QLabel, QScrollArea, QVBoxLayout, QWidget

from workbench.display.flicker import modulation
from workbench.display.setup import phosphor_choices
from workbench.display.timings import COUNTS
from workbench.language import _
from workbench.panels.display.controls import phosphor_title
from workbench.panels.display.raster.setting import RasterSetting
from workbench.panels.shared.tube_feed import setup_of
from workbench.panels.stage.card import number_field
from workbench.rendering.subjects.raster import NUMBERS, SHEET, typed
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.tube.timing_diagram import kind_title


def _field_title(name: str) -> str:
    """A field of the table of modes as a person calls it."""
    ways = {"h": _("horizontal {part}"), "v": _("vertical {part}")}
    way, _mark, kind = name.partition("_")
    titles = {"pixel_clock_hz": _("pixel clock"), "polarities": _("polarities of the sync pulses")}
    return titles.get(name) or ways[way].format(part=kind_title(kind))


class ModeDock(QScrollArea):
    """Changing any number makes the mode a typed one."""

    def __init__(self, setting: RasterSetting, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.phosphor = ChoiceBox(10)
        for name in phosphor_choices():
            self.phosphor.addItem(phosphor_title(name), name)
        self.phosphor.setAccessibleName(_("Phosphor"))
        self.phosphor.setToolTip(_("What the screen is coated with, and the time in which it decays to 10 %"))
        tell_choice(self.phosphor)
        self.phosphor.activated.connect(self._choose_phosphor)
        self.fields: dict[str, NumberField] = {}
        grid = QWidget()
        side_by_side, columns = flowing(grid, 12, 4), list[QVBoxLayout]()
        for title in (_("Line, in clocks"), _("Frame, in lines")):
            part, head = QWidget(), QLabel(title)
            head.setProperty("role", "muted")
            columns.append(QVBoxLayout(part))
            columns[-1].setContentsMargins(0, 0, 0, 0)
            columns[-1].setSpacing(4)
            columns[-1].addWidget(head)
            side_by_side.addWidget(part)
        for place, name in enumerate(("clock_mhz", "refresh_hz", *COUNTS)):
            number = NUMBERS[name]
            field = self.fields[name] = number_field(number, number.label.capitalize())
            give = partial(self._give, name)
            field.edited.connect(give)
            field.scrubbed.connect(give)
            across = name == "clock_mhz" or name.startswith("h_")
            columns[0 if across else 1].insertWidget(0 if place < 2 else -1, field)
        self.totals = QLabel()
        self.interlaced = QCheckBox(_("Interlaced: two fields"))
        self.interlaced.setToolTip(_("Scan every second line in one field, and the others in the next"))
        self.interlaced.setAccessibleName(self.interlaced.text())
        self.interlaced.clicked.connect(lambda on: self._give("interlaced", on))
        self.note = QLabel()
        self.twitter = QLabel()
        self.fault = QLabel()
        self.fault.setProperty("role", "error")
        self.note.setProperty("role", "muted")
        body = QWidget()
        column_layout = QVBoxLayout(body)
        column_layout.setContentsMargins(10, 8, 10, 8)
        column_layout.setSpacing(8)
        column_layout.addWidget(self.phosphor)
        column_layout.addWidget(grid)
        column_layout.addWidget(self.interlaced)
        for label in (self.totals, self.fault, self.twitter, self.note):
            label.setWordWrap(True)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            column_layout.addWidget(label)
        column_layout.addStretch(1)
        self.setWidget(body)
        self.in_sight = InSight(self)
        self.in_sight.follow(self.refresh)

    def _choose_phosphor(self, number: int) -> None:
        session = self._setting.session
        tube = replace(session.state.tube, phosphor=self.phosphor.itemData(number))
        session.update_state(tube=tube)

    def _give(self, name: str, value: float) -> None:
        """Change one number of the mode, whose others stay as they are."""
        if name == "refresh_hz" and self._setting.value("mode") == SHEET:
            self._setting.give(refresh_hz=float(value))
            return
        changes = typed(self._setting.mode)
        if name == "refresh_hz":
            mode = self._setting.mode
            changes["clock_mhz"] = float(value) * mode.clocks_per_frame / 1e6
        elif name == "interlaced":
            changes[name] = bool(value)
        else:
            changes[name] = int(value) if NUMBERS[name].whole else float(value)
        self._setting.give(**changes)

    def refresh(self) -> None:
        """Show the numbers of the mode that is set now; unseen, when it is seen."""
        if not self.in_sight.now:
            return
        mode = self._setting.mode
        phosphor = self._setting.session.state.tube.phosphor
        self.phosphor.setCurrentIndex(max(self.phosphor.findData(phosphor), 0))
        for name in COUNTS:
            self.fields[name].set_value(float(getattr(mode, name)))
        self.fields["clock_mhz"].set_value(round(float(mode.pixel_clock_hz) / 1e6, 9))
        self.interlaced.setChecked(mode.interlaced)
        fault = mode.fault
        self.fault.setText(fault)
        self.fault.setVisible(bool(fault))
        self.totals.setVisible(not fault)
        self.twitter.setVisible(not fault and mode.interlaced)
        if not fault:
            self.fields["refresh_hz"].set_value(round(float(mode.refresh_hz), 6))
            self.totals.setText(self._totals())
            self.twitter.setText(self._twitter())
        self.note.setText(self._uncertain())
        self.note.setVisible(bool(self.note.text()))

    def _totals(self) -> str:
        mode = self._setting.mode
        said = _("Totals: {across} clocks a line, {down} lines a frame.").format(
            across=mode.h_total, down=mode.v_total
        )
        if mode.interlaced:
            said += " " + _("A field has {lines:g} lines; the half line lets the fields interleave.").format(
                lines=float(mode.lines_per_field)
            )
        return said

    def _twitter(self) -> str:
        """How much a line one pixel high flickers, and an area."""
        mode = self._setting.mode
        gun = setup_of(self._setting.session.state.tube).guns()[0]
        frame = float(mode.frame_s)
        return _(
            "A line one pixel high is refreshed {line:.4g} times a second (modulation {one:.2f}), an area of "
            "both fields {area:.4g} times ({two:.2f}): so lines twitter while areas look steady. Switch Calm "
            "off on the page Tubes to see it."
        ).format(line=1 / frame, one=modulation(gun, frame), area=2 / frame, two=modulation(gun, frame / 2))

    def _uncertain(self) -> str:
        mode = self._setting.mode
        if not mode.uncertain_fields:
            return mode.note if self._setting.value("mode") != SHEET else ""
        fields = ", ".join(_field_title(name) for name in mode.uncertain_fields)
        return _("Uncertain: {fields}. {note}").format(fields=fields, note=mode.note)
