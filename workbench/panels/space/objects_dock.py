"""The list of objects: chosen, named, hidden, coloured, copied, moved and removed there."""

from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QColor, QIcon, QKeySequence, QPixmap, QShortcut
from PySide6.QtWidgets import (
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure
from workbench.document.scene.edits import (
    add_material,
    add_object,
    duplicate_object,
    remove_thing,
    rename_thing,
    reorder_object,
    set_material,
    set_visible,
)
from workbench.document.scene.model import Material, Object, Scene
from workbench.language import _, ngettext, reason_of
from workbench.panels.space.object_fields import ObjectFields
from workbench.panels.space.solids_offered import Offer, offers, title_of
from workbench.panels.space.sweeps import extruded, revolved
from workbench.panels.stage.card import kind_title
from workbench.session.session import Session
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.split import Split

COLOURS = (
    (_("Blue"), 0x9CC8E6),
    (_("Orange"), 0xF0A878),
    (_("Green"), 0x8CCDB0),
    (_("Pink"), 0xDDA0C4),
    (_("Yellow"), 0xE6CE7C),
    (_("Violet"), 0xB4ACE0),
    (_("Grey"), 0xC8C8C8),
    (_("White"), 0xF4F4F4),
)
_ID = Qt.ItemDataRole.UserRole
_SWATCH_PX = 14
_ASIDE = 1.2
_MOST_LISTED = 30


class ObjectsDock(QWidget):
    """``said`` sends what is wrong, ``added`` the id of an object that was added here."""

    said = Signal(str)
    added = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._showing = False
        self._shown: tuple[object, ...] = ()
        self.list = QListWidget()
        self.list.setAccessibleName(_("Objects"))
        self.list.setIconSize(QSize(_SWATCH_PX, _SWATCH_PX))
        self.list.setToolTip(_("The check mark shows an object or hides it; F2 gives it another name"))
        self.list.itemSelectionChanged.connect(self._choose)
        self.list.itemChanged.connect(self._take_change)
        self.fields = ObjectFields(session)
        self.fields.said.connect(self.said)
        self.add = QPushButton(_("Add object"))
        self.add.setToolTip(_("Put a solid into the scene"))
        menu = QMenu(self.add)
        self.commands: list[QAction] = []
        for offer in offers():
            menu.addAction(offer.title, partial(self.add_solid, offer))
            command = QAction(_("Add object: {what}").format(what=offer.title), self)
            command.setToolTip(self.add.toolTip())
            command.triggered.connect(lambda _checked=False, offer=offer: self.add_solid(offer))
            self.commands.append(command)
        menu.addSeparator()
        self._swept = {
            "extrude": menu.addMenu(_("Extrude a figure")),
            "turn": menu.addMenu(_("Revolve a figure")),
        }
        menu.aboutToShow.connect(self._fill_swept)
        self.add.setMenu(menu)
        self.colour = self._button("palette", _("Colour"), None)
        colours = QMenu(self.colour)
        for title, value in COLOURS:
            colours.addAction(_swatch(value), title, partial(self._paint, value))
        self.colour.setMenu(colours)
        self.colour.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.tools = [
            self.colour,
            self._button("copy", _("Duplicate the object"), self.duplicate),
            self._button("arrow-up", _("Move the object up in the list"), partial(self.shift, -1)),
            self._button("arrow-down", _("Move the object down in the list"), partial(self.shift, 1)),
            self._button("trash", _("Delete the object"), self.delete),
        ]
        row = QHBoxLayout()
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(2)
        row.addWidget(self.add)
        row.addStretch(1)
        for tool in self.tools:
            row.addWidget(tool)
        top = QWidget()
        column = QVBoxLayout(top)
        column.setContentsMargins(0, 6, 0, 0)  # clear of the tabs
        column.setSpacing(0)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        split = Split(Qt.Orientation.Vertical)
        split.addWidget(top)
        split.addWidget(self.fields)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(split)
        for key, do in ((QKeySequence.StandardKey.Delete, self.delete), ("Ctrl+D", self.duplicate)):
            shortcut = QShortcut(QKeySequence(key), self.list)
            shortcut.setContext(Qt.ShortcutContext.WidgetShortcut)
            shortcut.activated.connect(do)

    def _button(self, name: str, title: str, do: object) -> QToolButton:
        button = QToolButton()
        set_icon(button, name)
        button.setToolTip(title)
        button.setAccessibleName(title)
        if callable(do):
            button.clicked.connect(lambda _checked=False: do())
        return button

    # Showing

    def show_scene(self, scene: Scene, chosen: str) -> None:
        """Show the objects of a scene, one of them chosen."""
        self._showing = True
        listed = scene.objects, scene.materials
        if listed != self._shown:
            self._shown = listed
            self._fill(scene)
        here = next((k for k, thing in enumerate(scene.objects) if thing.id == chosen), -1)
        self.list.setCurrentRow(here)
        self.fields.show_object(scene.objects[here] if here >= 0 else None)
        for tool in self.tools:
            tool.setEnabled(here >= 0)
        self._showing = False

    def _fill(self, scene: Scene) -> None:
        colours = {material.id: material.colour for material in scene.materials}
        self.list.clear()
        for thing in scene.objects:
            row = QListWidgetItem(_swatch(colours[thing.material]), title_of(thing))
            row.setData(_ID, thing.id)
            row.setToolTip(_size(thing))
            row.setFlags(row.flags() | Qt.ItemFlag.ItemIsEditable | Qt.ItemFlag.ItemIsUserCheckable)
            row.setCheckState(Qt.CheckState.Checked if thing.visible else Qt.CheckState.Unchecked)
            self.list.addItem(row)

    # Changing

    @property
    def chosen(self) -> Object | None:
        """The chosen object."""
        scene, identity = self._session.sheet.scene, self._session.state.thing
        return next((each for each in scene.objects if each.id == identity), None) if scene else None

    def _apply(self, edit: Edit, name: str, merge: str = "") -> bool:
        try:
            self._session.apply(edit, name, merge)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return False
        return True

    def _choose(self) -> None:
        if self._showing:
            return
        things = [self._thing_of(row) for row in self.list.selectedItems()]
        self._session.update_state(thing=things[0].id if things and things[0] is not None else "")

    def _thing_of(self, row: QListWidgetItem) -> Object | None:
        """The object in a row; None when the scene no longer has it, and the list is yet to be told."""
        scene = self._session.sheet.scene
        return next((each for each in scene.objects if each.id == row.data(_ID)), None) if scene else None

    def _take_change(self, row: QListWidgetItem) -> None:
        """Another name, or shown and hidden."""
        thing = None if self._showing else self._thing_of(row)
        if thing is None:
            return
        visible = row.checkState() == Qt.CheckState.Checked
        if visible != thing.visible:
            self._apply(set_visible(thing.id, visible), _("Show or hide"))
        elif row.text().strip() != title_of(thing):
            self._apply(rename_thing(thing.id, row.text().strip()), _("Rename"))
        self._shown = ()
        scene = self._session.sheet.scene
        if scene is not None and thing in scene.objects:  # what was typed was refused, or changes nothing
            self._showing = True
            row.setText(title_of(thing))
            self._showing = False

    def add_solid(self, offer: Offer) -> None:
        """Put a solid into the scene, with a colour of its own, and choose it."""
        sheet = self._session.sheet
        count = len(sheet.scene.objects) if sheet.scene else 0
        colour = COLOURS[count % (len(COLOURS) - 2)][1]
        if not self._apply(add_material(sheet.id, Material("", offer.title, colour)), offer.title, "add"):
            return
        scene = self._session.sheet.scene
        assert scene is not None
        added = Object("", offer.solid, scene.materials[-1].id, offer.title, points=offer.points)
        if self._apply(add_object(sheet.id, added), offer.title, "add"):
            self._choose_newest()
        self._session.end_merge()

    def _fill_swept(self) -> None:
        """The figures of the sheet, each to be swept into a solid."""
        sheet = self._session.sheet
        for name, menu in self._swept.items():
            menu.clear()
            menu.menuAction().setEnabled(bool(sheet.figures))
            for figure in sheet.figures[:_MOST_LISTED]:
                menu.addAction(figure.name or kind_title(figure), partial(self.sweep, name, figure))

    def sweep(self, way: str, figure: AnyFigure) -> None:
        """Put a solid into the scene that a figure of the sheet is swept into: "extrude" it, or "turn" it."""
        try:
            solid, points = (extruded if way == "extrude" else revolved)(self._session.sheet, figure)
        except ValueError as error:
            self.said.emit(reason_of(error))
            return
        self.add_solid(Offer(figure.name or kind_title(figure), solid, points))

    def _choose_newest(self) -> None:
        scene = self._session.sheet.scene
        assert scene is not None
        self._session.update_state(thing=scene.objects[-1].id)
        self.added.emit(scene.objects[-1].id)

    def duplicate(self) -> None:
        """Copy the chosen object, a little aside, and choose the copy."""
        thing, sheet = self.chosen, self._session.sheet
        if thing is None or sheet.scene is None:
            return
        vertices = thing.mesh.vertices
        aside = _ASIDE * float((vertices.max(axis=0) - vertices.min(axis=0))[0])
        if self._apply(duplicate_object(thing.id, aside), _("Duplicate")):
            scene = self._session.sheet.scene
            assert scene is not None
            at = [each.id for each in scene.objects].index(thing.id) + 1
            self._session.update_state(thing=scene.objects[at].id)

    def shift(self, by: int) -> None:
        """Move the chosen object in the list."""
        thing, scene = self.chosen, self._session.sheet.scene
        if thing is None or scene is None:
            return
        at = scene.objects.index(thing) + by
        if 0 <= at < len(scene.objects):
            self._apply(reorder_object(thing.id, at), _("Change order"))

    def delete(self) -> None:
        """Remove the chosen object."""
        if (thing := self.chosen) is not None:
            self._apply(remove_thing(thing.id), _("Delete"))

    def _paint(self, value: int) -> None:
        """Give the chosen object a colour, without changing what shares its material."""
        thing, sheet = self.chosen, self._session.sheet
        if thing is None or sheet.scene is None:
            return
        old = next(each for each in sheet.scene.materials if each.id == thing.material)
        merge = "colour"
        if self._apply(add_material(sheet.id, replace(old, id="", colour=value)), _("Colour"), merge):
            scene = self._session.sheet.scene
            assert scene is not None
            self._apply(set_material(thing.id, scene.materials[-1].id), _("Colour"), merge)
            if all(each.material != old.id or each.id == thing.id for each in scene.objects):
                self._apply(remove_thing(old.id), _("Colour"), merge)
        self._session.end_merge()


def _size(thing: Object) -> str:
    mesh = thing.mesh
    vertices = ngettext("{n:,} vertex", "{n:,} vertices", len(mesh.vertices)).format(n=len(mesh.vertices))
    faces = ngettext("{n:,} face", "{n:,} faces", len(mesh.faces)).format(n=len(mesh.faces))
    return f"{vertices}, {faces}"


def _swatch(value: int) -> QIcon:
    pixmap = QPixmap(_SWATCH_PX, _SWATCH_PX)
    pixmap.fill(QColor(value))
    return QIcon(pixmap)
