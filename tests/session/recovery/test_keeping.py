"""Unsaved work is kept beside the session, and offered when its process is dead."""

import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.session.recovery.left_work import MOVE, ROOT, left_by_a_dead_process, names
from workbench.document import DocumentError, Stored, read, write
from workbench.document.samples.examples import example_document
from workbench.session import Session, recovery
from workbench.session.recovery import RecoveryFile, recoverable

pytestmark = pytest.mark.xdist_group("processes")


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
    assert session._recovery.flush()
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


@pytest.mark.parametrize("end", ["save", "close"])
def test_recovered_work_goes_once_it_is_saved_or_given_up(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    left_by_a_dead_process(tmp_path / "left")
    (work,) = recoverable(tmp_path / "left")

    def refuse(*_args: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(recovery, "write", refuse)
        session.recover(work)
        assert not session._recovery.flush()
        assert len(recoverable(tmp_path / "left")) == 1
        if end == "save":
            session.save_as(tmp_path / "mine.gwb")
            assert session._recovery.flush()
        else:
            session.close()
    assert recoverable(tmp_path / "left") == []


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


def test_where_nothing_goes_that_is_open_locks_are_closed_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = Path.unlink

    def unlink(path: Path, missing_ok: bool = False) -> None:
        for descriptor in range(64):
            with suppress(OSError):
                if os.path.samestat(os.fstat(descriptor), path.stat()):
                    raise AssertionError(f"{path.name} is open")
        real(path, missing_ok)

    (tmp_path / "1-00000000.lock").touch()
    file = RecoveryFile(tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(recovery.sys, "platform", "win32")
        patch.setattr(Path, "unlink", unlink)
        assert recoverable(tmp_path) == []
        assert [each.stem for each in tmp_path.iterdir()] == [file.path.stem]
        file.close()
    assert list(tmp_path.iterdir()) == []
