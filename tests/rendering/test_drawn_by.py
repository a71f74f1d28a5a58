"""A faster text draws for another one only where both paint the same; all else is of the one named."""

import dataclasses
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest import mock

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from numpy.typing import NDArray

from tests.algorithms.runs import arguments
from tests.lines.exact import is_tie, true_points
from workbench.algorithms import catalogue
from workbench.algorithms.entry import DrawnBy, Entry
from workbench.document.model import SeedFill, Sheet
from workbench.document.samples.figures import document_of, line, polygon, seed_fill
from workbench.rendering import raster
from workbench.rendering.mapping import Call
from workbench.rendering.pipeline import Batch, batches, faster, law_holds
from workbench.rendering.raster import composite_below, figure_calls, pixels

DECLARED = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries() if entry.drawn_by]
NEAR = st.tuples(*[st.integers(0, 255)] * 4)


def stand_in(entry: Entry) -> DrawnBy:
    assert entry.drawn_by is not None
    return entry.drawn_by


def painted(entry: Entry, given: tuple[Any, ...]) -> tuple[set[tuple[int, int]], list[NDArray[Any]]]:
    """The pixels that a call emits, and its arrays as they are afterwards."""
    own = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in given)
    emitted = list(entry.function(*own))
    wide = len(emitted[0]) if emitted else 3 if entry.emits == "spans" else 2
    rows = np.array(emitted).reshape(-1, wide)
    return set(map(tuple, pixels(entry, rows).tolist())), [a for a in own if isinstance(a, np.ndarray)]


@pytest.mark.parametrize("entry", DECLARED)
def test_what_draws_for_another_takes_the_same_and_names_a_law_of_its(entry: Entry) -> None:
    other = catalogue.get(stand_in(entry).slug)
    assert other.parameter_names == entry.parameter_names
    assert (other.topic, other.writes) == (entry.topic, entry.writes)
    assert set(entry.draws) <= set(other.draws)
    assert other.emits in ("pixels", "spans")
    assert not other.compiles
    assert other.drawn_by is None  # what is looked for ends after one step
    assert stand_in(entry).law in entry.laws


@pytest.mark.parametrize("entry", DECLARED)
@settings(max_examples=150)
@given(data=st.data())
def test_where_the_law_holds_both_paint_the_same(entry: Entry, data: st.DataObject) -> None:
    near = [NEAR] if entry.topic == "lines" else []
    given = data.draw(st.one_of(*near, arguments(entry)))
    call = faster(Call(entry, given))
    if stand_in(entry).holds(*given):
        assert call.entry.slug == stand_in(entry).slug
        first, second = painted(entry, given), painted(call.entry, given)
        assert first[0] == second[0]
        assert all(map(np.array_equal, first[1], second[1]))
    else:
        assert call.entry is entry


@given(rows=st.lists(st.tuples(*[st.integers(-20, 300)] * 4), min_size=1, max_size=20))
def test_of_many_lines_the_law_is_told_as_of_each(rows: list[tuple[int, int, int, int]]) -> None:
    entry = catalogue.get("dda_line_single")
    batch = Batch(entry, tuple(np.array(rows).T), np.arange(len(rows)))
    expected = [
        min(row) >= 0 and max(row) <= 255 and row[:2] != row[2:] and not any(map(is_tie, true_points(row)))
        for row in rows
    ]
    assert law_holds(batch).tolist() == expected
    assert [bool(stand_in(entry).holds(*row)) for row in rows] == expected


@contextmanager
def watched() -> Iterator[list[str]]:
    """The slugs that paint, in their order."""
    painters: list[str] = []
    real = raster._put

    def put(entry: Entry, *others: Any) -> None:
        painters.append(entry.slug)
        real(entry, *others)

    with mock.patch.object(raster, "_put", put), mock.patch.object(raster, "at_hand", return_value=False):
        yield painters


def lines(*ends: tuple[int, int, int, int], algorithm: str = "dda_line_single") -> Sheet:
    figures = [line(end[:2], end[2:], 1 + k % 3, algorithm) for k, end in enumerate(ends)]
    return document_of("Lines", 40, 30, figures).sheets[0]


TIED, CLEAR = (0, 0, 30, 15), (0, 3, 35, 20)


@pytest.mark.parametrize(
    ("ends", "drawn_by"),
    [
        ([CLEAR, CLEAR], ["dda_line"]),
        ([CLEAR, TIED], ["dda_line_single"]),
        ([(-3, 0, 20, 7)], ["dda_line_single"]),
        ([(0, 0, 300, 7)], ["dda_line_single"]),
    ],
)
def test_a_stretch_of_lines_is_painted_by_what_its_law_allows(
    ends: list[tuple[int, int, int, int]], drawn_by: list[str]
) -> None:
    sheet = lines(*ends)
    with watched() as painters:
        composite_below(sheet, len(ends))
    assert painters == drawn_by
    assert {call.entry.slug for figure in sheet.figures for call in figure_calls(sheet, figure)} == {
        "dda_line_single"
    }


def test_between_other_figures_each_stretch_is_asked_for_itself() -> None:
    sheet = lines(CLEAR, TIED, CLEAR)
    middle = replace(sheet.figures[1], algorithm="bresenham_line")
    mixed = replace(sheet, figures=(sheet.figures[0], middle, *lines(TIED, CLEAR).figures))
    with watched() as painters:
        composite_below(mixed, 4)
    assert painters == ["dda_line", "bresenham_line", "dda_line_single"]


def test_a_picture_is_the_same_with_and_without_what_is_faster() -> None:
    ring = polygon([[(3, 3), (35, 5), (30, 26), (8, 22)]], 1, "")
    figures = [
        ring,
        seed_fill((15, 15), 2, 1, ""),
        seed_fill((1, 1), 3, 1, ""),
        *lines(CLEAR, TIED, CLEAR).figures,
    ]
    sheet = document_of("Fills", 40, 30, figures).sheets[0]
    ready = mock.patch.object(raster, "at_hand", lambda _function, use: use == "collect")
    with watched() as painters, ready:
        fast = composite_below(sheet, len(figures))
    assert "boundary_fill_spans" in painters
    assert "boundary_fill_4" not in painters
    with mock.patch.object(raster, "faster", lambda call: call):
        slow = composite_below(sheet, len(figures))
    assert np.array_equal(fast.image, slow.image)
    assert np.array_equal(fast.painter, slow.painter)
    fill = next(figure for figure in sheet.figures if isinstance(figure, SeedFill))
    assert [call.entry.slug for call in figure_calls(sheet, fill)] == ["boundary_fill_4"]


def test_of_a_text_that_takes_lists_each_call_is_asked() -> None:
    areas = [polygon([[(3, 3), (20, 3), (x, 20)]], 1, "") for x in (9.0, 9.5, 12.0)]
    sheet = document_of("Areas", 40, 30, areas).sheets[0]
    (batch,) = batches(sheet, sheet.figures)
    whole = DrawnBy("", batch.entry.laws[0], lambda vertices, *_rules: bool((vertices % 1 == 0).all()))
    entry = dataclasses.replace(batch.entry, drawn_by=whole)
    assert law_holds(batch._replace(entry=entry)).tolist() == [True, False, True]
