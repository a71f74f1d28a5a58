"""The focus that a card over the window takes while it is there, and gives back where it was."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget
from shiboken6 import isValid


class BorrowedFocus:
    """The focus of what is in ``card``, taken from wherever it was, be that in a dock that floats."""

    def __init__(self, card: QWidget) -> None:
        self._card = card
        self._from: QWidget | None = None

    @property
    def here(self) -> bool:
        """Whether a part of the card has the focus of its window, be that the active one or not."""
        now = self._card.window().focusWidget()
        return now is not None and (now is self._card or self._card.isAncestorOf(now))

    def remember(self) -> None:
        """Note where the focus is, unless it is in the card."""
        if not self.here:
            self._from = QApplication.focusWidget() or self._card.window().focusWidget()

    def take(self, part: QWidget) -> None:
        """Give it to a part of the card, in whose window keys are then typed."""
        self.remember()
        if QApplication.activeWindow() is not None and not self._card.isActiveWindow():
            self._card.activateWindow()
        part.setFocus(Qt.FocusReason.OtherFocusReason)

    def give_back(self) -> None:
        """Let it be where it was. Before the card is hidden: that would hand it on in the order of Tab."""
        before, self._from = self._from, None
        if not self.here or before is None or not isValid(before) or not before.isVisible():
            return
        if before.window() is not self._card.window() and self._card.isActiveWindow():
            before.activateWindow()
        before.setFocus(Qt.FocusReason.OtherFocusReason)
