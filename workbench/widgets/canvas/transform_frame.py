"""The seen half of the box around what is selected: its handles, where they are, and how they look."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QCursor

from workbench.algorithms.marks import Word
from workbench.geometry.transform_box import MOVE, PIVOT, SIDES, TURN, Box, Motion, Point
from workbench.widgets.canvas.drawing import Drawn, Marker, PenStroke
from workbench.widgets.canvas.overlay import GripShape, Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.transform_words import described, pivot_at

PIVOT_REACH_PX = 9.0
_REACH_PX = 12.0
_TURN_PX, _NEAR_TURN_PX, _CROSS_PX, _RING_PX = 28.0, 18.0, 10.0, 12.0
_GRIP_PX = 6
_LEAST_PX, _LONG_PX, _THICK_PX = 26.0, 52.0, 34.0
_TAG_PX = 12.0
_IDS = "box/"


class TransformFrame(QObject):
    """A box on ``canvas``, in device coordinates, with a pivot. ``looks_changed``: ask for ``over`` again.

    ``words`` and ``pivot_words`` say what a drag does, and where the pivot is: in pixels unless set.
    """

    looks_changed = Signal()

    def __init__(self, canvas: PixelCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._box: Box | None = None
        self._pivot: Point = (0.0, 0.0)
        self._chosen = MOVE
        self._held = ""
        self._start: Point = (0.0, 0.0)
        self._now: Point = (0.0, 0.0)
        self._moved = False
        self._motion: Motion | None = None
        self._shears = False
        self.words: Callable[[Motion], str] = described
        self.pivot_words: Callable[[float, float], str] = pivot_at

    @property
    def box(self) -> Box | None:
        """The box as it was before the drag under way."""
        return self._box

    @property
    def pivot(self) -> Point:
        """What is turned about."""
        return self._pivot

    @property
    def dragging(self) -> bool:
        """Whether a handle is held."""
        return bool(self._held)

    def set_box(self, box: Box | None, pivot: Point | None = None) -> None:
        """Show a box, with its pivot in the middle unless another is given; None shows none.

        While a handle is held the box of its beginning stays, for that is what ``changed`` speaks of.
        """
        if self._held and box is not None:
            return
        self._held = ""
        self._motion = None
        if box is None or self._box is None:
            self._chosen, self._shears = MOVE, False
        self._box = box
        if box is not None:
            self._pivot = pivot or box.centre
        self.looks_changed.emit()

    def over(self, overlay: Overlay) -> Overlay:
        """``overlay`` with the box on top."""
        if self._box is None:
            return overlay
        return replace(
            overlay,
            drawn=(*overlay.drawn, *self._drawn(self._box)),
            handles=(*overlay.handles, *self._handles(self._box)),
        )

    @property
    def _unit(self) -> float:
        """Device units of one logical pixel."""
        return 1 / (self._canvas.widget_position(1.0, 0.0).x() - self._canvas.widget_position(0.0, 0.0).x())

    def places(self) -> dict[str, Point]:
        """Where each handle is that can be grabbed: on a box too small for all, only some."""
        box = self._box
        if box is None:
            return {}
        unit = self._unit
        least = _LEAST_PX * unit
        # Handles of a small box stand off from it
        outer = box._replace(width=max(box.width, least), height=max(box.height, least))
        wide, high = box.width / unit, box.height / unit
        across, upright = _has_middle(wide, high), _has_middle(high, wide)
        sides = {
            name: outer.place(*side)
            for name, side in SIDES.items()
            if 0 not in side or (upright if side[0] else across)
        }
        stalks = [
            outer.place(0.0, way * (1.0 + 2 * long * unit / outer.height))
            for way in (1, -1)
            for long in (_TURN_PX, _NEAR_TURN_PX)
        ]
        places = {**sides, TURN: next(filter(self._in_sight, stalks), stalks[0])}
        if self._pivot != box.centre or max(wide, high) > _LONG_PX:
            places[PIVOT] = self._pivot
        return places

    def _in_sight(self, place: Point) -> bool:
        sight = self._canvas.rect().adjusted(_GRIP_PX, _GRIP_PX, -_GRIP_PX, -_GRIP_PX)
        return sight.contains(self._canvas.widget_position(*place).toPoint())

    def _after(self, point: Point) -> Point:
        """Where a point of the box is now, in the drag under way."""
        if self._motion is None:
            return point
        x, y, _one = self._motion.matrix @ np.array([*point, 1.0])
        return float(x), float(y)

    def _drawn(self, box: Box) -> list[Drawn]:
        unit, places = self._unit, self.places()
        corners = np.array([self._after((x, y)) for x, y in box.corners().tolist()], np.float64)
        drawn: list[Drawn] = [PenStroke(np.concatenate([corners, corners[:1]]), "accent", 1.25, "dash")]
        foot = min(box.place(0.0, 1.0), box.place(0.0, -1.0), key=lambda end: math.dist(end, places[TURN]))
        drawn.append(PenStroke(np.array([self._after(foot), self._after(places[TURN])]), "accent", 1.25))
        if self._held == TURN:
            spoke = np.array([self._now, self._pivot, self._start], np.float64)
            drawn.append(PenStroke(spoke, "muted", 1.0, "dash"))
        if PIVOT in places:
            x, y = self._after(self._pivot)
            arm = _CROSS_PX * unit
            drawn.append(Marker(x, y, "accent", "ring", _RING_PX))
            for ends in ([(x - arm, y), (x + arm, y)], [(x, y - arm), (x, y + arm)]):
                strong = PIVOT in (self._chosen, self._held)
                drawn.append(PenStroke(np.array(ends), "accent", 2.5 if strong else 1.5))
        if self._held and self._moved:
            text = self.pivot_words(*self._pivot) if self._held == PIVOT else ""
            text = self.words(self._motion) if self._motion is not None else text
            away = _TAG_PX * unit
            drawn.append(Word(text, self._now[0] + away, self._now[1] + away, "accent", 1, 1, True, True))
        return drawn

    def _handles(self, box: Box) -> list[Handle]:
        handles = []
        for name, place in self.places().items():
            if name == PIVOT:
                continue
            slides = self._shears and name in SIDES and 0 in SIDES[name]
            shape: GripShape = "round" if name == TURN else "diamond" if slides else "square"
            x, y = self._after(place)
            handles.append(Handle(_IDS + name, "", x, y, name in (self._held, self._shown_choice), shape))
        return handles

    @property
    def _shown_choice(self) -> str:
        return self._chosen if self._canvas.hasFocus() else ""

    def handle_at(self, position: QPointF) -> str:
        """The handle under a position of the canvas, MOVE inside the box, or ""."""
        if self._box is None:
            return ""
        nearest, least = "", math.inf
        for name, place in self.places().items():
            away = position - self._canvas.widget_position(*place)
            distance = math.hypot(away.x(), away.y())
            if (
                distance <= (PIVOT_REACH_PX if name == PIVOT else _REACH_PX) and distance <= least
            ):  # the pivot, last, may lie on a corner
                nearest, least = name, distance
        if nearest:
            return nearest
        return MOVE if self._box.holds(self._canvas.device_position(position)) else ""

    def _cursor(self, handle: str) -> QCursor:
        shapes = Qt.CursorShape
        if handle in (MOVE, PIVOT):
            return QCursor(shapes.SizeAllCursor if handle == MOVE else shapes.CrossCursor)
        if handle == TURN or self._box is None:
            return QCursor(shapes.PointingHandCursor)
        across, up = SIDES[handle]
        angle = math.atan2(up, across) + self._box.angle
        if self._shears and 0 in (across, up):
            angle += math.pi / 2
        eighth = round(angle / (math.pi / 4)) % 4
        return QCursor(
            (shapes.SizeHorCursor, shapes.SizeBDiagCursor, shapes.SizeVerCursor, shapes.SizeFDiagCursor)[
                eighth
            ]
        )


def _has_middle(length: float, other: float) -> bool:
    """Whether a side so many pixels long, of a box so thick, has a handle in its middle."""
    return length > _LONG_PX and other > _THICK_PX
