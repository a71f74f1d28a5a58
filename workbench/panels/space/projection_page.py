"""The page Projection: what the eye sees, the same from outside, and the matrices between them."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from workbench.document.scene.model import Camera, Point3D, Scene
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.camera_card import CameraCard
from workbench.panels.space.contrast_dock import ContrastDock
from workbench.panels.space.eye_view import EyeView, Vertex
from workbench.panels.space.family_dock import FamilyDock
from workbench.panels.space.looking import Looking
from workbench.panels.space.matrix_strip import MatrixStrip
from workbench.panels.space.objects_dock import ObjectsDock
from workbench.panels.space.outside_view import OutsideView
from workbench.panels.space.polygon_tables import PolygonTablesView
from workbench.panels.space.solids_offered import offers
from workbench.panels.space.view_cube import SIDE_PX, ViewCube
from workbench.panels.space.view_tools import Tool, ViewTools
from workbench.panels.stage.empty import EmptyState
from workbench.rendering.scene.picking import Pick, pick
from workbench.rendering.subjects.projection import KIND, is_of_a_vertex, seen_from, vertex_of
from workbench.session.session import Session
from workbench.widgets.stepping.step_bar import stepping_keys

_CARD_GAP_PX = 8
_LEAST_BESIDE_PX = 560


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
        self.cube = ViewCube(self.eye)
        self.objects = ObjectsDock(session)
        self.family = FamilyDock()
        self.tables_view = PolygonTablesView()
        self.contrast = ContrastDock()
        self.empty = EmptyState(
            self.eye,
            _("Nothing to look at."),
            partial(self.objects.add_solid, offers()[0]),
            _("Add a house"),
            _("Put a house into the scene"),
        )
        self.empty.hide()
        self.beside = "both"
        self._lay_out()
        self._waiting = False
        self._about: Point3D | None = None
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
        self.tools = ViewTools(self._commands(), self)
        self._actions = self.tools.actions_by_name
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
        whole.addWidget(self.tools)
        whole.addLayout(right, 1)
        self.setFocusProxy(self.eye)
        KeysWhileSeen(self, self._actions.values())

    def _commands(self) -> list[Tool]:
        say, looking = self.say, self.looking
        sides = (
            ("front", _("Look from the front"), "(1)"),
            ("back", _("Look from the back"), "(Ctrl+1)"),
            ("right", _("Look from the right"), "(3)"),
            ("left", _("Look from the left"), "(Ctrl+3)"),
            ("top", _("Look from above"), "(7)"),
            ("bottom", _("Look from below"), "(Ctrl+7)"),
        )
        return [
            Tool("both", _("Picture and outside view"), "columns", "", partial(self.show_beside, "both")),
            Tool("picture", _("The picture alone"), "image", "", partial(self.show_beside, "eye")),
            Tool("outside", _("The outside view alone"), "cube", "", partial(self.show_beside, "outside")),
            Tool("faces", _("Faces, edges or both"), "circle-half", "", self.next_shows),
            Tool("zoom_in", _("Zoom in"), "magnifying-glass-plus", "Ctrl++", lambda: self.focused.zoom(1.25)),
            Tool(
                "zoom_out", _("Zoom out"), "magnifying-glass-minus", "Ctrl+-", lambda: self.focused.zoom(0.8)
            ),
            Tool("fit", _("Fit the scene"), "frame-corners", "Ctrl+0", self.fit),
            Tool("home", _("Back to the view of the document"), "house-simple", "", self.go_home),
            *(Tool(side, title, "", key, partial(self.face, side)) for side, title, key in sides),
            Tool("isometric", _("Look from (1, 1, 1), isometric"), "", "", partial(self.glance, "isometric")),
            Tool("switch", _("Perspective or parallel"), "", "(5)", self.switch),
            Tool("trackball", _("Turn freely, as a trackball"), "", "", self.switch_trackball, False),
            Tool("keep", _("Keep this view"), "", "", lambda: say(looking.keep())),
        ]

    @property
    def _beside(self) -> tuple[QWidget, ...]:
        return self.objects, self.family, self.tables_view, self.contrast

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
        eye.turn_began.connect(self._begin_turn)
        eye.turned.connect(lambda theta, phi: self.say(self.looking.orbit(theta, phi, self._about)))
        eye.turn_ended.connect(self._end_turn)
        eye.framed.connect(self.centre_at)
        eye.resized.connect(self._place_cube)
        self.cube.chosen.connect(self.glance)
        for view in (eye, self.outside):
            view.switched.connect(self.switch)
            view.failed.connect(self.hover_text)
        eye.faced.connect(self.face)
        self.outside.faced.connect(self.outside.face)
        eye.clicked.connect(partial(self._pick, eye))
        self.outside.clicked.connect(partial(self._pick, self.outside))
        eye.vanishing_moved.connect(
            lambda axis, x, y, pinned: self.say(self.looking.vanish(axis, (x, y), pinned))
        )
        eye.turn_ended.connect(self._follow)
        eye.view_changed.connect(self._view_changed)
        self.card.chosen.connect(self.choose)
        self.family.tree.chosen.connect(self.choose)
        for part in (self.card, self.strip, self.objects):
            part.said.connect(self.hover_text)
        self.objects.added.connect(lambda _id: self.eye.fit())
        self.contrast.looked.connect(self.look)
        for view in (eye, self.outside):
            self.contrast.marked.connect(view.mark)

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
            ("polygon_tables", _("Tables"), self.tables_view, right),
            ("contrast", _("Compare"), self.contrast, right),
        )

    def commands(self) -> Sequence[QAction]:
        """All that the tools and the menu of the views have."""
        return list(self._actions.values())

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The polygon tables of the chosen object, and the comparison of projections."""
        return [*self.tables_view.content(), *self.contrast.content()]

    def derivation(self) -> Derivation | None:
        """None yet."""
        return None

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

    def face(self, side: str) -> None:
        """Stand before one of the six sides, and see all of the scene."""
        self.say(self.looking.face(side))
        self.eye.keeps_fit = True
        self._kept = None

    def glance(self, slug: str) -> None:
        """See the scene by another projection from where that is at its best; the document keeps its own."""
        self.say(self.looking.glance(slug))
        self.eye.keeps_fit = True
        self._kept = None

    def switch_trackball(self) -> None:
        """Turn freely, or on a turntable that keeps the horizon level."""
        self.looking.trackball = self._actions["trackball"].isChecked()

    def _begin_turn(self, position: QPointF) -> None:
        """A turn is about the point of the scene under the pointer, where there is one."""
        there = self._pick_at(self.eye, position)
        self._about = None if there is None else Point3D(*there.place)

    def _end_turn(self) -> None:
        self._about = None

    def centre_at(self, position: QPointF) -> None:
        """Look at the point of the scene that is there, and bring it into the middle."""
        there = self._pick_at(self.eye, position)
        if there is None:
            self.fit()
            return
        self.say(self.looking.centre(Point3D(*there.place)))
        self.eye.middle, self.eye.keeps_fit = (0.0, 0.0), False
        self.refresh_soon()

    def _place_cube(self) -> None:
        self.cube.move(self.eye.width() - SIDE_PX - 4, 4)

    def switch(self) -> None:
        """Exchange perspective and parallel projection, from the same place."""
        camera = self.looking.camera
        other = "orthographic" if camera.projection == "perspective" else "perspective"
        self.look(replace(camera, projection=other))

    def look(self, camera: Camera) -> None:
        """See all of the scene by another camera; the document keeps its own."""
        self.say(self.looking.look(camera))
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
        self.strip.show_camera(scene.camera, anew)
        self.card.show_camera(scene.camera, self.looking.around)
        self.family.show_camera(scene.camera, self.card.kind.currentData() or "")
        self.cube.show_camera(scene.camera)
        self.contrast.show_scene(scene)
        self.objects.show_scene(scene, chosen)
        self.tables_view.show_object(next((each for each in scene.objects if each.id == chosen), None))
        self.empty.setVisible(not scene.objects)
        self.strip.setVisible(bool(scene.objects))
        self.card.setVisible(bool(scene.objects))
        self.cube.setVisible(bool(scene.objects))
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
        there = self._pick_at(view, position)
        self.session.update_state(thing=there.thing if there else "")

    @staticmethod
    def _pick_at(view: EyeView | OutsideView, position: QPointF) -> Pick | None:
        ratio = view.devicePixelRatioF()
        x, y = position.x() * ratio - 0.5, view.device_size[1] - 0.5 - position.y() * ratio
        try:
            return pick(view.scene, view.device_size, view.window_world, x, y)
        except ValueError:  # what cannot be seen cannot be picked, and why is said already
            return None

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
