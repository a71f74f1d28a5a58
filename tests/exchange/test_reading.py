"""The child process reads what the parent would have read, tells how far it is, and can be stopped."""

import hashlib
import os
import shlex
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.views import seen_through
from workbench.document.errors import DocumentError
from workbench.document.model import Polyline, WorldPoint
from workbench.document.samples.examples import example, example_document, examples
from workbench.document.state import SessionState
from workbench.document.storage.content import Stopped, read_text
from workbench.document.storage.files import Stored, encode
from workbench.document.subjects import Position, Subject
from workbench.exchange import reading
from workbench.exchange.figures import write_figures
from workbench.exchange.reading import (
    Fitted,
    Job,
    Reading,
    ReadingError,
    ReadingFailure,
    read_at_once,
    read_now,
)

ROOT = Path(__file__).parents[2]
posix = pytest.mark.skipif(os.name != "posix", reason="limits and scripts of POSIX")
SHEET = example_document().sheets[0]
MOVING = example("animate-ball").document.sheets[0]
WAVE = "".join(f"{k / 9:.3f};{np.sin(k / 40):.6f}\n" for k in range(3000)).encode()
PATHS = "".join(f'<path id="p{k}" d="M {k} 0 C {k} 2 9 4 3 0A1 2 3 0 1 {k} 9"/>' for k in range(1500))
DRAWING = f'<svg xmlns="http://www.w3.org/2000/svg">{PATHS}<text/></svg>'.encode()


def large_picture() -> Stored:
    """Two sheets, one bare, a figure of more points than go in one part, a blob of several parts."""
    points = tuple(WorldPoint(f"q{k}x", k / 7, -k) for k in range(12_000))
    sheet = example_document().sheets[0]
    figures = (*sheet.figures, Polyline("long", points, "dda_line"))
    bare = replace(seen_through(sheet, id="v-other"), id="other", figures=())
    document = replace(example_document(), sheets=(replace(sheet, figures=figures), bare))
    blob = bytes(range(256)) * 10_000
    blobs = {hashlib.sha256(content).hexdigest(): content for content in (blob, b"")}
    state = SessionState(sheet="other", positions={"draw": Position(Subject(ids=("long",)), 3)})
    return Stored(document, state, blobs, "/from/there.gwb", (3, 2, 1), ("beside",))


def test_a_picture_comes_whole(tmp_path: Path) -> None:
    stored = large_picture()
    (tmp_path / "a.gwb").write_bytes(encode(stored))
    job = Job("picture", str(tmp_path / "a.gwb"))
    assert read_at_once(job) is None
    shares: list[float] = []
    assert Reading(job).follow(shares.append) == stored
    assert shares == sorted(shares)
    assert all(0.0 <= share <= 1.0 for share in shares)


@pytest.mark.parametrize(
    "job",
    [
        Job("drawing", content=DRAWING, sheet=SHEET),
        Job("points", content=WAVE),
        Job("figures", content=write_figures(SHEET, SHEET.figures * 300)),
        Job("figures", content=write_figures(MOVING, MOVING.figures)),
    ],
)
def test_the_child_reads_what_is_read_here(job: Job) -> None:
    there, here = Reading(job).follow(), read_now(job)
    if isinstance(here, np.ndarray):
        assert np.array_equal(there, here)
    else:
        assert there == here


def test_a_curve_is_fitted_by_the_child() -> None:
    job = Job("fit", content=WAVE, sheet=SHEET, tolerance_px=0.6, colour=2)
    there = Reading(job).follow()
    assert isinstance(there, Fitted)
    assert there == read_now(job)
    assert (there.points, there.curve.colour) == (3000, 2)
    assert there.error <= 0.6


@pytest.mark.parametrize(
    ("job", "said"),
    [
        (Job("drawing", content=DRAWING + b"<", sheet=SHEET), "the XML is broken"),
        (Job("points", content=WAVE + b"a;b"), "Line 3001, column 1: 'a' is not a number"),
        (Job("picture", "/dev/zero"), "/dev/zero is a device"),
        (Job("figures", content=b"[[]" * 9), "The figures on the clipboard cannot be read"),
        (Job("picture", "/no/such.gwb"), "There is no file /no/such.gwb"),
    ],
)
def test_a_refusal_is_the_same_sentence(job: Job, said: str) -> None:
    with pytest.raises(ReadingError) as there:
        Reading(job).follow()
    with pytest.raises(ValueError) as here:
        read_now(job)
    assert str(there.value) == str(here.value)
    assert said in str(here.value)


@pytest.mark.parametrize("kind", ["points", "fit"])
def test_points_that_are_no_text_are_refused_as_every_text_is(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "a.csv"
    path.write_bytes(b"1;2\n\0\xff;4\n")
    with pytest.raises(DocumentError) as refusal:
        read_now(Job(kind, str(path), sheet=SHEET))
    with pytest.raises(DocumentError) as same:
        read_text(path, 100)
    assert (
        str(refusal.value)
        == str(same.value)
        == (f"{path} is not UTF-8 text; save it as UTF-8, or choose another file.")
    )
    path.write_bytes("größe;y\n1;2\n3;4".encode("latin-1"))
    assert read_now(Job("points", str(path))).tolist() == [[1, 2], [3, 4]]
    path.write_bytes(b"\xef\xbb\xbf1;2\n3;4\n")
    assert read_now(Job("points", str(path))).tolist() == [[1, 2], [3, 4]]


def test_every_example_that_is_not_long_is_read_at_once(tmp_path: Path) -> None:
    for one in examples():
        content = encode(Stored(one.document))
        (tmp_path / "a.gwb").write_bytes(content)
        read = read_at_once(Job("picture", str(tmp_path / "a.gwb")))
        assert read == (Stored(one.document) if len(content) <= reading.AT_ONCE else None)


def test_short_text_that_takes_long_is_left_to_the_child() -> None:
    depth = "".join(f'<g id="g{k}"><use href="#g{k + 1}"/><use href="#g{k + 1}"/></g>' for k in range(16))
    text = f'<svg xmlns="http://www.w3.org/2000/svg">{depth}<path id="g16" d="M0 0 9 9"/></svg>'
    assert read_at_once(Job("drawing", content=text.encode(), sheet=SHEET)) is None


def test_more_text_than_the_limit_is_refused_at_once() -> None:
    with pytest.raises(ReadingError, match="at most 16,777,216"):
        read_at_once(Job("points", content=b"1 2\n" * 5_000_000))


def test_a_reading_that_is_stopped_gives_nothing() -> None:
    stopped = Reading(Job("points", content=WAVE))
    threading.Timer(0.05, stopped.stop).start()
    with pytest.raises(Stopped):
        stopped.follow(lambda share: stopped.stop())


def test_a_name_without_its_folder_is_that_of_this_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.gwb").write_bytes(encode(large_picture()))
    assert Reading(Job("picture", "a.gwb")).follow() == large_picture()


def in_the_child(monkeypatch: pytest.MonkeyPatch, folder: Path, code: str) -> None:
    """Let every child run ``code`` first, with the modules of the program at hand."""
    starter = folder / "python"
    preface = f"import runpy, sys; sys.path.insert(0, {str(ROOT)!r}); {code}"
    line = preface + "; from workbench.exchange import reading; sys.exit(reading.main())"
    starter.write_text(f"#!/bin/sh\nexec {shlex.quote(sys.executable)} -c {shlex.quote(line)}\n")
    starter.chmod(0o700)
    monkeypatch.setattr(reading.sys, "executable", str(starter))


@posix
@pytest.mark.parametrize("hard", [3 * 2**30, 8 * 2**30])
def test_a_limit_that_is_there_already_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, hard: int
) -> None:
    in_the_child(monkeypatch, tmp_path, f"import resource as r; r.setrlimit(r.RLIMIT_AS, ({hard}, {hard}))")
    job = Job("points", content=WAVE)
    assert np.array_equal(Reading(job).follow(), read_now(job))


@posix
def test_a_system_that_bounds_no_memory_reads_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    code = "import resource as r; r.setrlimit = lambda *_bounds: [].index(0)"
    in_the_child(monkeypatch, tmp_path, code)
    assert len(Reading(Job("points", content=WAVE)).follow()) == 3000


@posix
def test_a_failure_of_the_program_in_the_child_is_told_with_its_traceback(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    code = "import workbench.exchange.reading as r; r.read_now = lambda *_job: {}['no such thing']"
    in_the_child(monkeypatch, tmp_path, code)
    with pytest.raises(ReadingFailure, match=r"Traceback[^$]*KeyError: 'no such thing'"):
        Reading(Job("points", content=WAVE)).follow()


def test_a_child_that_dies_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading.sys, "executable", "/bin/false")
    with pytest.raises(ReadingError, match="stopped before the end of the file"):
        Reading(Job("points", content=WAVE)).follow()
