"""Whether a part of the window is in sight: one in a dock behind other tabs is not, although Qt calls it
visible."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QTimer, Signal
from PySide6.QtWidgets import QDockWidget, QWidget
from shiboken6 import isValid


class InSight(QObject):
    """``changed`` sends whether ``part`` has come in sight, or gone out of it; ``now`` tells."""

    changed = Signal(bool)
    now = False  # of the class: a part that is being taken apart still hides, when this may have lost its own

    def __init__(self, part: QWidget) -> None:
        super().__init__(part)
        self._part = part
        self._dock: QDockWidget | None = None
        part.installEventFilter(self)

    def follow(self, refresh: Callable[[], object]) -> None:
        """Have it refreshed whenever it has come in sight or gone out of it, once docks have their places."""
        self.changed.connect(lambda _seen: QTimer.singleShot(0, self, refresh))

    def eventFilter(self, _part: QObject, event: QEvent) -> bool:
        """Follow the dock that it has come into."""
        if event.type() == QEvent.Type.Show:
            dock = dock_around(self._part)
            if dock is not self._dock:
                if self._dock is not None and isValid(self._dock):  # one of a reset workspace is not
                    self._dock.visibilityChanged.disconnect(self._set)
                if dock is not None:
                    dock.visibilityChanged.connect(self._set)
                self._dock = dock
            self._set(dock is None or in_front(dock))
        elif event.type() == QEvent.Type.Hide:
            self._set(False)
        return False

    def _set(self, seen: bool) -> None:
        if seen != self.now:
            self.now = seen
            self.changed.emit(seen)


def dock_around(part: QWidget) -> QDockWidget | None:
    """The dock in which it lies, however deep."""
    around: QWidget | None = part
    while around is not None and not isinstance(around, QDockWidget):
        around = around.parentWidget()
    return around


def bring_forward(part: QWidget) -> None:
    """Bring the dock in which it lies before the others, if that is one of what is seen."""
    dock = dock_around(part)
    if dock is not None and dock.isVisible():
        dock.raise_()


def in_front(dock: QDockWidget) -> bool:
    """Whether a dock is none of those behind tabs, which Qt lays out beyond the corner of the window."""
    place = dock.geometry()
    return dock.isVisible() and place.right() >= 0 and place.bottom() >= 0
