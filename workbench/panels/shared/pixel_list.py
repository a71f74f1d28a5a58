"""What is told of the pixel that is asked about, line by line: each leads to a step."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon, QKeyEvent
from PySide6.QtWidgets import QLabel, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from workbench.language import _
from workbench.session.session import Session
from workbench.widgets.look.in_sight import bring_forward
from workbench.widgets.look.plain_keys import is_plain


class PixelList(QWidget):
    """A caption over a list called ``name``. It comes forward where a pixel is asked about."""

    def __init__(self, session: Session, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        session.why_asked.connect(self.come_forward)
        self.caption = QLabel()
        self.caption.setWordWrap(True)
        self.caption.setContentsMargins(12, 8, 12, 4)
        self.list = QListWidget()
        self.list.setWordWrap(True)
        self.list.setIconSize(QSize(16, 16))
        self.list.setAccessibleName(name)
        self.list.setToolTip(_("Click a line to go to that step"))
        self.list.setFrameShape(QListWidget.Shape.NoFrame)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.itemClicked.connect(self.go)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.caption)
        column.addWidget(self.list, 1)
        self.setAutoFillBackground(True)

    def come_forward(self) -> None:
        """Bring its dock before the others."""
        bring_forward(self)

    def go(self, item: QListWidgetItem) -> None:
        """Let the stepper show the step of a line."""
        raise NotImplementedError

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter goes to the step that is marked."""
        item = self.list.currentItem()
        if is_plain(event) and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and item is not None:
            self.go(item)
        else:
            super().keyPressEvent(event)


def line(picture: QIcon, text: str, step: object, stands: bool) -> QListWidgetItem:
    """A line that leads to a ``step``; half bold where what it tells of ``stands`` at the end."""
    item = QListWidgetItem(picture, text)
    font = item.font()
    font.setWeight(font.Weight.DemiBold if stands else font.Weight.Normal)
    item.setFont(font)
    item.setData(Qt.ItemDataRole.UserRole, step)
    return item
