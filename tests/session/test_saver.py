"""Saving behind the session's back: whatever happens there, its end is told and the next save works."""

import threading
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from workbench.document import Stored, read
from workbench.document.samples.examples import example_document
from workbench.exchange.written import formats
from workbench.session import saver
from workbench.session.saver import Saved, Saver
from workbench.session.writer import Outcome, Writer


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_failure_of_the_program_is_told_too(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saves: list[Saved] = []
    one = Saver()
    one.saved.connect(saves.append)
    stored = Stored(example_document())
    with monkeypatch.context() as patch:

        def fail(*_args: object) -> None:
            raise KeyError("no such thing")

        patch.setattr(saver, "write", fail)
        one.start(stored, tmp_path / "a.gwb")
        qtbot.waitUntil(lambda: not one.busy)
    one.start(stored, tmp_path / "a.gwb")
    one.wait()
    assert [bool(save.problem) for save in saves] == [True, False]
    assert read(tmp_path / "a.gwb") == stored


def test_where_the_system_gives_no_thread_the_file_is_written_all_the_same(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saves: list[Saved] = []
    one = Saver()
    one.saved.connect(saves.append)
    stored = Stored(example_document())
    with monkeypatch.context() as patch:
        patch.setattr(threading.Thread, "start", refuse)
        one.start(stored, tmp_path / "a.gwb")
        assert one.busy
        one.wait()
    assert not one.busy
    one.start(stored, tmp_path / "b.gwb")
    one.wait()
    assert [(save.path.name, save.problem) for save in saves] == [("a.gwb", ""), ("b.gwb", "")]
    assert read(tmp_path / "a.gwb") == read(tmp_path / "b.gwb") == stored


def test_a_save_whose_thread_never_comes_to_run_is_done_by_who_waits_for_it(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(threading.Thread, "_bootstrap", lambda _thread: None)
    saves: list[Saved] = []
    one = Saver()
    one.saved.connect(saves.append)
    stored = Stored(example_document())
    one.start(stored, tmp_path / "a.gwb")
    assert one.busy
    one.wait()
    assert not one.busy
    qtbot.wait(10)
    assert [save.problem for save in saves] == [""]
    assert read(tmp_path / "a.gwb") == stored


def test_an_export_that_gets_no_thread_is_written_all_the_same(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    row = next(row for row in formats("picture") if row.suffix == ".png")
    image = np.zeros((4, 5), np.uint32), 1
    outcomes: list[Outcome] = []
    writer = Writer()
    writer.ended.connect(outcomes.append)
    for name in ("a.png", "b.png"):
        with monkeypatch.context() as patch:
            patch.setattr(threading.Thread, "start", refuse)
            writer.start(row, lambda: image, tmp_path / name)
        qtbot.waitUntil(lambda: not writer.busy)
    assert [outcome.paths for outcome in outcomes] == [(tmp_path / "a.png",), (tmp_path / "b.png",)]


def test_what_the_system_says_is_told_without_its_number(qtbot: QtBot, tmp_path: Path) -> None:
    row = next(row for row in formats("picture") if row.suffix == ".png")
    outcomes: list[Outcome] = []
    writer = Writer()
    writer.ended.connect(outcomes.append)

    def fail() -> None:
        raise OSError(24, "Too many open files")

    writer.start(row, fail, tmp_path / "a.png")
    qtbot.waitUntil(lambda: not writer.busy)
    assert outcomes[0].problem == "Too many open files"


def refuse(_thread: threading.Thread) -> None:
    raise RuntimeError("can't start new thread")
