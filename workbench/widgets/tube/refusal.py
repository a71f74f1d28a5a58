"""Says over a tube why it shows nothing."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QLabel, QWidget


class Refusal(QLabel):
    """Covers ``tube`` with a sentence, and takes it out of use, until there is none to say."""

    def __init__(self, tube: QWidget) -> None:
        super().__init__(tube)
        self.setWordWrap(True)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setAutoFillBackground(True)
        self.setContentsMargins(24, 24, 24, 24)
        self._tube = tube
        tube.installEventFilter(self)
        self.hide()

    def say(self, sentence: str) -> None:
        """Cover the tube with ``sentence``, or with "" no longer."""
        self.setText(sentence)
        self.setGeometry(self._tube.rect())
        self.setVisible(bool(sentence))
        self._tube.setEnabled(not sentence)

    def eventFilter(self, tube: QObject, event: QEvent) -> bool:
        """Cover all of it, whatever its size."""
        if event.type() == QEvent.Type.Resize:
            self.setGeometry(self._tube.rect())
        return False
