"""Depths along one row of a picture, under the canvas that shows it, sharing its columns."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme_changed, tokens
from workbench.widgets.look.type_faces import scaled

HEIGHT, LEAST_HEIGHT = 104, 72
_TOP, _BOTTOM = 18, 18
_SQUARE, _DOT = 5.0, 2.0

Numbers = NDArray[np.float64]
_Place = Callable[[float, float], QPointF]


@dataclass(frozen=True, slots=True, eq=False)
class RowOfDepths:
    """Row ``y`` of a depth buffer: what was ``stored`` (w,) before the surface came to it, not a number where
    nothing was; the surface's fragments (n, 2) as (column, z), those that won, those that were refused, and
    those to come; its colour; where the run stands; and two lines of words.
    """

    y: int
    stored: Numbers
    won: Numbers
    refused: Numbers
    to_come: Numbers
    surface: QColor
    column: int | None
    step: str
    plane: str


class RowDepths(QWidget):
    """``canvas`` gives the columns; without a row a sentence stands there."""

    def __init__(self, canvas: CanvasSurface, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self.row: RowOfDepths | None = None
        self.setMinimumHeight(LEAST_HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(_("Depths along the row"))
        self.setToolTip(
            _("Line: the stored z. Squares: the surface's z, filled where it wins, hollow where not")
        )
        canvas.view_changed.connect(lambda _percent: self.update())
        theme_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Low beside the picture."""
        return QSize(400, HEIGHT if self.window().height() >= 620 else LEAST_HEIGHT)

    def show_row(self, row: RowOfDepths | None) -> None:
        """Show these depths; None shows none."""
        self.row = row
        said = "" if row is None else f"{_('z along row {y}').format(y=row.y)}. {row.plane}. {row.step}."
        self.setAccessibleDescription(said)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Line, squares, dots, and the scale at the left."""
        painter, now = QPainter(self), tokens()
        painter.fillRect(event.rect(), colour(now.surface))
        font = QFont(self.font())
        font.setPixelSize(scaled(CAPTION_PX))
        painter.setFont(font)
        left = self._canvas.area.left / self._canvas.devicePixelRatioF()
        box = QRectF(left, _TOP, self.width() - left - 4, self.height() - _TOP - _BOTTOM)
        painter.setPen(QPen(colour(now.muted)))
        if self.row is None:
            words = _("Step to a fragment: the depths along its row are plotted here.")
            painter.drawText(box, Qt.AlignmentFlag.AlignVCenter, words)
            painter.end()
            return
        self._words(painter, self.row, box)
        low, high = _range(self.row)
        self._scale(painter, box, low, high)

        def place(x: float, z: float) -> QPointF:
            share = (z - low) / (high - low)
            return QPointF(self._canvas.widget_position(x, 0.0).x(), box.bottom() - share * box.height())

        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        painter.setClipRect(box.adjusted(0, -_SQUARE, 0, _SQUARE))
        self._stored(painter, self.row, place)
        self._fragments(painter, self.row, place)
        painter.end()

    def _words(self, painter: QPainter, row: RowOfDepths, box: QRectF) -> None:
        right, centre = Qt.AlignmentFlag.AlignRight, Qt.AlignmentFlag.AlignVCenter
        above = QRectF(box.left(), 0, box.width(), _TOP)
        below = QRectF(box.left(), box.bottom() + 2, box.width(), _BOTTOM - 2)
        painter.setPen(QPen(colour(tokens().muted)))
        painter.drawText(above, centre, _("z along row {y}; lower is nearer").format(y=row.y))
        painter.drawText(below, centre, row.plane)
        painter.setPen(QPen(row.surface))
        painter.drawText(above, right | centre, row.step)

    def _scale(self, painter: QPainter, box: QRectF, low: float, high: float) -> None:
        now, metrics = tokens(), QFontMetricsF(painter.font())
        painter.fillRect(QRectF(box.left() - 1, box.top(), 1, box.height()), colour(now.line))
        painter.setPen(QPen(colour(now.muted)))
        for z, y, base in ((high, box.top(), metrics.ascent() + 1), (low, box.bottom(), -3.0)):
            painter.fillRect(QRectF(box.left(), y, box.width(), 1), colour(now.grid))
            painter.drawText(QPointF(box.left() + 4, y + base), f"{z:.3g}")

    def _stored(self, painter: QPainter, row: RowOfDepths, place: _Place) -> None:
        """A line through the stored depths; it breaks where nothing is, and where another surface begins."""
        painter.setPen(QPen(colour(tokens().text), 1.75))
        known = np.flatnonzero(np.isfinite(row.stored))
        for x in known.tolist():
            here = float(row.stored[x])
            painter.drawLine(place(x - 0.3, here), place(x + 0.3, here))
            if x + 1 < len(row.stored) and np.isfinite(row.stored[x + 1]):
                painter.drawLine(place(x + 0.3, here), place(x + 0.7, float(row.stored[x + 1])))
        for x in known[-1:].tolist():
            end = place(x + 1.0, float(row.stored[x]))
            painter.drawText(end + QPointF(0, 4), _("stored z"))

    def _fragments(self, painter: QPainter, row: RowOfDepths, place: _Place) -> None:
        now = tokens()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour(now.muted))
        for x, z in row.to_come.tolist():
            painter.drawEllipse(place(x, z), _DOT, _DOT)
        half = QPointF(_SQUARE / 2, _SQUARE / 2)
        for fragments, filled in ((row.refused, False), (row.won, True)):
            painter.setPen(QPen(row.surface, 1.5))
            painter.setBrush(row.surface if filled else colour(now.surface))
            for x, z in fragments.tolist():
                middle = place(x, z)
                painter.drawRect(QRectF(middle - half, middle + half))
        if row.column is not None:
            x = self._canvas.widget_position(row.column, 0.0).x()
            painter.setPen(QPen(colour(now.text), 1, Qt.PenStyle.DotLine))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))


def _range(row: RowOfDepths) -> tuple[float, float]:
    """The least and the greatest depth, some way apart."""
    z = np.concatenate([row.stored, row.won[:, 1], row.refused[:, 1], row.to_come[:, 1]])
    z = z[np.isfinite(z)]
    if not len(z):
        return 0.0, 1.0
    low, high = float(z.min()), float(z.max())
    if high - low < 1e-9 * max(abs(high), 1.0):
        return low - 0.5, high + 0.5
    return low, high
