"""Which file recovered work came from, and what is no recovery file at all."""

import os
import shutil
import sys
import time
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.session.recovery.left_work import MOVE, left_by_a_dead_process
from workbench.document import Stored, read, write
from workbench.document.samples.examples import example_document
from workbench.session import Session
from workbench.session.recovery import recoverable

pytestmark = pytest.mark.xdist_group("processes")


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
