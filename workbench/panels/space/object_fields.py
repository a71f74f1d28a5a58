"""The numbers of the chosen object: those of its solid, and of each link of its chain of transforms."""

from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.fields import Number, numbers_of
from workbench.document.scene.edits import add_link, remove_link, set_link, set_solid_parameter
from workbench.document.scene.links import AnyLink3D
from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.space.solids_offered import link_title, links
from workbench.rendering.scene.solid_octree import OCTREE, placed_solid
from workbench.rendering.subjects.visibility import KIND
from workbench.session.session import Session
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.icons import set_icon


class ObjectFields(QScrollArea):
    """Shows one object and edits it. ``said`` sends what is wrong."""

    said = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self._session = session
        self._thing: Object | None = None
        self._shape: tuple[object, ...] = ()
        self.fields: dict[str, NumberField] = {}

    def show_object(self, thing: Object | None) -> None:
        """Show the numbers of an object, or none."""
        self._thing = thing
        shape = _shape_of(thing)
        if shape != self._shape:
            self._shape = shape
            self._rebuild(thing)
        if thing is not None:
            for name in numbers_of(type(thing.solid)):
                self.fields[name].set_value(float(getattr(thing.solid, name)))
            for link in thing.transforms:
                for name in numbers_of(type(link)):
                    self.fields[f"{link.id}/{name}"].set_value(round(float(getattr(link, name)), 6))

    def _rebuild(self, thing: Object | None) -> None:
        self.fields = {}
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(10, 6, 10, 6)
        column.setSpacing(6)
        if thing is not None:
            self._add_fields(column, thing)
        column.addStretch(1)
        self.setWidget(body)

    def _add_fields(self, column: QVBoxLayout, thing: Object) -> None:
        if thing.solid.equation:
            equation = QLabel(thing.solid.equation)
            equation.setToolTip(_("The equation of the surface that the faces approximate"))
            equation.setAccessibleName(_("Equation: {equation}").format(equation=thing.solid.equation))
            equation.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            equation.setWordWrap(True)
            column.addWidget(equation)
        grid = self._grid(column)
        for at, (name, number) in enumerate(numbers_of(type(thing.solid)).items()):
            field = self._field(name, number, number.label)
            grid.addWidget(field, at // 2, at % 2)
        for link in thing.transforms:
            head = QHBoxLayout()
            title = QLabel(link_title(link))
            title.setStyleSheet("font-weight: 600;")
            remove = QToolButton()
            set_icon(remove, "trash", "muted")
            remove.setToolTip(_("Remove this transform"))
            remove.setAccessibleName(_("Remove this transform"))
            edit, name = remove_link(thing.id, link.id), _("Remove the transform")
            remove.clicked.connect(partial(self._apply, edit, name))
            head.addWidget(title, 1)
            head.addWidget(remove)
            column.addLayout(head)
            grid = self._grid(column)
            for at, (name, number) in enumerate(numbers_of(type(link)).items()):
                label = number.symbol or number.label
                grid.addWidget(self._field(f"{link.id}/{name}", number, label), at // 2, at % 2)
        if placed_solid(thing) is not None:
            octree = QPushButton(_("Divide into an octree"))
            octree.setToolTip(_("Step how the solid is divided into cubes, on the page Visibility"))
            octree.clicked.connect(partial(self._divide, thing.id))
            column.addWidget(octree, 0, Qt.AlignmentFlag.AlignLeft)
        add = QPushButton(_("Add a transform"))
        add.setToolTip(_("Move, rotate or scale the object, after the transforms it already has"))
        menu = QMenu(add)
        for title_, link in links():
            menu.addAction(title_, partial(self._add, thing.id, link))
        add.setMenu(menu)
        column.addWidget(add, 0, Qt.AlignmentFlag.AlignLeft)

    @staticmethod
    def _grid(column: QVBoxLayout) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(4)
        column.addLayout(grid)
        return grid

    def _field(self, name: str, number: Number, label: str) -> NumberField:
        angle = number.unit == "°"
        field = NumberField(
            label,
            "" if number.unit == "world" else number.unit,
            low=number.low,
            high=number.high,
            step=1.0 if number.whole or angle else 0.1,
            integer=number.whole,
            meaning=number.label,
        )
        field.edited.connect(partial(self._set, name, ""))
        field.scrubbed.connect(partial(self._set, name, f"solid {name}"))
        field.scrub_ended.connect(self._session.end_merge)
        self.fields[name] = field
        return field

    def _set(self, name: str, merge: str, value: float) -> None:
        thing = self._thing
        assert thing is not None
        identity, slash, attribute = name.partition("/")
        if slash:
            link = next(each for each in thing.transforms if each.id == identity)
            edit, now = set_link(thing.id, replace(link, **{attribute: value})), getattr(link, attribute)
        else:
            number = numbers_of(type(thing.solid))[name]
            edit = set_solid_parameter(thing.id, name, int(value) if number.whole else value)
            now = getattr(thing.solid, name)
        try:
            self._session.apply(edit, _("Change value"), merge)
        except DocumentError as problem:
            self.fields[name].refuse(problem.short, float(now))

    def _divide(self, thing: str, *_checked: object) -> None:
        """Step the octree of the object."""
        subject = Subject(KIND, (thing,), OCTREE)
        self._session.visit(KIND, subject)
        self._session.update_state(subject=subject, step=0)

    def _add(self, thing: str, link: AnyLink3D) -> None:
        self._apply(add_link(thing, link), _("Add a transform"))

    def _apply(self, edit: Edit, name: str, *_checked: object) -> None:
        try:
            self._session.apply(edit, name)
        except DocumentError as problem:
            self.said.emit(problem.short)


def _shape_of(thing: Object | None) -> tuple[object, ...]:
    """What decides which fields there are."""
    if thing is None:
        return ()
    chain = tuple((link.id, type(link)) for link in thing.transforms)
    return thing.id, type(thing.solid), chain
