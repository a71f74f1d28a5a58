"""Garbage is collected on the interface thread only.

Python collects cycles on whichever thread happens to allocate. A recording thread would so destroy widgets
and timers that lie in a cycle, and Qt ends the process when one of them dies on a foreign thread. Once an
application records, Python's own collector is therefore off and a timer does its work, by like thresholds.
"""

import gc
import sys

from PySide6.QtCore import QCoreApplication, QObject, QTimer

_INTERVAL_MS = 100
# Python's own rule: everything is looked through only when it has grown by a quarter since the last time.
_GROWTH = 1.25
# Modules that came since the last time, as when a compiler is loaded.
_WAVE = 100


class _Collector(QObject):
    """Collects what Python's collector would, from the event loop of the thread it lives on."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._survived = 0
        self._modules = 0
        gc.disable()
        timer = QTimer(self)
        timer.timeout.connect(self.collect)
        timer.start(_INTERVAL_MS)

    def collect(self) -> None:
        """Collect the youngest generation that is full, and with it the next one when that is full too."""
        if len(sys.modules) > self._modules + _WAVE:
            # What modules are made of lives as long as the program: it is never looked through again. Nor is
            # what else is there, so that old garbage goes first; at the first wave there is none.
            gc.collect(2 if self._modules else 1)
            gc.freeze()
            self._modules = len(sys.modules)
            return
        young, middle, old = gc.get_count()
        most_young, most_middle, most_old = gc.get_threshold()
        if young <= most_young:
            return
        if middle <= most_middle:
            gc.collect(0)
        elif old <= most_old or len(gc.get_objects(2)) < _GROWTH * self._survived:
            gc.collect(1)
        else:
            gc.collect(2)
            self._survived = len(gc.get_objects(2))


def collect_here() -> None:
    """From now on, garbage is collected on this thread, the one of the running application."""
    application = QCoreApplication.instance()
    if application is None:
        return
    if application.findChild(_Collector) is None:
        _Collector(application)
    gc.disable()  # a library may have switched it on again
