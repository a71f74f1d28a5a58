"""When unsaved work is written, and what is done where it cannot be."""

import os
import shutil
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.session.recovery.left_work import BLOBS, MOVE, names
from workbench.document import DocumentError, Stored, edits, read
from workbench.document.samples.examples import example_document
from workbench.session import Session, recovery
from workbench.session.recovery import RecoveryFile, recoverable

pytestmark = pytest.mark.xdist_group("processes")


def test_a_stream_of_changes_does_not_put_off_the_write(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written = threading.Event()
    monkeypatch.setattr(recovery, "write", lambda _stored, _path: written.set())
    file = RecoveryFile(tmp_path, delay_s=0.05)
    stored = Stored(example_document())
    while not written.is_set():
        file.keep(stored)
    file.close()


def test_the_last_change_is_the_one_that_is_written(tmp_path: Path) -> None:
    file = RecoveryFile(tmp_path, delay_s=0.001)
    for x in range(200):
        document = edits.move_points({"s1/f1/p1/x": (x, 0.0)})(example_document())
        file.keep(Stored(document))
    file.flush()
    assert read(file.path).document == document
    file.close()


def test_a_full_disk_is_told_and_the_next_change_tries_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = RecoveryFile(tmp_path)
    with monkeypatch.context() as patch:

        def full(*_args: object) -> None:
            raise OSError(28, "No space left on device")

        patch.setattr(os, "fsync", full)
        file.keep(Stored(example_document()))
        file.flush()
    assert "No space left" in file.trouble
    file.keep(Stored(example_document()))
    file.flush()
    assert read(file.path).document == example_document()
    assert file.trouble == ""
    file.close()


@pytest.mark.parametrize("broken", ["write", "_remove", "sweep", "replace_file"])
@pytest.mark.parametrize("error", [OSError(30, "Read-only file system"), MemoryError(), ValueError("odd")])
def test_whatever_fails_it_goes_on_by_itself(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, broken: str, error: Exception
) -> None:
    folder = tmp_path / "recovery"
    stored = Stored(example_document(), blobs=BLOBS)
    with monkeypatch.context() as patch:

        def refuse(*_args: object) -> None:
            raise error

        if broken != "_remove":
            patch.setattr(recovery, broken, refuse)
        file = RecoveryFile(folder, 0.001)
        if broken == "_remove":
            file.keep(stored)
            assert file.flush()
            patch.setattr(recovery, broken, refuse)
        file.keep(None if broken == "_remove" else stored)
        assert not file.flush()
        assert not file.flush()
        assert file.trouble.startswith("Unsaved work is not kept")
        assert file.trouble.endswith("save often until then.")
    # The disk is back; nothing is changed any more, and nobody asks.
    end_s = time.monotonic() + 10
    while file.trouble:
        assert time.monotonic() < end_s
        time.sleep(0.002)
    file.keep(stored)
    assert file.flush()
    assert recovery.Recoverable(file.path, None, "", 0.0).read() == stored
    file.close()
    assert list(folder.iterdir()) == []


def test_nothing_is_tried_where_there_is_nothing_to_keep_or_remove(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    file = RecoveryFile(tmp_path / "file" / "recovery")
    trouble = file.trouble
    assert trouble
    (tmp_path / "file").unlink()
    for _time in range(3):
        file.keep(None)
        assert file.flush()
    assert file.trouble == trouble  # nothing was tried
    assert list(tmp_path.iterdir()) == []
    file.close()


def test_what_cannot_be_removed_is_not_tried_without_a_pause(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = RecoveryFile(tmp_path, delay_s=60)
    file.keep(Stored(example_document()))
    assert file.flush()
    tries: list[Path] = []

    def refuse(path: Path) -> None:
        tries.append(path)
        raise OSError(30, "Read-only file system")

    with monkeypatch.context() as patch:
        patch.setattr(recovery, "_remove", refuse)
        file.keep(None)
        assert not file.flush()
        time.sleep(0.05)
        assert 1 <= len(tries) <= 2
    assert file.flush()
    file.close()


def test_a_folder_that_is_removed_is_made_again(tmp_path: Path) -> None:
    folder = tmp_path / "recovery"
    file = RecoveryFile(folder, delay_s=0.001)
    file.keep(Stored(example_document()))
    assert file.flush()
    shutil.rmtree(folder)
    file.keep(Stored(example_document()))
    assert file.flush()
    assert names(folder) == [".gwb", ".lock"]
    file.close()
    assert names(folder) == []


def test_it_rests_twenty_times_as_long_as_it_wrote(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    clock = 100.0
    waits: list[float] = []
    file = RecoveryFile(tmp_path, delay_s=2.0)
    whole = file._state.wait_for

    def wait_for(predicate: Callable[[], bool], timeout: float | None = None) -> bool:
        if timeout is not None:
            waits.append(timeout)
        return whole(predicate)

    def write_slowly(_stored: Stored, _path: Path) -> None:
        nonlocal clock
        clock += 0.5

    monkeypatch.setattr(recovery.time, "monotonic", lambda: clock)
    monkeypatch.setattr(recovery, "write", write_slowly)
    monkeypatch.setattr(file._state, "wait_for", wait_for)
    for seconds_later in (0.0, 4.0, 0.0, 60.0):
        clock += seconds_later
        file.keep(Stored(example_document()))
        assert file.flush()
    file.close()
    assert waits[:4] == [2.0, 6.0, 10.0, 2.0]


def test_trouble_reaches_the_interface(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    session = Session(document=example_document())
    session.start_autosave(tmp_path)

    def refuse(*_args: object) -> None:
        raise DocumentError("", "The disk is full.")

    monkeypatch.setattr(recovery, "write", refuse)
    with qtbot.waitSignal(session.autosave_failed) as told:
        session.apply(MOVE, "Move")
        session.flush()
        session._recovery.flush()
    assert "The disk is full." in told.args[0]
    session.close()


def test_without_a_folder_to_keep_it_in_work_goes_on(qtbot: QtBot, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    session = Session(document=example_document())
    with qtbot.waitSignal(session.autosave_failed) as told:
        session.start_autosave(tmp_path / "file" / "recovery")
    assert "save often" in told.args[0]
    session.apply(MOVE, "Move")
    session.flush()
    assert recoverable(tmp_path / "file" / "recovery") == []
    (tmp_path / "file").unlink()
    with qtbot.waitSignal(session.autosave_mended):
        assert session._recovery.flush()
    assert read(session._recovery.path).document == session.document
    session.close()
