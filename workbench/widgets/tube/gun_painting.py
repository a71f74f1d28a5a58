"""How the parts of a tube that is cut open are painted: outlines by their kind, lengths, words."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFont, QFontMetricsF, QLinearGradient, QPainter, QPen, QPolygonF

from workbench.display.cutaway import Kind, Shape
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.look.tokens import Tokens, colour


def paint_shape(
    painter: QPainter, outline: QPolygonF, shape: Shape, lit: bool, glow: QColor, now: Tokens
) -> None:
    """Paint a part with this outline in pixels; ``lit``: it is spoken of; ``glow``: that of the phosphor."""
    pen, brush = _style(shape.kind, outline, lit, glow, now)
    painter.setPen(pen)
    painter.setBrush(brush)
    if shape.closed:
        painter.drawPolygon(outline)
    else:
        painter.drawPolyline(outline)


def _style(kind: Kind, outline: QPolygonF, lit: bool, glow: QColor, now: Tokens) -> tuple[QPen, QBrush]:
    name = now.accent if lit else now.muted
    ink, nothing = colour(name), QBrush(Qt.BrushStyle.NoBrush)
    match kind:
        case "glass":
            around = outline.boundingRect()
            inside = QLinearGradient(around.topLeft(), around.bottomLeft())
            for stop, strong in ((0.0, 46), (0.5, 14), (1.0, 46)):
                inside.setColorAt(stop, colour(now.muted, strong))
            return QPen(colour(now.field_edge), 2.2), QBrush(inside)
        case "metal":
            return QPen(ink, 1), QBrush(colour(name, 200))
        case "plate":
            return QPen(ink, 1.2), QBrush(colour(name, 90))
        case "coil":
            return QPen(ink, 1.2), QBrush(colour(name, 90), Qt.BrushStyle.BDiagPattern)
        case "heater":
            return QPen(ink if lit else colour(ink_of(now, "data2")), 1.8), nothing
        case "coating":
            return QPen(ink, 1.6, Qt.PenStyle.DashLine), nothing
        case "phosphor":
            return QPen(glow, 4.0 if lit else 2.6), nothing
        case "axis":
            return QPen(colour(now.muted, 120), 1, Qt.PenStyle.DashDotLine), nothing
        case "pin":
            return QPen(ink, 1.6), nothing


def paint_length(painter: QPainter, start: QPointF, end: QPointF, name: str, now: Tokens) -> None:
    """A level length with arrows at its ends; its name stands in it, or where it is too short beside it."""
    painter.setPen(QPen(colour(now.muted), 1))
    painter.drawLine(start, end)
    for tip, way in ((start, 1.0), (end, -1.0)):
        painter.drawLine(tip + QPointF(0, -4), tip + QPointF(0, 4))
        painter.drawPolyline(QPolygonF([tip + QPointF(5 * way, -3), tip, tip + QPointF(5 * way, 3)]))
    wide = QFontMetricsF(painter.font()).horizontalAdvance(name)
    middle = (start + end) / 2.0
    if wide + 30.0 > end.x() - start.x():
        middle = end + QPointF(wide / 2.0 + 8.0, 0.0)
    paint_words(painter, name, middle, now)


def paint_height(painter: QPainter, foot: QPointF, tip: QPointF, name: str, now: Tokens) -> None:
    """An upright length with arrows at its ends, its name at its left."""
    painter.setPen(QPen(colour(now.text), 1.2))
    painter.drawLine(foot, tip)
    up = 1.0 if tip.y() < foot.y() else -1.0
    for end, way in ((foot, -up), (tip, up)):
        painter.drawPolyline(QPolygonF([end + QPointF(-3, 5 * way), end, end + QPointF(3, 5 * way)]))
    wide = QFontMetricsF(painter.font()).horizontalAdvance(name)
    paint_words(painter, name, (foot + tip) / 2.0 - QPointF(wide / 2.0 + 9.0, 0.0), now)


def paint_words(painter: QPainter, words: str, middle: QPointF, now: Tokens) -> None:
    """Words around a place, clear of what they lie on."""
    metrics = QFontMetricsF(painter.font())
    box = QRectF(0, 0, metrics.horizontalAdvance(words) + 8.0, metrics.height())
    box.moveCenter(middle)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour(now.window, 225))
    painter.drawRoundedRect(box, 3, 3)
    painter.setPen(colour(now.text))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)


def draw_lowered(painter: QPainter, at: QPointF, line: str) -> None:
    """Draw a line of words from its base line; the letter that follows an underscore is small and lowered."""
    font, small = painter.font(), QFont(painter.font())
    small.setPixelSize(round(0.8 * font.pixelSize()))
    head, mark, tail = line.partition("_")
    painter.drawText(at, head)
    if mark:
        beside = at + QPointF(QFontMetricsF(font).horizontalAdvance(head), 0.0)
        painter.setFont(small)
        painter.drawText(beside + QPointF(0.0, 2.0), tail[:1])
        after = beside + QPointF(QFontMetricsF(small).horizontalAdvance(tail[:1]) + 1.0, 0.0)
        painter.setFont(font)
        painter.drawText(after, tail[1:])


def is_at(shape: Shape, z: float, y: float, near: float) -> bool:
    """Whether a place (mm) is on a shape, or as near to it as a finger: in its box, or at a line."""
    points = shape.points
    if shape.kind not in ("coating", "phosphor"):
        low, high = points.min(axis=0) - near, points.max(axis=0) + near
        return bool((low <= (z, y)).all() and ((z, y) <= high).all())
    starts, ways = points[:-1], np.diff(points, axis=0)
    squares = np.maximum((ways * ways).sum(axis=1), 1e-12)
    shares = np.clip(((np.array([z, y]) - starts) * ways).sum(axis=1) / squares, 0.0, 1.0)
    feet = starts + shares[:, None] * ways
    return bool(np.hypot(*(feet - (z, y)).T).min() <= 1.5 * near)
