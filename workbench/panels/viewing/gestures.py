"""What a drag in one of the two pictures does to the view, and to the point that is sent through it."""

from collections.abc import Callable
from typing import NamedTuple

from PySide6.QtCore import Qt, Signal

from workbench.document.errors import DocumentError
from workbench.document.model import Rectangle, View
from workbench.document.view_edits import set_clip, set_window
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.stage.gesture import Gesture
from workbench.panels.viewing.rectangles import (
    SIDES,
    Named,
    between,
    inside,
    moved,
    rectangles,
    snapped,
    stretched,
)
from workbench.panels.viewing.stages import Stage, frame_map
from workbench.rendering.mapping import DeviceMap
from workbench.rendering.subjects.window import Point, at_point, point_of, view_of
from workbench.session.session import Session

POINT = "point"
_FINER = 10
_SLACK = 0.5
_CURSORS = {
    "left": Qt.CursorShape.SizeHorCursor,
    "right": Qt.CursorShape.SizeHorCursor,
    "top": Qt.CursorShape.SizeVerCursor,
    "bottom": Qt.CursorShape.SizeVerCursor,
    "left bottom": Qt.CursorShape.SizeBDiagCursor,
    "right top": Qt.CursorShape.SizeBDiagCursor,
    "left top": Qt.CursorShape.SizeFDiagCursor,
    "right bottom": Qt.CursorShape.SizeFDiagCursor,
}


class Tool(NamedTuple):
    """What a drag in the pictures does."""

    name: str
    title: str
    icon: str
    key: str
    tip: str


def tools() -> tuple[Tool, ...]:
    """In the order of the tool bar."""
    return (
        Tool("select", _("Select"), "cursor", "V", _("Drag a rectangle or its sides; click to send a point")),
        Tool("window", _("Window"), "selection", "W", _("Drag a new window over the world")),
        Tool("clip", _("Clip window"), "crop", "K", _("Drag a separate clip window over the world")),
        Tool("point", _("Point"), "crosshair-simple", "P", _("Send a point through, and drag it")),
        Tool("pan", _("Pan"), "hand", "H", _("Drag the world under the viewport: the window moves")),
    )


class ViewGesture(Gesture):
    """One drag. ``held`` names what is dragged, such as "window/left top" or "point"; empty without one.

    ``ended`` comes when it is over.
    """

    ended = Signal()

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self.held = ""
        self.before: View | None = None
        self._stage: Stage | None = None
        self._start: Point = (0.0, 0.0)
        self._step = 1.0
        self._map = DeviceMap(1.0, 1.0, 0.0, 0.0)
        self._point: Point | None = None
        self._clicks = False
        self._reach = 0.0

    @property
    def view(self) -> View:
        """The view that is worked on."""
        return view_of(self.session.sheet, self.session.subject)

    def press(
        self, stage: Stage, tool: str, x: float, y: float, grip: str, reach: float, grid: float
    ) -> None:
        """Take hold of what ``tool`` takes at a place (x, y) of a stage."""
        self.begin()
        view = self.view
        self.before, self._stage, self._start, self._reach = view, stage, (x, y), reach
        self._step = grid / _FINER
        self._map = frame_map(view, stage.frame)
        self._point = point_of(self.session.subject)
        self._clicks = False
        rectangle = self._rectangle(stage)
        if tool == "point" or self._on_point(x, y):
            self.held = POINT
        elif tool == "pan":
            self.held = "pan"
        elif tool in ("window", "clip") and stage.frame == "world":
            self.held = f"band/{tool}"
        elif grip:
            self.held = grip
        elif rectangle is not None and inside(rectangle, x, y, reach):
            side = _side_at(rectangle, x, y, reach)
            self.held = f"{stage.rectangle}/{side or 'whole'}"
            self._clicks = not side
        else:
            self.held, self._clicks = "nothing", True
        if tool == "point":
            self._send(x, y)

    def _rectangle(self, stage: Stage) -> Rectangle | None:
        return rectangles()[stage.rectangle].of(self.view) if stage.rectangle else None

    def _on_point(self, x: float, y: float) -> bool:
        if self._point is None:
            return False
        px, py = self._map.point(*self._point)
        return max(abs(px - x), abs(py - y)) <= 1.5 * self._reach

    def move(self, x: float, y: float) -> None:
        """Drag to a place of the stage."""
        if not self.busy or self.overtaken:
            return
        if self._clicks and max(abs(x - self._start[0]), abs(y - self._start[1])) <= _SLACK * self._reach:
            return
        self._clicks = False
        if self.held == POINT:
            self._send(x, y)
        elif self.held == "pan":
            self._pan(x, y)
        elif self.held.startswith("band/"):
            self._band(x, y)
        elif self.held != "nothing":
            self._drag(x, y)

    def _send(self, x: float, y: float) -> None:
        """Send the point under the pointer through, on a line of the fine grid."""
        at = snapped(x, self._step), snapped(y, self._step)
        self.send(self._map.world_point(*at))
        self.tag = ""

    def send(self, point: Point | None) -> None:
        """Send a point (world) through, or with None the points of the active figure again."""
        session = self.session
        fresh = (point_of(session.subject) is None) != (point is None)
        subject = at_point(session.state.subject, point)
        try:
            session.update_state(subject=subject, **({"step": 0} if fresh else {}))
        except DocumentError as problem:
            self.failed.emit(problem.short)

    def _pan(self, x: float, y: float) -> None:
        assert self.before is not None
        assert self._stage is not None
        dx, dy = self._map.world_way(self._start[0] - x, self._start[1] - y)
        if self._stage.frame == "world":
            dx, dy = -dx, -dy  # here the window is seen, and goes with the hand
        window = moved(self.before.window_world, dx, dy)
        self.show(set_window(self.before.id, window), _("Pan"))

    def _band(self, x: float, y: float) -> None:
        assert self.before is not None
        x0, y0, x1, y1 = (snapped(value, self._step) for value in (*self._start, x, y))
        rectangle = between(x0, y0, x1, y1, self._step)
        if rectangle is None:
            return
        if self.held == "band/window":
            self.show(set_window(self.before.id, rectangle), _("Draw the window"))
        else:
            self.show(set_clip(self.before.id, rectangle), _("Draw the clip window"))
        self.tag = extent(rectangle)

    def _drag(self, x: float, y: float) -> None:
        assert self.before is not None
        slug, _slash, grip = self.held.partition("/")
        named = rectangles()[slug]
        rectangle = named.of(self.before)
        if rectangle is None:
            return
        if grip == "whole":
            dx, dy = (
                snapped(end - start, self._step) for end, start in zip((x, y), self._start, strict=True)
            )
            new = moved(rectangle, dx, dy)
        else:
            new = stretched(rectangle, grip, snapped(x, self._step), snapped(y, self._step), self._step)
        self.show(named.edit(self.before.id, new), change_of(named))
        self.tag = extent(new)

    def release(self, x: float, y: float) -> None:
        """Let go; a click where nothing was dragged sends the point there."""
        if self._clicks and self.held:
            self._send(x, y)
        self._end()

    def cancel(self) -> None:
        """Bring back what was dragged."""
        super().cancel()
        if self.held == POINT:
            self.send(self._point)
        self._end()

    def _end(self) -> None:
        self.held = self.tag = ""
        self.before = None
        self.commit()
        self.ended.emit()

    def nudge(self, stage: Stage, dx: int, dy: int, resize: bool, step: float) -> None:
        """Move the rectangle of a stage, or its upper right corner, by so many steps."""
        rectangle = self._rectangle(stage)
        if rectangle is None:
            return
        named = rectangles()[stage.rectangle]
        if resize:
            x, y = rectangle.xmax + dx * step, rectangle.ymax + dy * step
            new = stretched(rectangle, "right top", x, y, step)
        else:
            new = moved(rectangle, dx * step, dy * step)
        try:
            self.session.apply(named.edit(self.view.id, new), change_of(named), f"nudge {stage.rectangle}")
        except DocumentError as problem:
            self.failed.emit(problem.short)

    def shape(self, stage: Stage, tool: str, x: float, y: float, grip: str, reach: float) -> Qt.CursorShape:
        """The pointer's shape over a place of a stage."""
        if tool == "pan":
            return Qt.CursorShape.OpenHandCursor
        if tool != "select":
            return Qt.CursorShape.CrossCursor
        rectangle = self._rectangle(stage)
        side = grip.partition("/")[2]
        if not side and rectangle is not None and inside(rectangle, x, y, reach):
            side = _side_at(rectangle, x, y, reach) or "whole"
        if side == "whole":
            return Qt.CursorShape.SizeAllCursor
        return _CURSORS.get(side, Qt.CursorShape.ArrowCursor)


def change_of(named: Named) -> str:
    """What a step of undo is called."""
    names = {
        "window": _("Change the window"),
        "clip": _("Change the clip window"),
        "viewport": _("Change the viewport"),
    }
    return names[named.slug]


def extent(rectangle: Rectangle) -> str:
    """From where to where a rectangle reaches."""
    return _("x {xmin} to {xmax}\ny {ymin} to {ymax}").format(
        **{side: displayed(getattr(rectangle, side)) for side in SIDES}
    )


def _side_at(rectangle: Rectangle, x: float, y: float, reach: float) -> str:
    """The side of a rectangle within ``reach`` of a point, if any."""
    away: dict[str, Callable[[], float]] = {
        "left": lambda: abs(x - rectangle.xmin),
        "right": lambda: abs(x - rectangle.xmax),
        "bottom": lambda: abs(y - rectangle.ymin),
        "top": lambda: abs(y - rectangle.ymax),
    }
    nearest = min(away, key=lambda side: away[side]())
    return nearest if away[nearest]() <= reach else ""
