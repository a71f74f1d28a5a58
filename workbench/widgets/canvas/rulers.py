"""The rulers of a canvas: the numbers of its columns and rows, below and left of the picture."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRect
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter

from workbench.widgets.canvas.overlay import Cell, Overlay
from workbench.widgets.canvas.painter import Scene
from workbench.widgets.canvas.view import label_step
from workbench.widgets.look.tokens import CAPTION_PX
from workbench.widgets.look.type_faces import scaled

_PLAIN = Overlay()


@lru_cache(maxsize=16)
def ruler_sizes(scene_font: QFont, size: tuple[int, int], unit: float) -> tuple[int, int]:
    """Width of the left ruler and height of the lower one, in screen pixels."""
    font = QFont(scene_font)
    font.setPixelSize(max(1, round(scaled(CAPTION_PX) * unit)))
    metrics = QFontMetricsF(font)
    digits = len(str(max(1, size[1] - 1)))
    return round(metrics.horizontalAdvance("0" * max(2, digits)) + 10 * unit), round(
        metrics.height() + 4 * unit
    )


class _Place(NamedTuple):
    """Where a number is written, where its tick lies, and a box around both."""

    text: QPointF
    tick: QRect
    box: QRect


class _Ruler:
    """The ruler of the columns, or of the rows, of a scene; ``strip`` is where it lies."""

    def __init__(self, scene: Scene, horizontal: bool) -> None:
        self.scene, self.horizontal = scene, horizontal
        self._font = scene.caption()
        self._metrics = QFontMetricsF(self._font)
        area, unit = scene.area, scene.unit
        wide, high = ruler_sizes(scene.font, scene.size, unit)
        self._hair = max(1, int(unit))
        left = area.left - self._hair
        self.strip = (
            QRect(left, area.bottom, area.width + self._hair, high)
            if horizontal
            else QRect(area.left - wide, area.top, wide, area.height + high)
        )
        self._line = (
            QRect(left, area.bottom, area.width + self._hair, self._hair)
            if horizontal
            else QRect(left, area.top, self._hair, area.height)
        )
        widest = self._metrics.horizontalAdvance(str(max(scene.size)))
        between = widest + 10 * unit if horizontal else self._metrics.height() + 6 * unit
        self._room = widest + 4 * unit if horizontal else self._metrics.height()
        self._step = label_step(scene.view.cell, between)
        seen = scene.view.visible(area, *scene.size)
        self._ends = (0, -1) if seen is None else seen[:2] if horizontal else seen[2:]
        self._plain: QImage | None = None
        self._emphasised: tuple[int, QImage] | None = None

    def image(self, number: int | None) -> QImage:
        """It as it is seen with this number emphasised, if any; kept for as long as that is the same."""
        if self._plain is None:
            self._plain = QImage(self.strip.size(), QImage.Format.Format_RGB32)
            self._paint_on(self._plain, self.paint)
        if number is None:
            return self._plain
        if self._emphasised is None or self._emphasised[0] != number:
            image = self._plain.copy()
            self._paint_on(image, lambda painter: self.emphasise(painter, number))
            self._emphasised = number, image
        return self._emphasised[1]

    def _paint_on(self, image: QImage, paint: Callable[[QPainter], None]) -> None:
        painter = QPainter(image)
        painter.translate(-self.strip.topLeft())
        paint(painter)
        painter.end()

    def paint(self, painter: QPainter) -> None:
        """The ground and every number."""
        self._paint_ground(painter)
        first, last = self._ends
        self._write(painter, range(-(-first // self._step) * self._step, last + 1, self._step))

    def emphasise(self, painter: QPainter, number: int) -> None:
        """Over what ``paint`` has painted: this number emphasised, those in its way taken off."""
        first, last = self._ends
        if not first <= number <= last:
            return
        below = number // self._step * self._step
        hidden = [
            n
            for n in (below, below + self._step)
            if first <= n <= last and abs(n - number) * self.scene.view.cell < self._room
        ]
        for gone in hidden:
            painter.setClipRect(self._place(gone).box)
            self._paint_ground(painter)
            beside = (gone - self._step, gone + self._step)  # at an edge their texts can overlap
            self._write(painter, [n for n in beside if first <= n <= last and n not in hidden])
        painter.setClipping(False)
        self._write(painter, [number], strong=True)

    def _paint_ground(self, painter: QPainter) -> None:
        painter.fillRect(self.strip, QColor(self.scene.tokens.surface))
        painter.fillRect(self._line, QColor(self.scene.tokens.line))

    def _write(self, painter: QPainter, numbers: range | list[int], strong: bool = False) -> None:
        ink = QColor(self.scene.tokens.text if strong else self.scene.tokens.muted)
        painter.setFont(self._font)
        painter.setPen(ink)
        for number in numbers:
            place = self._place(number)
            painter.fillRect(place.tick, ink)
            painter.drawText(place.text, str(number))

    def _place(self, number: int) -> _Place:
        area, unit, metrics = self.scene.area, self.scene.unit, self._metrics
        middle_x, middle_y = self.scene.view.to_screen(number, number)
        wide, length = metrics.horizontalAdvance(str(number)), round(3 * unit)
        if self.horizontal:
            left = min(max(middle_x - wide / 2, area.left + 1), area.right - wide - 1)
            text = QPointF(left, area.bottom + 2 * unit + metrics.ascent())
            tick = QRect(round(middle_x), area.bottom, self._hair, length)
            box = QRect(math.floor(left) - 1, area.bottom, math.ceil(wide) + 3, self.strip.height())
        else:
            base = middle_y + (metrics.ascent() - metrics.descent()) / 2
            base = min(max(base, area.top + metrics.ascent()), area.bottom - metrics.descent())
            text = QPointF(area.left - length - 2 * unit - wide, base)
            tick = QRect(area.left - length, round(middle_y), length, self._hair)
            top = math.floor(base - metrics.ascent()) - 1
            box = QRect(self.strip.left(), top, self.strip.width(), math.ceil(metrics.height()) + 3)
        tick &= self.strip  # the middle of a cell that is seen in part can lie outside
        return _Place(text, tick, box.united(tick))


class Rulers:
    """Both rulers of a canvas, painted once for each view of it and cell that is pointed at, and kept."""

    def __init__(self) -> None:
        self._scene: Scene | None = None
        self._kept: tuple[_Ruler, ...] = ()

    def paint(self, painter: QPainter, scene: Scene, pointed: Cell | None) -> None:
        """Axis numbers below and left of ``scene.area``; those of the ``pointed`` cell are emphasised."""
        if scene.overlay.plane:
            return
        plain = replace(scene, overlay=_PLAIN)
        if plain != self._scene:
            self._scene = plain
            self._kept = _rulers(plain)
        for ruler in self._kept:
            number = None if pointed is None else pointed[0 if ruler.horizontal else 1]
            painter.drawImage(ruler.strip.topLeft(), ruler.image(number))


def paint_rulers(painter: QPainter, scene: Scene) -> None:
    """Axis numbers below and left of ``scene.area``."""
    if not scene.overlay.plane:
        for ruler in _rulers(scene):
            ruler.paint(painter)


def _rulers(scene: Scene) -> tuple[_Ruler, _Ruler]:
    return _Ruler(scene, horizontal=False), _Ruler(scene, horizontal=True)
