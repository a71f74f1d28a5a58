"""Long work on the interface thread, a slice in each turn of its event loop."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

if TYPE_CHECKING:
    from collections.abc import Iterator


class Slices(QObject):
    """Works off generators by turns, one step in each turn of the event loop. One that raises is dropped."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._works: deque[Iterator[None]] = deque()
        self._timer = QTimer(self)
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._slice)

    def add(self, work: Iterator[None]) -> None:
        """Do this beside what is under way."""
        self._works.appendleft(work)
        self._timer.start()

    def _slice(self) -> None:
        work = self._works.popleft()
        try:
            if next(work, self) is not self:
                self._works.append(work)
        finally:
            if not self._works:
                self._timer.stop()
