"""The compiled reading: one signature, painting against an oracle, the cache, no compiler at all."""

import importlib.util
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.engine import written_texts as texts
from workbench.algorithms import catalogue
from workbench.engine import compiled, kernel_files
from workbench.engine.compiled import Stop, Stopped
from workbench.engine.warm import Progress, Warming, compile_use

LINE = catalogue.get("bresenham_line").function
CIRCLE = catalogue.get("midpoint_circle").function
WU = catalogue.get("wu_line").function
FILL = catalogue.get("boundary_fill_4").function
near = st.integers(-25, 45)


def painted(pixels: list[tuple[int, int]], shape: tuple[int, int]) -> NDArray[np.uint32]:
    image = np.zeros(shape, np.uint32)
    for x, y in pixels:
        if 0 <= x < shape[1] and 0 <= y < shape[0]:
            image[y, x] = 7
    return image


@given(x0=near, y0=near, x1=near, y1=near)
def test_painting_is_clipped_and_the_same_inside_and_across_the_edge(
    x0: int, y0: int, x1: int, y1: int
) -> None:
    image = np.zeros((20, 24), np.uint32)
    compiled.paint(LINE, image, 7, x0, y0, x1, y1)
    assert np.array_equal(image, painted(list(LINE(x0, y0, x1, y1)), image.shape))


@given(x=near, y=near, r=st.integers(-3, 30))
def test_a_circle_paints_what_it_emits(x: int, y: int, r: int) -> None:
    image = np.zeros((20, 24), np.uint32)
    compiled.paint(CIRCLE, image, 7, x, y, r)
    assert np.array_equal(image, painted(list(CIRCLE(x, y, r)), image.shape))


@given(rows=st.lists(st.tuples(near, near, near, near), max_size=8))
def test_many_at_once_paint_what_they_paint_one_by_one(rows: list[tuple[int, ...]]) -> None:
    many, each = np.zeros((20, 24), np.uint32), np.zeros((20, 24), np.uint32)
    compiled.paint_many(LINE, many, 7, np.array(rows, np.int64).reshape(-1, 4))
    for row in rows:
        compiled.paint(LINE, each, 7, *row)
    assert np.array_equal(many, each)


@given(rows=st.lists(st.tuples(near, near, near, near), max_size=8))
def test_many_at_once_collect_what_they_collect_one_by_one(rows: list[tuple[int, ...]]) -> None:
    table = np.array(rows, np.int64).reshape(-1, 4)
    for flavour in ("", "interpreted"):
        values, ends = compiled.collect_many(LINE, table, flavour=flavour)
        assert values.dtype == np.int64
        assert len(ends) == len(rows)
        assert not rows or ends[-1] == len(values)
        starts = [0, *ends][:-1]
        for row, start, end in zip(rows, starts, ends, strict=True):
            assert [tuple(pixel) for pixel in values[start:end]] == list(LINE(*row))


def test_many_at_once_are_collected_again_where_there_was_no_room() -> None:
    rows = np.array([[0, 0, 3000, 0], [0, 0, 0, 3000]])
    values, ends = compiled.collect_many(LINE, rows)
    assert ends.tolist() == [3001, 6002]
    assert values[3000:3002].tolist() == [[3000, 0], [0, 0]]
    assert values[-1].tolist() == [0, 3000]


def test_rows_without_emissions_end_where_the_row_before_did() -> None:
    clip = catalogue.get("cohen_sutherland").function
    window = (0.0, 0.0, 30.0, 20.0)
    values, ends = compiled.collect_many(
        clip, [(10, 30, 40, 0, *window), (-1, 30, -5, 0, *window), (1, 2, 3, 4, *window)]
    )
    assert ends.tolist() == [1, 1, 2]
    assert values.tolist() == [[20, 20, 30, 10], [1, 2, 3, 4]]


@given(x0=near, y0=near, x1=near, y1=near)
def test_coverage_mixes_each_channel(x0: int, y0: int, x1: int, y1: int) -> None:
    image = np.full((20, 24), 0x102030, np.uint32)
    compiled.paint(WU, image, 0xF0E0D0, x0, y0, x1, y1)
    expected = np.full((20, 24), 0x102030, np.uint32)
    for x, y, coverage in WU(x0, y0, x1, y1):
        if 0 <= x < 24 and 0 <= y < 20:
            under = int(expected[y, x])
            channels = [((under >> s) & 255, (0xF0E0D0 >> s) & 255, s) for s in (16, 8, 0)]
            expected[y, x] = sum(int(a + (b - a) * coverage + 0.5) << s for a, b, s in channels)
    assert np.array_equal(image, expected)


def test_spans_are_painted_with_both_ends_and_clipped() -> None:
    image = np.zeros((4, 5), np.uint8)
    compiled.paint(texts.spans, image, 1, 6)
    assert image.tolist() == [[1, 0, 0, 0, 0], [1, 1, 0, 0, 0], [1, 1, 1, 0, 0], [1, 1, 1, 1, 0]]
    assert compiled.hits(texts.spans, 1, 2, 6).tolist() == [2]


def test_a_text_that_writes_its_picture_paints_itself() -> None:
    image = np.zeros((6, 6), np.int64)
    image[0, :] = image[5, :] = image[:, 0] = image[:, 5] = 1
    compiled.paint(FILL, image, 9, image, 2, 2, 3, 1)
    assert (image[1:5, 1:5] == 3).all()
    assert not (image == 9).any()
    flipped = np.zeros((3, 3), np.int64)[::-1]
    compiled.paint(FILL, flipped, 9, flipped, 1, 1, 3, 1)
    assert (flipped == 3).all()


def test_collecting_copies_arrays_also_when_it_runs_twice() -> None:
    image = np.zeros((100, 100), np.int64)
    pixels = compiled.collect(FILL, image, 50, 50, 3, 1)
    assert len(pixels) == 10_000
    assert not image.any()
    assert len(compiled.collect(FILL, [[0, 0], [0, 1]], 0, 0, 3, 1)) == 3
    image.flags.writeable = False
    assert len(compiled.collect(FILL, image, 50, 50, 3, 1)) == 10_000


@given(x=st.integers(20, 30), y=st.integers(10, 18))
def test_hits_are_the_emissions_at_the_pixel(x: int, y: int) -> None:
    expected = [k for k, pixel in enumerate(LINE(20, 10, 30, 18)) if pixel == (x, y)]
    assert compiled.hits(LINE, x, y, 20, 10, 30, 18).tolist() == expected


def test_forms_of_arguments_share_one_signature() -> None:
    first = compiled.collect(LINE, 1, 2, 5, 4)
    dispatcher = compiled.kernel(LINE)._module(True)._collect
    before = len(dispatcher.signatures)
    for values in [(np.int32(1), np.uint8(2), 5.0, np.int64(4)), (True, 2, 5, 4)]:
        assert np.array_equal(compiled.collect(LINE, *values), first)
    assert len(dispatcher.signatures) == before == 1


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ((1.5, 0, 1, 1), "x0"),
        ((0, float("nan"), 1, 1), "y0"),
        ((0, 0, 2**80, 1), "x1"),
        ((0, 0, 1, "a"), "y1"),
    ],
)
def test_an_argument_that_does_not_fit_is_named(arguments: tuple[Any, ...], name: str) -> None:
    with pytest.raises(ValueError, match=name):
        compiled.collect(LINE, *arguments)


def test_what_cannot_be_painted_says_so() -> None:
    with pytest.raises(ValueError, match="integers"):
        compiled.paint(LINE, np.zeros((3, 3)), 1, 0, 0, 1, 1)
    with pytest.raises(ValueError, match="collect it"):
        compiled.paint(texts.edges, np.zeros((3, 3), np.int64), 1, 3)
    with pytest.raises(ValueError, match="4 numbers"):
        compiled.paint_many(LINE, np.zeros((3, 3), np.int64), 1, [[1, 2, 3]])
    with pytest.raises(ValueError, match="more than numbers"):
        compiled.collect_many(FILL, [[1, 2, 3]])
    with pytest.raises(ValueError, match="more than numbers"):
        compiled.paint_many(FILL, np.zeros((3, 3), np.int64), 1, [[1, 2, 3]])


@pytest.mark.parametrize("flavour", ["", "interpreted"])
def test_a_run_without_end_can_be_stopped(flavour: str) -> None:
    if not flavour:
        compiled.collect(texts.box, 1, 1)
    stop = Stop()
    threading.Timer(0.05, stop.set).start()
    with pytest.raises(Stopped):
        compiled.hits(texts.endless, 0, 0, stop=stop, flavour=flavour)


def test_without_a_compiler_the_lowered_text_is_read_as_python(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        assert name == "numba"

    compiled._kernel.cache_clear()
    monkeypatch.setattr(importlib.util, "find_spec", missing)
    assert not compiled.available()
    assert not compiled.ready(LINE, "collect")
    assert compiled.collect(LINE, 0, 0, 2, 1).tolist() == [[0, 0], [1, 1], [2, 1]]
    image = np.zeros((2, 3), np.uint32)
    compiled.paint(LINE, image, 7, 0, 0, 2, 1)
    assert np.array_equal(image, painted(list(LINE(0, 0, 2, 1)), (2, 3)))


def _corners() -> list[list[int]]:
    return compiled.collect(texts.corners).tolist()  # type: ignore[no-any-return]


def test_a_cache_that_cannot_be_written_only_costs_time(own_cache: Path) -> None:
    own_cache.write_text("a file where the folder should be")
    assert _corners() == [[0, 0], [4, 5], [2, 7]]


def test_rubbish_in_the_cache_only_costs_time(own_cache: Path) -> None:
    assert not compiled.ready(texts.corners, "collect")
    assert _corners() == [[0, 0], [4, 5], [2, 7]]
    assert compiled.ready(texts.corners, "collect")
    for path in [*own_cache.rglob("*.nbi"), *own_cache.rglob("*.nbc")]:
        path.write_bytes(b"rubbish")
    compiled._kernel.cache_clear()
    assert _corners() == [[0, 0], [4, 5], [2, 7]]
    for path in own_cache.rglob("kernel.py"):
        path.write_bytes(b"\xff\xff(")
    compiled._kernel.cache_clear()
    assert _corners() == [[0, 0], [4, 5], [2, 7]]


def test_the_folder_depends_on_the_text_and_the_flavour() -> None:
    keys = {kernel_files.key(text, flavour) for text in ("a", "b") for flavour in ("", "checked")}
    assert len(keys) == 4


def test_a_child_compiles_and_the_parent_finds_it_ready(own_cache: Path) -> None:
    warming = Warming(["bresenham_line"], ("collect",))
    reports: list[Progress] = []
    warming.follow(reports.append)
    assert reports == [Progress(1, 1, "bresenham_line", "collect")]
    assert warming.finished
    assert compiled.ready(LINE, "collect")
    assert not compiled.ready(LINE, "paint")
    again = Warming(["bresenham_line"], ("collect",))
    assert again.finished
    warming.stop()


def test_every_use_of_a_kernel_is_known_when_it_was_compiled(own_cache: Path) -> None:
    entry = catalogue.get("boundary_fill_4")
    for use in ("paint", "count"):
        assert not compiled.ready(entry.function, use)
        compile_use(entry, use)
        assert compiled.ready(entry.function, use)


def test_only_what_is_called_from_python_can_be(own_cache: Path) -> None:
    """What lets Python call a function has to be compiled, and is cached, with each of them."""
    compiled.collect(LINE, 0, 0, 5, 3)
    module = compiled.kernel(LINE)._module(True)
    called = {
        name
        for name, each in vars(module).items()
        for overload in getattr(each, "overloads", {}).values()
        for function in overload.library.get_defined_functions()
        if "cpython" in function.name
    }
    assert called == {"_collect"}


def test_importing_the_compiled_reading_does_not_import_the_compiler() -> None:
    program = "import sys, workbench.engine.compiled as c; c.available(); sys.exit('numba' in sys.modules)"
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    assert subprocess.run([sys.executable, "-c", program], env=environment, check=False).returncode == 0
