"""The text of the algorithm, exactly as it runs, with the lines of this step marked."""

import inspect
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPolygon,
    QResizeEvent,
    QTextCursor,
    QTextFormat,
)
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QPlainTextEdit, QTextEdit, QVBoxLayout, QWidget

from workbench.language import _
from workbench.session.run import Run
from workbench.widgets.look.empty_state import EmptyState
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import code_font
from workbench.widgets.stepping.source_highlighter import SourceHighlighter


class SourceText(QPlainTextEdit):
    """One function's source, read-only, with line numbers. ``line_clicked`` gives the number in its file."""

    line_clicked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setReadOnly(True)
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.setFont(code_font(12))
        self.setAccessibleName(_("Source of the algorithm"))
        self.setToolTip(_("Click a line to run to it"))
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        self.document().setDocumentMargin(0)
        self._highlighter = SourceHighlighter(self.document())
        self._gutter = _Gutter(self)
        self.first_line = 1
        self.marked: frozenset[int] = frozenset()
        self.current: int | None = None
        self._pressed = QPoint()
        self.updateRequest.connect(self._scrolled)
        theme.changed.connect(self._mark)
        self.setViewportMargins(self._gutter.sizeHint().width(), 0, 0, 0)

    def show_source(self, source: str, first_line: int) -> None:
        """Show ``source``, whose first line has this number in its file."""
        self.first_line = first_line
        self._highlighter.lex(source)
        self.setPlainText(source)
        self._highlighter.rehighlight()
        self.setViewportMargins(self._gutter.sizeHint().width(), 0, 0, 0)

    def mark(self, lines: frozenset[int], current: int | None) -> None:
        """Mark the lines that ran, and the one that runs next; numbers are those of the file."""
        if lines != self.marked or current != self.current:
            self.marked, self.current = lines, current
            self._mark()
            self._make_visible()

    def _block_of(self, line: int) -> Any:
        return self.document().findBlockByNumber(line - self.first_line)

    def _mark(self) -> None:
        ink = colour(tokens().selected)
        selections = []
        for line in sorted(self.marked):
            block = self._block_of(line)
            if not block.isValid():
                continue
            selection: Any = QTextEdit.ExtraSelection()
            selection.format.setBackground(ink)
            selection.format.setProperty(QTextFormat.Property.FullWidthSelection, True)
            selection.cursor = QTextCursor(block)
            selections.append(selection)
        self.setExtraSelections(selections)
        self._gutter.update()

    def _make_visible(self) -> None:
        """Scroll by as little as shows the marked lines."""
        wanted = [self.current] if self.current is not None else sorted(self.marked)
        blocks = [block.blockNumber() for line in wanted if (block := self._block_of(line)).isValid()]
        if not blocks:
            return
        bar = self.verticalScrollBar()
        page = max(bar.pageStep() - 1, 1)
        top = bar.value()
        if blocks[-1] > top + page:
            top = blocks[-1] - page
        if blocks[0] < top:
            top = blocks[0]
        bar.setValue(top)

    def line_at(self, y: int) -> int:
        """The line number at a height of the viewport."""
        return self.first_line + self.cursorForPosition(QPoint(0, y)).blockNumber()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Remember where, to tell a click from a selection."""
        self._pressed = event.position().toPoint()
        super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click that selected nothing runs to its line."""
        super().mouseReleaseEvent(event)
        here = event.position().toPoint()
        if event.button() == Qt.MouseButton.LeftButton and (here - self._pressed).manhattanLength() < 4:
            self.line_clicked.emit(self.line_at(here.y()))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the gutter as high as the text."""
        super().resizeEvent(event)
        inner = self.contentsRect()
        self._gutter.setGeometry(
            QRect(inner.left(), inner.top(), self._gutter.sizeHint().width(), inner.height())
        )

    def _scrolled(self, rectangle: QRect, dy: int) -> None:
        if dy:
            self._gutter.scroll(0, dy)
        else:
            self._gutter.update(0, rectangle.y(), self._gutter.width(), rectangle.height())

    def visible_lines(self) -> list[tuple[int, int, int]]:
        """(line, top, height) of what is seen."""
        block = self.firstVisibleBlock()
        found = []
        while block.isValid():
            area = self.blockBoundingGeometry(block).translated(self.contentOffset())
            if area.top() > self.viewport().height():
                break
            found.append((self.first_line + block.blockNumber(), round(area.top()), round(area.height())))
            block = block.next()
        return found


class _Gutter(QWidget):
    """Line numbers, an arrow at the line that runs next, a bar at those that ran."""

    def __init__(self, text: SourceText) -> None:
        super().__init__(text)
        self._text = text

    def sizeHint(self) -> QSize:
        """Wide enough for the last number."""
        last = self._text.first_line + self._text.blockCount() if hasattr(self._text, "first_line") else 99
        digits = max(len(str(last)), 2)
        return QSize(self._text.fontMetrics().horizontalAdvance("0") * digits + 24, 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the numbers that are seen."""
        now = tokens()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(event.rect(), colour(now.surface))
        painter.setFont(self._text.font())
        text = self._text
        for line, top, height in text.visible_lines():
            marked = line in text.marked
            if marked:
                painter.fillRect(0, top, self.width(), height, colour(now.selected))
                painter.fillRect(0, top, 3, height, colour(now.accent))
            painter.setPen(colour(now.text if marked else now.muted))
            painter.drawText(0, top, self.width() - 14, height, Qt.AlignmentFlag.AlignRight, str(line))
            if line == text.current:
                self._arrow(painter, top + height / 2, colour(now.accent))

    def _arrow(self, painter: QPainter, middle: float, ink: QColor) -> None:
        x, y = self.width() - 11, round(middle)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(ink)
        painter.drawPolygon(QPolygon([QPoint(x, y - 4), QPoint(x + 6, y), QPoint(x, y + 4)]))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A click on a number runs to its line."""
        self._text.line_clicked.emit(self._text.line_at(round(event.position().y())))


class SourceView(QWidget):
    """The entry of a run and all that it calls, one at a time; the function of the current line comes up.

    ``refused``: a sentence, when the run does not come to the clicked line again.
    """

    refused = Signal(str)
    example_wanted = Signal()

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._shown: Callable[..., Any] | None = None
        self._lines = range(0)
        self.text = SourceText()
        self.chooser = QComboBox()
        self.chooser.setAccessibleName(_("Function shown"))
        self.chooser.setToolTip(_("Show the algorithm, or a function that it calls"))
        tell_choice(self.chooser)
        self.chooser.activated.connect(lambda index: self._show(self.chooser.itemText(index)))
        self._head = QWidget()
        head = QHBoxLayout(self._head)
        head.setContentsMargins(8, 4, 8, 4)
        head.addWidget(self.chooser, 1)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._head)
        column.addWidget(self.text, 1)
        self.state = EmptyState(body, _("Draw a figure to see the algorithm that draws it."))
        self.state.wanted.connect(self.example_wanted)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(self.state)
        self.setFocusProxy(self.text)
        self.text.line_clicked.connect(self._run_to)
        run.changed.connect(self._take_run)
        run.moved.connect(self.refresh)
        run.grown.connect(self.refresh)
        self._take_run()

    def _take_run(self) -> None:
        recording = self._run.recording
        self.state.set_empty(recording is None)
        names = list(recording.functions) if recording is not None else []
        if names != [self.chooser.itemText(i) for i in range(self.chooser.count())]:
            self.chooser.clear()
            self.chooser.addItems(names)
        self._head.setVisible(len(names) > 1)
        if names and (self._run.entry is None or self._shown is not self._run.entry.function):
            self._show(names[0])
        self.refresh()

    def _show(self, name: str) -> None:
        recording = self._run.recording
        if recording is None or name not in recording.functions:
            return
        function = recording.functions[name]
        if function is not self._shown:
            self._shown = function
            source, first = inspect.getsourcelines(function)
            self._lines = range(first, first + len(source))
            self.text.show_source("".join(source), first)
        self.chooser.setCurrentText(name)
        self.refresh()

    def refresh(self) -> None:
        """Mark the lines of the current step."""
        moment = self._run.moment
        if moment is None or self._shown is None:
            self.text.mark(frozenset(), None)
            return
        if self._run.detail and moment.function != self._shown.__name__:
            self._show(moment.function)
            return
        name = self._shown.__name__
        lines = frozenset(line for function, line in self._run.lines_run if function == name)
        here = moment.line if self._run.detail and moment.function == name and not self._run.ended else None
        self.text.mark(lines, here)

    def _run_to(self, line: int) -> None:
        if self._shown is not None and not self._run.run_to_line(line, self._shown.__name__):
            self.refused.emit(_("Line {line} does not run again after this step.").format(line=line))
