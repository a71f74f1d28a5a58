"""What is drawn on a canvas over its cells: pen strokes, tints and markers with their sizes, and words.

Everything is in device coordinates; ``ink`` names a colour of the theme: "text", "accent", "muted", "error",
or "data1" to "data6"; "#RRGGBB" is a colour of a picture. A pattern or a shape stands beside every colour.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter, QPen

from workbench.algorithms.marks import Mark, Word
from workbench.widgets.canvas.line_layers import paint_many
from workbench.widgets.canvas.lines import on_screen
from workbench.widgets.canvas.polygons import polygon
from workbench.widgets.look.tokens import Tokens, colour

if TYPE_CHECKING:
    from workbench.widgets.canvas.painter import Scene

Points = NDArray[np.float64]
Pattern = Literal["solid", "dash", "dot"]
Shape = Literal["dot", "ring", "square", "cross"]

PATTERNS = {
    "solid": Qt.PenStyle.SolidLine,
    "dash": Qt.PenStyle.DashLine,
    "dot": Qt.PenStyle.DotLine,
}
DATA_INKS = 6
_SPOT = 8
_HAIR = 0.8
_FAR = 1e6
_OPAQUE = 255
_PHASES = 4


@dataclass(frozen=True, slots=True, eq=False)
class PenStroke:
    """A polyline (n, 2), ``width`` logical pixels wide; ``haloed`` keeps it clear of what it crosses."""

    points: Points
    ink: str = "text"
    width: float = 1.5
    pattern: Pattern = "solid"
    haloed: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Tint:
    """The inside of a polygon (n, 2), filled by a share of its colour, 0 to 255; ``outline`` is the ink of a
    thin line round it, of many polygons far quicker than strokes of their own."""

    points: Points
    ink: str = "accent"
    alpha: int = 32
    outline: str = ""


@dataclass(frozen=True, slots=True)
class Marker:
    """One place, marked by a shape of ``size`` logical pixels."""

    x: float
    y: float
    ink: str = "text"
    shape: Shape = "dot"
    size: float = _SPOT


Sized = PenStroke | Tint | Marker | Word
Drawn = Sized | Mark
"""What a canvas is given: these, or marks of a step, whose sizes it chooses."""


def ink_of(tokens: Tokens, name: str) -> str:
    """The colour that a name of an ink stands for."""
    if name.startswith("data"):
        return tokens.data[int(name[4:]) - 1]
    if name.startswith("#"):
        return name
    return str(getattr(tokens, name))


def data_ink(number: int) -> str:
    """The data colours in turn."""
    return f"data{number % DATA_INKS + 1}"


def paint_drawn(painter: QPainter, scene: Scene, drawn: tuple[Sized, ...]) -> None:
    """Paint them in the order given."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    for _style, alike in groupby(drawn, _style_of):
        each = next(alike)
        match each:
            case PenStroke():
                more = [stroke.points for stroke in alike if isinstance(stroke, PenStroke)]
                _strokes(painter, scene, each, [each.points, *more])
            case Tint():
                # A pale ground has a stroke round it that covers its edge: unsmoothed it takes a tenth.
                painter.setRenderHint(QPainter.RenderHint.Antialiasing, scene.vector or each.alpha == _OPAQUE)
                painter.setPen(_outline(scene, each))
                painter.setBrush(colour(ink_of(scene.tokens, each.ink), each.alpha))
                painter.drawPolygon(polygon(*on_screen(scene, each.points, _FAR)))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
            case Marker():
                _marker(painter, scene, each)
            case Word():
                _word(painter, scene, each)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)


def _outline(scene: Scene, tint: Tint) -> QPen:
    if not tint.outline:
        return QPen(Qt.PenStyle.NoPen)
    return QPen(QColor(ink_of(scene.tokens, tint.outline)), _HAIR * scene.unit)


def _style_of(drawn: Sized) -> object:
    """Strokes of one style that follow one another are painted at once; a halo is for one alone."""
    if isinstance(drawn, PenStroke) and not drawn.haloed:
        return drawn.ink, drawn.width, drawn.pattern
    return id(drawn)


def _strokes(painter: QPainter, scene: Scene, style: PenStroke, lines: list[Points]) -> None:
    if style.haloed:
        around = QPen(QColor(scene.tokens.canvas), (style.width + 2.5) * scene.unit)
        paint_many(painter, scene, lines, around)
    ink = QColor(ink_of(scene.tokens, style.ink))
    pen = QPen(ink, style.width * scene.unit, PATTERNS[style.pattern], Qt.PenCapStyle.FlatCap)
    paint_many(painter, scene, lines, pen)


def _marker(painter: QPainter, scene: Scene, spot: Marker) -> None:
    x, y = scene.view.to_screen(spot.x, spot.y)
    inks = ink_of(scene.tokens, spot.ink), scene.tokens.canvas
    if scene.vector or not (abs(x) < _FAR and abs(y) < _FAR):
        _paint_spot(painter, QPointF(x, y), spot.shape, spot.size, inks, scene.unit)
        return
    phases = round(x * _PHASES), round(y * _PHASES)
    image = _spot_image(spot.shape, spot.size, inks, scene.unit, phases[0] % _PHASES, phases[1] % _PHASES)
    half = image.width() // 2
    painter.drawImage(phases[0] // _PHASES - half, phases[1] // _PHASES - half, image)


@lru_cache(maxsize=512)
def _spot_image(
    shape: Shape, size: float, inks: tuple[str, str], unit: float, across: int, down: int
) -> QImage:
    """A spot painted once for every place that lies alike between pixels: a picture may hold hundreds."""
    half = math.ceil((size / 2 + 4) * unit) + 1
    image = QImage(2 * half, 2 * half, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(0)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    _paint_spot(painter, QPointF(half + across / _PHASES, half + down / _PHASES), shape, size, inks, unit)
    painter.end()
    return image


def _paint_spot(
    painter: QPainter, place: QPointF, shape: Shape, size: float, inks: tuple[str, str], unit: float
) -> None:
    half = size * unit / 2
    box = QRectF(place.x() - half, place.y() - half, 2 * half, 2 * half)
    ink, ground = QColor(inks[0]), QColor(inks[1])
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if shape == "cross":
        for pen in (QPen(ground, 4.5 * unit), QPen(ink, 2 * unit)):
            painter.setPen(pen)
            painter.drawLine(box.topLeft(), box.bottomRight())
            painter.drawLine(box.topRight(), box.bottomLeft())
        return
    wide = 2 * unit
    painter.setPen(QPen(ground, wide))
    painter.drawEllipse(box.adjusted(-wide, -wide, wide, wide))
    painter.setPen(QPen(ink, wide))
    painter.setBrush(ground if shape == "ring" else ink)
    if shape == "square":
        painter.drawRect(box)
    else:
        painter.drawEllipse(box)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _word(painter: QPainter, scene: Scene, word: Word) -> None:
    font = scene.caption()
    font.setBold(word.strong)
    metrics = QFontMetricsF(font)
    pad = 3 * scene.unit
    wide, high = metrics.horizontalAdvance(word.text) + 2 * pad, metrics.height() + pad
    x, y = scene.view.to_screen(word.x, word.y)
    away = 7 * scene.unit
    left = x + word.right * away - wide * (1 - word.right) / 2
    top = y - word.up * away - high * (1 + word.up) / 2
    area = scene.area
    left = min(max(left, area.left + pad), area.right - wide - pad)
    top = min(max(top, area.top + pad), area.bottom - high - pad)
    if word.carded:
        painter.setPen(QPen(QColor(ink_of(scene.tokens, word.ink)), scene.unit))
        painter.setBrush(colour(scene.tokens.raised, 235))
        painter.drawRoundedRect(QRectF(left, top, wide, high), pad, pad)
    else:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour(scene.tokens.canvas, 150))
        painter.drawRoundedRect(QRectF(left, top, wide, high), pad, pad)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setFont(font)
    painter.setPen(QColor(ink_of(scene.tokens, word.ink)))
    painter.drawText(QPointF(left + pad, top + pad / 2 + metrics.ascent()), word.text)
