"""A part of the plane at a scale of its own, with axes, grid and what is drawn in it."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen

from workbench.exchange.formulas.terms import displayed
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.canvas.overlay import Handle, Overlay
from workbench.widgets.canvas.painter import Scene, paint_over
from workbench.widgets.canvas.view import Area, CanvasView
from workbench.widgets.look.tokens import DARK, Tokens

Box = tuple[float, float, float, float]

GRID_PX = 44
MARGIN_PX, SMALL_MARGIN_PX = 22, 5
_MOST_LINES = 400


@dataclass(frozen=True, slots=True, eq=False)
class Plane:
    """What is shown of a plane: at least ``box`` (xmin, ymin, xmax, ymax) of it, y upwards.

    ``axes`` are the names of its axes, such as ("x_w", "y_w"). ``pixels`` (h, w), 0xRRGGBB, row 0 at the
    bottom, lie under what is drawn, each about its centre. ``dark`` is for what looks the same in all themes;
    ``bare`` has neither grid nor axes.
    """

    box: Box = (0.0, 0.0, 1.0, 1.0)
    axes: tuple[str, str] = ("x", "y")
    drawn: tuple[Drawn, ...] = ()
    handles: tuple[Handle, ...] = ()
    pixels: NDArray[np.uint32] | None = None
    dark: bool = False
    bare: bool = False


def fitted_view(box: Box, area: Area, margin: float) -> CanvasView:
    """The mapping that shows ``box`` whole in the middle of ``area``, the same scale both ways."""
    width, height = max(box[2] - box[0], 1e-9), max(box[3] - box[1], 1e-9)
    room = max(area.width - 2 * margin, 1.0), max(area.height - 2 * margin, 1.0)
    cell = min(room[0] / width, room[1] / height)
    middle_x, middle_y = area.centre
    left = middle_x - ((box[0] + box[2]) / 2 + 0.5) * cell
    bottom = middle_y + ((box[1] + box[3]) / 2 + 0.5) * cell
    return CanvasView(cell, round(left), round(bottom))


def grid_step(cell: float, room: float) -> float:
    """The distance of grid lines: 1, 2 or 5 times a power of ten, ``room`` screen pixels or more apart."""
    least = room / cell
    power = 10.0 ** math.floor(math.log10(least))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= least * (1 - 1e-9))


def scene_of(plane: Plane, area: Area, tokens: Tokens, unit: float, font: QFont, small: bool) -> Scene:
    """What is painted of a plane in an area of the screen; ``small`` is without handles."""
    margin = (SMALL_MARGIN_PX if small or plane.bare else MARGIN_PX) * unit
    view = fitted_view(plane.box, area, margin)
    overlay = Overlay(drawn=plane.drawn, handles=() if small else plane.handles)
    return Scene(area, view, (1, 1), DARK if plane.dark else tokens, unit, font, overlay)


def paint_plane(painter: QPainter, plane: Plane, scene: Scene, small: bool) -> None:
    """Ground, grid, pixels, axes and what is drawn; ``small`` is without grid and axes."""
    area = scene.area
    painter.save()
    painter.setClipRect(QRect(area.left, area.top, area.width, area.height))
    painter.fillRect(area.left, area.top, area.width, area.height, QColor(scene.tokens.canvas))
    step = grid_step(scene.view.cell, GRID_PX * scene.unit)
    ruled = not (small or plane.bare)
    if ruled:
        _paint_grid(painter, scene, step)
    if plane.pixels is not None:
        _paint_pixels(painter, plane.pixels, scene)
    if ruled:
        _paint_axes(painter, plane.axes, scene, step)
    painter.restore()
    paint_over(painter, scene)


def _lines(scene: Scene, step: float) -> tuple[list[float], list[float]]:
    """Where grid lines cross the x axis and the y axis."""
    area = scene.area
    x0, y1 = scene.view.to_device(area.left, area.top)
    x1, y0 = scene.view.to_device(area.right, area.bottom)
    ranges = (
        range(math.ceil(low / step), min(math.floor(high / step), math.ceil(low / step) + _MOST_LINES) + 1)
        for low, high in ((x0, x1), (y0, y1))
    )
    across, up = ([number * step for number in numbers] for numbers in ranges)
    return across, up


def _paint_grid(painter: QPainter, scene: Scene, step: float) -> None:
    area, hair, ink = scene.area, max(1, int(scene.unit)), QColor(scene.tokens.grid)
    across, up = _lines(scene, step)
    for x in across:
        painter.fillRect(round(scene.view.to_screen(x, 0.0)[0]), area.top, hair, area.height, ink)
    for y in up:
        painter.fillRect(area.left, round(scene.view.to_screen(0.0, y)[1]), area.width, hair, ink)


def _paint_pixels(painter: QPainter, pixels: NDArray[np.uint32], scene: Scene) -> None:
    height, width = pixels.shape
    shown = np.ascontiguousarray(pixels[::-1])
    image = QImage(shown.data, width, height, 4 * width, QImage.Format.Format_RGB32)
    left, top = scene.view.to_screen(-0.5, height - 0.5)
    target = QRectF(left, top, width * scene.view.cell, height * scene.view.cell)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, scene.view.cell < 1)
    painter.drawImage(target, image)
    painter.setPen(QPen(QColor(scene.tokens.grid_strong), scene.unit))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(target)


def _paint_axes(painter: QPainter, names: tuple[str, str], scene: Scene, step: float) -> None:
    """Both axes with their numbers; where an axis is out of sight the numbers stand at the edge."""
    area, unit = scene.area, scene.unit
    font = scene.caption()
    metrics = QFontMetricsF(font)
    painter.setFont(font)
    hair, muted = max(1, int(unit)), QColor(scene.tokens.muted)
    zero_x, zero_y = scene.view.to_screen(0.0, 0.0)
    painter.fillRect(round(zero_x), area.top, hair, area.height, muted)
    painter.fillRect(area.left, round(zero_y), area.width, hair, muted)
    painter.setPen(muted)
    base = min(max(zero_y + metrics.ascent() + 3 * unit, metrics.ascent()), area.bottom - metrics.descent())
    across, up = _lines(scene, step)
    for x in across:
        text = displayed(x)
        wide = metrics.horizontalAdvance(text)
        middle = scene.view.to_screen(x, 0.0)[0]
        if x != 0.0 and area.left < middle - wide / 2 and middle + wide / 2 < area.right - 24 * unit:
            painter.drawText(QPointF(middle - wide / 2, base), text)
    for y in up:
        text = displayed(y)
        wide = metrics.horizontalAdvance(text)
        middle = scene.view.to_screen(0.0, y)[1]
        left = min(max(zero_x - wide - 5 * unit, area.left + 3 * unit), area.right - wide - 3 * unit)
        if y != 0.0 and area.top + 16 * unit < middle < area.bottom - metrics.height():
            painter.drawText(QPointF(left, middle + metrics.ascent() / 2 - unit), text)
    low = min(max(zero_y - 5 * unit, area.top + metrics.height()), area.bottom - 5 * unit)
    _name(painter, names[0], area.right - 22 * unit, low, font)
    _name(painter, names[1], min(max(zero_x + 6 * unit, area.left + 6 * unit), area.right - 24 * unit),
          area.top + metrics.ascent() + 3 * unit, font)  # fmt: skip


def _name(painter: QPainter, name: str, x: float, y: float, font: QFont) -> None:
    """The name of an axis, what follows its underline lowered."""
    head, _mark, tail = name.partition("_")
    painter.setFont(font)
    painter.drawText(QPointF(x, y), head)
    below = QFont(font)
    below.setPixelSize(max(1, round(font.pixelSize() * 0.8)))
    wide = QFontMetricsF(font).horizontalAdvance(head)
    painter.setFont(below)
    painter.drawText(QPointF(x + wide, y + font.pixelSize() * 0.25), tail)
    painter.setFont(font)
