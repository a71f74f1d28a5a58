"""The cards below the drawing: the beam's voltages, both ways of deflecting it, the knobs of a monitor."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QComboBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from workbench.display.gun import OFF, SAWTOOTH, SINE, Gun
from workbench.language import _
from workbench.panels.display.gun.arithmetic import current_line, deflection_law, deflection_line, focus_line
from workbench.panels.display.gun.monitor_card import MonitorCard
from workbench.rendering.subjects.gun import NUMBERS
from workbench.widgets.fields.slider_field import SliderField

_NARROW_PX = 700
_LINES = 2
_SHARES = (23, 18, 18, 13)
"""How wide the cards are beside one another: as wide as their arithmetic."""
_CARDS = {2: 0, 3: 0, 4: 0, 5: 1}
"""Which card each step of the run is about."""
_SPANS = {
    "grid": (-80.0, 0.0),
    "volts": (-700.0, 700.0),
    "field": (-3.0, 3.0),
    "peak": (0.0, 700.0),
    "peak_field": (0.0, 3.0),
    "phase": (-180.0, 180.0),
}
_LOGARITHMIC = ("focus", "anode", "rate")
_STEPS = {"field": 0.01, "peak_field": 0.01}


def wave_titles() -> tuple[tuple[str, str], ...]:
    """Each input, and what it is called."""
    return (OFF, _("held")), (SINE, _("sine")), (SAWTOOTH, _("sawtooth"))


class GunCard(QFrame):
    """``title`` over sliders and one line of arithmetic. ``edited`` sends settings by name."""

    edited = Signal(dict)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self.title = QLabel(title)
        self.title.setProperty("role", "section")
        self.line = QLabel()
        self.line.setTextFormat(Qt.TextFormat.RichText)
        self.line.setWordWrap(True)
        self.line.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.line.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.line.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.head = QHBoxLayout()
        self.head.addWidget(self.title, 1)
        self.rows = QVBoxLayout()
        self.rows.setSpacing(2)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(10, 6, 10, 6)
        whole.setSpacing(4)
        whole.addLayout(self.head)
        whole.addLayout(self.rows)
        whole.addWidget(self.line)
        whole.addStretch(1)

    def lie_down(self, flat: bool) -> None:
        """Let the sliders stand beside one another, over a line of arithmetic and without a title."""
        way = QBoxLayout.Direction.LeftToRight if flat else QBoxLayout.Direction.TopToBottom
        self.rows.setDirection(way)
        self.rows.setSpacing(12 if flat else 2)
        self.title.setVisible(not flat)
        self.line.setFixedHeight((1 if flat else _LINES) * self.fontMetrics().lineSpacing() + 2)

    def slider(self, name: str, label: str = "") -> SliderField:
        """A slider for the setting of this name, below those before."""
        number = NUMBERS[name]
        short = name.partition("_")[2] if name[:2] in ("x_", "y_") else name
        field = SliderField(
            label or number.symbol,
            number.unit,
            number.label[:1].upper() + number.label[1:],
            number.low,
            number.high,
            span=_SPANS.get(short),
            step=_STEPS.get(short, 1.0),
            logarithmic=short in _LOGARITHMIC,
        )
        field.edited.connect(lambda value: self.edited.emit({name: value}))
        self.rows.addWidget(field)
        return field


class BeamCard(GunCard):
    """Grid, focus and anode."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Beam"), parent)
        self.focus = QLabel()
        self.focus.setProperty("role", "muted")
        self.focus.setWordWrap(True)
        self.focus.setToolTip(_("The lens is a model for teaching: its focal length grows with V_f / V_a"))
        self.head.addWidget(self.focus)
        self._flat = False
        self.fields = {name: self.slider(name) for name in ("grid", "focus", "anode")}

    def lie_down(self, flat: bool) -> None:
        """Flat, focus is told behind the current."""
        super().lie_down(flat)
        self._flat = flat
        self.focus.setVisible(not flat)

    def show_gun(self, gun: Gun) -> None:
        """Show what the tube is set to."""
        for name, field in self.fields.items():
            field.set_value(getattr(gun, name))
        self.focus.setText(focus_line(gun))
        current = current_line(gun)
        self.line.setText(f"{current};&nbsp; {focus_line(gun)}" if self._flat else current)


class DeflectionCard(GunCard):
    """One way of deflecting, ``way`` "x" or "y": held at a voltage, or driven by an input.

    Held, there is room for the law in letters, and for where the plates catch the beam.
    """

    def __init__(self, way: str, parent: QWidget | None = None) -> None:
        super().__init__("", parent)
        self.way = way
        self.wave = QComboBox()
        for name, title in wave_titles():
            self.wave.addItem(title, name)
        self.wave.setAccessibleName(_("Input across") if way == "x" else _("Input upwards"))
        self.wave.setToolTip(
            _("Hold the beam with a voltage, or let an input swing it like an oscilloscope's")
        )
        self.wave.activated.connect(lambda _row: self.edited.emit({f"{way}_wave": self.wave.currentData()}))
        self.head.addWidget(self.wave)
        short = {"volts": f"V_{way}", "field": f"B_{way}", "peak": _("Peak"), "peak_field": _("Peak")}
        short |= {"rate": _("Rate"), "phase": _("Phase")}
        self.fields = {name: self.slider(f"{way}_{name}", label) for name, label in short.items()}
        self.law, self.limit = QLabel(), QLabel()
        self.law.setTextFormat(Qt.TextFormat.RichText)
        self.limit.setProperty("role", "muted")
        for label in (self.law, self.limit):
            label.setWordWrap(True)
            label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        whole = self.layout()
        assert isinstance(whole, QVBoxLayout)
        whole.insertWidget(whole.indexOf(self.line), self.law)
        whole.insertWidget(whole.indexOf(self.line) + 1, self.limit)
        self._flat = False

    def lie_down(self, flat: bool) -> None:
        """Flat, the input is chosen beside its sliders."""
        super().lie_down(flat)
        self._flat = flat
        for name in ("peak", "peak_field", "rate", "phase"):
            self.fields[name].be_tight(flat)
        if flat:
            self.rows.insertWidget(0, self.wave)
        else:
            self.head.addWidget(self.wave)

    def show_gun(self, gun: Gun, seconds: float | None = None) -> None:
        """Show what the tube is set to, and where the beam is at a time."""
        way = getattr(gun, self.way)
        up = self.way == "y"
        if gun.coils:
            self.title.setText(_("Upwards") if up else _("Across"))
        else:
            self.title.setText(_("Vertical") if up else _("Horizontal"))
        self.wave.setCurrentIndex(max(self.wave.findData(way.wave), 0))
        swings = way.wave != OFF
        seen = {
            "volts": not swings and not gun.coils,
            "field": not swings and gun.coils,
            "peak": swings and not gun.coils,
            "peak_field": swings and gun.coils,
            "rate": swings,
            "phase": swings,
        }
        for name, field in self.fields.items():
            field.setVisible(seen[name])
            field.set_value(getattr(way, name))
        roomy = not swings and not self._flat
        self.law.setVisible(roomy)
        self.limit.setVisible(roomy and not gun.coils)
        self.law.setText(deflection_law(gun, self.way))
        self.limit.setText(_("caught beyond {volts:.4g} V").format(volts=gun.limit))
        self.line.setText(deflection_line(gun, self.way, seconds))


class GunCards(QWidget):
    """All cards beside one another below the ``time``, or where that is too narrow one at a time.

    ``edited`` sends settings.
    """

    edited = Signal(dict)

    def __init__(self, monitor: MonitorCard, time: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.beam, self.up, self.across = BeamCard(), DeflectionCard("y"), DeflectionCard("x")
        self.monitor, self.time = monitor, time
        self._cards = (self.beam, self.up, self.across, monitor)
        self._gun = Gun()
        self._seconds: float | None = None
        self._narrow: bool | None = None
        self._swings = False
        self.buttons = QButtonGroup(self)
        self._switch = QWidget()
        switch = QHBoxLayout(self._switch)
        switch.setContentsMargins(0, 0, 0, 0)
        switch.setSpacing(0)
        titles = (_("Beam"), _("Vertical"), _("Horizontal"), _("Monitor"), _("Time"))
        for number, title in enumerate(titles):
            button = QPushButton(title)
            button.setCheckable(True)
            button.setProperty("flat", True)
            button.setToolTip(_("Show this card"))
            self.buttons.addButton(button, number)
            switch.addWidget(button)
        switch.addStretch(1)
        self.buttons.button(0).setChecked(True)
        self.buttons.idClicked.connect(lambda _number: self._arrange())
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(4)
        self._grid.addWidget(self._switch, 0, 0, 1, len(self._cards))
        for column in range(len(self._cards)):
            self._grid.setColumnStretch(column, _SHARES[column])
        # Not fixed, which would hold it as low as it is where all text has one line
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        for card in (self.beam, self.up, self.across):
            card.edited.connect(self.edited)
        self._lay_out(False)  # with the usual tube, so that they ask for no more room than it needs

    def show_gun(self, gun: Gun, seconds: float | None = None) -> None:
        """Show what the tube is set to, and where its beam is at a time."""
        self._gun, self._seconds = gun, seconds
        self.beam.show_gun(gun)
        self.up.show_gun(gun, seconds)
        self.across.show_gun(gun, seconds)
        if gun.swings != self._swings:
            self._swings = gun.swings
            self._arrange()

    def light(self, step: int) -> None:
        """Mark the cards that a step of the run is about; where there is room for one, it is that."""
        for card, lit in ((self.beam, 2 <= step <= 4), (self.up, step == 5), (self.across, step == 5)):
            if card.title.property("here") != lit:
                card.title.setProperty("here", lit)
                card.title.style().polish(card.title)
        if step in _CARDS:
            self.buttons.button(_CARDS[step]).setChecked(True)
            self._arrange()

    def _lay_out(self, narrow: bool) -> None:
        """Cards in a row, or each over the whole width with its sliders beside one another."""
        if narrow == self._narrow:
            return
        self._narrow = narrow
        whole = len(self._cards)
        for column, card in enumerate(self._cards):
            self._grid.addWidget(card, 2, 0 if narrow else column, 1, whole if narrow else 1)
        self._grid.addWidget(self.time, 2 if narrow else 1, 0, 1, whole)
        for each in (self.beam, self.up, self.across, self.monitor):
            each.lie_down(narrow)
        self.show_gun(self._gun, self._seconds)
        self._arrange()

    def _arrange(self) -> None:
        chosen = self.buttons.checkedId()
        if chosen == len(self._cards) and not self._swings:
            self.buttons.button(0).setChecked(True)
            chosen = 0
        self._switch.setVisible(bool(self._narrow))
        self.buttons.button(len(self._cards)).setVisible(self._swings)
        for number, card in enumerate(self._cards):
            card.setVisible(not self._narrow or number == chosen)
        self.time.setVisible(self._swings and (not self._narrow or chosen == len(self._cards)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """One card at a time where there is room for no more."""
        super().resizeEvent(event)
        self._lay_out(event.size().width() < _NARROW_PX)
