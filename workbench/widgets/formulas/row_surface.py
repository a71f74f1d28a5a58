"""The seen half of a row of matrices: its terms laid out in the room there is, highlights, and painting."""

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Literal, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontInfo, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.exchange.formulas.rows import LaidRow, lay_out, widest_of
from workbench.exchange.formulas.terms import Matrix, Place, Shows, Term, Terms
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.formulas.typesetting import QtMetrics, paint_primitives, typesetter_of
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled

MARGIN = 8
_TINT = 34
_ROUND = 4.0
_BEYOND = 1e6
_FEW = 2


class Highlight(NamedTuple):
    """A cell, or with None for its row or column a whole column or row, marked by an ink and an edge."""

    term: int
    row: int | None
    column: int | None
    ink: str = "accent"
    edge: Literal["solid", "dash", "double"] = "solid"


class RowSurface(QWidget):
    """A row of terms on the ground of a panel. It breaks into lines, and goes down to captions' type,
    before it needs more width than it has. While only numbers change nothing moves but to make room.
    ``upright`` pixels are left free above and below it.
    """

    def __init__(self, parent: QWidget | None = None, upright: int = MARGIN) -> None:
        super().__init__(parent)
        self._upright = upright
        policy = QSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self._terms: tuple[Term, ...] = ()
        self._shows: Shows = "numbers"
        self._highlights: tuple[Highlight, ...] = ()
        self._hovered: Place | None = None
        self._current: Place | None = None
        self._least: dict[float, dict[int, tuple[float, ...]]] = {}
        self._kept: dict[float, LaidRow] = {}
        theme.changed.connect(self.update)

    # What is shown

    @property
    def terms(self) -> tuple[Term, ...]:
        """The terms shown."""
        return self._terms

    def set_terms(self, terms: Terms) -> None:
        """Show other terms; columns keep their widths where only numbers are others."""
        terms = tuple(terms)
        if terms == self._terms:
            return
        if _without_numbers(terms) != _without_numbers(self._terms):
            self._least.clear()
        elif _seen(terms, self._shows) == _seen(self._terms, self._shows):
            self._terms = terms  # other numbers, of which none is seen
            self.update()
            return
        self._terms = terms
        if self._current not in self.places:
            self._current = None
        self._lay_out_anew()

    def set_values(self, values: Mapping[int, NDArray[np.float64]]) -> None:
        """Other values, (rows, columns), for the matrices with these numbers of their terms."""
        terms = list(self._terms)
        for number, numbers in values.items():
            terms[number] = self._matrix(number).with_values(numbers)
        self.set_terms(terms)

    def _matrix(self, number: int) -> Matrix:
        return cast(Matrix, self._terms[number])

    @property
    def shows(self) -> Shows:
        """Whether symbols, numbers or both are shown."""
        return self._shows

    def set_shows(self, shows: Shows) -> None:
        """Show symbols, numbers or both."""
        if shows != self._shows:
            self._shows = shows
            self._least.clear()
            self._lay_out_anew()

    def set_highlights(self, highlights: Iterable[Highlight]) -> None:
        """Mark these cells, rows and columns."""
        highlights = tuple(highlights)
        if highlights != self._highlights:
            self._highlights = highlights
            self.update()

    @property
    def places(self) -> tuple[Place, ...]:
        """Every cell, term by term and row by row."""
        return tuple(
            (number, i, j)
            for number, term in enumerate(self._terms)
            if isinstance(term, Matrix)
            for i in range(term.shape[0])
            for j in range(term.shape[1])
        )

    # Layout

    @property
    def _base(self) -> int:
        return QFontInfo(self.font()).pixelSize()

    @property
    def _sizes(self) -> range:
        """Sizes of type, logical pixels, the proper one first."""
        return range(self._base, min(scaled(CAPTION_PX), self._base) - 1, -1)

    def _laid(self, width: float) -> LaidRow:
        """The row in a widget of this width."""
        room = max(width - 2 * MARGIN, 1.0)
        if room not in self._kept:
            if len(self._kept) > _FEW:
                self._kept.clear()
            setter = typesetter_of(self.font())
            laid = None
            for size in self._sizes:
                laid = lay_out(setter, self._terms, self._shows, size, room, self._least.get(size))
                self._least[size] = laid.columns
                if laid.widest <= room:
                    break
            assert laid is not None
            self._kept[room] = laid
        return self._kept[room]

    @property
    def laid(self) -> LaidRow:
        """The row as it is shown; its origin lies ``MARGIN`` and ``upright`` inside the widget."""
        return self._laid(self.width())

    def _lay_out_anew(self) -> None:
        before = self.laid if self._kept else None
        self._kept.clear()
        now = self.laid
        if before is None or (before.columns, before.height) != (now.columns, now.height):
            self.updateGeometry()
        self.update()

    def minimumSizeHint(self) -> QSize:
        """The widest term in the smallest type, and the height that the width there is asks for."""
        widest = widest_of(typesetter_of(self.font()), self._terms, self._shows, self._sizes[-1])
        high = self._laid(max(self.width(), widest + 2 * MARGIN)).height
        return QSize(int(widest) + 1 + 2 * MARGIN, int(high) + 1 + 2 * self._upright)

    def sizeHint(self) -> QSize:
        """One line."""
        laid = self._laid(_BEYOND)
        return QSize(int(laid.width) + 1 + 2 * MARGIN, int(laid.height) + 1 + 2 * self._upright)

    def hasHeightForWidth(self) -> bool:
        """Narrow, it breaks into lines."""
        return True

    def heightForWidth(self, width: int) -> int:
        """How high its lines are."""
        return int(self._laid(width).height) + 1 + 2 * self._upright

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width may take more lines."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def changeEvent(self, event: QEvent) -> None:
        """Other type is laid out anew."""
        if event.type() == QEvent.Type.FontChange:
            self._least.clear()
            self._lay_out_anew()
        super().changeEvent(event)

    # Places

    def cell_box(self, place: Place) -> QRectF:
        """Where a cell lies in the widget."""
        return QRectF(*self.laid.cells[place]).translated(MARGIN, self._upright)

    def cell_at(self, position: QPointF) -> Place | None:
        """The cell under a position of the widget."""
        x, y = position.x() - MARGIN, position.y() - self._upright
        for place, (left, top, width, height) in self.laid.cells.items():
            if left <= x < left + width and top <= y < top + height:
                return place
        return None

    def _block(self, highlight: Highlight) -> QRectF:
        box = QRectF()
        for place, cell in self.laid.cells.items():
            number, row, column = place
            if (
                number == highlight.term
                and highlight.row in (None, row)
                and highlight.column in (None, column)
            ):
                box = box.united(QRectF(*cell))
        return box

    # Painting

    def editable(self, place: Place) -> bool:
        """Whether the number of a cell can be changed where it stands."""
        number, row, column = place
        cell = self._matrix(number).cells[row][column]
        shown = self._shows != "symbols" or not cell.symbol
        return cell.editable and cell.value is not None and not cell.hidden and shown

    def paintEvent(self, event: QPaintEvent) -> None:
        """Ground, highlights, what is pointed at, the terms."""
        now = tokens()
        painter = QPainter(self)
        painter.fillRect(event.rect(), QColor(now.surface))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        painter.translate(MARGIN, self._upright)
        laid = self.laid
        if self._hovered in laid.cells and self._hovered is not None:
            box = QRectF(*laid.cells[self._hovered]).adjusted(1, 1, -1, -1)
            edge = QColor(now.field_edge if self.editable(self._hovered) else now.line)
            painter.setPen(QPen(edge, 1))
            painter.setBrush(QColor(now.selected))
            painter.drawRoundedRect(box, _ROUND, _ROUND)
        for highlight in self._highlights:
            self._paint_highlight(painter, highlight)
        metrics = cast(QtMetrics, typesetter_of(self.font()).metrics)
        paint_primitives(painter, laid.primitives, metrics, partial(ink_of, now))
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(now.accent), 2))
            if self._current is not None:
                painter.drawRoundedRect(QRectF(*laid.cells[self._current]), _ROUND, _ROUND)
            else:
                painter.resetTransform()
                painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_highlight(self, painter: QPainter, highlight: Highlight) -> None:
        now, box = tokens(), self._block(highlight).adjusted(1, 1, -1, -1)
        if box.isEmpty():
            return
        ink = ink_of(now, highlight.ink)
        painter.setBrush(colour(ink, _TINT))
        style = Qt.PenStyle.DashLine if highlight.edge == "dash" else Qt.PenStyle.SolidLine
        painter.setPen(QPen(QColor(ink), 1.5, style))
        painter.drawRoundedRect(box, _ROUND, _ROUND)
        if highlight.edge == "double":
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(box.adjusted(2.5, 2.5, -2.5, -2.5), _ROUND - 2, _ROUND - 2)
        painter.setBrush(Qt.BrushStyle.NoBrush)


def _seen(terms: Iterable[Term], shows: Shows) -> list[object]:
    """What is to be read of a row."""
    return [
        [[(cell.seen(shows), cell.editable) for cell in row] for row in term.cells]
        if isinstance(term, Matrix)
        else term
        for term in terms
    ]


def _without_numbers(terms: Iterable[Term]) -> list[object]:
    """What of a row decides where its parts stand, but for its numbers."""
    return [
        (term.name, term.named, [[(cell.symbol, cell.value is None) for cell in row] for row in term.cells])
        if isinstance(term, Matrix)
        else term
        for term in terms
    ]
