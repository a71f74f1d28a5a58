"""Preparing algorithms in the background: one failure does not end it for good."""

import pytest
from pytestqt.qtbot import QtBot

from workbench.engine import compiled
from workbench.shell.warming import Warming
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
    monkeypatch.setattr(window, "topics", lambda slug: (slug,))
    warming = Warming(window)
    warming.prepare("draw")
    warming.prepare("display")
    qtbot.waitUntil(lambda: len(asked) == 2)
    warming.stop()
    qtbot.waitUntil(lambda: warming._thread is None)
