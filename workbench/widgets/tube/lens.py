"""A magnifying glass over a tube: what lies under it is drawn anew, larger, as the beam draws it."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

_RIM = QColor("#AEB6BF")
_SHADE = QColor(0, 0, 0, 150)
_RIM_PX = 4.0
_LEAST_PX, _MOST_PX = 72, 190


class TubeLens(QWidget):
    """Lies over ``tube`` and lets the pointer through. ``size_px`` is how large a picture it takes."""

    def __init__(self, tube: QWidget) -> None:
        super().__init__(tube)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._picture: QImage | None = None
        self._tube = tube

    @property
    def size_px(self) -> int:
        """Width and height in pixels of the device: a good part of the tube's height."""
        return min(max(round(0.44 * min(self._tube.width(), self._tube.height())), _LEAST_PX), _MOST_PX)

    def show_part(self, pixels: NDArray[np.uint32], place: QPointF) -> None:
        """Show a picture 0xFFRRGGBB, top row first, beside a place of the tube, away from its middle."""
        rows, columns = pixels.shape
        self._picture = QImage(
            pixels.tobytes(), columns, rows, 4 * columns, QImage.Format.Format_RGB32
        ).copy()
        side = columns + 2 * round(_RIM_PX)
        self.setFixedSize(side, side)
        middle = QPointF(self._tube.rect().center())
        x = place.x() + (8 if place.x() < middle.x() else -side - 8)
        y = place.y() + (8 if place.y() < middle.y() else -side - 8)
        x = min(max(x, 0), self._tube.width() - side)
        y = min(max(y, 0), self._tube.height() - side)
        self.move(round(x), round(y))
        self.show()
        self.raise_()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The part in a round frame."""
        if self._picture is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        inside = QRectF(self.rect()).adjusted(_RIM_PX, _RIM_PX, -_RIM_PX, -_RIM_PX)
        path = QPainterPath()
        path.addEllipse(inside)
        painter.setClipPath(path)
        painter.fillRect(self.rect(), Qt.GlobalColor.black)
        painter.drawImage(inside, self._picture)
        painter.setClipping(False)
        for pen in (QPen(_SHADE, _RIM_PX + 2), QPen(_RIM, _RIM_PX - 1)):
            painter.setPen(pen)
            painter.drawEllipse(inside)
        painter.end()
