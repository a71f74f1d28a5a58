"""Preparing algorithms in the background: one failure does not end it for good."""

import threading
from types import SimpleNamespace

import pytest
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.engine import compiled, warm
from workbench.shell.warming import Warming, _Followed
from workbench.shell.window import MainWindow


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_after_a_failure_the_next_workspace_is_prepared(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def available() -> bool:
        asked.append("available")
        if len(asked) == 1:
            raise OSError(30, "Read-only file system")
        return False

    monkeypatch.setattr(compiled, "available", available)
    monkeypatch.setattr(window, "workspace", lambda slug: SimpleNamespace(topics=(slug,)))
    warming = Warming(window)
    warming.prepare("draw")
    warming.prepare("display")
    qtbot.waitUntil(lambda: len(asked) > 2)  # one for the reason that is told of the failure
    warming.stop()
    qtbot.waitUntil(lambda: not warming.busy)


def test_what_gets_no_thread_is_prepared_all_the_same(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled_topics: list[str] = []
    monkeypatch.setattr(window, "workspace", lambda slug: SimpleNamespace(topics=(slug,)))
    monkeypatch.setattr(_Followed, "_compile", lambda self, _tell: compiled_topics.extend(self._topics))
    warming = Warming(window)
    with monkeypatch.context() as patch:

        def refuse(_thread: threading.Thread) -> None:
            raise RuntimeError("can't start new thread")

        patch.setattr(threading.Thread, "start", refuse)
        warming.prepare("draw")
    warming.prepare("display")
    qtbot.waitUntil(lambda: compiled_topics == ["draw", "display"])
    qtbot.waitUntil(lambda: not warming.busy)


def test_what_was_compiled_before_is_loaded_before_it_is_asked_what_was_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    done: list[str] = []

    class Child:
        def __init__(self, slugs: list[str], modules: list[str]) -> None:
            done.append("ask")

        def follow(self, _tell: object) -> None:
            done.append("compile")

    monkeypatch.setattr(compiled, "available", lambda: True)
    monkeypatch.setattr(warm, "Warming", Child)
    monkeypatch.setattr(warm, "load", lambda slug, _stopped: done.append(slug))
    _Followed(("circles",)).work(lambda _progress: None)
    slugs = [entry.slug for entry in catalogue.entries() if entry.topic == "circles"]
    assert slugs
    assert done == [*slugs, "ask", "compile", *slugs]


def test_what_is_at_hand_is_not_loaded_again(monkeypatch: pytest.MonkeyPatch) -> None:
    loaded: list[str] = []
    monkeypatch.setattr(warm, "warm", lambda _slug, _use: True)
    monkeypatch.setattr(warm, "at_hand", lambda _function, use: use == "collect")
    monkeypatch.setattr(warm, "compile_use", lambda _entry, use: loaded.append(use))
    warm.load("bresenham_line", lambda: False)
    assert loaded == ["paint_batch"]
