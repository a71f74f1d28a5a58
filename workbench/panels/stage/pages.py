"""The steps of a run as pages: picture, rulers and sentence, painted as images, PDF or SVG."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QRect, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QFont, QImage, QPageSize, QPainter, QPdfWriter

from workbench.exchange.frames import Picture as Frame
from workbench.exchange.writing import FileFormat, Progress, Put, of_kind, whole
from workbench.exchange.written import FORMATS as WINDOWLESS
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.painter import Picture, Scene, paint_scene
from workbench.widgets.canvas.rulers import paint_rulers, ruler_sizes
from workbench.widgets.canvas.view import Area, fitted
from workbench.widgets.look.tokens import LIGHT

if TYPE_CHECKING:
    from workbench.exchange.diagrams import Derivation

PAGE_MM = (180.0, 140.0)
PICTURE_WIDTH = 1600
DRAWING = QSize(1080, 840)
DOTS_PER_INCH = 1200
CAPTION_PX = 40
_CAPTION_LEFT_PX = 24


class Paintable(Protocol):
    """What a page of a run shows, over the sentence ``caption``."""

    @property
    def caption(self) -> str:
        """The sentence under it."""

    def paint(self, painter: QPainter, size: tuple[int, int], font: QFont, unit: float, vector: bool) -> None:
        """Paint it on an area of ``size`` dots; ``unit`` dots are one logical pixel. As ``vector`` nothing is
        an image that can be shapes."""


@dataclass(frozen=True, slots=True)
class Page:
    """One picture of a run with its rulers: what it shows, and the sentence under it."""

    picture: Picture
    overlay: Overlay
    caption: str

    def paint(self, painter: QPainter, size: tuple[int, int], font: QFont, unit: float, vector: bool) -> None:
        """The picture between its rulers; as ``vector`` every run of cells is a shape of its own."""
        ruler_width, ruler_height = ruler_sizes(font, self.picture.size, unit)
        area = Area(ruler_width, 0, size[0], size[1] - ruler_height)
        view = fitted(area, *self.picture.size, round(8 * unit), largest=4096)
        scene = Scene(area, view, self.picture.size, LIGHT, unit, font, self.overlay, vector)
        paint_scene(painter, self.picture, scene)
        paint_rulers(painter, scene)


@dataclass(frozen=True, slots=True)
class Pages:
    """``parts`` pages, each made when it is asked for, as an image of ``width`` pixels.

    In a GIF each is seen for ``seconds``.
    """

    parts: int
    page: Callable[[int], Paintable]
    title: str
    font: QFont
    width: int = PICTURE_WIDTH
    seconds: float = 1.0
    rests: bool = True

    def image(self, number: int) -> Frame:
        """Page ``number`` as pixels, (h, w, 3), the top row first."""
        image = page_image(self.page(number), self.font, self.width)
        image = image.convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
        return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def paint_page(
    painter: QPainter, page: Paintable, size: tuple[int, int], font: QFont, unit: float, vector: bool = True
) -> None:
    """Paint a page with its caption on an area of ``size`` dots; ``unit`` dots are one logical pixel."""
    below = round(CAPTION_PX * unit)
    page.paint(painter, (size[0], size[1] - below), font, unit, vector)
    caption = QFont(font)
    caption.setPixelSize(round(13 * unit))
    painter.setFont(caption)
    painter.setPen(Qt.GlobalColor.black)
    left = round(_CAPTION_LEFT_PX * unit)
    box = QRectF(left, size[1] - below, size[0] - 2 * left, below)
    painter.drawText(box, Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignVCenter, page.caption)


def page_image(page: Paintable, font: QFont, width: int = PICTURE_WIDTH) -> QImage:
    """A page as an image."""
    height = round(width * PAGE_MM[1] / PAGE_MM[0])
    image = QImage(width, height, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.TextAntialiasing)
    paint_page(painter, page, (width, height), font, width / 800, vector=False)
    painter.end()
    return image


def _pdf(pages: Pages, put: Put, told: Progress) -> None:
    """One page per picture, with lines and cells as vectors."""
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setResolution(DOTS_PER_INCH)
    writer.setPageSize(QPageSize(QSizeF(*PAGE_MM), QPageSize.Unit.Millimeter))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    writer.setTitle(pages.title)
    painter = QPainter(writer)
    try:
        for number in range(pages.parts):
            told(number, pages.parts)
            if number:
                writer.newPage()
            size = writer.width(), writer.height()
            paint_page(painter, pages.page(number), size, pages.font, DOTS_PER_INCH / 96)
    finally:
        painter.end()
    put(bytes(buffer.data().data()))


def _svg(pages: Pages, put: Put, _told: Progress) -> None:
    """The first page as shapes."""
    from PySide6.QtSvg import QSvgGenerator

    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QSvgGenerator()
    writer.setOutputDevice(buffer)
    writer.setSize(DRAWING)
    whole = QRect(0, 0, DRAWING.width(), DRAWING.height())
    writer.setViewBox(whole)
    writer.setTitle(pages.title)
    painter = QPainter(writer)
    painter.fillRect(whole, Qt.GlobalColor.white)
    paint_page(painter, pages.page(0), (DRAWING.width(), DRAWING.height()), pages.font, 1.5)
    painter.end()
    put(bytes(buffer.data().data()))


def _derivation_pdf(content: Derivation) -> bytes:
    from workbench.widgets.formulas.paper import write_pdf

    return write_pdf(content)


FORMATS: tuple[FileFormat, ...] = (
    *WINDOWLESS,
    FileFormat("step", ".svg", "SVG", _svg),
    FileFormat("step", ".pdf", "PDF", _pdf),
    FileFormat("run", ".pdf", "PDF", _pdf),
    FileFormat("derivation", ".pdf", "PDF", whole(_derivation_pdf)),
)


def formats_of(kind: str) -> tuple[FileFormat, ...]:
    """Every way in which one kind of content is written."""
    return of_kind(FORMATS, kind)
