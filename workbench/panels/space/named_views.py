"""The named views of a scene: kept, gone to, renamed and removed, in a list or by commands."""

from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDockWidget,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QMenu,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.names import free_name
from workbench.document.scene.edits import add_named_view, remove_thing, rename_thing
from workbench.document.scene.looking import kind_of, kinds
from workbench.document.scene.model import Camera, NamedView, Scene
from workbench.language import _, legible
from workbench.panels.space.looking import Looking
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.icons import set_icon

_ID = Qt.ItemDataRole.UserRole


class NamedViewsDock(QWidget):
    """``wanted`` sends the camera of a view that is gone to, ``said`` what is wrong."""

    wanted = Signal(object)
    said = Signal(str)

    def __init__(self, looking: Looking, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._looking = looking
        self._shown: tuple[NamedView, ...] = ()
        self._showing = False
        self.list = QListWidget()
        self.list.setAccessibleName(_("Named views"))
        self.list.setToolTip(_("A click or Enter goes to a view; F2 gives it another name"))
        self.list.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)
        self.list.itemClicked.connect(self._go)
        self.list.itemActivated.connect(self._go)
        self.list.itemChanged.connect(self._take_name)
        self.keep = self._action("name_view", _("Name this view"), "Shift+N", self.name_view)
        self.next = self._action("next_view", _("Go to the next named view"), "N", self.go_to_next)
        self.rename = self._action("rename_view", _("Rename the named view"), "(F2)", self.rename_view)
        self.remove = self._action("remove_view", _("Remove the named view"), "(Delete)", self.remove_view)
        set_icon(self.remove, "trash")
        self.list.addActions([self.next, self.rename, self.remove])
        self.list.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        delete = QShortcut(QKeySequence.StandardKey.Delete, self.list)
        delete.setContext(Qt.ShortcutContext.WidgetShortcut)
        delete.activated.connect(self.remove_view)
        self.menu = QMenu(self.list.accessibleName(), self)
        self.menu.aboutToShow.connect(self._fill_menu)
        self.empty = EmptyView(self.list, _("No view has a name yet."), self.keep.text())
        self.empty.button.setToolTip(_("Keep this view, to come back to it later"))
        self.empty.wanted.connect(self.name_view)
        self.add = QPushButton(self.keep.text())
        self.add.setToolTip(self.empty.button.toolTip())
        self.add.clicked.connect(self.name_view)
        self.bin = ActionButton(self.remove)
        self._row = QWidget()
        row = QHBoxLayout(self._row)
        row.setContentsMargins(8, 4, 8, 4)
        row.addWidget(self.add)
        row.addStretch(1)
        row.addWidget(self.bin)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.empty, 1)
        column.addWidget(self._row)
        self.list.currentRowChanged.connect(lambda row: self.bin.setEnabled(row >= 0))
        self.show_scene(Scene())

    @property
    def commands(self) -> tuple[QAction, ...]:
        """What can be done with views, in the order of a menu."""
        return self.keep, self.next, self.rename, self.remove

    def _action(self, name: str, title: str, key: str, do: object) -> QAction:
        """A ``key`` in brackets is one of the list's own, which is only named."""
        action = QAction(title, self)
        action.setObjectName(f"space.{name}")
        action.setToolTip(f"{title} ({key.strip('()')})")
        if not key.startswith("("):
            action.setShortcut(key)
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.triggered.connect(do)
        return action

    # Showing

    def show_scene(self, scene: Scene) -> None:
        """List the views of a scene; one that is seen now is the current one, and stays it."""
        self._showing = True
        stood_at = self.current
        if scene.named_views != self._shown:
            self._shown = scene.named_views
            self.list.clear()
            for view in self._shown:
                row = QListWidgetItem(view.name)
                row.setData(_ID, view.id)
                row.setToolTip(_title(view.camera))
                row.setFlags(row.flags() | Qt.ItemFlag.ItemIsEditable)
                self.list.addItem(row)
        seen = [view.camera == scene.camera for view in self._shown]
        kept = [stood_at is not None and view.id == stood_at.id for view in self._shown]
        both = [is_seen and is_kept for is_seen, is_kept in zip(seen, kept, strict=True)]
        there = next((rows for rows in (both, seen, kept) if any(rows)), None)
        if there is not None:
            self.list.setCurrentRow(there.index(True))
        self.empty.set_empty(not self._shown)
        self._row.setVisible(bool(self._shown))
        self._showing = False

    @property
    def current(self) -> NamedView | None:
        """The one that the list stands at."""
        row = self.list.currentRow()
        return self._shown[row] if 0 <= row < len(self._shown) else None

    # Changing

    def _apply(self, edit: Edit, name: str) -> bool:
        try:
            self._looking.session.apply(edit, name)
        except DocumentError as problem:
            self.said.emit(problem.short)
            return False
        return True

    def name_view(self, *_checked: object) -> None:
        """Keep what is seen now, named after its projection, and let the name be typed over."""
        scene, sheet = self._looking.scene, self._looking.session.sheet
        if scene is None:
            self.said.emit(_("This sheet has no scene; add an object first."))
            return
        name = free_name(_title(scene.camera), {view.name for view in scene.named_views})
        if self._apply(add_named_view(sheet.id, scene.camera, name), _("Name a view")):
            self._looking.session.flush()
            self.show_scene(self._looking.scene or Scene())
            self.list.setCurrentRow(self.list.count() - 1)
            self.rename_view()

    def go_to_next(self, *_checked: object) -> None:
        """Go to the view after the current one, after the last to the first."""
        if not self._shown:
            self.said.emit(_("No view has a name yet; {key} names this one.").format(key="Shift+N"))
            return
        seen = self.current is not None and self.current.camera == self._looking.camera
        self.list.setCurrentRow((self.list.currentRow() + seen) % len(self._shown))
        self._go(self.list.currentItem())

    def rename_view(self, *_checked: object) -> None:
        """Let the name of the current view be typed, in its place in the list."""
        row = self.list.currentItem()
        if row is None:
            self.said.emit(_("Choose one of the named views first."))
            return
        around: QWidget | None = self
        while around is not None and not isinstance(around, QDockWidget):
            around = around.parentWidget()
        if around is not None:
            around.show()
            around.raise_()
        self.list.setFocus(Qt.FocusReason.OtherFocusReason)
        self.list.editItem(row)

    def remove_view(self, *_checked: object) -> None:
        """Take the current view off the list; what is seen stays."""
        view = self.current
        if view is None:
            self.said.emit(_("Choose one of the named views first."))
        else:
            self._apply(remove_thing(view.id), _("Remove the view {name}").format(name=view.name))

    def _fill_menu(self) -> None:
        self.menu.clear()
        for view in self._shown:
            text = legible(view.name).replace("&", "&&")
            self.menu.addAction(text, partial(self.wanted.emit, view.camera))
        if not self._shown:
            self.menu.addAction(_("None yet")).setEnabled(False)

    def _go(self, row: QListWidgetItem) -> None:
        view = next((each for each in self._shown if each.id == row.data(_ID)), None)
        if view is not None:
            self.wanted.emit(view.camera)

    def _take_name(self, row: QListWidgetItem) -> None:
        if self._showing:
            return
        views = (self._looking.scene or Scene()).named_views  # as they are, not as they were listed
        view = next((each for each in views if each.id == row.data(_ID)), None)
        name = row.text().strip()
        if view is None or name == view.name:
            return
        if not name:
            self.said.emit(_("A view needs a name; this one keeps the name {name}.").format(name=view.name))
        if not (name and self._apply(rename_thing(view.id, name), _("Rename"))):
            self._showing = True
            row.setText(view.name)
            self._showing = False


def _title(camera: Camera) -> str:
    """The projection of a camera, by which a view is called at first."""
    try:
        kind = kind_of(camera)
    except ValueError:  # it sees nothing now
        kind = camera.projection
    return next((each.title for each in kinds() if each.slug == kind), kind)
