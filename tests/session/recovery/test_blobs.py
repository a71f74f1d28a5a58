"""Blobs of unsaved work: written once, restored, and cleared away."""

from pathlib import Path

import pytest

from tests.session.recovery.left_work import BLOBS, left_by_a_dead_process
from workbench.document import DocumentError, Stored, edits
from workbench.document.samples.examples import example_document
from workbench.session import Session, recovery
from workbench.session.recovery import RecoveryFile, recoverable

pytestmark = pytest.mark.xdist_group("processes")


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
        written = beside  # what was cleared away in between is written anew
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
