"""The controls of the tubes: what is shown, phosphor, refresh, persistence, slow motion, time."""

import math
import re
from fractions import Fraction

from msgspec.structs import replace
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QSlider,
    QToolButton,
    QWidget,
)

from workbench.display import VectorTiming, vector_displays
from workbench.display.phosphor import Phosphor
from workbench.display.setup import COLOUR_TUBE, phosphor_choices
from workbench.language import _
from workbench.session.session import Session
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.flash_warning import CalmSwitch
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.icons import icon
from workbench.widgets.look.spans import span_text
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.tokens import theme

_PER_DECADE = 20
_PHOSPHOR_LETTERS, _DISPLAY_LETTERS = 21, 16
_FACTOR_PX = 150


def phosphor_title(name: str) -> str:
    """A phosphor with its colour and how long it glows, for a list."""
    if name == COLOUR_TUBE:
        return _("P22  red, green, blue")
    phosphor = Phosphor.named(name)
    return f"{name}  {re.split(', | / ', phosphor.colour_name)[0]}, {span_text(phosphor.t10_s)}"


class DisplayControls(QWidget):
    """Reads and changes the tube settings of a session. ``stepped`` asks for a step: "line" or "pixel"."""

    stepped = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._showing = False
        self._buttons: list[tuple[QToolButton, str]] = []
        flow = flowing(self)
        rows = []
        for _group in range(8):
            group = QWidget()
            group.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Preferred)
            row = QHBoxLayout(group)
            row.setContentsMargins(0, 0, 0, 0)
            row.setSpacing(8)
            rows.append(row)
            flow.addWidget(group)
        first, screens, clock, time, meter, displays, numbers, knobs = rows
        self._make_views(first)
        self.phosphor = self._combo(
            screens,
            _("Phosphor"),
            _("What the screen is coated with, and the time in which it decays to 10 %"),
            _PHOSPHOR_LETTERS,
        )
        for name in phosphor_choices():
            self.phosphor.addItem(phosphor_title(name), name)
        self.vector = self._combo(
            displays,
            _("Vector display"),
            _("Whose deflection speeds the vector tube has"),
            _DISPLAY_LETTERS,
        )
        for name in vector_displays():
            self.vector.addItem(VectorTiming.named(name).name, name)
        self.refresh = NumberField(
            _("Refresh"), "Hz", low=1.0, high=240.0, step=1.0, meaning=_("Pictures per second")
        )
        self.persistence = NumberField(
            _("Persistence"),
            "\N{MULTIPLICATION SIGN}",
            low=0.1,
            high=20.0,
            step=0.1,
            meaning=_("How many times longer the phosphor glows than it does in life"),
        )
        self.brightness = NumberField(
            _("Brightness"),
            low=-0.5,
            high=0.5,
            step=0.01,
            meaning=_("The bias of the grid: turned up, retraces show; turned down, dim strokes vanish"),
        )
        self.contrast = NumberField(
            _("Contrast"),
            low=0.0,
            high=2.0,
            step=0.05,
            meaning=_("How far the signal takes white from black"),
        )
        numbers.addWidget(self.refresh)
        numbers.addWidget(self.persistence)
        knobs.addWidget(self.brightness)
        knobs.addWidget(self.contrast)
        self._make_steps(clock)
        self._make_time(time)
        self._make_meter(meter)
        self.phosphor.activated.connect(lambda _i: self._set(phosphor=self.phosphor.currentData()))
        self.vector.activated.connect(lambda _i: self._set(vector_display=self.vector.currentData()))
        for field, name in (
            (self.refresh, "refresh_hz"),
            (self.persistence, "persistence"),
            (self.brightness, "brightness"),
            (self.contrast, "contrast"),
        ):
            field.edited.connect(lambda value, n=name: self._set(**{n: value}))
            field.scrubbed.connect(lambda value, n=name: self._set(**{n: value}))
        session.state_changed.connect(self.show_state)
        theme.changed.connect(self._colour_icons)
        self._colour_icons()
        self.show_state()

    def _combo(self, row: QHBoxLayout, name: str, meaning: str, letters: int) -> QComboBox:
        label = QLabel(name)
        label.setProperty("role", "muted")
        box = ChoiceBox(letters)
        box.setToolTip(meaning)
        tell_choice(box)
        box.setAccessibleName(name)
        label.setBuddy(box)
        row.addWidget(label)
        row.addWidget(box)
        return box

    def _button(self, row: QHBoxLayout, name: str, title: str, hint: str) -> QToolButton:
        button = QToolButton()
        button.setText(title)
        button.setToolTip(hint)
        button.setAccessibleName(title)
        button.setIconSize(QSize(16, 16))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._buttons.append((button, name))
        row.addWidget(button)
        return button

    def _make_views(self, row: QHBoxLayout) -> None:
        self.views = QButtonGroup(self)
        self._shown = ("both", "raster", "vector")
        choices = (
            (_("Both"), "columns", _("Raster and vector tube side by side")),
            (_("Raster"), "rows", _("The raster tube alone")),
            (_("Vector"), "path", _("The vector tube alone")),
        )
        for number, (title, picture, hint) in enumerate(choices):
            button = self._button(row, picture, title, hint)
            button.setCheckable(True)
            self.views.addButton(button, number)
        self.views.idClicked.connect(lambda number: self._set(shown=self._shown[number]))
        self.instruments = self._button(
            row, "chart-line", _("Instruments"), _("Show beam current, deflection and light below the tubes")
        )
        self.instruments.setCheckable(True)
        self.instruments.hide()
        row.addSpacing(8)

    def _make_steps(self, row: QHBoxLayout) -> None:
        self.pause = self._button(row, "pause", _("Pause"), _("Hold the tube's time (or let it run on)"))
        self.pause.setCheckable(True)
        self.pause.clicked.connect(lambda on: self._set(paused=on))
        self.line = self._button(
            row, "arrow-line-down", _("Line"), _("Pause and let the beam scan to the start of the next line")
        )
        self.pixel = self._button(
            row, "arrow-line-right", _("Pixel"), _("Pause and let the beam go on by one pixel clock")
        )
        self.line.clicked.connect(lambda: self._step("line"))
        self.pixel.clicked.connect(lambda: self._step("pixel"))

    def _make_time(self, row: QHBoxLayout) -> None:
        label = QLabel(_("Slow motion"))
        label.setProperty("role", "muted")
        row.addWidget(label)
        self.slow = QSlider(Qt.Orientation.Horizontal)
        self.slow.setRange(0, 6 * _PER_DECADE)
        self.slow.setPageStep(_PER_DECADE)
        self.slow.setTickInterval(_PER_DECADE)
        self.slow.setTickPosition(QSlider.TickPosition.TicksBelow)
        self.slow.setMinimumWidth(120)
        self.slow.setAccessibleName(_("Slow motion"))
        self.slow.setToolTip(
            _("How many times slower the tube runs, from 1 to 1,000,000; one mark is a factor of 10")
        )
        label.setBuddy(self.slow)
        self.slow.valueChanged.connect(self._slow_moved)
        row.addWidget(self.slow, 1)
        self.factor = QLabel()
        self.factor.setMinimumWidth(_FACTOR_PX)  # the slider keeps its length while it is dragged
        self.factor.setToolTip(_("How many times slower the tube runs, and how long a picture takes then"))
        row.addWidget(self.factor)

    def _make_meter(self, row: QHBoxLayout) -> None:
        self.flicker = QLabel()
        self.flicker.setProperty("role", "muted")
        self.flicker.setToolTip(
            _(
                "Predicted for an eye at 100 cd/m\N{SUPERSCRIPT TWO}: flicker is seen below the fusion "
                "frequency, which rises with brightness and with the modulation of the light"
            )
        )
        row.addWidget(self.flicker)
        self.calm = CalmSwitch()
        row.addWidget(self.calm)

    def _colour_icons(self) -> None:
        for button, name in self._buttons:
            button.setIcon(icon(name))

    def _set(self, **changes: object) -> None:
        if not self._showing:
            self._session.update_state(tube=replace(self._session.state.tube, **changes))

    def _slow_moved(self, value: int) -> None:
        self._set(slow_motion=10.0 ** (value / _PER_DECADE))

    def _step(self, what: str) -> None:
        self._set(paused=True)
        self.stepped.emit(what)

    def show_state(self) -> None:
        """Show the settings that the session has now."""
        now = self._session.state.tube
        self._showing = True
        self.views.button(self._shown.index(now.shown)).setChecked(True)
        self.phosphor.setCurrentIndex(max(self.phosphor.findData(now.phosphor), 0))
        self.vector.setCurrentIndex(max(self.vector.findData(now.vector_display), 0))
        self.vector.setEnabled(now.shown != "raster")
        self.refresh.set_value(now.refresh_hz)
        self.persistence.set_value(now.persistence)
        self.brightness.set_value(now.brightness)
        self.contrast.set_value(now.contrast)
        self.slow.setValue(round(_PER_DECADE * math.log10(max(now.slow_motion, 1.0))))
        self.pause.setChecked(now.paused)
        one = Fraction(1) / Fraction(str(now.refresh_hz)) * Fraction(now.slow_motion)
        if now.slow_motion == 1.0:
            self.factor.setText(_("real time"))
        else:
            self.factor.setText(
                _("1 : {factor:,.0f} ({time})").format(factor=now.slow_motion, time=span_text(float(one)))
            )
        self._showing = False

    def show_flicker(self, words: str) -> None:
        """Say what the flicker meter predicts."""
        self.flicker.setText(words)
