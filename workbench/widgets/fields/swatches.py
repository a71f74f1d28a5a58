"""A row of colours to choose one from; the chosen one bears a tick, so that no colour speaks alone."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from workbench.language import _
from workbench.widgets.look.tokens import theme_changed, tokens

SIDE_PX = 20


class Swatches(QWidget):
    """``chosen`` sends the index of a colour. ``name`` is what the colour is for."""

    chosen = Signal(int)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._name = name
        self._colours: tuple[int, ...] = ()
        self._left_out = -1
        self._index = -1
        self._buttons: dict[int, QToolButton] = {}
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(1)
        self.label = QLabel(name)
        self._row.addWidget(self.label, 1)
        theme_changed.connect(self._paint)

    def show_colours(self, colours: Sequence[int], index: int, left_out: int = -1) -> None:
        """Offer ``colours`` (0xRRGGBB) without the one at ``left_out``; ``index`` is the present one."""
        shown = tuple(colours)
        if (shown, left_out) != (self._colours, self._left_out):
            self._colours, self._left_out = shown, left_out
            for button in self._buttons.values():
                button.deleteLater()
            offered = [k for k in range(len(shown)) if k != left_out]
            self._buttons = {k: self._button(k) for k in offered[:8]}
            self._index = -2
        if index != self._index:
            self._index = index
            self._paint()

    def _button(self, index: int) -> QToolButton:
        button = QToolButton()
        button.setFixedSize(SIDE_PX, SIDE_PX)
        button.setIconSize(QSize(SIDE_PX, SIDE_PX))
        text = _("{name}: number {index} of the palette").format(name=self._name, index=index)
        button.setToolTip(text)
        button.setAccessibleName(text)
        button.setAutoRaise(True)
        button.setStyleSheet("padding: 0; border: none;")
        button.clicked.connect(lambda: self.chosen.emit(index))
        self._row.addWidget(button)
        return button

    def _paint(self) -> None:
        ratio = self.devicePixelRatioF()
        for index, button in self._buttons.items():
            pixmap = QPixmap(round(SIDE_PX * ratio), round(SIDE_PX * ratio))
            pixmap.setDevicePixelRatio(ratio)
            pixmap.fill(Qt.GlobalColor.transparent)
            painter = QPainter(pixmap)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor.fromRgb(self._colours[index]))
            painter.drawRoundedRect(QRectF(3, 3, SIDE_PX - 6, SIDE_PX - 6), 3, 3)
            if index == self._index:
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(QPen(QColor(tokens().text), 1.5))
                painter.drawRoundedRect(QRectF(1, 1, SIDE_PX - 2, SIDE_PX - 2), 5, 5)
                painter.setPen(QPen(QColor("#FFFFFF"), 2))
                painter.drawPolyline([QPointF(6.5, 10.5), QPointF(9, 13), QPointF(13.5, 7.5)])
            painter.end()
            button.setIcon(QIcon(pixmap))
