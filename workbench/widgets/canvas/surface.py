"""The seen half of the pixel canvas: the picture, its zoom and pan, and the painting."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen, QRegion, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.canvas.handle_names import label_box, label_size, paint_label, tag_box
from workbench.widgets.canvas.line_layers import LineLayers
from workbench.widgets.canvas.marks import ring
from workbench.widgets.canvas.overlay import Cell, Overlay, Still
from workbench.widgets.canvas.painter import Picture, Scene, paint_over, paint_scene
from workbench.widgets.canvas.rulers import Rulers, paint_rulers, ruler_sizes
from workbench.widgets.canvas.view import Area, CanvasView, centred, fitted
from workbench.widgets.look.tokens import theme_changed, tokens

MARGIN = 12
WORTHWHILE = 0.85
SMALLEST = 0.1

Reach = tuple[float, float, float, float]


class CanvasSurface(QWidget):
    """A picture of cells under grid, rulers and marks. ``view_changed`` sends the zoom in percent."""

    view_changed = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 120)
        self.setAccessibleName(_("Picture"))
        self._picture = Picture(np.zeros((1, 1), np.uint32), 0)
        self._overlay = Overlay()
        self._rulers = Rulers()
        self._view = CanvasView()
        self._keeps_fit = True
        self._covered = 0
        self._reach: Reach | None = None
        self.worthwhile = WORTHWHILE
        self.cells_per_unit = 1.0
        self._stale = True
        self._frame = QImage()
        self._layers = LineLayers()
        self._kept: tuple[tuple[object, ...], QImage] | None = None
        self._describe: Callable[[int, int], str] | None = None
        self._tag = ""
        self._hover: Cell | None = None
        self._pointer = QPointF()
        self._cursor: Cell | None = None
        self._pointed: Cell | None = None
        theme_changed.connect(self.repaint_soon)

    # What is shown

    def set_picture(self, pixels: NDArray[np.uint32], background: int | None = None) -> None:
        """Show (h, w) 0xRRGGBB cells, indexed [y, x]; ``background`` is shown as the theme's canvas.

        The array is kept, not copied, and must not be written afterwards.
        """
        before = self._picture.size
        self._picture = Picture(pixels, background)
        if self._picture.size != before:
            if self._cursor is not None:
                self._cursor = self._inside(*self._cursor)
            self.fit()
        self.repaint_soon()

    def set_overlay(self, overlay: Overlay) -> None:
        """Show other marks."""
        other_ground = overlay.plane != self._overlay.plane
        self._overlay = overlay
        if other_ground and self._keeps_fit:
            self.fit()
        self.repaint_soon()

    def set_describer(self, describe: Callable[[int, int], str] | None) -> None:
        """``describe(x, y)`` names what is at a cell: the pointer's tag, and what a screen reader says."""
        self._describe = describe

    def set_tag(self, text: str) -> None:
        """Text beside the pointer while something is being dragged; empty shows what the pointer is over."""
        if text != self._tag:
            self._tag = text
            self.repaint_soon()

    def point_at(self, cell: Cell | None) -> None:
        """Ring a cell that something else names, and bring it into sight; None rings none."""
        if cell is not None:
            self._bring_into_view(cell)
        if cell != self._pointed:
            self._pointed = cell
            self.repaint_soon()

    @property
    def pointed(self) -> Cell | None:
        """The cell that is ringed because something else names it."""
        return self._pointed

    @property
    def overlay(self) -> Overlay:
        """The marks shown now."""
        return self._overlay

    @property
    def picture_size(self) -> tuple[int, int]:
        """Width and height in cells."""
        return self._picture.size

    # Zoom and pan

    @property
    def view(self) -> CanvasView:
        """The mapping between cells and screen pixels."""
        return self._view

    @property
    def zoom_percent(self) -> float:
        """100 is one cell on one pixel of the screen."""
        return self._view.cell * 100

    @property
    def zoom_words(self) -> str:
        """How large the picture is shown; of a plane, how many logical pixels one unit of it is wide."""
        if self._overlay.plane:
            wide = self._view.cell * self.cells_per_unit / self.devicePixelRatioF()
            return _("{pixels:.3g} px per unit").format(pixels=wide)
        return f"{self.zoom_percent:.0f} %"

    def fit(self) -> None:
        """The whole picture, as large as whole cells allow; stays so when the widget is resized.

        What is covered at the left stays free, unless the picture would then be smaller than ``worthwhile``,
        a share of its size.
        """
        self._keeps_fit = True
        area, margin = self.area, round(MARGIN * self.devicePixelRatioF())
        plane = self._overlay.plane
        left, bottom, right, top = self._whole()
        size = right - left, top - bottom
        whole = fitted(area, *size, margin, in_cells=not plane)
        covered = min(area.right - 1, area.left + round(self._covered * self.devicePixelRatioF()))
        beside = fitted(replace(area, left=covered), *size, margin, in_cells=not plane)
        if beside.cell < self.worthwhile * whole.cell:
            # As far from what is covered as the picture can go and be seen whole
            room = area.right - margin - whole.left - round(whole.cell * size[0])
            beside = whole.moved(max(0, min(room, covered - whole.left)), 0)
        self._show(beside.moved(-round(left * beside.cell), round(bottom * beside.cell)), keep=True)

    def _whole(self) -> Reach:
        """What a fitted picture shows, itself and what reaches beyond it, in cells from its lower left."""
        width, height = self._picture.size
        if self._reach is None:
            return 0.0, 0.0, width, height
        left, bottom, right, top = self._reach
        return min(left + 0.5, 0.0), min(bottom + 0.5, 0.0), max(right + 0.5, width), max(top + 0.5, height)

    def set_reach(self, reach: Reach | None) -> None:
        """What is drawn of a plane reaches so far: left, bottom, right, top, device."""
        before = self._whole()
        self._reach = reach
        if self._keeps_fit and self._whole() != before:
            self.fit()

    def set_covered(self, width: int) -> None:
        """So many logical pixels at the left of the picture are covered by something else."""
        if width != self._covered:
            self._covered = width
            if self._keeps_fit:
                self.fit()

    def actual_size(self) -> None:
        """One cell on one pixel of the screen."""
        self._show(centred(self.area, *self._picture.size, 1.0))

    def zoom(self, steps: int, about: QPointF | None = None) -> None:
        """Nearer (or, negative, farther) by levels, about a point of the widget, or about its middle."""
        x, y = self.area.centre if about is None else self._screen(about)
        self._show(self._view.zoomed(steps, x, y, self._least_cell))

    def pan(self, right: int, down: int) -> None:
        """Move the picture by whole screen pixels."""
        self._show(self._view.moved(right, down))

    @property
    def _least_cell(self) -> float:
        """The size of a cell at which the picture is a tenth as wide, or as high, as there is room."""
        left, bottom, right, top = self._whole()
        return SMALLEST / max((right - left) / self.area.width, (top - bottom) / self.area.height)

    @property
    def beyond(self) -> Reach:
        """How far the picture and a margin reach beyond the area: left, top, right, bottom; screen pixels."""
        view, area, margin = self._view, self.area, MARGIN * self.devicePixelRatioF()
        left, bottom, right, top = (view.cell * side for side in self._whole())
        return (
            area.left - view.left - left + margin,
            area.top - view.bottom + top + margin,
            view.left + right - area.right + margin,
            view.bottom - bottom - area.bottom + margin,
        )

    @property
    def keeps_fit(self) -> bool:
        """Whether the picture stays fitted when the widget is resized."""
        return self._keeps_fit

    def look_like(self, other: "CanvasSurface") -> None:
        """Take over the view of another canvas, so that two lie side by side alike."""
        if (other._view, other._keeps_fit) != (self._view, self._keeps_fit):
            self._show(other._view, keep=other._keeps_fit)

    def _show(self, view: CanvasView, keep: bool = False) -> None:
        self._keeps_fit = keep
        margin = round(4 * MARGIN * self.devicePixelRatioF())
        self._view = view.kept_near(self.area, *self._picture.size, margin)
        self.view_changed.emit(self.zoom_percent)
        self.repaint_soon()

    def _bring_into_view(self, cell: Cell) -> None:
        area = self.area
        left, top, side = self._view.cell_box(*cell)
        right = max(0, area.left + side - left) - max(0, left + 2 * side - area.right)
        down = max(0, area.top + side - top) - max(0, top + 2 * side - area.bottom)
        if right or down:
            self.pan(right, down)

    @property
    def area(self) -> Area:
        """The part inside the rulers, in screen pixels of the widget."""
        unit = self.devicePixelRatioF()
        if self._overlay.plane:
            return Area(0, 0, round(self.width() * unit), round(self.height() * unit))
        ruler_width, ruler_height = ruler_sizes(self.font(), self._picture.size, unit)
        return Area(ruler_width, 0, round(self.width() * unit), round(self.height() * unit) - ruler_height)

    def _screen(self, position: QPointF) -> tuple[float, float]:
        unit = self.devicePixelRatioF()
        return position.x() * unit, position.y() * unit

    def device_position(self, position: QPointF) -> tuple[float, float]:
        """Device point under a position of the widget (logical pixels)."""
        return self._view.to_device(*self._screen(position))

    def widget_position(self, x: float, y: float) -> QPointF:
        """Position in the widget (logical pixels) of a device point."""
        unit = self.devicePixelRatioF()
        screen_x, screen_y = self._view.to_screen(x, y)
        return QPointF(screen_x / unit, screen_y / unit)

    def _inside(self, x: int, y: int) -> Cell:
        width, height = self._picture.size
        return min(max(x, 0), width - 1), min(max(y, 0), height - 1)

    def sizeHint(self) -> QSize:
        """Room enough to be useful."""
        return QSize(640, 480)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """A fitted picture stays fitted, another keeps its middle."""
        if self._keeps_fit:
            self.fit()
        else:
            unit, old = self.devicePixelRatioF(), event.oldSize()
            right = round((self.width() - old.width()) * unit / 2)
            down = round((self.height() - old.height()) * unit / 2)
            self.pan(right, down)

    # Painting

    def repaint_soon(self) -> None:
        """Something shown has changed: paint it anew. Where a child lies on top nothing is to be seen."""
        if self._stale:
            return  # as has been asked for
        self._stale = True
        region = QRegion(self.rect())
        for child in self.children():
            if isinstance(child, QWidget) and child.isVisible():
                region -= child.geometry()
        self.update(region)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Show the frame; it is painted anew only when something in it has changed."""
        unit = self.devicePixelRatioF()
        size = QSize(math.ceil(self.width() * unit) + 1, math.ceil(self.height() * unit) + 1)
        if self._stale or self._frame.size() != size:
            if self._frame.size() != size:
                self._frame = QImage(size, QImage.Format.Format_RGB32)
            self._stale = False  # first: after a fault the next change is painted again
            self._paint_frame()
        painter = QPainter(self)
        origin = painter.deviceTransform()
        painter.translate(
            (round(origin.dx()) - origin.dx()) / unit, (round(origin.dy()) - origin.dy()) / unit
        )
        painter.scale(1 / unit, 1 / unit)
        painter.drawImage(0, 0, self._frame)
        painter.end()

    def _paint_frame(self) -> None:
        """Picture, marks, rulers, cursor and tag."""
        still = self._overlay.still
        scene = replace(self.scene(), layers=self._layers if still is None else None)
        area, unit = scene.area, scene.unit
        if still is None:
            self._kept = None
            self._frame.fill(QColor(scene.tokens.window))
            painter = QPainter(self._frame)
            paint_scene(painter, self._picture, scene)
            self._end_layers()
        else:
            painter = QPainter(self._frame)
            painter.drawImage(0, 0, self._still_frame(scene, still))
            paint_over(painter, scene)
        self._rulers.paint(painter, scene, self._cursor or self._hover)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        if self._pointed is not None:
            self._paint_ring(painter, scene, self._pointed)
        if self._cursor is not None:
            self._paint_cursor(painter, scene)
        tag = self._tag or self._hover_text()
        if tag:
            paint_label(painter, tag, tag_box(tag, *self._screen(self._pointer), scene), scene)
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(scene.tokens.accent), 2 * unit))
            painter.drawRect(QRectF(area.left + unit, unit, area.width - 2 * unit, area.height - 2 * unit))
        painter.end()

    def _still_frame(self, scene: Scene, still: Still) -> QImage:
        """The picture under what stays; painted anew only when one of them or the view is another."""
        key = still, self._picture, scene.view, scene.tokens, self._frame.size()
        if self._kept is not None and self._kept[0] == key:
            return self._kept[1]
        image = QImage(self._frame.size(), self._frame.format())
        image.fill(QColor(scene.tokens.window))
        painter = QPainter(image)
        layered = replace(scene, overlay=Overlay(drawn=still.drawn), layers=self._layers)
        paint_scene(painter, self._picture, layered)
        paint_over(painter, replace(scene, overlay=Overlay(handles=still.handles)))
        painter.end()
        self._kept = None if self._end_layers() else (key, image)
        return image

    def _end_layers(self) -> bool:
        """Whether the lines that were just painted are not yet all of them; another frame has more."""
        if grow := self._layers.end_frame():
            QTimer.singleShot(0, self, self.repaint_soon)
        return grow

    def scene(self) -> Scene:
        """What is painted now."""
        unit = self.devicePixelRatioF()
        return Scene(self.area, self._view, self._picture.size, tokens(), unit, self.font(), self._overlay)

    @property
    def picture(self) -> Picture:
        """The picture shown now."""
        return self._picture

    def _paint_cursor(self, painter: QPainter, scene: Scene) -> None:
        assert self._cursor is not None
        left, top, side = self._paint_ring(painter, scene, self._cursor)
        if not self._tag and self._describe is not None:
            text = self._describe(*self._cursor)
            paint_label(painter, text, label_box(label_size(text, scene), left + side, top, scene), scene)

    def _paint_ring(self, painter: QPainter, scene: Scene, cell: Cell) -> tuple[float, float, float]:
        left, top, side = scene.view.cell_box(*cell)
        painter.setClipRect(QRectF(scene.area.left, scene.area.top, scene.area.width, scene.area.height))
        ring(painter, QRectF(left, top, side, side).adjusted(-1, -1, 1, 1), scene)
        painter.setClipping(False)
        return left, top, side

    def _hover_text(self) -> str:
        if self._hover is None or self._describe is None or self._cursor is not None:
            return ""
        return self._describe(*self._hover)

    def grab_picture(self) -> QImage:
        """What the canvas shows now, without cursor and tag, in screen pixels."""
        scene = self.scene()
        area = scene.area
        plane = scene.overlay.plane
        ruler_height = 0 if plane else ruler_sizes(self.font(), self._picture.size, scene.unit)[1]
        image = QImage(area.right, area.bottom + ruler_height, QImage.Format.Format_RGB32)
        image.fill(QColor(scene.tokens.surface))
        painter = QPainter(image)
        paint_scene(painter, self._picture, scene)
        paint_rulers(painter, scene)
        painter.end()
        return image
