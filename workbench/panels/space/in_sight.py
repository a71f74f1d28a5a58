"""Whether the content of a dock is in sight: one behind other tabs is not, although Qt calls it visible."""

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtWidgets import QDockWidget, QWidget


class InSight(QObject):
    """``changed`` sends whether ``part`` has come in sight, or gone out of it; ``now`` tells."""

    changed = Signal(bool)

    def __init__(self, part: QWidget) -> None:
        super().__init__(part)
        self._part = part
        self._dock: QDockWidget | None = None
        self.now = False
        part.installEventFilter(self)

    def eventFilter(self, _part: QObject, event: QEvent) -> bool:
        """Follow the dock that it has come into."""
        if event.type() == QEvent.Type.Show:
            dock = self._part.parentWidget()
            if not isinstance(dock, QDockWidget):
                self._set(True)
            elif dock is not self._dock:
                self._dock = dock
                dock.visibilityChanged.connect(self._set)
        elif event.type() == QEvent.Type.Hide:
            self._set(False)
        return False

    def _set(self, seen: bool) -> None:
        if seen != self.now:
            self.now = seen
            self.changed.emit(seen)
