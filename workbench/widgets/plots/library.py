"""The library that plots are drawn by, loaded when the first of them is seen.

What it needs of Python itself comes on a thread; it makes classes of Qt, which only this one may: that takes
two tenths of a second, and so comes piece by piece, one in each turn of the event loop.
"""

from collections import deque
from collections.abc import Callable, Iterator
from importlib import import_module

from PySide6.QtCore import QObject, QTimer, Signal
from shiboken6 import isValid

from workbench.session.answers import Answers
from workbench.widgets.plots.stepwise import import_stepwise

_APART_MS = 16  # posted events would come in one turn where a widget is shown


class _Library(QObject):
    """``loaded`` comes in a turn of its own after each time it was asked for."""

    loaded = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._there = False
        self._coming: Answers | None = None
        self._queue: deque[tuple[QObject, Callable[[], object]]] = deque()
        self._turn = QTimer(self, interval=_APART_MS)
        self._turn.timeout.connect(self._make_next)

    def ask(self) -> None:
        """Load it, unless it is there or coming."""
        if self._there:
            QTimer.singleShot(0, self.loaded.emit)
        elif self._coming is None:
            self._coming = Answers()
            self._coming.arrived.connect(lambda _there: self._go_on(import_stepwise("pyqtgraph")))
            self._coming.ask(_load_below_qt, "imports")

    def _go_on(self, steps: Iterator[None]) -> None:
        try:
            more = next(steps, self) is not self
        except ImportError:  # the same failure is said where the plot is made
            more = False
        if more:
            QTimer.singleShot(0, self, lambda: self._go_on(steps))
            return
        self._there = True
        self._coming = None
        QTimer.singleShot(0, self.loaded.emit)

    @property
    def busy(self) -> bool:
        """Whether it is coming, or a plot waits to be made."""
        return self._coming is not None or bool(self._queue)

    def queue(self, plot: QObject, make: Callable[[], object]) -> None:
        """Have a plot make what takes long in a turn of its own, if it is still there by then."""
        self._queue.append((plot, make))
        self._turn.start()

    def _make_next(self) -> None:
        plot, make = self._queue.popleft()
        if not self._queue:
            self._turn.stop()
        if isValid(plot):
            make()


def _load_below_qt() -> bool:
    for module in ("cProfile", "multiprocessing.connection", "multiprocessing.shared_memory", "pydoc"):
        import_module(module)
    return True


library = _Library()
