"""The bar of the page Raster or random: the display, the hatching, and where the magnifying glass is."""

from collections.abc import Mapping

from msgspec.structs import replace
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.display import VectorTiming, vector_displays
from workbench.document.subjects import Argument
from workbench.language import _
from workbench.panels.stage.folding_card import fill_choices
from workbench.rendering.subjects.comparison import ARGUMENTS, LENS, compares_displays, lens_of, number_of
from workbench.rendering.subjects.random_scan import display_of
from workbench.session.session import Session
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField, complaint_label
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.tips import tell_choice

# By the name of the argument: label, unit, step, meaning.
_FIELDS: Mapping[str, tuple[str, str, float, str]] = {
    "refresh": (_("Refresh"), "Hz", 5.0, _("Refresh rate of the raster, and the highest of the vector tube")),
    "hatch": (_("Hatch"), "px", 1.0, _("Rows from one hatch of an area to the next; 0 draws outlines only")),
    "x": ("x", "px", 1.0, _("Column under the magnifying glass")),
    "y": ("y", "px", 1.0, _("Row under the magnifying glass, counted from below")),
    "power": (_("Power"), "×", 1.0, _("How many times larger the glass shows it")),
}


class ComparisonBar(QWidget):
    """Shows and sets what the session's subject is compared by."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.display = ChoiceBox(13)
        self.display.setAccessibleName(_("Display"))
        self.display.setToolTip(_("Whose beam draws the strokes: how fast it draws, jumps and settles"))
        tell_choice(self.display)
        self.complaint = complaint_label()
        self.complaint.setWordWrap(False)  # as wide as it is long, the row flows
        self.fields = {name: self._field(name, *words) for name, words in _FIELDS.items()}
        row = flowing(self, across=10, down=2)
        for part in (self.display, *self.fields.values(), self.complaint):
            row.addWidget(part)
        self.display.activated.connect(lambda k: self.give(display=self.display.itemData(k)))

    def _field(self, name: str, label: str, unit: str, step: float, meaning: str) -> NumberField:
        number = ARGUMENTS[name].number
        assert number is not None
        field = NumberField(
            label, unit, low=max(number.low, 0.0), high=number.high, step=step, integer=number.whole,
            meaning=meaning, complaint=self.complaint,
        )  # fmt: skip
        field.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)

        def change(value: float) -> None:
            self.give(**{name: int(value) if number.whole else value})

        field.edited.connect(change)
        field.scrubbed.connect(change)
        return field

    def give(self, **given: Argument) -> None:
        """Give the subject these arguments; the place of the glass leaves the run where it is."""
        session = self._session
        subject = session.state.subject
        if not compares_displays(subject):
            return
        changed = replace(subject, arguments={**subject.arguments, **given})
        if given.keys() <= LENS:
            session.update_state(subject=changed)
        else:
            session.update_state(subject=changed, step=0)

    def refresh(self) -> None:
        """Show what is set."""
        sheet, subject = self._session.frames.seen, self._session.state.subject
        displays = [(each, VectorTiming.named(each).name) for each in vector_displays()]
        fill_choices(self.display, displays, display_of(subject))
        lens = dict(zip("xy", lens_of(sheet, subject), strict=True))
        for name, field in self.fields.items():
            field.set_value(lens.get(name, number_of(subject, name)))
