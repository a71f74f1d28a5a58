"""A line of words that may be longer than its room."""

from html import escape

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget


class ElidedLabel(QLabel):
    """A line of plain text as wide as there is room: its end is cut visibly, and said when pointed at."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.setTextFormat(Qt.TextFormat.PlainText)

    @property
    def wide(self) -> int:
        """The logical pixels that the whole text takes."""
        return self.fontMetrics().horizontalAdvance(self.text()) + 2 * self.margin()

    def setText(self, text: str) -> None:
        """Show another text."""
        super().setText(text)
        self._say_whole()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """More or less of the text is seen."""
        super().resizeEvent(event)
        self._say_whole()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The text, or its beginning."""
        room = self.contentsRect()
        seen = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room.width())
        painter = QPainter(self)
        self.style().drawItemText(
            painter, room, self.alignment(), self.palette(), self.isEnabled(), seen, self.foregroundRole()
        )
        painter.end()

    def _say_whole(self) -> None:
        whole = self.wide <= self.contentsRect().width()
        self.setToolTip("" if whole else f"<qt>{escape(self.text())}</qt>")
