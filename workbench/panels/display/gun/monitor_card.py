"""The knobs of a monitor as a card: what they do to the grid here, and to the pictures of the page Tubes."""

from dataclasses import replace as with_fields

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QBoxLayout,
    QDial,
    QFrame,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms.numerals import with_minus
from workbench.display.gun import Gun
from workbench.display.monitor import Knobs, grid_voltage, level_of
from workbench.document.fields import Number, numbers_of
from workbench.document.state import TubeSettings
from workbench.language import _
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField, complaint_label, lowered

_STEPS = 200
_KNOB_PX = 42


class Knob(QWidget):
    """A dial with its number beside it. ``turned`` sends each value that a person gives."""

    turned = Signal(float)

    def __init__(self, title: str, meaning: str, number: Number, complaint: QLabel) -> None:
        super().__init__()
        self._low, self._high = number.low, number.high
        self._showing = False
        self.dial = QDial()
        self.dial.setRange(0, _STEPS)
        self.dial.setPageStep(_STEPS // 20)
        self.dial.setNotchesVisible(False)
        self.dial.setFixedSize(_KNOB_PX, _KNOB_PX)
        self.dial.setAccessibleName(title)
        self.dial.setToolTip(meaning)
        self.number = NumberField(
            "", low=self._low, high=self._high, step=0.01, meaning=meaning, complaint=complaint
        )
        self.title = QLabel(title)
        self.title.setBuddy(self.number)
        beside = QVBoxLayout()
        beside.setSpacing(0)
        beside.addWidget(self.title)
        beside.addWidget(self.number)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(6)
        row.addWidget(self.dial)
        row.addLayout(beside, 1)
        self.dial.valueChanged.connect(self._turn)
        for signal in (self.number.edited, self.number.scrubbed):
            signal.connect(self._give)

    def set_value(self, value: float) -> None:
        """Show a value, and nothing else."""
        self._showing = True
        self.number.set_value(value)
        self.dial.setValue(round(_STEPS * (value - self._low) / (self._high - self._low)))
        self._showing = False

    def _turn(self, at: int) -> None:
        if not self._showing:
            self._give(round(self._low + at / _STEPS * (self._high - self._low), 3))

    def _give(self, value: float) -> None:
        self.set_value(value)
        self.turned.emit(value)


class MonitorCard(QFrame):
    """``edited`` sends the grid's voltage, which the knobs move while the signal stays."""

    edited = Signal(dict)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self._session = session
        self._gun = Gun()
        self._level = 0.0
        self._driven: tuple[float, Knobs] | None = None
        numbers = numbers_of(TubeSettings)
        self.title = QLabel(_("Monitor"))
        self.title.setProperty("role", "section")
        self.complaint = complaint_label()
        self.brightness = Knob(
            _("Brightness"),
            _(
                "Moves the bias of the grid: turned up, even blanked retraces show; turned down, dim strokes "
                "go"
            ),
            numbers["brightness"],
            self.complaint,
        )
        self.contrast = Knob(
            _("Contrast"),
            _("Scales the video signal: how far white is from black"),
            numbers["contrast"],
            self.complaint,
        )
        self.line = QLabel()
        self.line.setProperty("role", "muted")
        self.line.setToolTip(_("The voltage of the grid, from black to white; at the cut-off it is dark"))
        self.line.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(10, 6, 10, 6)
        whole.setSpacing(2)
        self.knobs = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self.knobs.setSpacing(2)
        self.knobs.addWidget(self.brightness)
        self.knobs.addWidget(self.contrast)
        whole.addWidget(self.title)
        whole.addLayout(self.knobs)
        whole.addWidget(self.complaint)
        whole.addWidget(self.line)
        whole.addStretch(1)
        self.brightness.turned.connect(lambda value: self._turn(brightness=value))
        self.contrast.turned.connect(lambda value: self._turn(contrast=value))

    def lie_down(self, flat: bool) -> None:
        """Let the knobs stand beside one another, without a title."""
        way = QBoxLayout.Direction.LeftToRight if flat else QBoxLayout.Direction.TopToBottom
        self.knobs.setDirection(way)
        self.knobs.setSpacing(16 if flat else 2)
        self.title.setVisible(not flat)

    @property
    def _knobs(self) -> Knobs:
        tube = self._session.state.tube
        return Knobs(tube.brightness, tube.contrast)

    def _turn(self, **changes: float) -> None:
        """Set a knob; the grid follows as it would for the level of the signal that it has.

        The level is kept from turn to turn: at the ends of the grid it could not be told from its voltage.
        """
        gun, before = self._gun, self._knobs
        if (gun.grid, before) != self._driven:
            self._level = level_of(gun.grid, before, gun.cut_off) if before.contrast else 0.0
        self._session.update_state(tube=replace(self._session.state.tube, **changes))
        after = self._knobs
        grid = max(round(grid_voltage(self._level, after, gun.cut_off), 2), -200.0)
        self._driven = grid, after
        self._gun = with_fields(gun, grid=grid)  # the next turn may come before this is shown
        self.edited.emit({"grid": grid})

    def show_gun(self, gun: Gun) -> None:
        """Show where black and white lie for this gun."""
        self._gun, knobs = gun, self._knobs
        self.brightness.set_value(knobs.brightness)
        self.contrast.set_value(knobs.contrast)
        black, white = (grid_voltage(level, knobs, gun.cut_off) for level in (0.0, 1.0))
        words = _("V_g {black:.3g} to {white:.3g} V").format(black=black, white=white)
        self.line.setText(lowered(with_minus(words)))
