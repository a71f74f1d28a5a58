"""The colour tube and its mask: the whole face, a close-up, and how well the three beams converge."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from workbench.display.mask import KINDS, Kind, lit_share
from workbench.display.setup import area_mm
from workbench.document.fields import Number
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.panels.display.colour.sliders import Coordinate, NumberSlider
from workbench.rendering.subjects.colour_model import (
    ERROR_MM,
    ERRORS,
    PITCH_MM,
    SLOW,
    WIDTH_MM,
    number,
    setup_of,
)
from workbench.widgets.fields.number_field import NumberField, complaint_label
from workbench.widgets.look.split import Split
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.tube.colour_view import ColourView


def mask_title(kind: Kind) -> str:
    """What a mask is called."""
    return {
        "none": _("No mask"),
        "delta": _("Shadow mask, delta guns"),
        "in_line": _("Shadow mask, in-line guns"),
        "grille": _("Aperture grille"),
    }[kind]


class MaskView(QWidget):
    """``changed`` sends the arguments that a hand asks for."""

    changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.whole, self.magnified = ColourView(magnified=False), ColourView(magnified=True)
        self.kinds = QComboBox()
        self.kinds.setAccessibleName(_("Mask"))
        self.kinds.setToolTip(_("What lies before the screen, so that each beam reaches its grains alone"))
        tell_choice(self.kinds)
        for kind in KINDS:
            self.kinds.addItem(mask_title(kind), kind)
        self.complaint = complaint_label()
        self.pitch = self._field(_("Pitch"), "mm", PITCH_MM, _("From grain to grain of one colour"), 0.01)
        self.across = self._field(_("Close-up"), "mm", WIDTH_MM, _("How much of the face is magnified"), 1.0)
        self.slow = self._field(
            _("Slow motion"),
            "\N{MULTIPLICATION SIGN}",
            SLOW,
            _("How many times slower it runs"),
            1000.0,
        )
        self.errors = {
            name: NumberSlider(
                Coordinate(name[-1], meaning, ERROR_MM.high, "mm", 0.05, ERROR_MM.low), self.complaint
            )
            for name, meaning in zip(
                ERRORS,
                (
                    _("Red beam, to the right"),
                    _("Red beam, upwards"),
                    _("Green beam, to the right"),
                    _("Green beam, upwards"),
                    _("Blue beam, to the right"),
                    _("Blue beam, upwards"),
                ),
                strict=True,
            )
        }
        self.converge = QPushButton(_("Converge"))
        self.converge.setProperty("low", True)
        self.converge.setToolTip(_("Bring all three beams back to one place"))
        self.facts = QLabel()
        self.facts.setWordWrap(True)
        self.facts.setProperty("role", "muted")
        self._lay_out()
        self._connect()

    def _field(self, label: str, unit: str, bounds: Number, meaning: str, step: float) -> NumberField:
        return NumberField(
            label,
            unit,
            low=bounds.low,
            high=bounds.high,
            step=step,
            meaning=meaning,
            complaint=self.complaint,
        )

    def _lay_out(self) -> None:
        head = QHBoxLayout()
        head.setSpacing(12)
        for widget in (self.kinds, self.pitch, self.across):
            head.addWidget(widget)
        head.addStretch(1)
        both = Split(Qt.Orientation.Horizontal)
        both.addWidget(self.whole)
        both.addWidget(self.magnified)
        both.setSizes([1000, 1000])
        beams = QGridLayout()
        beams.setHorizontalSpacing(12)
        beams.setVerticalSpacing(2)
        for column, title in enumerate((_("Red beam"), _("Green beam"), _("Blue beam"))):
            label = QLabel(title)
            label.setProperty("role", "caption")
            beams.addWidget(label, 0, column)
            beams.setColumnStretch(column, 1)
            for row in (0, 1):
                beams.addWidget(self.errors[ERRORS[2 * column + row]], row + 1, column)
        beams.addWidget(self.slow, 1, 3)
        beams.addWidget(self.converge, 2, 3)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(6)
        whole.addLayout(head)
        whole.addWidget(both, 1)
        whole.addWidget(self.facts)
        whole.addLayout(beams)
        whole.addWidget(self.complaint)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)

    def _connect(self) -> None:
        self.kinds.activated.connect(lambda _i: self._send(mask=self.kinds.currentData()))
        for field, name in (
            (self.pitch, "pitch_mm"),
            (self.across, "width_mm"),
            (self.slow, "slow_motion"),
        ):
            for told in (field.edited, field.scrubbed):
                told.connect(lambda value, n=name: self._send(**{n: float(value)}))
        for name, slider in self.errors.items():
            slider.changed.connect(lambda value, n=name: self._send(**{n: float(value)}))
        self.converge.clicked.connect(lambda: self._send(**dict.fromkeys(ERRORS, 0.0)))

    def _send(self, **changes: Argument) -> None:
        self.changed.emit(changes)

    def show_subject(self, subject: Subject, picture_px: tuple[int, int]) -> None:
        """Show how the tube of the subject is set up."""
        setup = setup_of(subject)
        self.kinds.setCurrentIndex(self.kinds.findData(setup.mask))
        self.pitch.set_value(setup.pitch_mm)
        self.pitch.setEnabled(setup.mask != "none")
        self.across.set_value(number(subject, "width_mm"))
        self.slow.set_value(number(subject, "slow_motion"))
        for name, slider in self.errors.items():
            slider.set_value(number(subject, name))
        for view in (self.whole, self.magnified):
            view.set_width(number(subject, "width_mm"))
            view.set_slow_motion(number(subject, "slow_motion"))
        self.facts.setText(facts(subject, picture_px))


def guns_text(kind: Kind) -> str:
    """Where the three beams come from, and where they land."""
    return {
        "none": _(
            "Without a mask each beam would light every grain; here the three lights are simply added."
        ),
        "delta": _("Three guns in a triangle: their beams cross in a hole and land on three dots behind it."),
        "in_line": _("Three guns in a row: their beams cross in a slot and land on three stripes behind it."),
        "grille": _("Three guns in a row: their beams cross between two wires and land on three stripes."),
    }[kind]


def facts(subject: Subject, picture_px: tuple[int, int]) -> str:
    """What the mask means in numbers."""
    setup = setup_of(subject)
    left, _bottom, right, _top = area_mm(picture_px)
    pixel = (right - left) / picture_px[0]
    worst = max((x * x + y * y) ** 0.5 for x, y in setup.errors_mm)
    off = _(" A beam lands up to {mm:.2g} mm beside its place: {px:.2g} pixels of the picture.").format(
        mm=worst, px=worst / pixel
    )
    said = guns_text(setup.mask)
    if setup.mask != "none":
        counts = _(
            "{n:,.0f} triads of {pitch:g} mm across the picture, {each:.3g} to each of its pixels; "
            "{share:.0f} % of the face glows in each colour (uncertain, of the usual order)."
        ).format(
            n=(right - left) / setup.pitch_mm,
            pitch=setup.pitch_mm,
            each=pixel / setup.pitch_mm,
            share=100.0 * lit_share(setup.mask),
        )
        said = f"{said} {counts}"
    return said + (off if worst > 0.0 else "")
