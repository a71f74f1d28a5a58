"""The numbers of the page Flicker: phosphor, refresh, persistence, luminance, and what moves."""

from collections.abc import Mapping

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QSizePolicy, QToolButton, QWidget

from workbench.display.phosphor import names
from workbench.document.fields import Number
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.panels.display.controls import phosphor_title
from workbench.panels.display.flicker.figures import moving
from workbench.rendering.subjects.flicker import (
    BAR,
    LUMINANCE,
    PERIODS,
    PERSISTENCE,
    REFRESH_HZ,
    SPEED,
    SPOT,
    STEPS,
    STILL,
    given,
    number,
    phosphor_of,
)
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField, complaint_label
from workbench.widgets.look.flash_warning import CalmSwitch
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tips import tell_choice


class FlickerControls(QWidget):
    """``changed`` sends the arguments that a hand asks for.

    ``steps`` and ``periods`` are for another place: where the numbers are that they bear on.
    """

    changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = flowing(self, across=8, down=4)
        self.complaint = complaint_label()
        self.complaint.setWordWrap(False)  # as wide as it is long, the row flows
        self.phosphor = self._combo(_("Phosphor"), _("What the screen is coated with"), 13)
        for name in names():
            self.phosphor.addItem(phosphor_title(name), name)
        self.phosphor.activated.connect(lambda _i: self._send(phosphor=self.phosphor.currentData()))
        self.refresh = self._field(_("Refresh"), "Hz", REFRESH_HZ, "refresh_hz", 1.0)
        self.persistence = self._field(
            _("Persistence"), "\N{MULTIPLICATION SIGN}", PERSISTENCE, "persistence", 0.1
        )
        self.calm = CalmSwitch()
        self._rows.addWidget(self.calm)
        self.luminance = self._field(_("Luminance"), "cd/m\N{SUPERSCRIPT TWO}", LUMINANCE, "luminance", 10.0)
        self.steps = self._field("n", "", STEPS, "steps", 1.0, apart=True)
        self.periods = self._field(_("Periods"), "", PERIODS, "periods", 1.0, apart=True)
        self.figure = self._combo(_("Picture"), _("The sheet, or something that moves over it"), 7)
        for kind, title in ((STILL, _("The sheet")), (SPOT, _("Moving spot")), (BAR, _("Moving bar"))):
            self.figure.addItem(title, kind)
        self.figure.activated.connect(lambda _i: self._send(figure=self.figure.currentData()))
        self.speed = self._field(_("Speed"), "px/s", SPEED, "speed", 10.0)
        self.moves = QToolButton()
        self.moves.setText(_("Move"))
        self.moves.setCheckable(True)
        self.moves.setAccessibleName(_("Move"))
        self.moves.setToolTip(_("Let the figure move and leave its trail, or hold it"))
        self.moves.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        set_icon(self.moves, "play")
        for part in (self.moves, self.complaint):
            self._rows.addWidget(part)

    def _combo(self, name: str, meaning: str, letters: int) -> QComboBox:
        box = ChoiceBox(letters)
        box.setToolTip(meaning)
        tell_choice(box)
        box.setAccessibleName(name)
        self._rows.addWidget(box)
        return box

    def _field(
        self,
        label: str,
        unit: str,
        bounds: Number,
        name: str,
        step: float,
        apart: bool = False,
    ) -> NumberField:
        """A field; ``apart`` it is a whole number that stands elsewhere."""
        meanings = {
            "refresh_hz": _("Pictures per second"),
            "persistence": _("How many times longer the phosphor glows than it does in life"),
            "luminance": _("Mean luminance of what is looked at"),
            "speed": _("How fast the figure moves"),
            "steps": _("Steps of the run from one refresh to the next"),
            "periods": _("Refreshes that are plotted"),
        }
        field = NumberField(
            label,
            unit,
            low=bounds.low,
            high=bounds.high,
            step=step,
            integer=apart,
            meaning=meanings[name],
            complaint=self.complaint,
            digits=5,
        )
        kind = int if apart else float
        field.edited.connect(lambda value: self._send(**{name: kind(value)}))
        field.scrubbed.connect(lambda value: self._send(**{name: kind(value)}))
        if not apart:
            field.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
            self._rows.addWidget(field)
        return field

    def _send(self, **changes: Argument) -> None:
        asked: Mapping[str, Argument] = changes
        self.changed.emit(asked)

    def show_subject(self, subject: Subject) -> None:
        """Show the numbers of the subject."""
        figure = str(given(subject, "figure"))
        self.phosphor.setCurrentIndex(self.phosphor.findData(phosphor_of(subject).name))
        self.figure.setCurrentIndex(max(self.figure.findData(figure), 0))
        for field, name in (
            (self.refresh, "refresh_hz"),
            (self.persistence, "persistence"),
            (self.luminance, "luminance"),
            (self.speed, "speed"),
            (self.steps, "steps"),
            (self.periods, "periods"),
        ):
            field.set_value(number(subject, name))
        self.speed.setEnabled(moving(figure))
        self.moves.setEnabled(moving(figure))
