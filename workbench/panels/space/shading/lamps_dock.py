"""Lights and materials: the numbers of the one that is chosen, and lights added and removed."""

from collections.abc import Callable
from functools import partial
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QCheckBox,
    QColorDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.fields import Number, numbers_of
from workbench.document.scene.edits import add_light, remove_thing, set_thing
from workbench.document.scene.model import Light, Material, Point3D, Scene
from workbench.language import _
from workbench.panels.space.looking import light_moved_to
from workbench.panels.space.shading.light_faults import word_of
from workbench.session.session import Session
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tips import tell_choice

_STEPS = {"shininess": 1.0}


class LampsDock(QScrollArea):
    """``said`` sends what is wrong, ``chosen_changed`` the id of the light or material that is chosen."""

    said = Signal(str)
    chosen_changed = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self._session = session
        self._listed: tuple[object, ...] = ()
        self._kind: type | None = None
        self.fields: dict[str, NumberField] = {}
        self.choice = ChoiceBox(10)
        self.choice.setAccessibleName(_("Light or material"))
        self.choice.setToolTip(_("The light or material whose numbers are shown"))
        tell_choice(self.choice)
        self.choice.activated.connect(lambda _index: self._choose())
        self.add = self._button(_("Add light"), "plus", self.add_light, _("Put a light above the scene"))
        self.remove = self._button(_("Remove"), "trash", self.delete, _("Remove this light"))
        self.colour = self._button(_("Colour"), "palette", self.ask_colour, _("Give it another colour"))
        self.distant = QCheckBox(_("Far away"))
        self.distant.setToolTip(_("Shines from one direction, equally everywhere, and does not fade"))
        self.distant.clicked.connect(lambda on: self._change({"distant": on}))
        self.word = QLabel()
        self.word.setWordWrap(True)
        self.word.setProperty("role", "warn")
        top, buttons = QHBoxLayout(), QHBoxLayout()
        top.addWidget(self.choice, 1)
        top.addWidget(self.colour)
        buttons.addWidget(self.add)
        buttons.addWidget(self.remove)
        buttons.addStretch(1)
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(10)
        self._grid.setVerticalSpacing(4)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(10, 8, 10, 8)
        column.setSpacing(8)
        column.addLayout(top)
        column.addLayout(buttons)
        column.addLayout(self._grid)
        column.addWidget(self.distant)
        column.addWidget(self.word)
        column.addStretch(1)
        self.setWidget(body)

    @staticmethod
    def _button(title: str, icon: str, do: Callable[[], object], tip: str) -> QPushButton:
        button = QPushButton(title)
        set_icon(button, icon)
        button.setToolTip(tip)
        button.clicked.connect(lambda _checked=False: do())
        return button

    # Showing

    @property
    def chosen(self) -> Light | Material | None:
        """What is shown; None where the scene has neither."""
        scene = self._session.sheet.scene
        things: tuple[Light | Material, ...] = ()
        if scene is not None:
            things = (*scene.lights, *scene.materials)
        return next((each for each in things if each.id == self.choice.currentData()), None)

    def show_scene(self, scene: Scene) -> None:
        """Show the lights and materials of a scene, and the numbers of the chosen one."""
        rows = [(each.id, _("Light: {name}").format(name=each.name or each.id)) for each in scene.lights]
        rows += [
            (each.id, _("Material: {name}").format(name=_made_of(each, scene))) for each in scene.materials
        ]
        if tuple(rows) != self._listed:
            before, self._listed = self.choice.currentData(), tuple(rows)
            self.choice.clear()
            for identity, title in rows:
                self.choice.addItem(title, identity)
            self.choice.setCurrentIndex(max(self.choice.findData(before), 0))
        self._show_numbers(scene)

    def choose(self, identity: str) -> None:
        """Show the numbers of a light or a material."""
        at = self.choice.findData(identity)
        if at >= 0:
            self.choice.setCurrentIndex(at)
            self._choose()

    def _choose(self) -> None:
        self._show_numbers(self._session.sheet.scene or Scene())
        self.chosen_changed.emit(self.choice.currentData() or "")

    def _show_numbers(self, scene: Scene) -> None:
        thing = self.chosen
        self.choice.setVisible(bool(self._listed))
        self.remove.setEnabled(isinstance(thing, Light))
        self.colour.setEnabled(thing is not None)
        self.distant.setVisible(isinstance(thing, Light))
        if type(thing) is not self._kind:
            self._kind = type(thing)
            self._rebuild(thing)
        for name, field in self.fields.items():
            value: Any = thing
            for part in name.split("."):
                value = getattr(value, part)
            field.belong_to(self.choice.currentData())
            field.set_value(round(float(value), 6))
        if isinstance(thing, Light):
            self.distant.setChecked(thing.distant)
            for name in ("a0", "a1", "a2"):
                self.fields[name].setEnabled(not thing.distant)
        word = word_of(thing, scene) if isinstance(thing, Light) else ""
        if not scene.lights:
            word = _("The scene has no light of its own, so it is lit from above the eye.")
        self.word.setText(word)
        self.word.setVisible(bool(word))

    def _rebuild(self, thing: Light | Material | None) -> None:
        for field in self.fields.values():
            self._grid.removeWidget(field)
            field.blockSignals(True)  # what was typed is for nothing else
            field.deleteLater()
        self.fields = {}
        if thing is None:
            return
        places = {f"position.{axis}": number for axis, number in numbers_of(Point3D).items()}
        own = {name: number for name, number in numbers_of(type(thing)).items() if name != "colour"}
        numbers = {**(places if isinstance(thing, Light) else {}), **own}
        for at, (name, number) in enumerate(numbers.items()):
            self.fields[name] = field = self._field(name, number)
            self._grid.addWidget(field, at // 2, at % 2)

    def _field(self, name: str, number: Number) -> NumberField:
        field = NumberField(
            number.symbol or number.label,
            "",
            low=number.low,
            high=number.high,
            step=_STEPS.get(name, 0.05 if number.high == 1.0 else 0.1),
            meaning=number.label,
        )
        field.edited.connect(partial(self._set, name, ""))
        field.scrubbed.connect(partial(self._set, name, f"light {name}"))
        field.scrub_ended.connect(self._session.end_merge)
        return field

    # Changing

    def _set(self, name: str, merge: str, value: float) -> None:
        thing = self.chosen
        if isinstance(thing, Light) and name.startswith("position."):
            self._change({"position": replace(thing.position, **{name[-1]: value})}, merge, self.fields[name])
        else:
            self._change({name: value}, merge, self.fields[name])

    def _change(self, values: dict[str, Any], merge: str = "", field: NumberField | None = None) -> None:
        thing = self.chosen
        if thing is None:
            return
        try:
            title = _("Change a light") if isinstance(thing, Light) else _("Change a material")
            self._session.apply(set_thing(replace(thing, **values)), title, merge)
        except DocumentError as problem:
            if field is not None:
                field.refuse(problem.short, float(getattr(thing, next(iter(values)), 0.0) or 0.0))
            else:
                self.said.emit(problem.short)

    def move_light(self, identity: str, position: Point3D) -> None:
        """Put a light elsewhere, as a part of a drag."""
        edit = light_moved_to(self._session.sheet.scene or Scene(), identity, position)
        if edit is not None:
            self._apply(edit, _("Move a light"), f"light {identity}")

    def add_light(self) -> None:
        """Put a light above the scene, and choose it."""
        if self._apply(
            add_light(self._session.sheet.id, Light("", name=_("Lamp"), distant=False)), _("Add a light")
        ):
            scene = self._session.sheet.scene
            assert scene is not None
            self.show_scene(scene)
            self.choose(scene.lights[-1].id)

    def delete(self) -> None:
        """Remove the chosen light."""
        if isinstance(self.chosen, Light):
            self._apply(remove_thing(self.chosen.id), _("Remove a light"))

    def ask_colour(self) -> None:
        """Have another colour chosen for the light or the material that is shown now."""
        thing = self.chosen
        if thing is None:
            return
        dialog = QColorDialog(f"#{thing.colour:06x}", self)
        dialog.setWindowTitle(_("Colour"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.colorSelected.connect(partial(self._colour, thing.id))
        dialog.open()  # exec() would hold whatever else goes on, and what it was asked for may go meanwhile

    def _colour(self, identity: str, colour: QColor) -> None:
        if self.chosen is not None and self.chosen.id == identity:
            self._change({"colour": colour.rgb() & 0xFFFFFF})

    def _apply(self, edit: Edit, name: str, merge: str = "") -> bool:
        try:
            self._session.apply(edit, name, merge)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return False
        return True


def _made_of(material: Material, scene: Scene) -> str:
    """Its name, and what is made of it."""
    things = [thing.name or thing.id for thing in scene.objects if thing.material == material.id]
    name = material.name or material.id
    return name if not things or things == [name] else f"{name} ({', '.join(things)})"
