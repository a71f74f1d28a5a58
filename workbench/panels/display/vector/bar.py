"""The bar of the page Random scan: which display, its numbers, the order of the strokes, which tube."""

from collections.abc import Mapping

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QLabel,
    QSizePolicy,
    QWidget,
)

from workbench.display import VectorTiming, vector_displays
from workbench.display.setup import phosphor_choices
from workbench.display.storage_tube import STORAGE_PHOSPHOR
from workbench.display.vector_timing import TEACHING, doubts
from workbench.document.subjects import Argument
from workbench.language import _
from workbench.panels.display.controls import phosphor_title
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.subjects.random_scan import ARGUMENTS, display_of, is_ordered, lines_of, runs_a_list
from workbench.session.session import Session
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField, complaint_label
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.tips import tell_choice

# By the name of the argument: label, unit, step, meaning.
_FIELDS: Mapping[str, tuple[str, str, float, str]] = {
    "refresh": (_("Refresh"), "Hz", 5.0, _("Highest refresh rate of the controller")),
    "start": ("t_0", "µs", 0.5, _("What each stroke costs before the beam moves")),
    "pace": ("c", "µs", 0.01, _("Time of a stroke for each unit of its length")),
    "jump_pace": ("c_j", "µs", 0.01, _("Time of a dark jump for each unit of its length")),
    "settle": ("t_s", "µs", 0.5, _("Time that the deflection needs to settle after a jump")),
    "lines": (_("Lines"), "", 10.0, _("How many test lines; 0 draws the picture of the sheet")),
    "length": (_("Length"), "px", 1.0, _("How long each test line is")),
}


class VectorBar(QWidget):
    """Shows and sets what the session's subject is run by."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.display, self.phosphor = ChoiceBox(9), ChoiceBox(9)
        self.ordered = QCheckBox(_("Nearest end first"))
        self.storage = QCheckBox(_("Storage tube"))
        self.complaint = complaint_label()
        self.complaint.setWordWrap(False)  # as wide as it is long, the row flows
        for widget, name, tip in (
            (self.display, _("Display"), _("Whose beam it is: how fast it draws, jumps and settles")),
            (self.phosphor, _("Phosphor"), _("How long a stroke glows after the beam has passed")),
            (
                self.ordered,
                _("Nearest end first"),
                _("Put the strokes in an order that makes the dark jumps short, and see what it saves"),
            ),
            (
                self.storage,
                _("Storage tube"),
                _("A tube that keeps what was written, without any refresh, until all of it is erased"),
            ),
        ):
            widget.setAccessibleName(name)
            widget.setToolTip(tip)
        for box in (self.display, self.phosphor):
            box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            tell_choice(box)
        self.fields = {name: self._field(name, *words) for name, words in _FIELDS.items()}
        self._lay_out()
        self.display.activated.connect(lambda k: self._give(display=self.display.itemData(k)))
        self.phosphor.activated.connect(self._choose_phosphor)
        self.ordered.clicked.connect(lambda on: self._give(ordered=on))
        self.storage.clicked.connect(lambda on: self._give(storage=on))

    def _field(self, name: str, label: str, unit: str, step: float, meaning: str) -> NumberField:
        number = ARGUMENTS[name].number
        assert number is not None
        field = NumberField(
            label, unit, low=number.low, high=number.high, step=step, integer=number.whole, meaning=meaning,
            complaint=self.complaint, digits=6 if name == "jump_pace" else 5,
        )  # fmt: skip
        field.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)

        def change(value: float) -> None:
            self._give(**{name: int(value) if number.whole else value})

        field.edited.connect(change)
        field.scrubbed.connect(change)
        return field

    def _lay_out(self) -> None:
        self.uncertain = QLabel()
        self.uncertain.setProperty("role", "warn")
        self.uncertain.setWordWrap(False)
        self.uncertain.setTextFormat(Qt.TextFormat.PlainText)
        rows = flowing(self, across=10, down=4)
        boxes = self.display, self.uncertain, self.phosphor, self.ordered, self.storage
        for part in (*boxes, *self.fields.values(), self.complaint):
            rows.addWidget(part)

    def _give(self, **given: Argument) -> None:
        session = self._session
        subject = session.state.subject
        if runs_a_list(subject):
            arguments = {**subject.arguments, **given}
            session.update_state(subject=replace(subject, arguments=arguments), step=0)

    def give_lines(self, lines: int) -> None:
        """Draw so many test lines."""
        self._give(lines=lines)

    def _choose_phosphor(self, number: int) -> None:
        session = self._session
        phosphor = self.phosphor.itemData(number)
        session.update_state(tube=replace(session.state.tube, phosphor=phosphor))

    def refresh(self) -> None:
        """Show what is set."""
        subject = self._session.state.subject
        name = display_of(subject)
        displays = [(each, VectorTiming.named(each).name) for each in vector_displays()]
        fill_choices(self.display, displays, name)
        phosphors = [(each, phosphor_title(each)) for each in phosphor_choices()]
        storage = bool(subject.arguments.get("storage", False))
        tube = self._session.state.tube
        fill_choices(self.phosphor, phosphors, STORAGE_PHOSPHOR if storage else tube.phosphor)
        self.phosphor.setEnabled(not storage)
        self.ordered.setChecked(is_ordered(subject))
        self.storage.setChecked(storage)
        timing = VectorTiming.named(name)
        self.uncertain.setText(_("uncertain") if timing.uncertain else "")
        told = [timing.note]
        if timing.uncertain:
            told.insert(0, _("Not confirmed in a source: {names}.").format(names=doubts(timing)))
        self.uncertain.setToolTip(" ".join(told))
        self.uncertain.setVisible(bool(timing.uncertain))
        own = name == TEACHING
        for key, field in self.fields.items():
            value = subject.arguments.get(key, ARGUMENTS[key].usual)
            assert isinstance(value, int | float)
            field.set_value(float(value))
            if key in ("start", "pace", "jump_pace", "settle"):
                field.setVisible(own)
        self.fields["length"].setVisible(bool(lines_of(subject)))
