"""Lines, outlines and labels over a view of a scene, in logical pixels of its widget."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from workbench.geometry.meshes import Array
from workbench.rendering.scene.volume import clip_segments, side_planes
from workbench.widgets.look.tokens import colour, tokens

_LONG_PX, _AROUND_PX = 4e3, 64
_CRUMB = 1e-9


def short(value: float, digits: int = 3) -> str:
    """A number of the picture to so many digits; what is left of a rounding is 0."""
    return f"{0.0 if abs(value) < _CRUMB else value:.{digits}g}".replace("-", "−")


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


def label(painter: QPainter, within: QSize, at: Array, text: str, ink: str) -> QRectF:
    """Words on a small card beside a place (2,), kept within a widget of this size; where the card is."""
    if not np.isfinite(at).all():
        return QRectF()
    metrics = painter.fontMetrics()
    width, height = metrics.horizontalAdvance(text) + 10, metrics.height() + 4
    x = min(max(float(at[0]) + 8, 2.0), within.width() - width - 2.0)
    y = min(max(float(at[1]) - height - 6, 2.0), within.height() - height - 2.0)
    box = QRectF(x, y, width, height)
    painter.setPen(QPen(colour(ink), 1))
    painter.setBrush(colour(tokens().raised))
    painter.drawRoundedRect(box, 4, 4)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(colour(tokens().text))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
    return box
