"""The fill by crossings against exact fractions, and beside the fill with edge tables."""

import re
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.polygons.exact import covered, rings_of, winding_left_of
from tests.polygons.test_scan_line_exact import Rings, coordinates, polygons, quarters
from workbench.algorithms import catalogue
from workbench.algorithms.polygons import scan_line_crossings, scan_line_exact
from workbench.algorithms.polygons.scan_line_words import vertices_on
from workbench.engine.observation import Step, Steps
from workbench.engine.recorder import record

far = st.one_of(st.integers(-(2**14), 2**14).map(float), quarters)


Spans = list[tuple[int, int, int]]


def spans(polygon: Rings, closed: bool, nonzero: bool) -> Spans:
    points, ends = np.array(polygon[0], np.float64).reshape(-1, 2), np.array(polygon[1], np.int64)
    return list(scan_line_crossings(points, ends, closed, nonzero))


def pixels(polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int]]:
    return [(x, y) for y, left, right in spans(polygon, closed, nonzero) for x in range(left, right + 1)]


@given(polygons(quarters), st.booleans(), st.booleans())
def test_on_quarters_pixels_are_those_of_exact_fractions(polygon, closed, nonzero):
    assert set(pixels(polygon, closed, nonzero)) == covered(*polygon, closed, nonzero)


@given(polygons(), st.booleans(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed, nonzero):
    filled = pixels(polygon, closed, nonzero)
    assert filled == sorted(set(filled), key=lambda pixel: (pixel[1], pixel[0]))


@given(polygons(far), st.booleans(), st.booleans())
def test_far_vertices_give_the_pixels_of_the_edge_tables(polygon, closed, nonzero):
    """Of a strip: between far vertices are many rows and long spans."""
    strip = [(x, y % 50.0) for x, y in polygon[0]], polygon[1]
    points, ends = np.array(strip[0], np.float64), np.array(strip[1], np.int64)
    by_tables = list(scan_line_exact(points, ends, closed, nonzero))
    assert _merged(spans(strip, closed, nonzero)) == _merged(by_tables)


def _merged(rows: Spans) -> Spans:
    """Spans that touch as one: where crossings coincide their order is free."""
    merged: Spans = []
    for y, left, right in rows:
        if merged and merged[-1][0] == y and merged[-1][2] == left - 1:
            left = merged.pop()[1]
        merged.append((y, left, right))
    return merged


@pytest.mark.parametrize("closed", [False, True])
def test_the_triangle_of_the_course(closed):
    triangle = [(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]
    rows = {y: (left, right) for y, left, right in spans(triangle, closed, False)}
    assert rows[4] == (4, 6)
    assert (7 in rows) == closed


RUNGS = ("scan_line_crossings", "scan_line_fill", "scan_line_integer", "scan_line_exact")
POLYGONS = {
    "triangle": [(2, 1), (8, 1), (5, 7)],
    "step": [(1, 1), (7, 1), (7, 3), (9, 3), (9, 5), (5, 8), (1, 5)],
    "flat top": [(1, 1), (8, 3), (6, 6), (3, 6)],
    "letter M": [(1, 1), (9, 1), (9, 7), (7, 7), (5, 3), (3, 7), (1, 7)],
}


@pytest.mark.parametrize("nonzero", [False, True])
@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("name", POLYGONS)
def test_a_vertex_counts_as_on_the_other_rungs(name, closed, nonzero):
    """Crossings, spans and counts of every row, and what is said of its vertices."""
    points = np.array(POLYGONS[name], np.float64)
    run = points, np.array([len(points)], np.int64), closed, nonzero
    told = {}
    for slug in RUNGS:
        entry = catalogue.get(slug)
        steps = [step for step in Steps(entry, record(entry.function, *run)) if step.row and step.row[3]]
        told[slug] = [(step.row[0], _numbers(step.row[1]), *step.row[2:], _rule(step)) for step in steps]
    assert told["scan_line_crossings"]
    for slug in RUNGS[1:]:
        assert told[slug] == told["scan_line_crossings"]


def _numbers(crossings: str) -> list[float]:
    """2.5 of 2.5, and of 2 + 3/6."""
    each = [x.split(" + ") for x in crossings.split(", ") if x]
    return [round(float(sum(map(Fraction, parts))), 3) for parts in each]


def _rule(step: Step) -> str:
    """What is said of the vertices of a row and how they count."""
    vertices = re.match(r"Row \S+ has .*?\.(?= |$)", "".join(part.text for part in step.sentence))
    return vertices[0] if vertices else ""


def test_under_closed_the_top_of_the_triangle_counts_twice():
    triangle = np.array(POLYGONS["triangle"], np.float64)
    entry = catalogue.get("scan_line_crossings")
    steps = Steps(entry, record(entry.function, triangle, np.array([3]), True, False))
    assert [step.row for step in steps if step.row][-1] == (7, "5, 5", "5", 1)


@given(st.lists(st.tuples(coordinates, coordinates), max_size=2))
def test_less_than_a_polygon_ends(points):
    ends = [len(points)] if points else []
    assert all(left <= right for _y, left, right in spans((points, ends), True, False))


STEP = [(1, 1), (7, 1), (7, 3), (9, 3), (9, 5), (5, 8), (1, 5)]
TWO_FEET = [(0, 0), (2, 0), (4, 3), (6, 0), (8, 0), (4, 7)]


@pytest.mark.parametrize(
    ("ring", "y", "kind", "words"),
    [
        (STEP, 1, "bottom", "the level edge from (1, 1) to (7, 1)"),
        (STEP, 3, "through", "the level edge from (7, 3) to (9, 3)"),
        (STEP, 5, "through", "the vertices (9, 5), (1, 5)"),
        (STEP, 8, "top", "the vertex (5, 8)"),
        (STEP, 8, "bottom", ""),
        (STEP, 4, "through", ""),
        (
            TWO_FEET,
            0,
            "bottom",
            "the level edge from (0, 0) to (2, 0) and the level edge from (6, 0) to (8, 0)",
        ),
        (TWO_FEET, 3, "top", "the vertex (4, 3)"),
        (TWO_FEET, 3, "bottom", ""),
    ],
)
def test_what_a_row_has_is_named_whole(ring, y, kind, words):
    ring = list(ring)
    for turned in (ring, ring[2:] + ring[:2], ring[::-1]):
        named = vertices_on(np.array(turned, np.float64), np.array([len(turned)], np.int64), y, kind)
        assert _parts(named) == _parts(words)


def _parts(words: str) -> list[str]:
    """The places named, whatever their order round the ring."""
    return sorted(re.findall(r"\([^)]*\)(?: to \([^)]*\))?", words))


@given(polygons(st.integers(0, 6).map(float)), st.integers(0, 6))
def test_both_ends_that_are_said_to_count_are_crossed(polygon, y):
    """Of a place where edges begin, each end is a crossing of the row; where one goes on, one of its ends."""
    points, ends = np.array(polygon[0], np.float64).reshape(-1, 2), np.array(polygon[1], np.int64)
    crossed = {
        x for x in range(7)
        if winding_left_of(rings_of(*polygon), Fraction(x), Fraction(y))[1]
        > winding_left_of(rings_of(*polygon), x - Fraction(1, 1000), Fraction(y))[1]
    }  # fmt: skip
    for place in _parts(vertices_on(points, ends, y, "bottom")):
        assert {int(x) for x in re.findall(r"\((\d+),", place)} <= crossed
    for place in _parts(vertices_on(points, ends, y, "through")):
        assert {int(x) for x in re.findall(r"\((\d+),", place)} & crossed
