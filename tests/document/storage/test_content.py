"""What is read is a regular file of a bounded size; anything else is refused, and not waited for."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from workbench.__main__ import main
from workbench.document import DocumentError, load
from workbench.document.storage.content import Stopped, part, read_content, read_text


def test_the_bytes_of_a_file_are_read_and_the_share_is_told(tmp_path: Path) -> None:
    content = os.urandom(3_500_000)
    (tmp_path / "a").write_bytes(content)
    shares: list[float] = []
    assert read_content(tmp_path / "a", 4_000_000, shares.append) == content
    assert shares == sorted(shares)
    assert len(shares) > 3
    assert shares[-1] == 1.0


def test_what_the_progress_raises_ends_the_reading(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"a" * 3_000_000)
    told: list[float] = []

    def stop(share: float) -> None:
        told.append(share)
        raise Stopped

    with pytest.raises(Stopped):
        read_content(tmp_path / "a", 4_000_000, stop)
    assert len(told) == 1


def test_a_part_of_the_work_tells_its_part_of_the_whole() -> None:
    shares: list[float] = []
    inner = part(shares.append, 0.25, 0.75)
    for share in (0.0, 0.5, 1.0, 7.0):
        inner(share)
    assert shares == [0.25, 0.5, 0.75, 0.75]


def test_a_file_larger_than_the_limit_is_not_read(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"a" * 101)
    assert read_content(tmp_path / "a", 101) == b"a" * 101
    with pytest.raises(DocumentError, match=r"has 101 bytes, but at most 100 can be opened"):
        read_content(tmp_path / "a", 100)


def test_a_file_that_grows_is_bounded_all_the_same(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"a" * 2**20)

    def grow(_share: float) -> None:
        with open(path, "ab") as file:
            file.write(b"a" * 2**20)

    with pytest.raises(DocumentError, match="at most 5,000,000"):
        read_content(path, 5_000_000, grow)


def test_text_loses_its_mark_and_what_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"\xef\xbb\xbfx\xc3\xa9")
    assert read_text(tmp_path / "a", 10) == "xé"
    (tmp_path / "a").write_bytes(b"\xe9")
    with pytest.raises(DocumentError, match="not UTF-8"):
        read_text(tmp_path / "a", 10)


def _pipe(path: Path) -> None:
    os.mkfifo(path)


def _device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def _folder(path: Path) -> None:
    path.mkdir()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with a name")
@pytest.mark.parametrize("make", [_pipe, _device, _folder])
def test_what_is_no_regular_file_is_refused_by_every_reader(
    make: Callable[[Path], None],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    commands = [["convert", f"a.{kind}", "-o", "out.svg"] for kind in ("gwb", "svg", "csv", "tsv", "txt")]
    commands += [["draw", "a.gwb", "-o", "out.png"], ["surface", "a.json", "-o", "out.obj"]]
    commands += [["trace", "bresenham_line", "0", "0", "1", "@a.word"]]
    for name in {
        word.lstrip("@") for words in commands for word in words if word.lstrip("@").startswith("a.")
    }:
        make(Path(name))
    with pytest.raises(DocumentError):
        load("a.gwb")
    for words in commands:
        with ThreadPoolExecutor() as pool:
            assert pool.submit(main, words).result(timeout=20) == 2, words
        said = capsys.readouterr().err
        assert any(f"is a {kind}" in said for kind in ("folder", "pipe", "device", "socket"))
        assert len(said.splitlines()) == 1
