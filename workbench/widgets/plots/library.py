"""The library that plots are drawn by, loaded beside the interface when the first of them is seen."""

from contextlib import suppress
from importlib import import_module

from PySide6.QtCore import QObject, QTimer, Signal

from workbench.engine import background


class _Library(QObject):
    """``loaded`` comes in a turn of its own after each time it was asked for."""

    loaded = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._there = False
        self._coming = False

    def ask(self) -> None:
        """Load it, unless it is there or coming."""
        if self._there:
            QTimer.singleShot(0, self.loaded.emit)
        elif not self._coming:
            self._coming = True
            try:
                background.thread(self._load, "imports").start()
            except RuntimeError:  # the system gives no more threads now
                self._load()

    def _load(self) -> None:
        with suppress(ImportError):  # the same failure is said where the plot is made
            import_module("pyqtgraph")
        self._there = True
        self.loaded.emit()


library = _Library()
