"""The page Projection: what the eye sees, the same from outside, and the matrices between them."""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QKeyEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QSplitter, QToolButton, QVBoxLayout, QWidget

from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.camera_card import CameraCard
from workbench.panels.space.eye_view import EyeView, Vertex
from workbench.panels.space.family_dock import FamilyDock
from workbench.panels.space.looking import Looking
from workbench.panels.space.matrix_strip import MatrixStrip
from workbench.panels.space.objects_dock import ObjectsDock
from workbench.panels.space.outside_view import OutsideView
from workbench.panels.space.polygon_tables import PolygonTablesView
from workbench.panels.space.solids_offered import offers
from workbench.panels.stage.empty import EmptyState
from workbench.rendering.scene.edge_picture import object_at
from workbench.rendering.subjects.projection import KIND, is_of_a_vertex, seen_from, vertex_of
from workbench.session.session import Session
from workbench.widgets.look.icons import set_icon
from workbench.widgets.stepping.step_bar import stepping_keys

_BAR_PX, _CARD_GAP_PX = 44, 8
_LEAST_BESIDE_PX = 560
_REST_MS = 50
Command = tuple[str, str, str, str, Callable[[], object]]


class ProjectionPage(QWidget):
    """``hover_text``: said in passing; ``zoom_text``: the scale."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.looking = Looking(session)
        self.eye = EyeView()
        self.outside = OutsideView(self.eye)
        self.strip = MatrixStrip(self.looking)
        self.card = CameraCard(self.looking, self.eye)
        self.card.move(_CARD_GAP_PX, _CARD_GAP_PX)
        self.objects = ObjectsDock(session)
        self.family = FamilyDock()
        self.tables = PolygonTablesView()
        self.empty = EmptyState(
            self.eye,
            _("Nothing to look at."),
            partial(self.objects.add_solid, offers()[0]),
            _("Add a house"),
            _("Put a house into the scene"),
        )
        self.empty.hide()
        self.beside = "both"
        self._actions: dict[str, QAction] = {}
        self._lay_out()
        self._waiting = False
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._refresh_rest)
        self._kept: Scene | None = None
        self._connect()
        self.refresh()

    def _lay_out(self) -> None:
        self.views = QSplitter(Qt.Orientation.Horizontal)
        self.views.setChildrenCollapsible(False)
        self.views.addWidget(self.eye)
        self.views.addWidget(self.outside)
        self.views.setSizes([1000, 1000])
        for at in (0, 1):
            self.views.setStretchFactor(at, 1)
        bar = QFrame()
        bar.setFixedWidth(_BAR_PX)
        column = QVBoxLayout(bar)
        column.setContentsMargins(6, 8, 6, 8)
        column.setSpacing(4)
        for name, title, icon, key, do in self._commands():
            action = QAction(title, self)
            action.setObjectName(f"space.{name}")
            action.setToolTip(f"{title} ({key})" if key else title)
            if key:
                action.setShortcut(key)
                action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            action.triggered.connect(lambda _checked=False, do=do: do())
            self._actions[name] = action
            self.addAction(action)
            if icon:
                set_icon(action, icon)
                button = QToolButton()
                button.setDefaultAction(action)
                button.setFixedSize(32, 32)
                button.setAccessibleName(title)
                column.addWidget(button)
        column.addStretch(1)
        for view in (self.eye, self.outside):
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            view.addActions(list(self._actions.values()))
        right = QVBoxLayout()
        right.setContentsMargins(0, 0, 0, 0)
        right.setSpacing(0)
        right.addWidget(self.views, 1)
        right.addWidget(self.strip)
        whole = QHBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(bar)
        whole.addLayout(right, 1)
        self.setFocusProxy(self.eye)
        KeysWhileSeen(self, self._actions.values())

    def _commands(self) -> list[Command]:
        """Name, title, icon, key and what is done; those without an icon are in the menu only."""
        say, looking = self.say, self.looking
        return [
            ("both", _("Picture and outside view"), "columns", "", partial(self.show_beside, "both")),
            ("picture", _("The picture alone"), "image", "", partial(self.show_beside, "eye")),
            ("outside", _("The outside view alone"), "cube", "", partial(self.show_beside, "outside")),
            ("faces", _("Faces, edges or both"), "circle-half", "", self.next_shows),
            ("zoom_in", _("Zoom in"), "magnifying-glass-plus", "Ctrl++", lambda: self.focused.zoom(1.25)),
            ("zoom_out", _("Zoom out"), "magnifying-glass-minus", "Ctrl+-", lambda: self.focused.zoom(0.8)),
            ("fit", _("Fit the scene"), "frame-corners", "Ctrl+0", self.fit),
            ("home", _("Back to the view of the document"), "house-simple", "", self.go_home),
            ("front", _("Look from the front (1)"), "", "", lambda: say(looking.face("front"))),
            ("right", _("Look from the right (3)"), "", "", lambda: say(looking.face("right"))),
            ("top", _("Look from above (7)"), "", "", lambda: say(looking.face("top"))),
            ("switch", _("Perspective or parallel (5)"), "", "", self.switch),
            ("keep", _("Keep this view"), "", "", lambda: say(looking.keep())),
        ]

    @property
    def _beside(self) -> tuple[QWidget, ...]:
        return self.objects, self.family, self.tables

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A dock that comes to be seen shows what happened while it was hidden."""
        if event.type() == QEvent.Type.Show and not self.isVisible():
            self.refresh_soon()
        return super().eventFilter(watched, event)

    def _connect(self) -> None:
        session, eye = self.session, self.eye
        for part in self._beside:
            part.installEventFilter(self)
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed):
            told.connect(self._follow)
            told.connect(self.refresh_soon)
        eye.turned.connect(lambda theta, phi: self.say(self.looking.orbit(theta, phi)))
        for view in (eye, self.outside):
            view.switched.connect(self.switch)
            view.failed.connect(self.hover_text)
        eye.faced.connect(lambda side: self.say(self.looking.face(side)))
        self.outside.faced.connect(self.outside.face)
        eye.clicked.connect(partial(self._pick, eye))
        self.outside.clicked.connect(partial(self._pick, self.outside))
        eye.vanishing_moved.connect(
            lambda axis, x, y, pinned: self.say(self.looking.vanish(axis, (x, y), pinned))
        )
        eye.turn_ended.connect(self._follow)
        eye.turn_ended.connect(self.refresh_soon)
        eye.view_changed.connect(self._view_changed)
        self.card.chosen.connect(self.choose)
        self.family.tree.chosen.connect(self.choose)
        for part in (self.card, self.strip, self.objects):
            part.said.connect(self.hover_text)
        self.objects.added.connect(lambda _id: self.eye.fit())

    # What the panel is told

    @property
    def widget(self) -> QWidget:
        """Itself."""
        return self

    def docks(self) -> Sequence[DockPart]:
        """Objects, the family of projections, polygon tables."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (
            ("objects", _("Objects"), self.objects, right),
            ("family", _("Family"), self.family, right),
            ("polygon_tables", _("Tables"), self.tables, right),
        )

    def commands(self) -> Sequence[QAction]:
        """All that the tools and the menu of the views have."""
        return list(self._actions.values())

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def point_at(self, cell: Cell | None) -> None:
        """Its sentences name no pixels."""

    def say(self, sentence: str) -> None:
        """Say something in the status bar."""
        self.hover_text.emit(sentence)

    # Looking

    @property
    def focused(self) -> EyeView | OutsideView:
        """The view that has the focus, else the picture."""
        return self.outside if self.outside.hasFocus() or self.eye.isHidden() else self.eye

    def choose(self, slug: str) -> None:
        """Give the scene another projection."""
        self.say(self.looking.choose(slug, _("Change the projection")))
        self.eye.keeps_fit = True

    def switch(self) -> None:
        """Exchange perspective and parallel projection, from the same place."""
        camera = self.looking.camera
        other = "orthographic" if camera.projection == "perspective" else "perspective"
        self.say(self.looking.look(replace(camera, projection=other)))
        self.eye.keeps_fit = True
        self._kept = None

    def go_home(self) -> None:
        """See the scene as the document has it, and all of it."""
        self.say(self.looking.look(None))
        self.eye.keeps_fit = True
        self.outside.stand_aside()
        self._kept = None
        self.refresh_soon()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that the views left step the run."""
        do = None if event.modifiers() else stepping_keys(self.session.run).get(event.key())
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    def fit(self) -> None:
        """Show all of the scene in the view that has the focus."""
        self.focused.fit()

    def next_shows(self) -> None:
        """From faces and edges to edges, to faces, and back."""
        following = {"both": "edges", "edges": "faces", "faces": "both"}[self.eye.shows]
        for view in (self.eye, self.outside):
            view.set_shows(following)  # type: ignore[arg-type]

    def show_beside(self, which: str) -> None:
        """Show the picture, the outside view, or both."""
        self.beside = which
        self._arrange()

    def _arrange(self) -> None:
        """Side by side; one above the other where the room is taller than wide; one where it is narrow."""
        area = self.views
        upright = area.height() > area.width()
        area.setOrientation(Qt.Orientation.Vertical if upright else Qt.Orientation.Horizontal)
        alone = self.beside == "both" and area.width() < _LEAST_BESIDE_PX and not upright
        empty = not self.eye.scene.objects
        self.eye.setVisible(empty or self.beside != "outside")
        self.outside.setVisible(not empty and self.beside != "eye" and not alone)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the views anew."""
        super().resizeEvent(event)
        self._arrange()

    # Showing

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen.

        Its docks are seen beside the other pages too.
        """
        if not self._waiting and any(part.isVisible() for part in (self, *self._beside)):
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        if self.isVisible():
            self._say_scale()
        scene = self.looking.scene or Scene()
        chosen = self.session.state.thing
        self.eye.vertex = self.vertex()
        self.eye.show_scene(scene, chosen)
        kept = self.session.sheet.scene
        anew = kept is not self._kept
        if anew:
            self._kept = kept
            if self.eye.keeps_fit:
                self.eye.fit()
            self._show_outside()
            self.outside.stand_aside()
        self._show_outside()
        if not self.eye.dragging or anew:
            self._refresh_rest(anew)
        elif not self._rest.isActive():
            self._rest.start()

    def _refresh_rest(self, anew: bool = False) -> None:
        """Show beside the picture what it is seen by; during a drag less often than that."""
        self._rest.stop()
        scene, chosen = self.eye.scene, self.session.state.thing
        self.strip.show_camera(scene.camera, anew)
        self.card.show_camera(scene.camera, self.looking.around)
        self.family.show_camera(scene.camera, self.card.kind.currentData() or "")
        self.objects.show_scene(scene, chosen)
        self.tables.show_object(next((each for each in scene.objects if each.id == chosen), None))
        self.empty.setVisible(not scene.objects)
        self.strip.setVisible(bool(scene.objects))
        self.card.setVisible(bool(scene.objects))
        self._arrange()

    def _show_outside(self) -> None:
        eye = self.eye
        self.outside.show_seen(eye.scene, eye.window_world, eye.vertex, eye.chosen)

    def _view_changed(self, _scale: float) -> None:
        self._say_scale()
        self._show_outside()

    def _say_scale(self) -> None:
        self.zoom_text.emit(_("{scale:.3g} px a unit").format(scale=self.eye.scale))

    def vertex(self) -> Vertex | None:
        """The vertex that is stepped, where it is in the world."""
        subject = self.session.subject
        if not is_of_a_vertex(subject) or self.session.state.workspace != "space":
            return None
        chosen = vertex_of(self.session.sheet, subject)
        if chosen is None or not chosen[0].visible:
            return None
        thing, number = chosen
        x, y, z, _w = (thing.matrix if thing.matrix is not None else np.eye(4)) @ [
            *thing.mesh.vertices[number],
            1.0,
        ]
        return Vertex(thing.id, number, (float(x), float(y), float(z)))

    # Choosing

    def _pick(self, view: EyeView | OutsideView, position: QPointF) -> None:
        """A vertex of the picture is stepped; else the object there is chosen."""
        vertex = self.eye.vertex_at(position) if view is self.eye else None
        if vertex is not None:
            subject = Subject(KIND, (vertex.thing,), arguments={"vertex": vertex.number})
            self.session.update_state(thing=vertex.thing, subject=subject, step=0)
            self._follow()
            return
        ratio = view.devicePixelRatioF()
        x, y = position.x() * ratio - 0.5, view.device_size[1] - 0.5 - position.y() * ratio
        name = object_at(view.scene, view.device_size, view.window_world, x, y)
        self.session.update_state(thing=name)

    def _follow(self, *_changes: object) -> None:
        """The run goes through the matrices that the scene is seen by."""
        session = self.session
        subject, scene = session.state.subject, session.sheet.scene
        if not self.isVisible() or self.eye.dragging or not is_of_a_vertex(subject) or scene is None:
            return
        kept = {name: value for name, value in subject.arguments.items() if name == "vertex"}
        wanted = {**kept, **(seen_from(self.looking.camera) if self.looking.around else {})}
        if wanted != subject.arguments:
            session.update_state(subject=replace(subject, arguments=wanted))

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh()
