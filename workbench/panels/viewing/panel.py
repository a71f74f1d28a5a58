"""The View workspace: a window in the world and the viewport on the device that shows it, side by side."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import (
    QAction,
    QKeyEvent,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import QFrame, QHBoxLayout, QMenu, QVBoxLayout, QWidget

from workbench.algorithms.marks import Mark
from workbench.algorithms.viewing.window_to_viewport_point import alike
from workbench.document.errors import DocumentError
from workbench.document.model import Rectangle, View
from workbench.document.subjects import Subject
from workbench.document.view_edits import set_window, zoom
from workbench.exchange.diagrams import Derivation
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.panel import DockPart, KeysWhileSeen, PlainPanel, Said
from workbench.panels.stage.export import Exporter
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.labels import clear_of
from workbench.panels.viewing.actions import view_actions
from workbench.panels.viewing.card import ViewCard, factors_of
from workbench.panels.viewing.derivation import derivation
from workbench.panels.viewing.gestures import ViewGesture, tools
from workbench.panels.viewing.matrices import Matrices
from workbench.panels.viewing.paper import ViewOnPaper
from workbench.panels.viewing.picture import StagePicture
from workbench.panels.viewing.point import PointCard
from workbench.panels.viewing.stages import Geometry, frame_map, plane_of, stages, world_box
from workbench.panels.viewing.strip import StageStrip
from workbench.rendering.emissions import emitted
from workbench.rendering.extent import world_extent
from workbench.rendering.mapping import Box
from workbench.rendering.subjects.registry import calls_of
from workbench.rendering.subjects.window import (
    KIND,
    Point,
    is_through_a_window,
    parted,
    point_of,
    view_of,
)
from workbench.session.session import Session
from workbench.widgets.look.split import Split
from workbench.widgets.look.tokens import theme_changed, tokens

EXAMPLE = "view-house"
TOOL_BAR_PX = 44
LOW_PX, NARROW_PX = 420, 560
_ZOOM = 1.25
_FINER = 10
_ALT, _SHIFT = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.ShiftModifier


class ViewingPanel(PlainPanel, QWidget):
    """Strip, two pictures and the matrices in the middle; the view in numbers and the point in docks."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    slug = "view"
    usual = Subject(KIND)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.title = _("View")
        self._waiting = False
        self._kept_box: Box | None = None
        self._stages = {stage.slug: stage for stage in stages()}
        self._tools = {tool.name: tool for tool in tools()}
        self.tool = "select"
        self.gesture = ViewGesture(session)
        self.strip = StageStrip(tuple(self._stages.values()))
        self.left = StagePicture(self._stages["window"])
        self.right = StagePicture(self._stages["viewport"])
        self.card = ViewCard(session)
        self.point = PointCard()
        self.matrices = Matrices(session, self.card)
        self.exporter = self.paper = Exporter(ViewOnPaper(self), self)
        self.paper.said.connect(self.hover_text)
        self._lay_out()
        self._actions = view_actions(self, self._bar)
        KeysWhileSeen(self, self._actions.values())
        self._connect()
        self.choose_tool("select")

    def _lay_out(self) -> None:
        self._bar = QFrame()
        self._bar.setFixedWidth(TOOL_BAR_PX)
        split = Split(Qt.Orientation.Horizontal)
        split.addWidget(self.left)
        split.addWidget(self.right)
        split.setSizes([1000, 1000])
        middle = QVBoxLayout()
        middle.setContentsMargins(0, 0, 0, 0)
        middle.setSpacing(0)
        middle.addWidget(self.strip)
        middle.addWidget(split, 1)
        middle.addWidget(self.matrices)
        whole = QHBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self._bar)
        whole.addLayout(middle, 1)
        self.setFocusProxy(self.left)
        self.empty = Invitation(self.left.plane, _("Nothing in the world."), self.show_example)
        self.empty.button.setText(_("Show the house"))

    def _connect(self) -> None:
        session = self.session
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, session.unfolding.grown, theme_changed):
            told.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown, session.run.asked):
            signal.connect(self.refresh_soon)
        session.path_changed.connect(self._take_run)
        self.strip.opened.connect(self.open_stage)
        for picture in (self.left, self.right):
            plane = picture.plane
            plane.pressed.connect(partial(self._press, picture))
            plane.moved.connect(partial(self._move, picture))
            plane.released.connect(partial(self._release, picture))
            plane.turned.connect(partial(self._turn, picture))
            plane.arrow.connect(partial(self._arrow, picture))
            plane.cancelled.connect(self._cancel)
            plane.hovered.connect(partial(self._hover, picture))
            plane.hover_left.connect(lambda: self.hover_text.emit(""))
            plane.shape_at = partial(self._shape, picture)
            plane.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            plane.addActions(list(self._actions.values()))
        self.gesture.failed.connect(self.hover_text)
        self.card.said.connect(self.hover_text)
        self.matrices.copied.connect(self.hover_text)
        self.matrices.changed.connect(self.refresh_soon)
        self.point.sent.connect(lambda x, y: self.gesture.send((x, y)))
        self.point.figure_wanted.connect(lambda: self.gesture.send(None))

    # What the window places

    @property
    def center(self) -> QWidget:
        """What fills the middle of the workspace."""
        return self

    def docks(self) -> Sequence[DockPart]:
        """The view in numbers, and the point."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return [("viewing", _("View"), self.card, right), ("point", _("The point"), self.point, right)]

    def actions(self) -> list[QAction]:
        """Every command of this panel."""
        return list(self._actions.values())

    def said(self) -> Said:
        """What is under the pointer or said in passing, and the zoom."""
        return Said(self.hover_text, self.zoom_text)

    def show_example(self) -> None:
        """Open the house in two viewports."""
        self.session.open_example(EXAMPLE)

    def derivation(self) -> Derivation:
        """The view on a page: both pictures, its matrices, and the way of the point that is looked at."""
        return derivation(self.session.sheet, self.view, self._point_now())

    def copy(self) -> bool:
        """Put both pictures on the clipboard, side by side as they are seen."""
        self.paper.copy_picture()
        return True

    def offer_export(self, menu: QMenu) -> None:
        """Let the menus of both pictures lead to what can be exported."""
        for picture in (self.left, self.right):
            picture.plane.addAction(menu.menuAction())

    # What is shown

    @property
    def view(self) -> View:
        """The view that is worked on."""
        return view_of(self.session.sheet, self.session.subject)

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened, once; unseen, when it is seen."""
        if not self._waiting and self.isVisible():
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        sheet, view = self.session.shown, view_of(self.session.shown, self.session.subject)
        before = self.gesture.before if self.gesture.busy else self.matrices.before
        if self._kept_box is None or before is None:
            self._kept_box = world_box(sheet, view)
        geometry = Geometry(sheet, view, self._kept_box, tokens())
        world, device = parted(self.marks())
        for picture in (self.left, self.right):
            stage = picture.stage
            marks = {"world": world, "device": device, "normalised": ()}[stage.frame]
            own = marks if stage.rectangle else ()
            plane = plane_of(stage, geometry, own, self.gesture.held)
            grips = [(handle.x, handle.y) for handle in plane.handles]
            picture.plane.set_plane(
                replace(plane, drawn=(*clear_of(plane.drawn, grips, picture.plane.unit),))
            )
        self.strip.show_geometry(geometry, at_leisure=before is not None)
        self.strip.show_open((self.left.stage.slug, self.right.stage.slug))
        self.card.refresh(before)
        if self.isVisible():
            sx, sy = factors_of(view)
            self.zoom_text.emit(
                _("{sx:.3g} × {sy:.3g} px per unit").format(sx=sx, sy=sy)
                if not alike(sx, sy)
                else _("{s:.3g} px per unit").format(s=sx)
            )
        self.matrices.refresh(view, before)
        clicked = point_of(self.session.subject)
        self.point.show_point(view, self._point_now(), clicked is not None)
        self.empty.setVisible(not sheet.figures and not self.gesture.busy)

    def _stepping(self) -> bool:
        run, subject = self.session.run, self.session.subject
        own = is_through_a_window(subject) and run.subject == subject  # else another workspace is entered
        return own and run.step is not None and (run.number > 0 or run.waiting)

    def marks(self) -> tuple[Mark, ...]:
        """What the step, or the point that was clicked, draws in world and device."""
        session, run = self.session, self.session.run
        dragging = self.gesture.busy or self.matrices.before is not None
        if self._stepping() and not dragging:
            return tuple(run.marks())
        calls = calls_of(session.sheet, session.subject)
        number = self._number()
        if number is None or number >= len(calls) or session.state.ask_first:
            return ()
        call = calls[number]
        return tuple(call.entry.marks(call.arguments, {}, emitted(call), True))

    def _number(self) -> int | None:
        """Which of the points is looked at."""
        if not is_through_a_window(self.session.subject):
            return None
        if self._stepping():
            own = self.session.run.own_call()
            return None if own is None else own.number
        return None if point_of(self.session.subject) is None else 0

    def _point_now(self) -> Point | None:
        """The point that is looked at, in the world."""
        number = self._number()
        calls = calls_of(self.session.sheet, self.session.subject)
        if number is None or number >= len(calls):
            return None
        x, y = calls[number].arguments[:2]
        return float(x), float(y)

    def open_stage(self, slug: str, right: bool) -> None:
        """Open a stage at the left or the right; where the other has it they change places."""
        here, other = (self.right, self.left) if right else (self.left, self.right)
        if other.stage.slug == slug:
            other.set_stage(here.stage)
        here.set_stage(self._stages[slug])
        self.refresh()

    # Gestures

    def choose_tool(self, name: str) -> None:
        """Take up a tool."""
        self.tool = name
        for each in self._tools:
            self._actions[each].setChecked(each == name)

    def _press(self, picture: StagePicture, x: float, y: float, grip: str) -> None:
        self._take_run()
        self.session.run.hold()
        plane = picture.plane
        self.gesture.press(picture.stage, self.tool, x, y, grip, plane.reach, plane.grid)
        self.refresh_soon()

    def _move(self, picture: StagePicture, x: float, y: float) -> None:
        self._hover(picture, x, y)
        self.gesture.move(x, y)
        picture.plane.set_tag(self.gesture.tag)
        self.refresh_soon()

    def _release(self, picture: StagePicture, x: float, y: float) -> None:
        drew = self.gesture.held.startswith("band/")
        self.gesture.release(x, y)
        picture.plane.set_tag("")
        self.session.run.go_on()
        if drew:
            self.choose_tool("select")
        self.refresh()

    def _cancel(self) -> None:
        """Escape: what is being dragged, else the tool."""
        if self.gesture.busy:
            self.gesture.cancel()
            self.session.run.go_on()
            for picture in (self.left, self.right):
                picture.plane.set_tag("")
        else:
            self.choose_tool("select")
        self.refresh()

    def _shape(self, picture: StagePicture, x: float, y: float, grip: str) -> Qt.CursorShape:
        return self.gesture.shape(picture.stage, self.tool, x, y, grip, picture.plane.reach)

    def _hover(self, picture: StagePicture, x: float, y: float) -> None:
        where = {
            "world": _("({x}, {y}) in the world"),
            "normalised": _("({x}, {y}) in the unit square"),
            "device": _("({x}, {y}) on the device"),
        }[picture.stage.frame]
        self.hover_text.emit(where.format(x=displayed(float(f"{x:.4g}")), y=displayed(float(f"{y:.4g}"))))

    def _turn(self, picture: StagePicture, notches: float, x: float, y: float) -> None:
        """The wheel changes the window about the place in the world that is pointed at."""
        scale = frame_map(self.view, picture.stage.frame)
        self._zoom(_ZOOM**notches, *scale.world_point(x, y))

    def zoom(self, steps: int) -> None:
        """Nearer or farther about the middle of the window."""
        window = self.view.window_world
        self._zoom(_ZOOM**steps, (window.xmin + window.xmax) / 2, (window.ymin + window.ymax) / 2)

    def _zoom(self, factor: float, x: float, y: float) -> None:
        self._try(lambda: self.session.apply(zoom(self.view.id, factor, x, y), _("Zoom"), "zoom in View"))

    def fit(self) -> None:
        """A window around everything, a little larger."""
        extent = world_extent(self.session.sheet)
        if extent is None:
            self.hover_text.emit(_("The world is empty, so there is nothing to put a window around."))
            return
        room = 0.05 * max(extent[2] - extent[0], extent[3] - extent[1], 1e-3)
        sides = extent[0] - room, extent[1] - room, extent[2] + room, extent[3] + room
        window = Rectangle(*(round(side, 6) for side in sides))
        self._try(lambda: self.session.apply(set_window(self.view.id, window), _("Show everything")))

    def _try(self, do: object) -> None:
        try:
            do()  # type: ignore[operator]
        except DocumentError as problem:
            self.hover_text.emit(problem.short)

    def _arrow(self, picture: StagePicture, dx: int, dy: int, keys: Qt.KeyboardModifier) -> None:
        """Arrows move the rectangle of the picture that has the focus, Alt resizes it, Shift goes farther."""
        if not picture.stage.rectangle:
            return
        step = picture.plane.grid / (1 if keys & _SHIFT else _FINER)
        self.gesture.nudge(picture.stage, dx, dy, bool(keys & _ALT), step)

    # The keys and the window

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Home, End and Space for the run."""
        run = self.session.run
        keys = {Qt.Key.Key_Home: run.first, Qt.Key.Key_End: run.last, Qt.Key.Key_Space: run.toggle_play}
        plain = not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        do = keys.get(Qt.Key(event.key())) if plain else None
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    def _take_run(self) -> None:
        """Step what is stepped here, when this panel comes to be seen, or another document under it."""
        if self.isVisible():
            self.session.visit(self.slug, self.usual)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Low, the strip is names only and the matrices are numbers only."""
        super().resizeEvent(event)
        low = event.size().height() < LOW_PX
        self.strip.set_low(low)
        self.matrices.symbols.setVisible(not low and event.size().width() >= NARROW_PX)
        self.refresh_soon()

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self._take_run()
        self.refresh()
