"""A colour in three models: solids that are turned, sliders, and the text that is stepped on its hexagon."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import (
    QButtonGroup,
    QGridLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Mark, Matrix
from workbench.display.colour_tube import packed_levels
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.display.colour.sliders import Coordinate, Sliders
from workbench.rendering.subjects.colour_model import (
    TO_CMY,
    TO_HSV,
    TO_RGB,
    cmy_of,
    hsv_of,
    rgb_of,
    with_cmy,
    with_hsv,
    with_rgb,
)
from workbench.widgets.canvas.plane import Plane
from workbench.widgets.canvas.plane_view import PlaneView
from workbench.widgets.colour.solid_view import SolidView, titles
from workbench.widgets.colour.solids import Model
from workbench.widgets.fields.number_field import complaint_label
from workbench.widgets.look.tokens import RADIUS, colour, tokens

_BOXES = {TO_CMY: (0.0, -0.25, 1.5, 1.25)}
_HEXAGON = (-1.25, -1.2, 1.25, 1.2)


def coordinates(model: Model) -> tuple[Coordinate, ...]:
    """The coordinates of a model."""
    return {
        "rgb": (
            Coordinate("R", _("Red, as it is coded")),
            Coordinate("G", _("Green, as it is coded")),
            Coordinate("B", _("Blue, as it is coded")),
        ),
        "cmy": (
            Coordinate("C", _("Cyan, which takes red away")),
            Coordinate("M", _("Magenta, which takes green away")),
            Coordinate("Y", _("Yellow, which takes blue away")),
        ),
        "hsv": (
            Coordinate("H", _("Hue, from red over green"), 360.0, "°", 1.0, decimals=2),
            Coordinate("S", _("Saturation: 0 is grey")),
            Coordinate("V", _("Value: 0 is black")),
        ),
    }[model]


class Swatch(QWidget):
    """The colour itself."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.packed = 0
        self.setMinimumHeight(26)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def show_colour(self, packed: int) -> None:
        """Show 0xRRGGBB."""
        self.packed = packed
        self.setAccessibleName(f"#{packed:06X}")
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """A card of it."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(colour(tokens().field_edge), 1))
        painter.setBrush(QColor(self.packed))
        painter.drawRoundedRect(self.rect().adjusted(1, 1, -2, -2), RADIUS, RADIUS)
        painter.end()


class ModelsView(QWidget):
    """``changed`` sends the arguments of a colour that a hand asks for, ``text_chosen`` a slug to step.

    ``held`` tells that a slider is dragged, and that it is let go.
    """

    changed = Signal(object)
    held = Signal(bool)
    text_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        models: tuple[Model, ...] = ("rgb", "cmy", "hsv")
        self.solids = {model: SolidView(model) for model in models}
        self.complaint = complaint_label()
        self.sliders = {model: Sliders(coordinates(model), self.complaint) for model in models}
        self.plane = PlaneView()
        self.plane.setMinimumSize(110, 110)
        self.plane.setToolTip(_("What the text that is stepped has worked out so far"))
        self.swatch = Swatch()
        self.hexadecimal = QLabel()
        self.hexadecimal.setToolTip(_("The coded colour, eight bits for each component"))
        self.hexadecimal.setAccessibleName(_("Coded colour"))
        self.texts = QButtonGroup(self)
        self._slugs = (TO_CMY, TO_HSV, TO_RGB)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(4)
        for column, model in enumerate(models):
            grid.addWidget(QLabel(titles(model)[0]), 0, column)
            grid.addWidget(self.solids[model], 1, column)
            grid.addWidget(self.sliders[model], 2, column)
        self.stepped = QLabel()
        grid.addWidget(self.stepped, 0, 3)
        grid.addWidget(self.plane, 1, 3)
        grid.addWidget(self._choices(), 2, 3)
        grid.addWidget(self.complaint, 3, 0, 1, 4)
        grid.setRowStretch(1, 1)
        for column in range(4):
            grid.setColumnStretch(column, 1)
        for model, written in (("rgb", with_rgb), ("cmy", with_cmy), ("hsv", with_hsv)):
            self.sliders[model].changed.connect(
                lambda values, write=written: self.changed.emit(write(values))
            )
        for sliders in self.sliders.values():
            sliders.held.connect(self.held)
        self.texts.idClicked.connect(lambda number: self.text_chosen.emit(self._slugs[number]))

    def _choices(self) -> QWidget:
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        row = QGridLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setHorizontalSpacing(6)
        row.addWidget(self.swatch, 0, 0)
        row.addWidget(self.hexadecimal, 0, 1)
        column.addLayout(row)
        for number, slug in enumerate(self._slugs):
            title = _(catalogue.get(slug).title)
            button = QPushButton(title)
            button.setCheckable(True)
            button.setProperty("low", True)
            button.setToolTip(_("Step {title} on this colour").format(title=title))
            self.texts.addButton(button, number)
            column.addWidget(button)
        return holder

    def show_subject(self, subject: Subject) -> None:
        """Show the colour of the subject."""
        rgb, cmy, hsv = rgb_of(subject), cmy_of(subject), hsv_of(subject)
        values: Mapping[Model, Sequence[float]] = {"rgb": rgb, "cmy": cmy, "hsv": hsv}
        for model, view in self.solids.items():
            letters = (one.letter for one in coordinates(model))
            pairs = zip(letters, values[model], strict=True)
            view.show_colour(rgb, ", ".join(f"{letter} = {value:.4g}" for letter, value in pairs))
            self.sliders[model].set_values(values[model])
        packed = packed_levels(rgb)
        self.swatch.show_colour(packed)
        self.hexadecimal.setText(f"#{packed:06X}")
        slug = subject.entry or self._slugs[0]
        self.texts.button(self._slugs.index(slug)).setChecked(True)
        self.stepped.setText(_("Stepped: {title}").format(title=_(catalogue.get(slug).title)))

    def show_marks(self, slug: str, marks: Sequence[Mark]) -> None:
        """What the run has worked out so far."""
        drawn = tuple(mark for mark in marks if not isinstance(mark, Matrix))
        self.plane.set_plane(Plane(_BOXES.get(slug, _HEXAGON), drawn=drawn, bare=True))
        self.plane.setAccessibleName(self.stepped.text())
