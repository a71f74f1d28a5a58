"""What a view says while it has nothing to show: one sentence and one button."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QFrame,
    QLabel,
    QPushButton,
    QScrollArea,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from workbench.language import _
from workbench.widgets.look.tokens import colour, tokens


class EmptyView(QWidget):
    """Shows ``view``, or the sentence and a button while ``set_empty`` is on; ``wanted``: it was pressed."""

    wanted = Signal()

    def __init__(self, view: QWidget, sentence: str, button: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._layout = QStackedLayout(self)
        self._layout.addWidget(view)
        words = QWidget()
        column = QVBoxLayout(words)
        column.setContentsMargins(12, 16, 12, 12)
        column.setSpacing(8)
        self.sentence = QLabel(sentence)
        self.sentence.setWordWrap(True)
        self.sentence.setProperty("role", "muted")
        self.button = QPushButton(button or _("Show an example"))
        self.button.setToolTip(_("Open a picture that is already drawn"))
        self.button.setAccessibleName(self.button.text())
        self.button.clicked.connect(self.wanted)
        column.addWidget(self.sentence)
        column.addWidget(self.button, 0, Qt.AlignmentFlag.AlignLeft)
        column.addStretch(1)
        self._layout.addWidget(_scrolled(words))

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))

    def set_empty(self, empty: bool) -> None:
        """Show the sentence, or the view."""
        self._layout.setCurrentIndex(1 if empty else 0)

    @property
    def empty(self) -> bool:
        """Whether the sentence is shown."""
        return self._layout.currentIndex() == 1


def _scrolled(words: QWidget) -> QScrollArea:
    """In a view too low for its words they can be scrolled."""
    scrolled = QScrollArea()
    scrolled.setWidget(words)
    scrolled.setWidgetResizable(True)
    scrolled.setFrameShape(QFrame.Shape.NoFrame)
    scrolled.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    scrolled.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    for ground in (words, scrolled.viewport()):
        ground.setAutoFillBackground(False)
    return scrolled
