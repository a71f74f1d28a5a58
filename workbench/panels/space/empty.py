"""What a scene without objects says."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QVBoxLayout, QWidget

from workbench.language import _


class EmptyScene(QFrame):
    """One sentence and one button in the middle of a view."""

    def __init__(self, view: QWidget, add: Callable[[], object]) -> None:
        super().__init__(view)
        self.setObjectName("card")
        self._view = view
        self.button = QPushButton(_("Add a house"))
        self.button.setToolTip(_("Put a house into the scene"))
        self.button.clicked.connect(lambda: add())
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 12, 16, 12)
        column.setSpacing(8)
        column.addWidget(QLabel(_("Nothing to look at.")))
        column.addWidget(self.button)
        view.installEventFilter(self)
        self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in the middle."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show):
            self._centre()
        return False

    def setVisible(self, visible: bool) -> None:
        """Shown in the middle."""
        super().setVisible(visible)
        if visible:
            self._centre()

    def _centre(self) -> None:
        self.adjustSize()
        self.move((self._view.width() - self.width()) // 2, (self._view.height() - self.height()) // 2)
