"""A run that is left for another leaves nothing behind: nothing recorded, and no count under way."""

import gc
import time
import weakref
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.document.subjects import Subject
from workbench.engine import compiled, counts
from workbench.rendering.mapping import Call
from workbench.session import recorded_run
from workbench.session.run import Run

BRESENHAM = catalogue.get("bresenham_line")
LINE = (20, 10, 30, 18)
LONG = (0, 0, 10**6, 10**5)


@pytest.fixture
def run(qtbot: QtBot) -> Run:
    run = Run()
    run.limit = 3000
    return run


def follow(qtbot: QtBot, run: Run, line: tuple[int, int, int, int]) -> None:
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, line)], (40, 28))
    qtbot.waitUntil(lambda: run.done, timeout=20_000)


def test_nothing_keeps_what_was_recorded(qtbot: QtBot, run: Run) -> None:
    follow(qtbot, run, LONG)
    assert run.in_stretches
    gone = weakref.ref(run.recording)
    run.clear()
    gc.collect()
    assert gone() is None


def test_its_steps_are_counted_no_further(qtbot: QtBot, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    stops: list[compiled.Stop] = []

    def never_ends(_entry: Entry, *_arguments: Any, stop: compiled.Stop, compiling: bool) -> int:
        stops.append(stop)
        while not stop.is_set:
            time.sleep(0.001)
        raise compiled.Stopped

    monkeypatch.setattr(counts, "step_total", never_ends)
    monkeypatch.setattr(recorded_run, "_counting_is_ready", lambda _entry: True)
    follow(qtbot, run, LONG)
    qtbot.waitUntil(lambda: bool(stops))
    follow(qtbot, run, LINE)
    assert stops[0].is_set
    assert run.total_steps == 10
    run.clear()
