"""A picture of the window waits for what is still to come in it."""

import threading
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtWidgets import QMainWindow
from pytestqt.qtbot import QtBot

from tests.session.test_ahead import sheet_of
from workbench.display.setup import raster_tube
from workbench.session.ahead import Ahead
from workbench.shell.settled import has_settled, when_settled
from workbench.widgets.plots.library import library
from workbench.widgets.tube import view as view_module
from workbench.widgets.tube.view import TubeView


def test_it_waits_for_the_picture_of_a_tube_that_is_seen(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    may_go = threading.Event()
    monkeypatch.setattr(view_module, "raster_tube", lambda *asked: may_go.wait(20) and raster_tube(*asked))
    window, tube, hidden = QMainWindow(), TubeView("raster"), TubeView("raster")
    qtbot.addWidget(window)
    hidden.setParent(window)
    hidden.hide()
    window.session = SimpleNamespace(ahead=Ahead(window), run=SimpleNamespace(done=True))  # type: ignore[attr-defined]
    window.setCentralWidget(tube)
    tube.set_image(np.zeros((330, 330), np.uint32))  # so large that it is made on a thread
    window.resize(300, 240)
    window.show()
    qtbot.waitExposed(window)
    assert tube.sight.now
    assert not has_settled(window)  # type: ignore[arg-type]
    done: list[Fraction] = []
    when_settled(window, lambda: done.append(tube.seconds()))  # type: ignore[arg-type]
    qtbot.wait(120)
    assert done == []
    may_go.set()
    qtbot.waitUntil(lambda: len(done) == 1)
    assert has_settled(window)  # type: ignore[arg-type]
    tube.resize(200, 150)  # the picture has another size now
    assert not has_settled(window)  # type: ignore[arg-type]
    qtbot.waitUntil(lambda: has_settled(window))  # type: ignore[arg-type]


def test_it_waits_for_the_plots(qtbot: QtBot) -> None:
    window, made = QMainWindow(), []
    qtbot.addWidget(window)
    window.session = SimpleNamespace(ahead=Ahead(window), run=SimpleNamespace(done=True))  # type: ignore[attr-defined]
    library.queue(window, lambda: made.append(True))
    assert not has_settled(window)  # type: ignore[arg-type]
    qtbot.waitUntil(lambda: has_settled(window))  # type: ignore[arg-type]
    assert made == [True]


def test_it_waits_for_what_is_worked_on_of_a_large_sheet(qtbot: QtBot) -> None:
    window, ahead, go_on = QMainWindow(), Ahead(), threading.Event()
    qtbot.addWidget(window)
    window.session = SimpleNamespace(ahead=ahead, run=SimpleNamespace(done=True))  # type: ignore[attr-defined]
    assert has_settled(window)  # type: ignore[arg-type]
    ahead.of(sheet_of(400), "event", lambda: go_on.wait(20))
    assert not has_settled(window)  # type: ignore[arg-type]
    go_on.set()
    qtbot.waitUntil(lambda: has_settled(window))  # type: ignore[arg-type]


def test_it_waits_until_the_run_is_recorded_and_that_is_shown(qtbot: QtBot) -> None:
    window, run, done = QMainWindow(), SimpleNamespace(done=False), list[bool]()
    qtbot.addWidget(window)
    window.session = SimpleNamespace(ahead=Ahead(window), run=run)  # type: ignore[attr-defined]
    when_settled(window, lambda: done.append(True))  # type: ignore[arg-type]
    qtbot.wait(120)
    run.done = True
    when_settled(window, lambda: done.append(False))  # type: ignore[arg-type]
    assert done == []  # not in the same turn
    qtbot.waitUntil(lambda: len(done) == 2)
