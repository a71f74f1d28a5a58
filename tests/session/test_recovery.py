"""Unsaved work in its recovery file: when it is written, when it goes, and what a dead process leaves."""

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document import DocumentError, Stored, edits, read, write
from workbench.document.samples import example_document
from workbench.session import Session, recovery
from workbench.session.recovery import RecoveryFile, recoverable

pytestmark = pytest.mark.xdist_group("processes")

ROOT = Path(__file__).parents[2]
MOVE = edits.move_points({"s1/f1/p1/x": (3.0, 4.0)})


def left_by_a_dead_process(folder: Path, origin: str = "") -> Path:
    """The recovery file of a process that kept the example, moved, and was killed."""
    code = (
        "import os, sys; from pathlib import Path; from workbench.session.recovery import RecoveryFile;"
        "from workbench.document import Stored, edits;"
        "from workbench.document.samples import example_document;"
        "file = RecoveryFile(Path(sys.argv[1]));"
        "document = edits.move_points({'s1/f1/p1/x': (3.0, 4.0)})(example_document());"
        "file.keep(Stored(document, origin=sys.argv[2])); file.flush();"
        "print(file.path, flush=True); os._exit(9)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(folder), origin],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 9, done.stderr
    return Path(done.stdout.strip())


def names(folder: Path) -> list[str]:
    return sorted(file.suffix for file in folder.iterdir())


@pytest.fixture
def session(qtbot: QtBot, tmp_path: Path) -> Session:
    session = Session(document=example_document())
    session.start_autosave(tmp_path)
    yield session
    session.close()


def test_nothing_is_kept_of_what_is_not_changed(session: Session, qtbot: QtBot, tmp_path: Path) -> None:
    qtbot.wait(1)
    session._recovery.flush()
    assert names(tmp_path) == [".lock"]


def test_unsaved_work_is_kept_until_it_is_saved_or_undone(
    session: Session, qtbot: QtBot, tmp_path: Path
) -> None:
    session.apply(MOVE, "Move")
    session.update_state(step=2)
    qtbot.wait(1)
    session._recovery.flush()
    kept = read(session._recovery.path)
    assert (kept.document, kept.session, kept.origin) == (session.document, session.state, "")
    session.undo_stack.undo()
    session._recovery.flush()
    assert names(tmp_path) == [".lock"]
    session.undo_stack.redo()
    qtbot.wait(1)
    session._recovery.flush()
    assert names(tmp_path) == [".gwb", ".lock"]
    session.save_as(tmp_path / "mine.gwb")
    session._recovery.flush()
    assert sorted(file.name for file in tmp_path.glob("*.gwb")) == ["mine.gwb"]


def test_a_clean_end_leaves_nothing(session: Session, qtbot: QtBot, tmp_path: Path) -> None:
    session.apply(MOVE, "Move")
    qtbot.wait(1)
    session._recovery.flush()
    session.close()
    assert list(tmp_path.iterdir()) == []


def test_what_a_living_process_keeps_is_not_offered(session: Session, qtbot: QtBot, tmp_path: Path) -> None:
    session.apply(MOVE, "Move")
    qtbot.wait(1)
    session._recovery.flush()
    code = (
        "import sys; from pathlib import Path; from workbench.session.recovery import recoverable;"
        "print(len(recoverable(Path(sys.argv[1]))))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path)], cwd=ROOT, capture_output=True, text=True
    )
    assert done.stdout.strip() == "0", done.stderr
    assert recoverable(tmp_path) == []
    assert names(tmp_path) == [".gwb", ".lock"]


def test_what_a_dead_process_left_is_offered_and_restored(
    session: Session, qtbot: QtBot, tmp_path: Path
) -> None:
    origin = tmp_path / "elsewhere" / "lab 3.gwb"
    path = left_by_a_dead_process(tmp_path, str(origin))
    (work,) = recoverable(tmp_path)
    assert (work.path, work.origin, work.name) == (path, origin, "lab 3.gwb")
    session.recover(work)
    assert session.document == MOVE(example_document())
    assert session.path == origin
    assert session.dirty
    assert recoverable(tmp_path) == []
    assert read(session._recovery.path).document == session.document


def test_work_that_had_no_file_is_called_by_its_sheet(tmp_path: Path) -> None:
    left_by_a_dead_process(tmp_path)
    (work,) = recoverable(tmp_path)
    assert (work.origin, work.name) == (None, "A line")
    work.discard()
    assert list(tmp_path.iterdir()) == []


def test_work_stays_until_the_new_session_keeps_it_itself(qtbot: QtBot, tmp_path: Path) -> None:
    left_by_a_dead_process(tmp_path)
    session = Session()
    session.recover(recoverable(tmp_path)[0])
    assert len(recoverable(tmp_path)) == 1


def test_damaged_work_is_refused_and_what_is_open_stays(session: Session, tmp_path: Path) -> None:
    path = left_by_a_dead_process(tmp_path)
    path.write_bytes(path.read_bytes()[:300])
    (work,) = recoverable(tmp_path)
    with pytest.raises(DocumentError):
        session.recover(work)
    assert session.document == example_document()
    assert path.exists()


def test_locks_without_work_are_cleared_away_and_work_without_a_lock_is_found(tmp_path: Path) -> None:
    (tmp_path / "1-00000000.lock").touch()
    write(Stored(example_document()), tmp_path / "2-00000000.gwb")
    write(Stored(example_document()), tmp_path / "mine.gwb")
    (tmp_path / ".2-00000000.gwb-00000000.999999999.saving").touch()
    assert [work.path.name for work in recoverable(tmp_path)] == ["2-00000000.gwb"]
    assert {file.name for file in tmp_path.iterdir()} == {"2-00000000.gwb", "2-00000000.lock", "mine.gwb"}
    assert recoverable(tmp_path / "none") == []


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
    said: list[str] = []
    file = RecoveryFile(tmp_path, failed=said.append)
    with monkeypatch.context() as patch:

        def full(*_args: object) -> None:
            raise OSError(28, "No space left on device")

        patch.setattr(os, "fsync", full)
        file.keep(Stored(example_document()))
        file.flush()
    assert len(said) == 1
    assert "No space left" in said[0]
    file.keep(Stored(example_document()))
    file.flush()
    assert read(file.path).document == example_document()
    file.close()


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
    session.close()
