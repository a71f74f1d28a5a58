"""Paints the marks over cells: candidates, choice, rings, answers, patterns of a comparison, handles."""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from workbench.rendering.comparing import BOTH, ONLY_FIRST, TIE_FIRST, TIE_SECOND
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.canvas.handle_names import handle_names, paint_label
from workbench.widgets.canvas.lines import on_screen
from workbench.widgets.canvas.overlay import HANDLE, Cell, GripShape, Handle, handle_places
from workbench.widgets.look.tokens import Tokens

if TYPE_CHECKING:
    from workbench.widgets.canvas.painter import Scene

PATTERN_FROM = 10

GripKind = tuple[GripShape, str, bool]


def paint_marks(painter: QPainter, scene: Scene) -> None:
    """All marks of the scene's overlay but the handles, those on top last."""
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


def paint_handles(painter: QPainter, scene: Scene) -> None:
    """Grips, and the names of those for which there is room."""
    handles = scene.overlay.handles
    if not handles:
        return
    x, y = on_screen(scene, handle_places(handles))
    area, side = scene.area, HANDLE * scene.unit
    seen = (x >= area.left - side) & (x <= area.right + side)
    seen &= (y >= area.top - side) & (y <= area.bottom + side)
    numbers = np.flatnonzero(seen)
    if scene.vector:
        for number in numbers.tolist():
            place = QPointF(x[number], y[number])
            _paint_grip(painter, scene.tokens, scene.unit, _kind(handles[number]), place)
    else:
        _set_down(painter, scene, [handles[k] for k in numbers.tolist()], x[seen], y[seen])
    for text, box in handle_names(scene):
        paint_label(painter, text, box, scene)


def _kind(handle: Handle) -> GripKind:
    return handle.shape, handle.ink, handle.selected


def _set_down(
    painter: QPainter, scene: Scene, handles: list[Handle], x: NDArray[np.float64], y: NDArray[np.float64]
) -> None:
    """A grip on each of the screen places x and y, both (n,), on whole pixels; each kind is painted once."""
    side = _side(scene.unit)
    left, top = (np.rint(place - side / 2).astype(np.int64).tolist() for place in (x, y))
    kinds = [_kind(handle) for handle in handles]
    grips = {kind: _grip(scene.tokens, scene.unit, kind) for kind in set(kinds)}
    paint = painter.drawImage
    for i, j, kind in zip(left, top, kinds, strict=True):
        paint(i, j, grips[kind])


def _side(unit: float) -> int:
    """Screen pixels of the image of a grip: an odd number, so that it has a middle one."""
    return 2 * math.ceil(HANDLE * unit / 2 + 2 * unit) + 1


@lru_cache(maxsize=64)
def _grip(tokens: Tokens, unit: float, kind: GripKind) -> QImage:
    side = _side(unit)
    image = QImage(side, side, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(0)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    _paint_grip(painter, tokens, unit, kind, QPointF(side / 2, side / 2))
    painter.end()
    return image


def _paint_grip(painter: QPainter, tokens: Tokens, unit: float, kind: GripKind, place: QPointF) -> None:
    shape, name, selected = kind
    if shape == "mark":
        return
    surface, ink = QColor(tokens.surface), QColor(ink_of(tokens, name))
    painter.setPen(QPen(surface if selected else ink, 1.5 * unit))
    painter.setBrush(ink if selected else surface)
    half = HANDLE * unit / 2
    grip = QRectF(place.x() - half, place.y() - half, 2 * half, 2 * half)
    if shape == "square":
        inset = 0 if selected else unit
        painter.drawRect(grip.adjusted(inset, inset, -inset, -inset))
    elif shape == "diamond":
        far = half + 1.25 * unit
        ends = ((0, -far), (far, 0), (0, far), (-far, 0))
        painter.drawPolygon([place + QPointF(*end) for end in ends])
    else:
        more = 0.75 * unit if selected else 0.0  # its edge has the colour of the ground
        painter.drawEllipse(grip.adjusted(-more, -more, more, more))
    painter.setBrush(Qt.BrushStyle.NoBrush)


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
