"""The page Projection: what the eye sees, the same from outside, and the matrices between them."""

from collections.abc import Sequence
from functools import partial

from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QKeyEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _, reason_of
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.camera_card import CameraCard
from workbench.panels.space.contrast_dock import ContrastDock
from workbench.panels.space.derivation import derivation
from workbench.panels.space.derivation_dock import DerivationDock
from workbench.panels.space.eye_view import EyeView
from workbench.panels.space.family_dock import FamilyDock
from workbench.panels.space.looking import Looking
from workbench.panels.space.matrix_strip import MatrixStrip
from workbench.panels.space.morph import Morph
from workbench.panels.space.named_views import NamedViewsDock
from workbench.panels.space.object_clipboard import copy_chosen, object_held, paste_object
from workbench.panels.space.object_handles import MODES, title_of_mode
from workbench.panels.space.objects_dock import ObjectsDock
from workbench.panels.space.outside_view import OutsideView
from workbench.panels.space.pointing import Pointing
from workbench.panels.space.polygon_tables import PolygonTablesView
from workbench.panels.space.scene_picture import sentence_of
from workbench.panels.space.side_by_side import SideBySide
from workbench.panels.space.solids_offered import offers
from workbench.panels.space.stepped import clipped_so_far, vertex_on_its_way
from workbench.panels.space.stepping_choice import SteppingChoice
from workbench.panels.space.view_commands import ViewCommands
from workbench.panels.space.view_cube import SIDE_PX, ViewCube
from workbench.panels.space.view_tools import ViewTools, tools_of
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.subjects.projection import KIND, clips, is_of_a_vertex, seen_from
from workbench.session.session import Session
from workbench.widgets.stepping.step_bar import stepping_key

_CARD_GAP_PX, _REST_MS = 8, 50


class ProjectionPage(ViewCommands, PlainPage, QWidget):
    """``hover_text``: said in passing; ``zoom_text``: the scale."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)
    example = "space-house"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.looking = Looking(session)
        self.eye = EyeView()
        self.outside = OutsideView(self.eye)
        for view in (self.eye, self.outside):
            session.opened.connect(view.begin_anew)
        self.strip = MatrixStrip(self.looking)
        self.card = CameraCard(self.looking, self.eye)
        self.card.move(_CARD_GAP_PX, _CARD_GAP_PX)
        self.cube = ViewCube(self.eye)
        self.pointing = Pointing(self.looking, self.eye, self.outside, self)
        self.stepping = SteppingChoice(session, self.outside)
        self.stepping.move(_CARD_GAP_PX, _CARD_GAP_PX)
        self.objects = ObjectsDock(session)
        self.family = FamilyDock()
        self.named_views = NamedViewsDock(self.looking)
        self.tables_view = PolygonTablesView()
        self.contrast = ContrastDock()
        self.derived = DerivationDock()
        self.empty = Invitation(
            self.eye,
            _("There is nothing to look at yet."),
            partial(self.objects.add_solid, offers()[0]),
            _("Add a house"),
            _("Put a house into the scene"),
        )
        self.empty.hide()
        self._lay_out()
        self._waiting = False
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._show_outside)
        self._rest.timeout.connect(self._refresh_rest)
        self._kept: Scene | None = None
        self.morph = Morph(self)
        self._connect()
        self.refresh()

    def _lay_out(self) -> None:
        self.views = SideBySide(self.eye, self.outside)
        self.tools = ViewTools(tools_of(self), self)
        self._actions = self.tools.actions_by_name
        self.tools.add_named_views(self.named_views.commands, self.named_views.menu)
        self.addActions(self.named_views.commands)
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
        KeysWhileSeen(self, [*self._actions.values(), *self.objects.commands])

    @property
    def _beside(self) -> tuple[QWidget, ...]:
        return self.objects, self.family, self.named_views, self.tables_view, self.contrast, self.derived

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
        self.morph.valueChanged.connect(self.refresh_soon)
        self.morph.finished.connect(self._arrive)
        for told in (eye.resized, self.card.refitted):
            told.connect(self._place_cube)
        eye.pictured.connect(self.cube.show_camera)
        self.cube.chosen.connect(self.glance)
        self.pointing.said.connect(self.hover_text)
        self.pointing.stepped.connect(self._follow)
        for view in (eye, self.outside):
            view.switched.connect(self.switch)
            view.failed.connect(self.hover_text)
        eye.faced.connect(self.face)
        self.outside.faced.connect(self.outside.face)
        eye.vanishing_moved.connect(
            lambda axis, x, y, pinned: self.say(self.looking.vanish(axis, (x, y), pinned))
        )
        eye.turn_ended.connect(self._follow)
        eye.turn_ended.connect(self.refresh_soon)
        self.outside.camera_moved.connect(lambda camera: self.say(self.looking.look(camera)))
        self.outside.light_moved.connect(lambda light, at: self.say(self.looking.move_light(light, at)))
        self.outside.move_ended.connect(session.end_merge)
        self.outside.move_ended.connect(self._follow)
        self.outside.move_ended.connect(self._show_outside)
        for told in (session.run.changed, session.run.moved, session.run.grown):
            told.connect(self.refresh_soon)
        eye.view_changed.connect(self._view_changed)
        self.card.chosen.connect(self.choose)
        self.card.turned_over.connect(self.refresh_soon)
        self.card.towards_eye.toggled.connect(self._actions["z_towards_eye"].setChecked)
        self.family.tree.chosen.connect(self.choose)
        for part in (self.card, self.strip, self.objects, self.named_views):
            part.said.connect(self.hover_text)
        self.objects.added.connect(lambda _id: self.eye.fit())
        for part in (self.contrast, self.derived):
            part.looked.connect(self.look)
        self.named_views.wanted.connect(self.go_to)
        self.derived.said.connect(self.hover_text)
        for view in (eye, self.outside):
            self.contrast.marked.connect(view.mark)
            self.tables_view.marked.connect(view.mark)
        self.tables_view.in_sight.changed.connect(lambda seen: setattr(self.pointing, "follows", seen))
        self.pointing.pointed.connect(self.tables_view.show_part)

    # What the panel is told

    def docks(self) -> Sequence[DockPart]:
        """Objects, the family of projections, named views, polygon tables."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (
            ("objects", _("Objects"), self.objects, right),
            ("family", _("Family"), self.family, right),
            ("named_views", _("Views"), self.named_views, right),
            ("polygon_tables", _("Tables"), self.tables_view, right),
            ("derivation", _("Derivation"), self.derived, right),
            ("contrast", _("Compare"), self.contrast, right),
        )

    def commands(self) -> Sequence[QAction]:
        """All that the tools and the menus of views and objects have."""
        return [*self._actions.values(), *self.objects.commands]

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The polygon tables of the chosen object, and the comparison of projections."""
        return [*self.tables_view.content(), *self.contrast.content()]

    def copy(self) -> bool:
        """Put the chosen object on the clipboard, or with none chosen the picture."""
        self.say(copy_chosen(self.session, self.eye))
        return True

    def paste(self) -> bool:
        """Put the clipboard's object into the scene; False where it has none."""
        if not object_held():
            return False
        self.say(paste_object(self.session))
        return True

    def derivation(self) -> Derivation | None:
        """Its picture, the similar triangles, its matrices, and what it keeps; None where nothing is seen."""
        scene = self.looking.scene
        try:
            return None if scene is None else derivation(scene, vertex_on_its_way(self.session))
        except ValueError as error:
            self.say(reason_of(error))
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

    def switch_trackball(self) -> None:
        """Turn freely, or on a turntable that keeps the horizon level."""
        self.looking.trackball = self._actions["trackball"].isChecked()

    def switch_z(self) -> None:
        """Write V and P as the book has them, z towards the eye, or as we do."""
        self.card.towards_eye.setChecked(self._actions["z_towards_eye"].isChecked())

    def _place_cube(self) -> None:
        """At the top right, or below where the card leaves no room there; the choice of steps likewise."""
        beside = self.card.x() + self.card.width() + SIDE_PX + 8 <= self.eye.width()
        self.cube.move(self.eye.width() - SIDE_PX - 4, 4 if beside else self.eye.height() - SIDE_PX - 4)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that the views left step the run."""
        do = stepping_key(self.session.run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    def fit(self) -> None:
        """Show all of the scene in the view that has the focus."""
        self.focused.fit()

    def zoom(self, factor: float) -> None:
        """Show what the view with the focus shows ``factor`` times as large."""
        self.focused.zoom(factor)

    def next_shows(self) -> None:
        """From faces and edges to edges, to edges without hidden lines, to faces, and back."""
        following = self.eye.next_shows
        for view in (self.eye, self.outside):
            view.set_shows(following)
        self.say(sentence_of(following))

    def next_mode(self) -> None:
        """Handles to move, to turn, to scale the chosen object, or none; the first object where none is."""
        following = MODES[(MODES.index(self.eye.mode) + 1) % len(MODES)]
        things = [thing.id for thing in self.eye.scene.objects if thing.visible]
        if things and self.session.state.thing not in things:
            self.session.update_state(thing=things[0])
        self.eye.set_mode(following)
        words = _("{what}: drag a handle; with Shift all axes are scaled.")
        self.say(words.format(what=title_of_mode(following)) if following else "")

    def show_beside(self, which: str) -> None:
        """Show the picture, the outside view, or both."""
        self.views.show_views(which, not self.eye.scene.objects)

    def _arrange(self) -> None:
        self.show_beside(self.views.which)

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
        self.eye.vertex = vertex_on_its_way(self.session)
        self.outside.clipped = clipped_so_far(self.session)
        self.eye.show_scene(self.morph.through(scene), chosen)
        kept = self.session.sheet.scene
        anew = kept is not self._kept
        if (anew or self.morph.state() == self.morph.State.Running) and self.eye.keeps_fit:
            self.eye.fit()
        if anew:
            self._kept = kept
            self._show_outside()
            self.outside.stand_aside()
        turned = self.eye.dragging and not anew
        alone = turned and self.eye.is_large  # all beside the picture waits until the hand rests
        if not alone:
            self._show_outside()
        if not turned:
            self._refresh_rest(anew)
        elif alone or not self._rest.isActive():
            self._rest.start()

    def _refresh_rest(self, anew: bool = False) -> None:
        """Show beside the picture what it is seen by; during a drag less often than that."""
        self._rest.stop()
        scene, chosen = self.looking.scene or Scene(), self.session.state.thing
        self.strip.show_camera(scene.camera, anew)
        self.card.show_camera(scene.camera, self.looking.around)
        self.family.show_camera(scene.camera, self.card.kind.currentData() or "")
        self.named_views.show_scene(scene)
        self.cube.show_camera(scene.camera)
        self.contrast.show_scene(scene)
        self.stepping.refresh()
        self.derived.show_camera(scene.camera, self.eye.vertex, lambda: self.looking.radius)
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
        if clips(self.session.state.subject):
            self._follow()

    def _say_scale(self) -> None:
        self.zoom_text.emit(_("{scale:.3g} px per unit").format(scale=self.eye.scale))

    # The run

    def _follow(self, *_changes: object) -> None:
        """The run goes through the matrices that the scene is seen by, and clips to what is seen."""
        session = self.session
        subject, scene = session.state.subject, session.sheet.scene
        held = self.eye.dragging or self.outside.dragging or session.frames.playing
        if not self.isVisible() or held or not is_of_a_vertex(subject) or scene is None:
            return
        kept = {name: value for name, value in subject.arguments.items() if name == "vertex"}
        camera = self.looking.camera
        wanted = {**kept, **(seen_from(camera) if camera != scene.camera else {})}
        if clips(subject):
            seen = self.eye.window_world
            wanted["window"] = (seen.xmin, seen.ymin, seen.xmax, seen.ymax)
        chosen = session.state.thing
        ids = (chosen,) if chosen and clips(subject) else subject.ids
        if (ids, wanted) != (subject.ids, subject.arguments):
            session.update_state(subject=replace(subject, ids=ids, arguments=wanted))

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh()
