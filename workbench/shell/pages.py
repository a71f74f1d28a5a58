"""A page fills the middle of the window in place of a dialog: a title, and one column of text and fields."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent
from PySide6.QtGui import QKeyEvent, QKeySequence, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from workbench.language import _

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

SIDE_PAGES = ("settings", "help", "keys", "about")


class Page(QScrollArea):
    """One column of at most ``width`` pixels, in the middle, scrolled when the window is low."""

    def __init__(self, title: str, width: int = 760) -> None:
        super().__init__()
        self.setObjectName("page")
        self.setWidgetResizable(True)
        body = QWidget()
        body.setObjectName("pageBody")
        outer = QHBoxLayout(body)
        outer.setContentsMargins(24, 16, 24, 24)
        outer.addStretch(1)
        inner = QWidget()
        inner.setMaximumWidth(width)
        outer.addWidget(inner, 1000)
        outer.addStretch(1)
        self.column = QVBoxLayout(inner)
        self.column.setContentsMargins(0, 0, 0, 0)
        self.column.setSpacing(8)
        if title:
            heading(self.column, title, "title")
        self.setWidget(body)
        self.setAccessibleName(title)


class SidePage(Page):
    """A page beside the work: Escape, or its button, leads back to where it was opened."""

    def __init__(self, window: "MainWindow", title: str) -> None:
        super().__init__("")
        self.setAccessibleName(title)
        self._window = window
        self.back = QPushButton(_("Back"))
        self.back.setToolTip(_("Go back to where you were (Esc)"))
        self.back.clicked.connect(self._leave)
        self._head = QFrame(self)  # above what scrolls
        row = QHBoxLayout(self._head)
        row.setContentsMargins(24, 8, 24, 8)
        row.setSpacing(12)
        row.addWidget(self.back)
        heading(row, title, "title")
        row.addStretch(1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The head keeps its place."""
        super().resizeEvent(event)
        self._place_head()

    def changeEvent(self, event: QEvent) -> None:
        """Larger type has a higher head."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._place_head()

    def _place_head(self) -> None:
        high = self._head.sizeHint().height()
        self.setViewportMargins(0, high, 0, 0)
        self._head.setGeometry(0, 0, self.width(), high)

    def showEvent(self, event: QShowEvent) -> None:
        """Remember where one comes from; one of these pages leads to another without being returned to."""
        if self._window.place not in SIDE_PAGES:
            self._window.came_from = self._window.place
        super().showEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape leads back."""
        if event.matches(QKeySequence.StandardKey.Cancel):
            self._leave()
        else:
            super().keyPressEvent(event)

    def _leave(self) -> None:
        self._window.go(self._window.came_from or "home")


def heading(column: QBoxLayout, text: str, role: str = "section") -> QLabel:
    """The title of a page, or with some room above it of one section."""
    if role == "section":
        column.addSpacing(8)
    label = QLabel(text)
    label.setProperty("role", role)
    column.addWidget(label)
    return label


def paragraph(column: QVBoxLayout, text: str, role: str = "") -> QLabel:
    """A text in a column; ``role`` is "muted" for what only explains."""
    label = QLabel(text)
    label.setWordWrap(True)
    if role:
        label.setProperty("role", role)
    column.addWidget(label)
    return label
