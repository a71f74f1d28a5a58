"""Unsaved work in its recovery file: when it is written, when it goes, and what a dead process leaves."""

import hashlib
import os
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest
from msgspec.structs import replace
from pytestqt.qtbot import QtBot

from workbench.document import DocumentError, Stored, edits, read, write
from workbench.document.samples.examples import example_document
from workbench.session import Session, recovery
from workbench.session.recovery import RecoveryFile, recoverable

pytestmark = pytest.mark.xdist_group("processes")

ROOT = Path(__file__).parents[2]
MOVE = edits.move_points({"s1/f1/p1/x": (3.0, 4.0)})


def left_by_a_dead_process(folder: Path, origin: str = "", blobs: dict[str, bytes] | None = None) -> Path:
    """The recovery file of a process that kept the example, moved, and was killed."""
    texts = [text for digest, content in (blobs or {}).items() for text in (digest, os.fsdecode(content))]
    code = (
        "import os, sys; from pathlib import Path; from workbench.session.recovery import RecoveryFile;"
        "from workbench.document import Stored, edits;"
        "from workbench.document.samples.examples import example_document;"
        "file = RecoveryFile(Path(sys.argv[1]));"
        "document = edits.move_points({'s1/f1/p1/x': (3.0, 4.0)})(example_document());"
        "blobs = dict(zip(sys.argv[3::2], map(os.fsencode, sys.argv[4::2])));"
        "file.keep(Stored(document, blobs=blobs, origin=sys.argv[2])); file.flush();"
        "print(file.path, flush=True); os._exit(9)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(folder), origin, *texts],
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
    mended: list[str] = []
    file = RecoveryFile(tmp_path, failed=said.append, mended=mended.append)
    with monkeypatch.context() as patch:

        def full(*_args: object) -> None:
            raise OSError(28, "No space left on device")

        patch.setattr(os, "fsync", full)
        file.keep(Stored(example_document()))
        file.flush()
    assert len(said) == 1
    assert "No space left" in said[0]
    assert mended == []
    file.keep(Stored(example_document()))
    file.flush()
    assert read(file.path).document == example_document()
    assert (len(said), mended) == (1, ["Unsaved work is kept safe again."])
    file.close()


@pytest.mark.parametrize("broken", ["write", "_remove", "sweep", "replace_file"])
@pytest.mark.parametrize("error", [OSError(30, "Read-only file system"), MemoryError(), ValueError("odd")])
def test_whatever_fails_it_goes_on_by_itself(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, broken: str, error: Exception
) -> None:
    said: list[str] = []
    mended = threading.Event()
    folder = tmp_path / "recovery"
    stored = Stored(example_document(), blobs=BLOBS)
    with monkeypatch.context() as patch:

        def refuse(*_args: object) -> None:
            raise error

        if broken != "_remove":
            patch.setattr(recovery, broken, refuse)
        file = RecoveryFile(folder, 0.001, said.append, lambda _sentence: mended.set())
        if broken == "_remove":
            file.keep(stored)
            assert file.flush()
            patch.setattr(recovery, broken, refuse)
        file.keep(None if broken == "_remove" else stored)
        assert not file.flush()
        assert not file.flush()
    # The disk is back; nothing is changed any more, and nobody asks.
    assert mended.wait(10)
    assert len(said) == 1
    assert said[0].startswith("Unsaved work is not kept")
    assert said[0].endswith("save often until then.")
    file.keep(stored)
    assert file.flush()
    assert recovery.Recoverable(file.path, None, "", 0.0).read() == stored
    file.close()
    assert list(folder.iterdir()) == []


def test_nothing_is_tried_where_there_is_nothing_to_keep_or_remove(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    said: list[str] = []
    file = RecoveryFile(tmp_path / "file" / "recovery", failed=said.append)
    (tmp_path / "file").unlink()
    for _time in range(3):
        file.keep(None)
        assert file.flush()
    assert len(said) == 1
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


# No zeros, and no more than fits on a command line.
BLOBS = {hashlib.sha256(content).hexdigest(): content for content in (b"a mesh" * 1000, b"a picture" * 999)}


def test_each_blob_is_written_once_beside_the_recovery_file(tmp_path: Path) -> None:
    file = RecoveryFile(tmp_path)
    written: dict[str, int] = {}
    for number in range(4):
        blobs = dict(list(BLOBS.items())[: 1 + number % 2])
        document = edits.rename_sheet("s1", str(number))(example_document())
        file.keep(Stored(document, blobs=blobs))
        assert file.flush()
        beside = {path.name: path.stat().st_ino for path in tmp_path.glob("*.blob")}
        assert sorted(beside) == sorted(f"{file.path.stem}.{digest}.blob" for digest in blobs)
        assert all(beside[name] == number for name, number in written.items() if name in beside)
        written |= beside
        assert file.path.stat().st_size < 2000
        assert recovery.Recoverable(file.path, None, "", 0.0).read() == Stored(document, blobs=blobs)
    file.close()
    assert list(tmp_path.iterdir()) == []


def test_blobs_of_a_dead_process_are_restored_and_cleared_away(session: Session, tmp_path: Path) -> None:
    path = left_by_a_dead_process(tmp_path, blobs=BLOBS)
    # The process died before it cleared away what it needed no longer.
    path.with_suffix(f".{'0' * 64}.blob").touch()
    (work,) = recoverable(tmp_path)
    session.recover(work)
    assert session._recovery.flush()
    assert session.stored.blobs == BLOBS
    assert recoverable(tmp_path) == []
    assert {file.name.partition(".")[0] for file in tmp_path.iterdir()} == {session._recovery.path.stem}


@pytest.mark.parametrize("damage", ["does not match its content", "A file that belongs to .* is missing"])
def test_a_damaged_blob_is_refused_and_nothing_is_thrown_away(
    session: Session, tmp_path: Path, damage: str
) -> None:
    path = left_by_a_dead_process(tmp_path, blobs=BLOBS)
    digest, content = next(iter(BLOBS.items()))
    damaged = path.with_suffix(f".{digest}.blob")
    if "missing" in damage:
        damaged.unlink()
    else:
        damaged.write_bytes(content[:-1])
    with pytest.raises(DocumentError, match=damage):
        session.recover(recoverable(tmp_path)[0])
    assert len(list(tmp_path.glob(f"{path.stem}.*"))) == 4 - ("missing" in damage)


def test_blobs_without_their_recovery_file_are_cleared_away(tmp_path: Path) -> None:
    (tmp_path / f"1-00000000.{'0' * 64}.blob").touch()
    assert recoverable(tmp_path) == []
    assert list(tmp_path.iterdir()) == []


def test_recovered_work_whose_file_was_saved_since_counts_as_changed_on_disk(
    session: Session, tmp_path: Path
) -> None:
    origin = tmp_path / "lab 3.gwb"
    write(Stored(example_document()), origin)
    path = left_by_a_dead_process(tmp_path, str(origin))
    session.recover(recoverable(tmp_path)[0])
    assert not session.changed_on_disk
    left_by_a_dead_process(tmp_path, str(origin))
    later = path.stat().st_mtime + 10 if path.exists() else time.time() + 10
    os.utime(origin, (later, later))
    session.recover(recoverable(tmp_path)[0])
    assert session.changed_on_disk


def test_a_change_that_the_dead_process_had_not_seen_counts_even_if_it_is_older(
    session: Session, tmp_path: Path
) -> None:
    origin = tmp_path / "lab 3.gwb"
    write(Stored(example_document()), origin)
    mine = Session()
    mine.open(origin)
    mine.start_autosave(tmp_path / "dead")
    write(Stored(MOVE(example_document())), origin)  # another program
    mine.apply(MOVE, "Move")
    mine.flush()
    assert mine._recovery.flush()
    shutil.copytree(tmp_path / "dead", tmp_path / "left")
    mine.close()
    (work,) = recoverable(tmp_path / "left")
    assert origin.stat().st_mtime < work.kept_at
    session.recover(work)
    assert session.changed_on_disk
    session.save()
    assert not session.changed_on_disk


def test_a_file_that_comes_back_counts_as_changed(session: Session, tmp_path: Path) -> None:
    origin = tmp_path / "lab 3.gwb"
    left_by_a_dead_process(tmp_path, str(origin))
    session.recover(recoverable(tmp_path)[0])
    assert not session.changed_on_disk
    write(Stored(example_document()), origin)
    assert session.changed_on_disk


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


@pytest.mark.parametrize("kind", ["pipe", "device", "sparse"])
def test_what_is_no_recovery_file_is_not_read(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "1-aaaaaaaa.gwb"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "device":
        path.symlink_to("/dev/zero")
    else:
        with path.open("wb") as file:
            file.truncate(8 << 30)
    assert recoverable(tmp_path) == []
    assert os.path.lexists(path)


@pytest.mark.parametrize("lock", ["folder", "loop", "link"])
def test_a_lock_that_no_process_can_hold_hides_no_work(tmp_path: Path, lock: str) -> None:
    path = left_by_a_dead_process(tmp_path)
    place = path.with_suffix(".lock")
    place.unlink()
    if lock == "folder":
        place.mkdir()
    else:
        place.symlink_to(place if lock == "loop" else "/dev/zero")
    (work,) = recoverable(tmp_path)
    assert work.path == path
    work.discard()
    assert not path.exists()
    assert recoverable(tmp_path) == []


def test_work_whose_origin_is_no_path_is_offered_without_one(session: Session, tmp_path: Path) -> None:
    folder = tmp_path / "left"
    path = left_by_a_dead_process(folder)
    stored = read(path)
    write(replace(stored, origin="/tmp/a\0b.gwb"), path)
    (work,) = recoverable(folder)
    assert (work.origin, work.name) == (None, "A line")
    session.recover(work)
    assert session.path is None
    assert session.dirty


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are any bytes on Linux only")
def test_work_on_a_file_whose_name_is_not_utf_8_is_kept_with_its_name(
    session: Session, tmp_path: Path
) -> None:
    origin = tmp_path / os.fsdecode(b"caf\xe9 %41.gwb")
    session.save_as(origin)
    session.apply(MOVE, "Move")
    assert session._recovery.flush()
    copy = tmp_path / "copies"
    copy.mkdir()
    shutil.copy(session._recovery.path, copy)
    (work,) = recoverable(copy)
    assert work.origin == origin
    assert not work.origin_changed
