"""A lens over a canvas: the numbers of the cells round one of them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.canvas.overlay import Cell
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme_changed, tokens
from workbench.widgets.look.type_faces import code_font, scaled

SIDE = 5
_ROW_PX, _LABEL_PX, _PAD, _NOTCH = 18, 26, 8, 6
_AWAY = 8


@dataclass(frozen=True, slots=True, eq=False)
class LensCells:
    """``middle`` is the cell in the middle, ``texts`` those in each of the SIDE x SIDE cells, the lowest row
    first, None outside of the picture; ``inks`` 0xRRGGBB of what each cell shows, or -1; ``notched`` those of
    what is drawn now; ``current`` is ringed, if it is seen.
    """

    title: str
    middle: Cell
    texts: tuple[tuple[str | None, ...], ...]
    inks: NDArray[np.int64]
    notched: NDArray[np.bool_]
    current: Cell | None


class Lens(QWidget):
    """Lies in the corner of ``canvas`` farthest from what it enlarges; the pointer goes through it."""

    def __init__(self, canvas: CanvasSurface) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.cells: LensCells | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAccessibleName(_("Numbers around the pixel"))
        theme_changed.connect(self.update)
        self.hide()

    def sizeHint(self) -> QSize:
        """Room for the widest number."""
        wide = scaled(_LABEL_PX) + SIDE * self._cell_width()
        return QSize(wide + 2 * _PAD, (SIDE + 2) * _ROW_PX + 2 * _PAD)

    def _cell_width(self) -> int:
        texts = [] if self.cells is None else [text or "" for row in self.cells.texts for text in row]
        widest = max(
            (QFontMetricsF(code_font(CAPTION_PX)).horizontalAdvance(text) for text in texts), default=0
        )
        return max(round(widest) + 8, 36)

    def show_cells(self, cells: LensCells | None, covered: int) -> None:
        """Show these, to the right of what is ``covered`` at the left; None hides the lens."""
        self.cells = cells
        size = self.sizeHint()
        room = self._canvas.width() - covered - 2 * _AWAY
        self.setVisible(cells is not None and size.width() < room / 2)
        if cells is None or self.isHidden():
            return
        self.resize(size)
        self.setAccessibleDescription(
            "; ".join(", ".join(text or "" for text in row) for row in reversed(cells.texts))
        )
        self._place(cells, covered)
        self.update()

    def _place(self, cells: LensCells, covered: int) -> None:
        area, unit = self._canvas.area, self._canvas.devicePixelRatioF()
        left, right = max(area.left / unit, covered) + _AWAY, area.right / unit - self.width() - _AWAY
        top, bottom = _AWAY, area.bottom / unit - self.height() - _AWAY
        seen = self._canvas.widget_position(*cells.middle)

        def away(corner: tuple[float, float]) -> float:
            x, y = corner
            return float(abs(x + self.width() / 2 - seen.x()) / 2 + abs(y + self.height() / 2 - seen.y()))

        x, y = max(((x, y) for x in (right, left) for y in (top, bottom)), key=away)
        self.move(round(x), round(y))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """A card with rulers of its own, and the numbers on their colours."""
        if self.cells is None:
            return
        painter, now, cells = QPainter(self), tokens(), self.cells
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        painter.setPen(QPen(colour(now.line), 1))
        painter.setBrush(colour(now.raised, 245))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        caption = QFont(self.font())
        caption.setPixelSize(scaled(CAPTION_PX))
        wide, half = self._cell_width(), SIDE // 2
        centre = Qt.AlignmentFlag.AlignCenter
        painter.setFont(caption)
        painter.setPen(colour(now.muted))
        painter.drawText(
            QRectF(_PAD, _PAD / 2, self.width() - 2 * _PAD, _ROW_PX),
            Qt.AlignmentFlag.AlignVCenter,
            cells.title,
        )
        for k in range(SIDE):
            x, y = _PAD + scaled(_LABEL_PX) + k * wide, _PAD + (SIDE + 1 - k) * _ROW_PX
            column, row = cells.middle[0] - half + k, cells.middle[1] - half + k
            painter.drawText(QRectF(x, _PAD + _ROW_PX, wide, _ROW_PX), centre, str(column))
            painter.drawText(QRectF(_PAD, y, scaled(_LABEL_PX), _ROW_PX), centre, str(row))
        painter.setFont(code_font(CAPTION_PX))
        for row in range(SIDE):
            for column in range(SIDE):
                x, y = _PAD + scaled(_LABEL_PX) + column * wide, _PAD + (SIDE + 1 - row) * _ROW_PX
                box = QRectF(x, y, wide - 1, _ROW_PX - 1)
                self._cell(painter, cells, row, column, box)
        painter.end()

    def _cell(self, painter: QPainter, cells: LensCells, row: int, column: int, box: QRectF) -> None:
        text, ink, now = cells.texts[row][column], int(cells.inks[row, column]), tokens()
        if text is None:
            return
        ground = QColor(0xFF000000 | ink) if ink >= 0 else colour(now.canvas)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour(now.canvas))
        painter.drawRect(box)
        if ink >= 0:
            painter.setBrush(QColor(ground.red(), ground.green(), ground.blue(), 70))
            painter.drawRect(box)
        if cells.notched[row, column]:
            painter.setBrush(ground)
            corner = box.topLeft()
            painter.drawPolygon(QPolygonF([corner, corner + QPointF(_NOTCH, 0), corner + QPointF(0, _NOTCH)]))
        painter.setPen(colour(now.text))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        half = SIDE // 2
        if cells.current == (cells.middle[0] - half + column, cells.middle[1] - half + row):
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(colour(now.text), 2))
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5))
