"""Paints polylines of thousands of corners in a millisecond: side by side, and only what is to be seen.

A painter takes single sides quickly, a whole polyline whose long sides cross sixty times as long.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPen

from workbench.widgets.canvas.polygons import polygon

if TYPE_CHECKING:
    from workbench.widgets.canvas.painter import Scene

Array = NDArray[np.float64]

# On and off, in widths of the pen, as Qt has them.
_DASHES = {Qt.PenStyle.DashLine: (4.0, 2.0), Qt.PenStyle.DotLine: (1.0, 2.0)}
_FARTHEST, _NEAR_PX = 1e15, 1e4
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


def paint_lines(painter: QPainter, scene: Scene, lines: Sequence[Array], pen: QPen) -> None:
    """Paint polylines, each (n, 2) device points, with one pen whose width is in screen pixels."""
    if len(lines) == 1 and len(lines[0]) == 2 and _paint_side(painter, scene, lines[0], pen):
        return
    counts = np.array([len(line) for line in lines if len(line) > 1], np.int64)
    if not len(counts):
        return
    x, y = on_screen(scene, np.concatenate([line for line in lines if len(line) > 1]))
    if scene.vector:
        painter.setPen(pen)
        for end, count in zip(np.cumsum(counts).tolist(), counts.tolist(), strict=True):
            painter.drawPolyline(polygon(x[end - count : end], y[end - count : end]))
        return
    wide = pen.widthF()
    sides, way = _sides(np.stack([x, y], axis=1), counts, scene, wide)
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


def _paint_side(painter: QPainter, scene: Scene, ends: Array, pen: QPen) -> bool:
    """Paint a single side the short way, unless it is dashed or goes far; whether it was painted."""
    start, end = (QPointF(*scene.view.to_screen(x, y)) for x, y in ends.tolist())
    far = max(abs(start.x()), abs(start.y()), abs(end.x()), abs(end.y())) >= _NEAR_PX
    if far or pen.style() in _DASHES:
        return False
    if start != end:
        painter.setPen(pen)
        painter.drawLine(start, end)
    return True


def _sides(corners: Array, counts: NDArray[np.int64], scene: Scene, wide: float) -> tuple[Array, Array]:
    """The sides (k, 2, 2) to be seen of polylines of so many corners each, and how far along its own line
    each begins.
    """
    line = np.repeat(np.arange(len(counts)), counts)
    legs = np.diff(corners, axis=0)
    way = np.concatenate([[0.0], np.cumsum(np.hypot(legs[:, 0], legs[:, 1]))])
    if counts.max() > _FEW:
        kept = _shows(legs, way) | (counts <= _FEW)[line]
        kept[1:] |= line[1:] != line[:-1]
        kept[:-1] |= line[1:] != line[:-1]
        corners, way, line = corners[kept], way[kept], line[kept]
    begin = np.flatnonzero(np.diff(line, prepend=-1))
    own = line[1:] == line[:-1]
    length = np.diff(way)[own]
    way = (way - way[begin][line])[:-1][own]
    return _clipped(corners[:-1][own], corners[1:][own], length, way, scene, wide)


def _shows(legs: Array, way: Array) -> NDArray[np.bool_]:
    """Of many corners those that show: one every few pixels, and oftener where the line turns."""
    stretch = np.floor(way[1:] / _STRETCH_PX)
    turn = np.diff(np.arctan2(legs[:, 1], legs[:, 0]))
    turned = np.floor(np.cumsum(np.abs(turn - 2 * np.pi * np.rint(turn / (2 * np.pi)))) / _TURN)
    kept = np.ones(len(way), bool)
    kept[1:-1] = (stretch[:-1] != stretch[1:]) | (np.diff(turned, prepend=0.0) != 0)
    return kept


def _clipped(
    start: Array, end: Array, length: Array, way: Array, scene: Scene, wide: float
) -> tuple[Array, Array]:
    """The parts of sides inside the area and a little beyond, and how far along the line each begins.

    Source: Liang and Barsky, A new concept and method for line clipping, 1984.
    """
    leg = end - start
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
    begin = way[seen] + enter[:, 0] * length[seen]
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
    leg = sides[:, 1] - sides[:, 0]
    length = np.hypot(leg[:, 0], leg[:, 1])
    some = length > 0  # a corner cut off far away may leave two ends that round to one place
    sides, leg = sides[some], leg[some] / length[some, None]
    if len(sides) < 2:
        return sides
    meet = (np.abs(sides[:-1, 1] - sides[1:, 0]) < _MEETING_PX).all(axis=1)
    sine = np.abs(leg[:-1, 0] * leg[1:, 1] - leg[:-1, 1] * leg[1:, 0])
    more = meet * np.maximum(min(_OVERLAP_PX, wide / 2), sine * wide / 2)
    sides[1:, 0] -= more[:, None] * leg[1:]
    sides[:-1, 1] += more[:, None] * leg[:-1]
    return sides
