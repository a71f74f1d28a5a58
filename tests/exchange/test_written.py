"""Every format writes what its own reader reads, whole or not at all."""

import os
import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image, ImageSequence

from workbench.algorithms import catalogue
from workbench.document import Stored
from workbench.document.samples.examples import example_document
from workbench.document.storage.files import pieces_of
from workbench.document.storage.saving import SavingError
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.exchange.frames import indexed
from workbench.exchange.run_tables import hand
from workbench.exchange.writing import Cancelled, SuffixError, completed, format_for, of_kind, write
from workbench.exchange.written import FORMATS, formats

ROOT = Path(__file__).resolve().parents[2]


class Made:
    """Pictures that follow one another: 3 x 2 pixels, the first so many of them red."""

    def __init__(self, parts: int, seconds: float = 0.25) -> None:
        self.parts, self.seconds, self.rests = parts, seconds, True

    def image(self, number: int) -> np.ndarray[Any, Any]:
        picture = np.full((2, 3, 3), 255, np.uint8)
        picture.reshape(-1, 3)[:number] = (200, 10, 20)
        return picture


def reds(image: Image.Image) -> int:
    return sum(count for count, colour in image.convert("RGB").getcolors() if colour == (200, 10, 20))


def test_a_document_is_written_in_the_pieces_that_saving_writes() -> None:
    stored = Stored(example_document())
    (row,) = formats("document")
    given: list[list[bytes]] = []
    row.encode(stored, lambda data: given.append(list(data)), lambda *_told: None)
    assert given == [list(pieces_of(stored))]
    assert len(given[0]) > 1


def test_every_suffix_of_a_kind_is_there_once() -> None:
    assert len({(row.kind, row.suffix) for row in FORMATS}) == len(FORMATS)
    for row in FORMATS:
        assert format_for(of_kind(FORMATS, row.kind), Path("a" + row.suffix.upper())) is row


def test_a_gif_has_every_frame_and_its_time(tmp_path: Path) -> None:
    write(format_for(formats("run"), tmp_path / "a.gif"), Made(6), tmp_path / "a.gif")
    with Image.open(tmp_path / "a.gif") as image:
        frames = [(reds(frame), frame.info["duration"]) for frame in ImageSequence.Iterator(image)]
    assert frames == [(k, 250) for k in range(5)] + [(5, 750)]


def test_a_gif_that_would_fill_the_memory_is_refused_at_its_first_picture(tmp_path: Path) -> None:
    class Many(Made):
        def image(self, number: int) -> np.ndarray[Any, Any]:
            assert number == 0
            return np.zeros((933, 1200, 3), np.uint8)

    with pytest.raises(ValueError, match="A GIF of 500 pictures 1200 pixels wide is too large"):
        write(format_for(formats("run"), tmp_path / "a.gif"), Many(500), tmp_path / "a.gif")
    assert list(tmp_path.iterdir()) == []


@given(st.integers(2, 700), st.integers(0, 2**32 - 1))
def test_the_frequent_colours_of_a_gif_are_exact_and_the_others_near(count: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    colours = random.integers(0, 256, (count, 3), np.uint8)
    picture = colours[np.sort(random.integers(0, count, 40 * 40) ** 2 // count)].reshape(40, 40, 3)
    back = np.asarray(indexed(picture).convert("RGB"))
    distinct, counts = np.unique(picture.reshape(-1, 3), axis=0, return_counts=True)
    kept = {tuple(colour) for colour in np.unique(back.reshape(-1, 3), axis=0).tolist()}
    assert len(kept) == min(len(distinct), 256)
    most = distinct[np.argsort(-counts, kind="stable")][:128]
    assert {tuple(colour) for colour in most.tolist()} <= kept or len(distinct) <= 256
    palette = np.array(sorted(kept), int)
    away = ((picture.reshape(-1, 1, 3).astype(int) - palette) ** 2).sum(axis=-1).min(axis=1)
    assert (((picture.astype(int) - back) ** 2).sum(axis=-1).ravel() == away).all()


def test_frames_are_numbered_from_nothing(tmp_path: Path) -> None:
    row = format_for(formats("run"), tmp_path / "a.png")
    paths = write(row, Made(4), tmp_path / "a.png")
    assert [path.name for path in paths] == ["a-000.png", "a-001.png", "a-002.png", "a-003.png"]
    for number, path in enumerate(paths):
        with Image.open(path) as image:
            assert reds(image) == number
    assert [path.name for path in row.paths(Path("b.png"), 1001)][::1000] == ["b-0000.png", "b-1000.png"]


@pytest.mark.parametrize(("suffix", "last"), [(".png", 3), (".gif", 3), (".gif", 5), (".png", 5)])
def test_cancelled_everything_is_as_before(suffix: str, last: int, tmp_path: Path) -> None:
    for name in ("a-001.png", "a.gif"):
        (tmp_path / name).write_bytes(b"mine")

    def told(done: int, parts: int) -> None:
        assert parts == 5
        if done == last:
            raise Cancelled

    path = tmp_path / f"a{suffix}"
    with pytest.raises(Cancelled):
        write(format_for(formats("run"), path), Made(5), path, told)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a-001.png", "a.gif"]
    assert {each.read_bytes() for each in tmp_path.iterdir()} == {b"mine"}


@pytest.mark.parametrize("suffix", [".csv", ".json", ".html"])
def test_a_long_table_is_told_row_by_row_and_can_be_cancelled(suffix: str, tmp_path: Path) -> None:
    entry = catalogue.get("bresenham_line")
    steps = Steps(entry, record(entry.function, 0, 0, 500, 200))
    path, done = tmp_path / f"a{suffix}", []

    def told(rows_done: int, of: int) -> None:
        done.append((rows_done, of))
        if rows_done > 200:
            raise Cancelled

    with pytest.raises(Cancelled):
        write(format_for(formats("table"), path), hand(steps), path, told)
    assert done == [(0, 500), (64, 500), (128, 500), (192, 500), (256, 500)]
    assert list(tmp_path.iterdir()) == []
    write(format_for(formats("table"), path), hand(steps), path)
    assert path.read_text(encoding="utf-8").count("(500, 200)" if suffix != ".json" else "[500, 200]") == 1


def test_when_the_last_of_many_cannot_take_its_place_the_others_have_theirs_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in (1, 4):
        (tmp_path / f"a-{number:03d}.png").write_bytes(b"mine")
    replace = os.replace

    def refuse(source: Path, target: Path) -> None:
        if Path(target).name == "a-004.png" and not target.read_bytes().startswith(b"\x89"):
            raise OSError(28, "No space left on device")
        replace(source, target)

    monkeypatch.setattr(os, "replace", refuse)
    with pytest.raises(SavingError, match="make room"):
        write(format_for(formats("run"), tmp_path / "a.png"), Made(5), tmp_path / "a.png")
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a-001.png", "a-004.png"]
    assert {each.read_bytes() for each in tmp_path.iterdir()} == {b"mine"}


@pytest.mark.parametrize(
    ("typed", "name"),
    [("a", "a.csv"), ("a.", "a.csv"), ("1.5", "1.5.csv"), ("a.JSON", "a.JSON"), ("a b. c", "a b. c.csv")],
)
def test_names_are_completed(typed: str, name: str) -> None:
    table = formats("table")
    path, row = completed(table, Path("folder") / typed, table[0])
    assert path == Path("folder") / name
    assert row.suffix == path.suffix.lower()


def test_a_wrong_ending_names_the_right_ones() -> None:
    with pytest.raises(SuffixError, match=r"^a\.doc: choose a name that ends in \.csv, \.json or \.html\."):
        completed(formats("table"), Path("a.doc"), formats("table")[0])


@pytest.mark.skipif(sys.platform == "win32", reason="limits of POSIX")
@pytest.mark.parametrize("name", ["out.svg", "out.gwb"])
def test_a_limit_on_the_size_of_files_leaves_the_old_one(name: str, tmp_path: Path) -> None:
    source = tmp_path / "big.svg"
    paths = "".join(f'<path d="M {k} 0 C {k} 20 {k + 9} 20 {k + 9} 0"/>' for k in range(60))
    source.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 20">{paths}</svg>')
    target = tmp_path / name
    target.write_bytes(b"the old one")
    command = [sys.executable, "-m", "workbench", "convert", str(source), "-o", str(target)]
    done = subprocess.run(
        command,
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)),
    )
    assert done.returncode == 1
    assert done.stderr == (
        f"graphics-workbench: {target} would be larger than a file may be here; choose another disk.\n"
    )
    assert target.read_bytes() == b"the old one"
    assert sorted(each.name for each in tmp_path.iterdir()) == sorted(["big.svg", name])
