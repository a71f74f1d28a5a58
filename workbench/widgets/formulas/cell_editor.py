"""A field over a cell in which its number is typed, with what is wrong with it said beside it."""

from PySide6.QtCore import QPoint, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QFont, QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLabel, QWidget

from workbench.widgets.fields.arithmetic import evaluate
from workbench.widgets.fields.number_field import EntryLine
from workbench.widgets.look.tokens import RADIUS, tokens

_LEAST_PX, _ROOM_PX, _SENTENCE_PX = 76, 18, 260


class _Complaint(QLabel):
    """A sentence on a ground of its own, for it lies over other cells."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "error")
        self.setWordWrap(True)
        self.setContentsMargins(6, 4, 6, 4)
        self.hide()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Ground, edge, and the sentence."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        painter.setPen(QPen(QColor(tokens().error), 1))
        painter.setBrush(QColor(tokens().raised))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        painter.end()
        super().paintEvent(event)


class CellEditor(EntryLine):
    """``typed`` sends a number once it is good. Enter and Escape give the focus back."""

    typed = Signal(float)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._ground = parent
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setTextMargins(0, 0, 0, 0)
        self.complaint = _Complaint(parent)
        self.destroyed.connect(self.complaint.deleteLater)  # it may belong to the window by then
        self.hide()

    def open_at(self, box: QRectF, text: str, name: str, font: QFont) -> None:
        """Show the field over ``box`` of its parent with ``text`` selected; ``name`` says whose it is."""
        parent = self._ground
        self.setFont(font)
        width = max(_LEAST_PX, round(box.width()) + _ROOM_PX)
        height = max(self.sizeHint().height(), round(box.height()))
        left = min(max(round(box.center().x() - width / 2), 0), max(parent.width() - width, 0))
        top = min(max(round(box.center().y() - height / 2), 0), max(parent.height() - height, 0))
        self.setGeometry(left, top, width, height)
        self.setText(text)
        self.setAccessibleName(name)
        self._complain("")
        self.show()
        self.raise_()
        self.setFocus()
        self.selectAll()

    @property
    def is_open(self) -> bool:
        """Whether a number is being typed."""
        return not self.isHidden()

    def _commit(self) -> bool:
        """Send what was typed; whether it was good."""
        try:
            value = evaluate(self.text())
        except ValueError as problem:
            self._complain(str(problem))
            return False
        self.close_field()
        self.typed.emit(value)
        return True

    def close_field(self) -> None:
        """Hide the field; what was typed in it is left out."""
        if self.is_open:
            self.complaint.hide()
            self.hide()

    def _complain(self, sentence: str) -> None:
        """Say beside the field what is wrong; over the whole window, for a row may be low."""
        self.setAccessibleDescription(sentence)
        self.setProperty("wrong", bool(sentence))
        self.style().polish(self)
        self.complaint.setText(sentence)
        if sentence:
            window, complaint = self.window(), self.complaint
            complaint.setParent(window)
            complaint.setFixedWidth(min(_SENTENCE_PX, window.width()))
            complaint.adjustSize()
            field = QRect(self.mapTo(window, QPoint()), self.size())
            left = min(field.x(), window.width() - complaint.width())
            below, over = field.bottom() + 3, field.y() - complaint.height() - 2
            fits = below + complaint.height() <= window.height() or over < 0
            complaint.move(left, below if fits else over)
            complaint.raise_()
        self.complaint.setVisible(bool(sentence))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter sends the number, Escape leaves it as it was; neither reaches the cell underneath."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self._commit():
                self._ground.setFocus()
        elif event.key() == Qt.Key.Key_Escape:
            self.close_field()
            self._ground.setFocus()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Going elsewhere takes what was typed, if it is good."""
        super().focusOutEvent(event)
        if self.is_open and event.reason() != Qt.FocusReason.PopupFocusReason:
            if self.isModified():
                self._commit()
            self.close_field()
