"""Replacing a file: the old one or the new one, its permissions, its links, and nothing left beside it."""

import os
import stat
import subprocess
import sys
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

from workbench.document import DocumentError
from workbench.document.storage.saving import Replacement, SavingError, replace_file, sweep

posix = pytest.mark.skipif(sys.platform == "win32", reason="permissions and links of POSIX")


def test_a_new_file_and_its_replacement(tmp_path: Path) -> None:
    for data in (b"one", b"", b"three" * 100_000):
        replace_file(tmp_path / "a.gwb", data)
        assert (tmp_path / "a.gwb").read_bytes() == data
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


@posix
def test_permissions_are_kept_and_new_files_follow_the_mask(tmp_path: Path) -> None:
    path = tmp_path / "a.gwb"
    old = os.umask(0o027)
    try:
        replace_file(path, b"one")
    finally:
        os.umask(old)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    path.chmod(0o604)
    replace_file(path, b"two")
    assert stat.S_IMODE(path.stat().st_mode) == 0o604


@posix
def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    target = tmp_path / "far" / "real.gwb"
    target.write_bytes(b"old")
    link = tmp_path / "link.gwb"
    link.symlink_to(Path("far") / "real.gwb")
    replace_file(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    assert sorted(file.name for file in tmp_path.rglob("*")) == ["far", "link.gwb", "real.gwb"]


def test_a_link_to_nowhere_is_said_to_be_one(tmp_path: Path) -> None:
    link = tmp_path / "dang.gwb"
    link.symlink_to("gone/work.gwb")
    with pytest.raises(SavingError, match=r"is a link to gone/work\.gwb, whose folder does not exist;"):
        replace_file(link, b"new")
    assert link.is_symlink()


def test_what_reads_back_wrong_never_replaces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.gwb"
    path.write_bytes(b"old")

    def keep_something_else(descriptor: int) -> None:
        os.lseek(descriptor, 0, os.SEEK_SET)
        os.write(descriptor, b"now")

    monkeypatch.setattr(os, "fsync", keep_something_else)
    with pytest.raises(SavingError, match="does not read back from the disk the same"):
        replace_file(path, b"new")
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
        with pytest.raises(
            SavingError, match=r"a\.gwb cannot be written \(No space left on device\); make room"
        ):
            replace_file(path, b"new")
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == ["a.gwb"]


def test_a_file_that_may_not_be_changed_is_not_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.gwb"
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "access", lambda *_args: False)
    with pytest.raises(DocumentError, match="another name"):
        replace_file(path, b"new")
    assert path.read_bytes() == b"old"


def test_a_very_long_name(tmp_path: Path) -> None:
    path = tmp_path / ("é" * 120 + ".gwb")
    replace_file(path, b"new")
    assert path.read_bytes() == b"new"


@posix
def test_what_dead_processes_left_is_swept_and_what_lives_is_not(tmp_path: Path) -> None:
    path = tmp_path / "a.gwb"
    code = (
        "import os, sys; from pathlib import Path;"
        "from workbench.document.storage.saving import replace_file;"
        "replace_file(Path(sys.argv[1]), (os.kill(os.getpid(), 9) for _piece in 'x'))"
    )
    subprocess.run([sys.executable, "-c", code, str(path)], check=False, cwd=Path(__file__).parents[3])
    (left,) = tmp_path.iterdir()
    assert left.name.endswith(".saving")
    living = left.with_name(left.name.replace(left.name.split(".")[-2], str(os.getppid())))
    living.write_bytes(b"")
    foreign = tmp_path / ".b.gwb-00000000.999999999.saving"
    foreign.write_bytes(b"")
    replace_file(path, b"new")
    assert sorted(tmp_path.iterdir()) == sorted([path, living, foreign])


@posix
@pytest.mark.parametrize("plant", [Path.symlink_to, Path.hardlink_to])
def test_a_link_under_the_temporary_name_is_not_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, plant: Callable[[Path, Path], None]
) -> None:
    precious = tmp_path / "precious"
    precious.write_bytes(b"mine")
    names = iter(["1111", "2222"])
    monkeypatch.setattr("workbench.document.storage.saving.secrets.token_hex", lambda _bytes: next(names))
    replace_file(tmp_path / "a.gwb", b"one")
    planted = f".a.gwb-{zlib.crc32(b'a.gwb'):08x}.2222.{os.getpid()}.saving"
    plant(tmp_path / planted, precious)
    with pytest.raises(SavingError):
        replace_file(tmp_path / "a.gwb", b"two")
    assert precious.read_bytes() == b"mine"
    assert (tmp_path / "a.gwb").read_bytes() == b"one"


def test_temporary_names_cannot_be_guessed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    names: list[str] = []
    opened = os.open
    monkeypatch.setattr(os, "open", lambda path, *given: (names.append(str(path)), opened(path, *given))[1])
    for _time in range(2):
        replace_file(tmp_path / "a.gwb", b"one")
    first, second = (name for name in names if name.endswith(".saving"))
    parts = first.split("."), second.split(".")
    assert [len(part) for part in (parts[0][-3], parts[1][-3])] == [16, 16]
    assert parts[0][-3] != parts[1][-3]


@posix
@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("folder", "folder is a folder; choose another name."),
        ("pipe", "pipe is a device, not a file; choose another name."),
        ("full", "full is a device, not a file; choose another name."),
        ("n" * 300, "is too long; choose a shorter one."),
        ("file/a.gwb", "for a.gwb; choose another folder."),
        ("none/a.gwb", "for a.gwb; choose another folder."),
        ("loop", "loop is a link that leads back to itself; choose another name."),
        ("null\0byte", "choose another folder."),
    ],
)
def test_what_is_no_place_for_a_file_is_left_alone(tmp_path: Path, name: str, said: str) -> None:
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "full").symlink_to("/dev/full")
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "file").write_bytes(b"mine")
    before = sorted(os.listdir(tmp_path))
    with pytest.raises(SavingError) as refused:
        replace_file(tmp_path / name, b"new")
    assert str(refused.value).endswith(said)
    assert str(refused.value).count(". ") == 0
    assert sorted(os.listdir(tmp_path)) == before
    assert (tmp_path / "file").read_bytes() == b"mine"


@posix
def test_a_folder_that_may_not_be_written_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_given: object) -> int:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "open", refuse)
    refusal = rf"^You are not allowed to write a\.gwb in the folder {tmp_path}; choose"
    with pytest.raises(SavingError, match=refusal):
        replace_file(tmp_path / "a.gwb", b"new")
    assert list(tmp_path.iterdir()) == []


def test_without_a_commit_nothing_is_changed(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"old")
    with Replacement() as replacement:
        replacement.put(tmp_path / "a", b"new")
        replacement.put(tmp_path / "b", b"new")
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [("a", b"old")]


def test_what_the_disk_gives_back_differently_never_replaces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a").write_bytes(b"old")

    def damage(descriptor: int) -> None:
        os.lseek(descriptor, 1, os.SEEK_SET)
        os.write(descriptor, b"x")

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", damage)
        for data in (b"new", [b"n", b"ew"]):
            with pytest.raises(SavingError, match="does not read back from the disk the same"):
                replace_file(tmp_path / "a", data)
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [("a", b"old")]


@posix
@pytest.mark.parametrize("links", [True, False])
def test_several_files_are_replaced_together_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, links: bool
) -> None:
    for name in "ac":
        (tmp_path / name).write_bytes(b"old " + name.encode())
    replace = os.replace

    def refuse(source: Path, target: Path) -> None:
        if Path(target).name == "c" and Path(source).read_bytes() == b"new":
            raise OSError(30, "Read-only file system")
        replace(source, target)

    def no_links(*_given: object) -> None:
        raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(os, "replace", refuse)
    if not links:
        monkeypatch.setattr(os, "link", no_links)
    with Replacement() as replacement:
        for name in "abc":
            replacement.put(tmp_path / name, b"new")
        with pytest.raises(SavingError, match="is read-only"):
            replacement.commit()
    assert sorted((each.name, each.read_bytes()) for each in tmp_path.iterdir()) == [
        ("a", b"old a"),
        ("c", b"old c"),
    ]
    sweep(tmp_path)
