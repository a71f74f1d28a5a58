"""The text of one function with line numbers: nothing runs off to the right, and its docstring is folded."""

import ast
import textwrap
from collections.abc import Sequence

from PySide6.QtCore import QMimeData, QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygon,
    QResizeEvent,
    QTextBlock,
    QTextBlockFormat,
    QTextCursor,
    QTextOption,
)
from PySide6.QtWidgets import QTextEdit, QWidget

from workbench.language import _, ngettext
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import keep_code_font
from workbench.widgets.stepping.source_highlighter import SourceHighlighter

_TYPE_PX = 12
_HANG_COLUMNS = 8
_CLICK_PX = 4


class SourceText(QTextEdit):
    """One function's source, read-only, with line numbers. ``line_clicked`` gives the number in its file.

    A line that is too long for the view goes on below itself, indented by eight columns more than it begins.
    All of the docstring but its first line is left out until it is unfolded.
    """

    line_clicked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setReadOnly(True)
        self.setUndoRedoEnabled(False)
        self.setLineWrapMode(QTextEdit.LineWrapMode.WidgetWidth)
        self.setWordWrapMode(QTextOption.WrapMode.WrapAtWordBoundaryOrAnywhere)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.horizontalScrollBar().rangeChanged.connect(self._stay_left)
        keep_code_font(self, _TYPE_PX)
        self.setAccessibleName(_("Source of the algorithm"))
        self.setToolTip(_("Click a line to run to it"))
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        self.document().setDocumentMargin(0)
        self._highlighter = SourceHighlighter(self.document())
        self._lines: list[str] = []
        self._rows: Sequence[int] = ()
        self._docstring = range(0)
        self._most_hang = 0
        self.folded = True
        self.first_line = 1
        self.marked: frozenset[int] = frozenset()
        self.current: int | None = None
        self._pressed = QPoint()
        self._gutter = _Gutter(self)
        self.verticalScrollBar().valueChanged.connect(self._gutter.update)
        self.document().documentLayout().documentSizeChanged.connect(self._gutter.update)
        theme.changed.connect(self._repaint)
        self.setViewportMargins(self._gutter.sizeHint().width(), 0, 0, 0)

    # What is shown

    def show_source(self, source: str, first_line: int) -> None:
        """Show ``source``, whose first line has this number in its file, with its docstring folded."""
        self.first_line = first_line
        self._lines = source.split("\n")
        self._docstring = docstring_rows(source)
        self._highlighter.lex(source)
        self.fold(True)

    def fold(self, folded: bool) -> None:
        """Leave out all of the docstring but its first line, or show it all."""
        self.folded = folded
        hidden = self._docstring[1:] if folded else range(0)
        self._rows = [row for row in range(len(self._lines)) if row not in hidden]
        self._highlighter.rows = self._rows
        cursor = QTextCursor(self.document())
        cursor.beginEditBlock()  # so that every line is coloured and laid out once
        cursor.select(QTextCursor.SelectionType.Document)
        cursor.insertText("\n".join(self._lines[row] for row in self._rows))
        self._most_hang = 0
        self._hang()
        cursor.endEditBlock()
        self.moveCursor(QTextCursor.MoveOperation.Start)
        self.setViewportMargins(self._gutter.sizeHint().width(), 0, 0, 0)
        self._repaint()

    @property
    def last_line(self) -> int:
        """The number of the last line."""
        return self.first_line + len(self._lines)

    @property
    def folded_block(self) -> QTextBlock:
        """The line that stands for the folded docstring; not valid where nothing is folded."""
        if not self.folded or len(self._docstring) < 2:
            return QTextBlock()
        return self.document().findBlockByNumber(self._rows.index(self._docstring[0]))

    def _hang(self) -> None:
        """Indent what goes on below a line, but never by more than half of the view; and fold nothing of a
        folded docstring."""
        column = self.fontMetrics().horizontalAdvance("0")
        most = max(self.viewport().width() // column // 2, _HANG_COLUMNS)
        if most == self._most_hang or not self._rows:
            return
        self._most_hang = most
        folded = self.folded_block
        cursor = QTextCursor(self.document())
        cursor.beginEditBlock()
        for number, row in enumerate(self._rows):
            line = self._lines[row]
            hang = min(len(line) - len(line.lstrip()) + _HANG_COLUMNS, most) * column
            layout = QTextBlockFormat()
            layout.setLeftMargin(hang)
            layout.setTextIndent(-hang)
            layout.setNonBreakableLines(folded.isValid() and number == folded.blockNumber())
            cursor.setPosition(self.document().findBlockByNumber(number).position())
            cursor.setBlockFormat(layout)
        cursor.endEditBlock()

    def _stay_left(self, _least: int, most: int) -> None:
        if most:
            self.horizontalScrollBar().setRange(0, 0)

    # What is marked

    def mark(self, lines: frozenset[int], current: int | None) -> None:
        """Mark the lines that ran, and the one that runs next; numbers are those of the file."""
        if lines != self.marked or current != self.current:
            self.marked, self.current = lines, current
            self._repaint()
            self._make_visible()

    def _block_of(self, line: int) -> QTextBlock:
        row = line - self.first_line
        return self.document().findBlockByNumber(self._rows.index(row)) if row in self._rows else QTextBlock()

    def _repaint(self) -> None:
        self.viewport().update()
        self._gutter.update()

    def area_of(self, block: QTextBlock) -> QRectF:
        """Where a line is in the viewport, with all that goes on below it."""
        area = self.document().documentLayout().blockBoundingRect(block)
        return area.translated(0.0, -self.verticalScrollBar().value())

    def _make_visible(self) -> None:
        """Scroll by as little as shows the marked lines."""
        lines = [self.current] if self.current is not None else sorted(self.marked)
        areas = [self.area_of(block) for line in lines if (block := self._block_of(line)).isValid()]
        if not areas:
            return
        bar = self.verticalScrollBar()
        below = max(areas[-1].bottom() - self.viewport().height(), 0.0)
        above = min(areas[0].top() - below, 0.0)
        bar.setValue(round(bar.value() + below + above))

    def line_at(self, y: int) -> int:
        """The line number at a height of the viewport."""
        block = self.cursorForPosition(QPoint(0, y)).blockNumber()
        return self.first_line + (self._rows[block] if self._rows else 0)

    def visible_lines(self) -> list[tuple[int, int, int]]:
        """(line, top, height) of what is seen."""
        seen = []
        block = self.cursorForPosition(QPoint(0, 0)).block()
        while block.isValid() and block.blockNumber() < len(self._rows):
            area = self.area_of(block)
            if area.top() > self.viewport().height():
                break
            line = self.first_line + self._rows[block.blockNumber()]
            seen.append((line, round(area.top()), round(area.height())))
            block = block.next()
        return seen

    # What is done with it

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Remember where, to tell a click from a selection."""
        self._pressed = event.position().toPoint()
        super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click that selected nothing runs to its line, or unfolds the docstring."""
        super().mouseReleaseEvent(event)
        here = event.position().toPoint()
        if (
            event.button() != Qt.MouseButton.LeftButton
            or (here - self._pressed).manhattanLength() >= _CLICK_PX
        ):
            return
        folded = self.folded_block
        if folded.isValid() and self.area_of(folded).contains(here):
            self.fold(False)
        else:
            self.line_clicked.emit(self.line_at(here.y()))

    def createMimeDataFromSelection(self) -> QMimeData:
        """What is copied is the source, with the lines of a folded docstring that is copied over."""
        cursor, folded = self.textCursor(), self.folded_block
        text = cursor.selection().toPlainText()
        first = self.document().findBlock(cursor.selectionStart()).blockNumber()
        if folded.isValid() and 0 <= folded.blockNumber() - first < text.count("\n"):
            lines = text.split("\n")
            at = folded.blockNumber() - first + 1
            lines[at:at] = [self._lines[row] for row in self._docstring[1:]]
            text = "\n".join(lines)
        copied = QMimeData()
        copied.setText(text)
        return copied

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the gutter as high as the text."""
        super().resizeEvent(event)
        inner = self.contentsRect()
        self._gutter.setGeometry(
            QRect(inner.left(), inner.top(), self._gutter.sizeHint().width(), inner.height())
        )
        self._hang()
        # Qt lays the text out anew only now, and would leave the bar as long as before.
        height = self.document().size().height()
        self.verticalScrollBar().setRange(0, max(round(height) - self.viewport().height(), 0))
        self._make_visible()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The ring appears."""
        super().focusInEvent(event)
        self.viewport().update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring goes."""
        super().focusOutEvent(event)
        self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Mark lines over the whole width, which a selection does not where they hang; say what is folded."""
        painter = QPainter(self.viewport())
        for line, top, height in self.visible_lines():
            if line in self.marked:
                painter.fillRect(0, top, self.viewport().width(), height, colour(tokens().selected))
        painter.end()
        super().paintEvent(event)
        if self.hasFocus():
            painter = QPainter(self.viewport())
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.drawRect(self.viewport().rect().adjusted(1, 1, -1, -1))
            painter.end()
        folded = self.folded_block
        if not folded.isValid():
            return
        count = len(self._docstring) - 1
        words = ngettext("{n} more line", "{n} more lines", count).format(n=count)
        area, now = self.area_of(folded).toRect(), tokens()
        width = self.fontMetrics().horizontalAdvance(words) + 12
        chip = QRect(self.viewport().width() - width - 4, area.top(), width, area.height())
        painter = QPainter(self.viewport())
        painter.fillRect(chip.adjusted(-6, 0, 4, 0), colour(now.surface))
        painter.setPen(colour(now.line))
        painter.drawRoundedRect(chip.adjusted(0, 0, -1, -1), 3, 3)
        painter.setFont(self.font())
        painter.setPen(colour(now.muted))
        painter.drawText(chip, Qt.AlignmentFlag.AlignCenter, words)
        painter.end()


def docstring_rows(source: str) -> range:
    """The rows of a function's docstring, counted from its first line; empty where it has none."""
    try:
        (function,) = ast.parse(textwrap.dedent(source)).body
    except (SyntaxError, ValueError):
        return range(0)
    if not isinstance(function, ast.FunctionDef) or ast.get_docstring(function) is None:
        return range(0)
    first = function.body[0]
    return range(first.lineno - 1, first.end_lineno or first.lineno)


class _Gutter(QWidget):
    """Line numbers, an arrow at the line that runs next, a bar at those that ran."""

    def __init__(self, text: SourceText) -> None:
        super().__init__(text)
        self._text = text

    def sizeHint(self) -> QSize:
        """Wide enough for the last number."""
        digits = len(str(self._text.last_line))
        return QSize(self._text.fontMetrics().horizontalAdvance("0") * max(digits, 2) + 24, 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the numbers that are seen; a line that goes on below itself has its number once."""
        now = tokens()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(event.rect(), colour(now.surface))
        painter.setFont(self._text.font())
        text = self._text
        row = text.fontMetrics().height()
        for line, top, height in text.visible_lines():
            marked = line in text.marked
            if marked:
                painter.fillRect(0, top, self.width(), height, colour(now.selected))
                painter.fillRect(0, top, 3, height, colour(now.accent))
            painter.setPen(colour(now.text if marked else now.muted))
            painter.drawText(0, top, self.width() - 14, height, Qt.AlignmentFlag.AlignRight, str(line))
            if line == text.current:
                self._arrow(painter, top + min(row, height) / 2, colour(now.accent))

    def _arrow(self, painter: QPainter, middle: float, ink: QColor) -> None:
        x, y = self.width() - 11, round(middle)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(ink)
        painter.drawPolygon(QPolygon([QPoint(x, y - 4), QPoint(x + 6, y), QPoint(x, y + 4)]))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A click on a number runs to its line."""
        self._text.line_clicked.emit(self._text.line_at(round(event.position().y())))
