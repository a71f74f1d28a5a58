"""Paints the marks over cells: candidates, choice, rings, answers, patterns of a comparison, handles."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from workbench.widgets.canvas_overlay import BOTH, ONLY_FIRST, TIE_FIRST, TIE_SECOND, Cell
from workbench.widgets.tokens import colour

if TYPE_CHECKING:
    from workbench.widgets.canvas_painter import Scene

HANDLE, GRAB = 9, 24
PATTERN_FROM = 10


def paint_marks(painter: QPainter, scene: Scene) -> None:
    """All marks of the scene's overlay, those on top last."""
    overlay, tokens = scene.overlay, scene.tokens
    muted = QColor(tokens.muted)
    if overlay.classes is not None:
        _paint_patterns(painter, scene)
    for box in _boxes(scene, overlay.chosen):
        painter.fillRect(box, QColor(tokens.data[0]))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for box in _boxes(scene, overlay.candidates):
        _outline(painter, box, QColor(tokens.data[0]), 2 * scene.unit)
    for box in _boxes(scene, overlay.rejected):
        _outline(painter, box, muted, scene.unit)
        _cross(painter, box, muted, 1.5 * scene.unit)
    for box in _boxes(scene, overlay.right):
        _tick(painter, box, QColor(tokens.data[2]), 2.5 * scene.unit)
    for box in _boxes(scene, overlay.wrong):
        _outline(painter, box, QColor(tokens.error), 2 * scene.unit)
        _cross(painter, box, QColor(tokens.error), 2 * scene.unit)
    for box in _boxes(scene, overlay.current):
        ring(painter, box, scene)
    if overlay.snap is not None:
        for box in _boxes(scene, (overlay.snap,)):
            _snap(painter, box, scene)
    _paint_handles(painter, scene)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _boxes(scene: Scene, cells: Iterable[Cell]) -> list[QRectF]:
    """The inside of each seen cell, without its gap, in screen pixels."""
    cell, area = scene.view.cell, scene.area
    gap = scene.hair if cell >= 6 else 0
    boxes = []
    for x, y in cells:
        left, top = scene.view.to_screen(x - 0.5, y + 0.5)
        if left + cell >= area.left and left <= area.right and top + cell >= area.top and top <= area.bottom:
            boxes.append(QRectF(left + gap, top + gap, max(1.0, cell - gap), max(1.0, cell - gap)))
    return boxes


def _outline(painter: QPainter, box: QRectF, ink: QColor, width: float) -> None:
    width = min(width, box.width() / 2)
    painter.setPen(
        QPen(ink, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.SquareCap, Qt.PenJoinStyle.MiterJoin)
    )
    half = width / 2
    painter.drawRect(box.adjusted(half, half, -half, -half))


def _cross(painter: QPainter, box: QRectF, ink: QColor, width: float) -> None:
    painter.setPen(QPen(ink, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
    inset = box.width() * 0.25
    inner = box.adjusted(inset, inset, -inset, -inset)
    painter.drawLine(inner.topLeft(), inner.bottomRight())
    painter.drawLine(inner.topRight(), inner.bottomLeft())


def _tick(painter: QPainter, box: QRectF, ink: QColor, width: float) -> None:
    painter.setPen(
        QPen(ink, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
    )
    left, top, side = box.left(), box.top(), box.width()
    knee = QPointF(left + 0.42 * side, top + 0.75 * side)
    painter.drawLine(QPointF(left + 0.2 * side, top + 0.52 * side), knee)
    painter.drawLine(knee, QPointF(left + 0.8 * side, top + 0.28 * side))


def ring(painter: QPainter, box: QRectF, scene: Scene) -> None:
    """Two rings: text colour outside, canvas colour inside, so that it shows on any colour."""
    width = max(1.0, min(2 * scene.unit, box.width() / 5))
    least = 7 * scene.unit
    if box.width() < least:
        middle = box.center()
        box = QRectF(middle.x() - least / 2, middle.y() - least / 2, least, least)
    _outline(
        painter, box.adjusted(-width / 2, -width / 2, width / 2, width / 2), QColor(scene.tokens.text), width
    )
    inner = box.adjusted(width / 2, width / 2, -width / 2, -width / 2)
    _outline(painter, inner, QColor(scene.tokens.canvas), width)


def _snap(painter: QPainter, box: QRectF, scene: Scene) -> None:
    """Where a point would come to lie: the cell's outline and its centre."""
    accent = QColor(scene.tokens.accent)
    _outline(painter, box, accent, 1.5 * scene.unit)
    middle, arm = box.center(), min(4 * scene.unit, box.width() / 3)
    painter.setPen(QPen(accent, 1.5 * scene.unit))
    painter.drawLine(QPointF(middle.x() - arm, middle.y()), QPointF(middle.x() + arm, middle.y()))
    painter.drawLine(QPointF(middle.x(), middle.y() - arm), QPointF(middle.x(), middle.y() + arm))


def _paint_handles(painter: QPainter, scene: Scene) -> None:
    """Round grips; each name stands on the side away from the other handles, clear of the figure."""
    handles = scene.overlay.handles
    if not handles:
        return
    named = [handle for handle in handles if handle.name] or handles
    middle_x = sum(handle.x for handle in named) / len(named)
    middle_y = sum(handle.y for handle in named) / len(named)
    unit, tokens, area = scene.unit, scene.tokens, scene.area
    accent, surface, side = QColor(tokens.accent), QColor(tokens.surface), HANDLE * unit
    for handle in handles:
        x, y = scene.view.to_screen(handle.x, handle.y)
        if not (area.left - side <= x <= area.right + side and area.top - side <= y <= area.bottom + side):
            continue
        painter.setPen(QPen(surface if handle.selected else accent, 1.5 * unit))
        painter.setBrush(accent if handle.selected else surface)
        grip = QRectF(x - side / 2, y - side / 2, side, side)
        if handle.shape == "square":
            painter.drawRect(grip.adjusted(unit, unit, -unit, -unit))
        else:
            painter.drawEllipse(grip)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if handle.name:
            label = f"{handle.name} ({handle.x:g}, {handle.y:g})"
            clear = side / 2 + max(side / 2, scene.view.cell / 2)
            right = -1 if handle.x < middle_x else 1
            up = -1 if handle.y < middle_y else 1
            paint_label(painter, label, x + right * clear, y - up * clear, scene, right, up)


def paint_label(
    painter: QPainter, text: str, x: float, y: float, scene: Scene, right: int = 1, up: int = 1
) -> None:
    """A small card with text right (left: -1) of and above (below: -1) a point, kept in the area."""
    font = scene.caption()
    metrics = QFontMetricsF(font)
    lines = text.split("\n")
    pad = 4 * scene.unit
    width = max(metrics.horizontalAdvance(line) for line in lines) + 2 * pad
    height = len(lines) * metrics.height() + pad
    area = scene.area
    left = min(max(x if right > 0 else x - width, area.left + pad), area.right - width - pad)
    top = min(max(y - height if up > 0 else y, area.top + pad), area.bottom - height - pad)
    painter.setPen(QPen(QColor(scene.tokens.line), 1))
    painter.setBrush(colour(scene.tokens.raised, 235))
    painter.drawRoundedRect(QRectF(left, top, width, height), 3 * scene.unit, 3 * scene.unit)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setFont(font)
    painter.setPen(QColor(scene.tokens.text))
    for k, line in enumerate(lines):
        painter.drawText(QPointF(left + pad, top + pad / 2 + metrics.ascent() + k * metrics.height()), line)


def _paint_patterns(painter: QPainter, scene: Scene) -> None:
    """A shape beside each colour: a rising stroke, a falling stroke; ties have a hollow diamond."""
    classes = scene.overlay.classes
    if classes is None or scene.view.cell < PATTERN_FROM:
        return
    seen = scene.view.visible(scene.area, *scene.size)
    if seen is None:
        return
    column, last_column, row, last_row = seen
    part = classes[row : last_row + 1, column : last_column + 1]
    rows, columns = np.nonzero((part != 0) & (part != BOTH))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    pen = QPen(QColor(scene.tokens.canvas), max(1.0, min(2 * scene.unit, scene.view.cell / 8)))
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    side = scene.view.cell - scene.hair
    left = scene.view.left + (columns + column) * scene.view.cell + scene.hair + 0.22 * side
    top = scene.view.bottom - (rows + row + 1) * scene.view.cell + scene.hair + 0.22 * side
    side *= 0.56
    lines = []
    for value, x, y in zip(part[rows, columns].tolist(), left.tolist(), top.tolist(), strict=True):
        if value in (TIE_FIRST, TIE_SECOND):
            half = side / 2
            corners = (x + half, y), (x + side, y + half), (x + half, y + side), (x, y + half)
            lines += [QLineF(*corners[k], *corners[k - 1]) for k in range(4)]
        elif value == ONLY_FIRST:
            lines.append(QLineF(x, y + side, x + side, y))
        else:
            lines.append(QLineF(x, y, x + side, y + side))
    painter.drawLines(lines)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
