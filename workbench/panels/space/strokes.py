"""Lines, outlines and labels over a view of a scene, in logical pixels of its widget."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from workbench.geometry.meshes import Array
from workbench.widgets.look.tokens import colour, tokens

_FAR_PX = 1e5
_CRUMB = 1e-9


def short(value: float, digits: int = 3) -> str:
    """A number of the picture to so many digits; what is left of a rounding is 0."""
    return f"{0.0 if abs(value) < _CRUMB else value:.{digits}g}".replace("-", "−")


def lines(painter: QPainter, starts: Array, ends: Array, pen: QPen) -> None:
    """Lines between places (n, 2), where both are numbers."""
    whole = np.isfinite(starts).all(axis=1) & np.isfinite(ends).all(axis=1)
    rows = np.clip(np.concatenate([starts, ends], axis=1)[whole], -_FAR_PX, _FAR_PX)
    painter.setPen(pen)
    painter.drawLines([QLineF(*row) for row in rows.tolist()])


def outline(painter: QPainter, corners: Array) -> None:
    """A polygon (n, 2), where all its corners are numbers."""
    if np.isfinite(corners).all():
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
