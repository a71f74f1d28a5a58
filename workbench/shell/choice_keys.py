"""A letter typed at a closed list of choices chooses there, whatever command of the window has that key."""

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QComboBox, QWidget

from workbench.widgets.look.plain_keys import is_plain


class ChoiceKeys(QObject):
    """Follows the focus; other keys, as those that step, stay the window's."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)

    def _follow(self, _before: QWidget | None, now: QWidget | None) -> None:
        if isinstance(now, QComboBox):
            now.installEventFilter(self)

    def eventFilter(self, _box: QObject, event: QEvent) -> bool:
        """Keep a letter or a digit from being a shortcut."""
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.ShortcutOverride:
            return False
        chooses = is_plain(event) and event.text().isalnum()
        event.setAccepted(chooses)
        return chooses
