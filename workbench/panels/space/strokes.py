"""Lines, outlines and labels over a view of a scene, in logical pixels of its widget."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from workbench.algorithms.numerals import with_minus
from workbench.geometry.meshes import Array
from workbench.rendering.scene.volume import clip_segments, side_planes
from workbench.widgets.look.tokens import colour, tokens

_LONG_PX, _AROUND_PX = 4e3, 64
_CRUMB = 1e-9
_SIDES = ((True, 0), (False, 0), (True, 1), (False, 1), (True, -1), (False, -1), (True, 2), (False, 2))
"""Right of a place or left of it, and how many cards lower than just above it; the first is best."""


def short(value: float, digits: int = 3) -> str:
    """A number of the picture to so many digits; what is left of a rounding is 0."""
    return with_minus(f"{0.0 if abs(value) < _CRUMB else value:.{digits}g}")


def lines(painter: QPainter, starts: Array, ends: Array, pen: QPen) -> None:
    """Lines between places (n, 2), where both are numbers."""
    whole = np.isfinite(starts).all(axis=1) & np.isfinite(ends).all(axis=1)
    rows = np.concatenate([starts, ends], axis=1)[whole]
    if len(rows) and np.abs(rows).max() > _LONG_PX:
        rows = _within(rows, painter.viewport())
    painter.setPen(pen)
    painter.drawLines([QLineF(*row) for row in rows.tolist()])


def _within(rows: Array, seen: QRect) -> Array:
    """What of lines (n, 4) is near what is seen: dashes far outside would take long to be painted."""
    count = len(rows)
    points = np.column_stack([rows.reshape(-1, 2), np.zeros(2 * count), np.ones(2 * count)])
    sides = seen.adjusted(-_AROUND_PX, -_AROUND_PX, _AROUND_PX, _AROUND_PX)
    planes = side_planes(sides.left(), sides.top(), sides.right(), sides.bottom())
    begin, end, _of = clip_segments(points, np.arange(2 * count).reshape(-1, 2), planes)
    near: Array = np.concatenate([begin[:, :2], end[:, :2]], axis=1)
    return near


def outline(painter: QPainter, corners: Array) -> None:
    """A polygon (n, 2), where all its corners are numbers; unfilled, only as far as it is seen."""
    if painter.brush().style() == Qt.BrushStyle.NoBrush:
        lines(painter, corners, np.roll(corners, -1, axis=0), painter.pen())
    elif np.isfinite(corners).all():
        painter.drawPolygon(QPolygonF([QPointF(*each) for each in corners.tolist()]))


class Labels:
    """Words on small cards over a view, each where it hides least of those before it and of the widgets that
    float there."""

    def __init__(self, painter: QPainter, view: QWidget) -> None:
        self._painter = painter
        self._size = view.size()
        floating = view.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
        self._taken = [QRectF(each.geometry()) for each in floating if each.isVisible()]

    def put(self, at: Array, text: str, ink: str) -> QRectF:
        """Write beside a place (2,), within the view; where the card is, empty for a place of no numbers."""
        if not np.isfinite(at).all():
            return QRectF()
        painter, metrics = self._painter, self._painter.fontMetrics()
        width, height = metrics.horizontalAdvance(text) + 10, metrics.height() + 4
        box = min((self._beside(at, width, height, *side) for side in _SIDES), key=self._hidden)
        self._taken.append(box)
        painter.setPen(QPen(colour(ink), 1))
        painter.setBrush(colour(tokens().raised))
        painter.drawRoundedRect(box, 4, 4)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(colour(tokens().text))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        return box

    def _beside(self, at: Array, width: float, height: float, right: bool, steps: int) -> QRectF:
        """A card right or left of a place, its own height above it or so many times that below."""
        x = float(at[0]) + (8 if right else -8 - width)
        y = float(at[1]) - height - 6 + steps * (height + 4)
        x = min(max(x, 2.0), self._size.width() - width - 2.0)
        y = min(max(y, 2.0), self._size.height() - height - 2.0)
        return QRectF(x, y, width, height)

    def _hidden(self, box: QRectF) -> float:
        common = [box.intersected(each) for each in self._taken]
        return sum(each.width() * each.height() for each in common)
