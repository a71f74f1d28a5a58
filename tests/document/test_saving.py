"""Replacing a file: the old one or the new one, its permissions, its links, and nothing left beside it."""

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from workbench.document import DocumentError
from workbench.document.saving import replace_file

posix = pytest.mark.skipif(sys.platform == "win32", reason="permissions and links of POSIX")


def nothing(_data: bytes) -> None:
    """What was read back is taken as it is."""


def test_a_new_file_and_its_replacement(tmp_path: Path) -> None:
    for data in (b"one", b"", b"three" * 100_000):
        replace_file(tmp_path / "a.gwb", data, nothing)
        assert (tmp_path / "a.gwb").read_bytes() == data
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


@posix
def test_permissions_are_kept_and_new_files_follow_the_mask(tmp_path: Path) -> None:
    path = tmp_path / "a.gwb"
    old = os.umask(0o027)
    try:
        replace_file(path, b"one", nothing)
    finally:
        os.umask(old)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    path.chmod(0o604)
    replace_file(path, b"two", nothing)
    assert stat.S_IMODE(path.stat().st_mode) == 0o604


@posix
def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    target = tmp_path / "far" / "real.gwb"
    target.write_bytes(b"old")
    link = tmp_path / "link.gwb"
    link.symlink_to(Path("far") / "real.gwb")
    replace_file(link, b"new", nothing)
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    assert sorted(file.name for file in tmp_path.rglob("*")) == ["far", "link.gwb", "real.gwb"]


def test_what_reads_back_wrong_never_replaces(tmp_path: Path) -> None:
    path = tmp_path / "a.gwb"
    path.write_bytes(b"old")

    def wrong(data: bytes) -> None:
        assert data == b"new"
        raise DocumentError("", "It reads back differently.")

    with pytest.raises(DocumentError, match="differently"):
        replace_file(path, b"new", wrong)
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


@pytest.mark.parametrize("step", ["os.open", "os.fsync", "os.replace"])
def test_when_the_disk_refuses_the_old_file_stays(
    step: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.gwb"
    path.write_bytes(b"old")

    def full(*_args: object, **_kwargs: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(step, full)
        with pytest.raises(DocumentError, match="No space left"):
            replace_file(path, b"new", nothing)
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


def test_a_file_that_may_not_be_changed_is_not_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.gwb"
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "access", lambda *_args: False)
    with pytest.raises(DocumentError, match="another name"):
        replace_file(path, b"new", nothing)
    assert path.read_bytes() == b"old"


def test_a_very_long_name(tmp_path: Path) -> None:
    path = tmp_path / ("é" * 120 + ".gwb")
    replace_file(path, b"new", nothing)
    assert path.read_bytes() == b"new"


@posix
def test_what_dead_processes_left_is_swept_and_what_lives_is_not(tmp_path: Path) -> None:
    path = tmp_path / "a.gwb"
    code = (
        "import os, sys; from pathlib import Path; from workbench.document.saving import replace_file;"
        "replace_file(Path(sys.argv[1]), b'x', lambda data: os.kill(os.getpid(), 9))"
    )
    subprocess.run([sys.executable, "-c", code, str(path)], check=False, cwd=Path(__file__).parents[2])
    (left,) = tmp_path.iterdir()
    assert left.name.endswith(".saving")
    living = left.with_name(left.name.replace(left.name.split(".")[-2], str(os.getppid())))
    living.write_bytes(b"")
    foreign = tmp_path / ".b.gwb-00000000.999999999.saving"
    foreign.write_bytes(b"")
    replace_file(path, b"new", nothing)
    assert sorted(tmp_path.iterdir()) == sorted([path, living, foreign])
