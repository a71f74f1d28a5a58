"""Enter presses the button that has the focus, as it does in a dialog."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

from workbench.widgets.look.plain_keys import is_plain


class EnterKey(QObject):
    """Takes the key where it comes to the window, since nothing in it has taken it."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        window.installEventFilter(self)

    def eventFilter(self, _window: QObject, event: QEvent) -> bool:
        """Press the button."""
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.KeyPress:
            return False
        button = QApplication.focusWidget()
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and is_plain(event)
        if not enter or not isinstance(button, QAbstractButton):
            return False
        if not event.isAutoRepeat():
            button.click()
        return True
