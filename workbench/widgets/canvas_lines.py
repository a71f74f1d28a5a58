"""Paints polylines of thousands of corners in a millisecond: side by side, and only what is to be seen.

A painter takes single sides quickly, a whole polyline whose long sides cross sixty times as long.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPen

from workbench.widgets.polygons import polygon

if TYPE_CHECKING:
    from workbench.widgets.canvas_painter import Scene

Array = NDArray[np.float64]

# On and off, in widths of the pen, as Qt has them.
_DASHES = {Qt.PenStyle.DashLine: (4.0, 2.0), Qt.PenStyle.DotLine: (1.0, 2.0)}
_FARTHEST = 1e15
# What stands for a curve is nowhere farther from it than an eighth of stretch times turn.
_FEW, _STRETCH_PX, _TURN = 64, 8.0, 0.12
_OVERLAP_PX = 0.4
_MEETING_PX = 1e-6


def on_screen(scene: Scene, points: Array, farthest: float = _FARTHEST) -> tuple[Array, Array]:
    """The screen places of device points (n, 2) as x and y, no farther than ``farthest`` from the origin."""
    view = scene.view
    x = view.left + (points[:, 0] + 0.5) * view.cell
    y = view.bottom - (points[:, 1] + 0.5) * view.cell
    return np.clip(x, -farthest, farthest), np.clip(y, -farthest, farthest)


def paint_line(painter: QPainter, scene: Scene, points: Array, pen: QPen) -> None:
    """Paint a polyline (n, 2) of device points with a pen whose width is in screen pixels."""
    if len(points) < 2:
        return
    x, y = on_screen(scene, points)
    if scene.vector:
        painter.setPen(pen)
        painter.drawPolyline(polygon(x, y))
        return
    wide = pen.widthF()
    sides, way = _clipped(*_seen_corners(np.stack([x, y], axis=1)), scene, wide)
    if pen.style() in _DASHES:
        sides = _dashed(sides, way, wide * np.array(_DASHES[pen.style()]))
    sides = _overlapping(sides, wide)
    solid = QPen(pen)
    solid.setStyle(Qt.PenStyle.SolidLine)
    solid.setCapStyle(Qt.PenCapStyle.FlatCap)
    painter.setPen(solid)
    if len(sides):
        ends = polygon(sides[:, :, 0].ravel(), sides[:, :, 1].ravel())
        painter.drawLines(ends.data(), len(sides))


def _seen_corners(corners: Array) -> tuple[Array, Array]:
    """Of many corners those that show, one every few pixels and oftener where the line turns, and how far
    along the line each is.
    """
    legs = np.diff(corners, axis=0)
    way = np.concatenate([[0.0], np.cumsum(np.hypot(legs[:, 0], legs[:, 1]))])
    if len(corners) <= _FEW:
        return corners, way
    stretch = np.floor(way[1:] / _STRETCH_PX)
    heading = np.arctan2(legs[:, 1], legs[:, 0])
    turn = np.diff(heading)
    turned = np.floor(np.cumsum(np.abs(turn - 2 * np.pi * np.rint(turn / (2 * np.pi)))) / _TURN)
    kept = np.ones(len(corners), bool)
    kept[1:-1] = (stretch[:-1] != stretch[1:]) | (np.diff(turned, prepend=0.0) != 0)
    return corners[kept], way[kept]


def _clipped(corners: Array, way: Array, scene: Scene, wide: float) -> tuple[Array, Array]:
    """The sides (k, 2, 2) inside the area and a little beyond, and how far along the line each begins.

    Source: Liang and Barsky, A new concept and method for line clipping, 1984.
    """
    start, leg = corners[:-1], np.diff(corners, axis=0)
    length = np.diff(way)
    area, room = scene.area, wide + 2.0
    low = np.array([area.left - room, area.top - room])
    high = np.array([area.right + room, area.bottom + room])
    with np.errstate(divide="ignore", invalid="ignore"):
        to_low, to_high = (low - start) / leg, (high - start) / leg
    still = leg == 0
    between = (start >= low) & (start <= high)
    enter = np.where(still, np.where(between, 0.0, 2.0), np.minimum(to_low, to_high)).max(axis=1)
    leave = np.where(still, 1.0, np.maximum(to_low, to_high)).min(axis=1)
    enter, leave = np.maximum(enter, 0.0), np.minimum(leave, 1.0)
    seen = (enter < leave) & (length > 0)
    start, leg, enter, leave = start[seen], leg[seen], enter[seen, None], leave[seen, None]
    begin = way[:-1][seen] + enter[:, 0] * length[seen]
    return np.stack([start + enter * leg, start + leave * leg], axis=1), begin


def _dashed(sides: Array, way: Array, dashes: Array) -> Array:
    """The parts of the sides that a pattern leaves, ``dashes`` (2,) its screen pixels on and off."""
    length = np.hypot(*(sides[:, 1] - sides[:, 0]).T)
    on, period = float(dashes[0]), float(dashes.sum())
    first = np.floor(way / period)
    count = (np.floor((way + length) / period) - first + 1).astype(np.int64)
    side = np.repeat(np.arange(len(sides)), count)
    number = np.arange(len(side)) - np.repeat(np.cumsum(count) - count, count)
    begin = (first[side] + number) * period - way[side]
    cuts = np.clip(np.stack([begin, begin + on], axis=1), 0.0, length[side, None])
    some = cuts[:, 1] > cuts[:, 0]
    side, cuts = side[some], cuts[some] / length[side[some], None]
    leg = sides[side, 1] - sides[side, 0]
    parts: Array = sides[side, :1] + cuts[:, :, None] * leg[:, None]
    return parts


def _overlapping(sides: Array, wide: float) -> Array:
    """Sides made longer where they meet, so that no seam shows: by half the pen where they meet squarely."""
    if len(sides) < 2:
        return sides
    leg = sides[:, 1] - sides[:, 0]
    leg /= np.hypot(leg[:, 0], leg[:, 1])[:, None]
    meet = (np.abs(sides[:-1, 1] - sides[1:, 0]) < _MEETING_PX).all(axis=1)
    sine = np.abs(leg[:-1, 0] * leg[1:, 1] - leg[:-1, 1] * leg[1:, 0])
    more = meet * np.maximum(min(_OVERLAP_PX, wide / 2), sine * wide / 2)
    sides[1:, 0] -= more[:, None] * leg[1:]
    sides[:-1, 1] += more[:, None] * leg[:-1]
    return sides
