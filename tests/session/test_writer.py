"""What is written beside the interface: its end is told in any case, and a failure keeps its traceback."""

import threading
from pathlib import Path
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from workbench.exchange.writing import Cancelled, FileFormat, whole
from workbench.session.writer import Outcome, Writer

TEXT = FileFormat("text", ".txt", "Text", whole(bytes))


def outcome(qtbot: QtBot, path: Path, error: BaseException | None) -> Outcome:
    """How a writing ends whose content raises ``error``."""
    writer = Writer()
    ends: list[Outcome] = []
    writer.ended.connect(ends.append)

    def make() -> Any:
        if error is not None:
            raise error
        return b"a"

    writer.start(TEXT, make, path)
    qtbot.waitUntil(lambda: not writer.busy)
    (end,) = ends
    return end


@pytest.mark.parametrize("error", [MemoryError(), KeyError("none"), RuntimeError("odd")])
def test_a_failure_of_the_program_is_said_and_goes_where_failures_go(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    reported: list[object] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: reported.append(args.exc_value))
    end = outcome(qtbot, tmp_path / "a.txt", error)
    assert end == Outcome(problem="Something in the program failed, so a.txt was not written.")
    assert reported == [error]
    assert list(tmp_path.iterdir()) == []


def test_the_other_ends(qtbot: QtBot, tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    assert outcome(qtbot, path, Cancelled()) == Outcome(cancelled=True)
    assert outcome(qtbot, path, ValueError("No.")) == Outcome(problem="No.")
    assert list(tmp_path.iterdir()) == []
    assert outcome(qtbot, path, None) == Outcome((path,), b"a")
    assert path.read_bytes() == b"a"
