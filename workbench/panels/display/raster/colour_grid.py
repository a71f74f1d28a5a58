"""The entries of a colour table as a grid of swatches, of which one is chosen; or three ramps."""

import math
from collections.abc import Sequence

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QLinearGradient, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, theme, tokens

_COLUMNS, _CELL_PX, _RAMP_PX = 16, 20, 16
_RAMPS = ("#FF0000", "#00FF00", "#0000FF")
_WAYS = {
    Qt.Key.Key_Left: -1,
    Qt.Key.Key_Right: 1,
    Qt.Key.Key_Up: -_COLUMNS,
    Qt.Key.Key_Down: _COLUMNS,
}


class ColourGrid(QWidget):
    """``chosen`` sends the number of an entry, ``wanted`` one that is to be changed."""

    chosen = Signal(int)
    wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colours: tuple[int, ...] = ()
        self._direct = False
        self.index = 0
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(_("Colour table"))
        self.setToolTip(_("Click an entry to choose it, double-click it to change its colour."))
        theme.changed.connect(self.update)

    def show_colours(self, colours: Sequence[int], direct: bool) -> None:
        """Show these entries (0xRRGGBB), or three ramps where the bits are the colour."""
        self._colours, self._direct = tuple(colours), direct
        self.index = min(self.index, max(len(self._colours) - 1, 0))
        self.updateGeometry()
        self.update()

    def sizeHint(self) -> QSize:
        """As many rows as there are colours for."""
        rows = max(1, math.ceil(len(self._colours) / _COLUMNS))
        return QSize(_COLUMNS * _CELL_PX, 3 * (_RAMP_PX + 4) if self._direct else rows * self._cell)

    @property
    def _cell(self) -> int:
        return max(8, min(_CELL_PX, self.width() // _COLUMNS)) if self.width() else _CELL_PX

    def choose(self, index: int) -> None:
        """Choose an entry."""
        if 0 <= index < len(self._colours) and not self._direct:
            self.index = index
            self.chosen.emit(index)
            self.update()

    def _at(self, event: QMouseEvent) -> int:
        place = event.position()
        column = int(place.x() // self._cell)
        return int(place.y() // self._cell) * _COLUMNS + column if column < _COLUMNS else -1

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the entry."""
        self.choose(self._at(event))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """The press has done it."""

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Change the entry."""
        if 0 <= self._at(event) < len(self._colours) and not self._direct:
            self.wanted.emit(self._at(event))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows go from entry to entry, Enter changes one."""
        way = _WAYS.get(Qt.Key(event.key()))
        if not is_plain(event):
            super().keyPressEvent(event)
        elif way is not None:
            self.choose(self.index + way)
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self._colours and not self._direct:
            self.wanted.emit(self.index)
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The swatches, the chosen one ringed twice."""
        painter = QPainter(self)
        if self._direct:
            self._paint_ramps(painter)
            return
        cell = self._cell
        for number, each in enumerate(self._colours):
            row, column = divmod(number, _COLUMNS)
            box = QRectF(column * cell + 1, row * cell + 1, cell - 2, cell - 2)
            painter.fillRect(box, QColor.fromRgb(each))
            painter.setPen(QPen(colour(tokens().line), 1))
            painter.drawRect(box)
            if number == self.index:
                painter.setPen(QPen(colour(tokens().text), 2))
                painter.drawRect(box.adjusted(0, 0, 0, 0))
                painter.setPen(QPen(colour(tokens().canvas), 1))
                painter.drawRect(box.adjusted(2, 2, -2, -2))
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 1))
            painter.drawRect(QRectF(0.5, 0.5, _COLUMNS * cell - 1, self.height() - 1))

    def _paint_ramps(self, painter: QPainter) -> None:
        for number, last in enumerate(_RAMPS):
            box = QRectF(0, number * (_RAMP_PX + 4), _COLUMNS * self._cell, _RAMP_PX)
            ramp = QLinearGradient(box.topLeft(), box.topRight())
            ramp.setColorAt(0.0, QColor("#000000"))
            ramp.setColorAt(1.0, QColor(last))
            painter.fillRect(box, ramp)
