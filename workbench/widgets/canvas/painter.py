"""Paints a picture, its grid and its marks in screen pixels, for the screen and for paper alike."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPainter, QPen

from workbench.algorithms.marks import Word
from workbench.rendering.comparing import BOTH, ONLY_FIRST, ONLY_SECOND, TIE_FIRST, TIE_SECOND
from workbench.widgets.canvas.drawing import paint_drawn
from workbench.widgets.canvas.line_layers import LineLayers, paint_many
from workbench.widgets.canvas.mark_styles import sized
from workbench.widgets.canvas.marks import paint_handles, paint_marks
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.view import Area, CanvasView
from workbench.widgets.look.tokens import CAPTION_PX, Tokens, colour
from workbench.widgets.look.type_faces import scaled

GRID_FROM, GAP_FROM = 6, 8


@dataclass(frozen=True, slots=True)
class Scene:
    """One painting: ``unit`` is the screen pixels of one logical pixel, ``hair`` the width of a grid line.

    ``layers`` keep what a canvas painted before of thousands of lines.
    """

    area: Area
    view: CanvasView
    size: tuple[int, int]
    tokens: Tokens
    unit: float
    font: QFont
    overlay: Overlay
    vector: bool = False
    layers: LineLayers | None = None

    @property
    def hair(self) -> int:
        """Screen pixels of a grid line: one, two on a screen of twice the density once cells are large."""
        wide = max(1, int(self.unit))
        return wide if self.view.cell >= GAP_FROM * wide else 1

    def caption(self) -> QFont:
        """The font of axis numbers and labels, for a painter that draws in screen pixels."""
        font = QFont(self.font)
        font.setPixelSize(max(1, round(scaled(CAPTION_PX) * self.unit)))
        return font


class Picture:
    """A picture ready to be drawn: (h, w) 0xRRGGBB, ``background`` shown as the canvas of the theme."""

    def __init__(self, pixels: NDArray[np.uint32], background: int | None = None) -> None:
        self.pixels = pixels
        self.background = background
        self._kept = pixels
        self._shown: tuple[str, QImage] | None = None
        self._reduced: tuple[float, QImage] | None = None

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in cells."""
        return self.pixels.shape[1], self.pixels.shape[0]

    def image(self, tokens: Tokens) -> QImage:
        """Top row first, in the colours of the theme; made anew only when the theme changes."""
        if self._shown is None or self._shown[0] != tokens.canvas:
            shown = np.ascontiguousarray(self.pixels[::-1], np.uint32)
            if self.background is not None:
                ground = np.uint32(QColor(tokens.canvas).rgb())
                shown = np.where(shown == np.uint32(self.background), ground, shown)
            height, width = shown.shape
            self._kept = shown
            image = QImage(shown.data, width, height, 4 * width, QImage.Format.Format_RGB32)
            self._shown, self._reduced = (tokens.canvas, image), None
        return self._shown[1]

    def reduced(self, tokens: Tokens, cell: float) -> QImage:
        """The whole picture at less than one screen pixel per cell, every cell contributing."""
        image = self.image(tokens)
        if self._reduced is None or self._reduced[0] != cell:
            width, height = (max(1, round(side * cell)) for side in self.size)
            small = image.scaled(
                width,
                height,
                Qt.AspectRatioMode.IgnoreAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
            self._reduced = cell, small
        return self._reduced[1]


def paint_scene(painter: QPainter, picture: Picture, scene: Scene) -> None:
    """Everything inside ``scene.area``: picture, comparison, grid, ideal geometry, marks, handles."""
    area = scene.area
    clip = QRect(area.left, area.top, area.width, area.height)
    painter.save()
    painter.setClipRect(clip)
    seen = None if scene.overlay.plane else scene.view.visible(area, *scene.size)
    if scene.overlay.plane:
        painter.fillRect(clip, colour(scene.tokens.canvas))
    if seen is not None:
        if scene.vector:
            _paint_cells(painter, picture, scene, seen)
        else:
            _paint_picture(painter, picture, scene, seen)
        if scene.overlay.classes is not None:
            _paint_classes(painter, scene.overlay.classes, scene, seen)
        _paint_grid(painter, scene, seen)
    if not scene.overlay.plane:
        _paint_edge(painter, scene)
    painter.restore()
    paint_over(painter, scene)


def paint_over(painter: QPainter, scene: Scene) -> None:
    """What lies over the picture inside ``scene.area``: ideal geometry, constructions, marks, handles."""
    area = scene.area
    painter.save()
    painter.setClipRect(QRect(area.left, area.top, area.width, area.height))
    _paint_curves(painter, scene)
    drawn = tuple(sized(each, scene.view.cell / scene.unit) for each in scene.overlay.drawn)
    words = tuple(each for each in drawn if isinstance(each, Word))
    paint_drawn(painter, scene, tuple(each for each in drawn if not isinstance(each, Word)))
    paint_marks(painter, scene)
    paint_drawn(painter, scene, words)  # over the marks, which would strike them through
    paint_handles(painter, scene)
    painter.restore()


def _box(scene: Scene, seen: tuple[int, int, int, int]) -> tuple[QRect, QRect]:
    """The seen cells as a part of the screen and as a part of the image (top row first)."""
    column, last_column, row, last_row = seen
    cell = int(scene.view.cell)
    columns, rows = last_column - column + 1, last_row - row + 1
    on_screen = QRect(
        scene.view.left + column * cell,
        scene.view.bottom - (last_row + 1) * cell,
        columns * cell,
        rows * cell,
    )
    return on_screen, QRect(column, scene.size[1] - 1 - last_row, columns, rows)


def _paint_picture(
    painter: QPainter, picture: Picture, scene: Scene, seen: tuple[int, int, int, int]
) -> None:
    if scene.view.cell >= 1:
        on_screen, part = _box(scene, seen)
        painter.drawImage(on_screen, picture.image(scene.tokens), part)
    else:
        small = picture.reduced(scene.tokens, scene.view.cell)
        painter.drawImage(scene.view.left, scene.view.bottom - small.height(), small)


def _paint_cells(painter: QPainter, picture: Picture, scene: Scene, seen: tuple[int, int, int, int]) -> None:
    """The picture as rectangles, one per run of equal cells in a row, for paper."""
    column, last_column, row, last_row = seen
    on_screen = QRectF(_box(scene, seen)[0]) if scene.view.cell >= 1 else QRectF()
    painter.fillRect(on_screen, colour(scene.tokens.canvas))
    for y in range(row, last_row + 1):
        values = picture.pixels[y, column : last_column + 1]
        starts = np.flatnonzero(np.diff(values, prepend=~values[:1]))
        for start, end in zip(starts, [*starts[1:], len(values)], strict=True):
            if int(values[start]) != picture.background:
                left, top = scene.view.to_screen(column + int(start) - 0.5, y + 0.5)
                box = QRectF(left, top, (int(end) - int(start)) * scene.view.cell, scene.view.cell)
                painter.fillRect(box, QColor(0xFF000000 | int(values[start])))


def class_colours(tokens: Tokens) -> dict[int, str]:
    """The colour of each class of a comparison; a pattern stands beside each."""
    first, second = tokens.data[0], tokens.data[1]
    return {
        ONLY_FIRST: first,
        ONLY_SECOND: second,
        BOTH: tokens.agreement,
        TIE_FIRST: first,
        TIE_SECOND: second,
    }


def _paint_classes(
    painter: QPainter, classes: NDArray[np.uint8], scene: Scene, seen: tuple[int, int, int, int]
) -> None:
    column, last_column, row, last_row = seen
    part = np.ascontiguousarray(classes[row : last_row + 1, column : last_column + 1][::-1])
    table = np.zeros(max(TIE_SECOND, BOTH) + 1, np.uint32)
    for value, name in class_colours(scene.tokens).items():
        table[value] = colour(name).rgba()
    shown = table[part]
    height, width = part.shape
    image = QImage(shown.data, width, height, 4 * width, QImage.Format.Format_ARGB32_Premultiplied)
    left, top = scene.view.to_screen(column - 0.5, last_row + 0.5)
    painter.drawImage(QRectF(left, top, width * scene.view.cell, height * scene.view.cell), image)


def _paint_grid(painter: QPainter, scene: Scene, seen: tuple[int, int, int, int]) -> None:
    cell = int(scene.view.cell)
    if cell < GRID_FROM:
        return
    column, last_column, row, last_row = seen
    box, _part = _box(scene, seen)
    tokens, hair = scene.tokens, scene.hair
    plain, strong = QColor(tokens.grid), QColor(tokens.grid_strong)
    for tenth, ink in ((False, plain), (True, strong)):
        for x in range(column, last_column + 2):
            if (x % 10 == 0) == tenth:
                painter.fillRect(scene.view.left + x * cell, box.top(), hair, box.height() + hair, ink)
        for y in range(row, last_row + 2):
            if (y % 10 == 0) == tenth:
                painter.fillRect(box.left(), scene.view.bottom - y * cell, box.width() + hair, hair, ink)


def _paint_edge(painter: QPainter, scene: Scene) -> None:
    """The edge of the picture."""
    width, height = (round(side * scene.view.cell) for side in scene.size)
    hair = scene.hair
    left, top, bottom = scene.view.left, scene.view.bottom - height, scene.view.bottom
    ink = QColor(scene.tokens.grid_strong)
    for box in (
        (left, top, width + hair, hair),
        (left, bottom, width + hair, hair),
        (left, top, hair, height),
        (left + width, top, hair, height + hair),
    ):
        painter.fillRect(*box, ink)


def _paint_curves(painter: QPainter, scene: Scene) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    muted = QPen(QColor(scene.tokens.muted), 1.25 * scene.unit)
    accent = QPen(QColor(scene.tokens.accent), 1.5 * scene.unit)
    for pen, curves in ((muted, scene.overlay.ideal), (accent, scene.overlay.outlined)):
        paint_many(painter, scene, curves, pen)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
