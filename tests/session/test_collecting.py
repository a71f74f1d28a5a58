"""Cycles with Qt objects in them die on the interface thread, whoever allocates."""

import gc
import sys
import threading
import weakref

import pytest
from PySide6.QtCore import QCoreApplication, QObject, QTimer
from pytestqt.qtbot import QtBot

from workbench.session import collecting


@pytest.fixture
def collector(qapp: QCoreApplication) -> QObject:
    collecting.collect_here()
    return qapp.findChild(collecting._Collector)


class Cycle(QObject):
    """An object that only the collector can free, with a timer that must not die elsewhere."""

    def __init__(self) -> None:
        super().__init__()
        self.itself = self
        timer = QTimer(self)
        timer.start(1)
        self.children_too = [timer, self]


def allocate(count: int = 200_000) -> None:
    """Enough cycles for Python's own collector to run many times."""
    for _number in range(count):
        one: list[object] = []
        one.append(one)


def test_a_thread_that_allocates_destroys_no_timers(collector: QObject, qtbot: QtBot) -> None:
    gone = weakref.ref(Cycle())
    thread = threading.Thread(target=allocate)
    thread.start()
    thread.join()
    assert gone() is not None
    qtbot.waitUntil(lambda: gone() is None)


def test_there_is_one_collector_and_it_keeps_up(collector: QObject, qtbot: QtBot) -> None:
    collecting.collect_here()
    assert len(QCoreApplication.instance().findChildren(collecting._Collector)) == 1
    assert not gc.isenabled()
    allocate()
    qtbot.waitUntil(lambda: gc.get_count()[0] < 20_000)


def test_old_garbage_goes_too(collector: QObject) -> None:
    cycle: list[object] = [Cycle()]
    gone = weakref.ref(cycle[0])
    gc.collect()
    cycle.clear()
    for _turn in range(400):
        allocate(1_000)
        collector.collect()
        if gone() is None:
            break
        collector._survived = 0
    assert gone() is None


def test_no_garbage_is_frozen_with_the_modules(collector: QObject, monkeypatch: pytest.MonkeyPatch) -> None:
    cycle: list[object] = [Cycle()]
    gone = weakref.ref(cycle[0])
    gc.collect()
    cycle.clear()
    assert gone() is not None
    monkeypatch.setattr(gc, "freeze", lambda: None)
    collector._modules = len(sys.modules) - 2 * collecting._WAVE
    collector.collect()
    assert gone() is None
