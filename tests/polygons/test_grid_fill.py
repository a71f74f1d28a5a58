"""What paints polygons on the grid of 1/4096 px, against the text whose pixels it paints."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.polygons import scan_line_exact
from workbench.algorithms.polygons.grid_edges import COLUMN, FIELDS, FIRST_ROW, REACH, in_order, is_on_grid
from workbench.algorithms.polygons.grid_fill import fill_on_grid
from workbench.engine.compiled import collect, paint
from workbench.geometry.conventions import GRID

WIDTH, HEIGHT = 40, 30

# On a pixel's centre, a trifle beside it, or anywhere
place = st.one_of(
    st.builds(lambda whole, part: whole * GRID + part, st.integers(-4, 44), st.sampled_from([-1, 0, 1])),
    st.integers(-GRID * 4, GRID * 44),
)
ring = st.lists(st.tuples(place, place), min_size=1, max_size=9)


def painted_by_the_text(
    vertices: NDArray[np.float64], ring_ends: NDArray[np.int64], closed: bool, nonzero: bool
) -> NDArray[np.uint8]:
    picture = np.zeros((HEIGHT, WIDTH), np.uint8)
    for y, left, right in collect(scan_line_exact, vertices, ring_ends, closed, nonzero):
        if 0 <= y < HEIGHT:
            picture[y, max(left, 0) : max(right + 1, 0)] = 7
    return picture


@given(rings=st.lists(ring, min_size=1, max_size=3), closed=st.booleans(), nonzero=st.booleans())
@settings(max_examples=150)
def test_it_paints_the_pixels_of_the_text(
    rings: list[list[tuple[int, int]]], closed: bool, nonzero: bool
) -> None:
    vertices = np.array([corner for corners in rings for corner in corners]) / GRID
    ends = np.cumsum([len(corners) for corners in rings])
    picture = np.zeros((HEIGHT, WIDTH), np.uint8)
    paint(scan_line_exact, picture, 7, vertices, ends, closed, nonzero)
    assert np.array_equal(picture, painted_by_the_text(vertices, ends, closed, nonzero))


@given(given=arguments(catalogue.get("scan_line_exact")))
@settings(max_examples=100)
def test_off_the_grid_the_text_paints_itself(
    given: tuple[NDArray[np.float64], NDArray[np.int64], bool, bool],
) -> None:
    vertices, ends, closed, nonzero = given
    moved = vertices + 1 / 3
    picture = np.zeros((HEIGHT, WIDTH), np.uint8)
    paint(scan_line_exact, picture, 7, moved, ends, closed, nonzero)
    assert np.array_equal(picture, painted_by_the_text(moved, ends, closed, nonzero))
    assert not list(fill_on_grid(moved, ends, closed, nonzero))


@given(rings=st.lists(ring, min_size=1, max_size=3), nonzero=st.booleans())
@settings(max_examples=100)
def test_its_spans_come_bottom_to_top_and_left_to_right(
    rings: list[list[tuple[int, int]]], nonzero: bool
) -> None:
    vertices = np.array([corner for corners in rings for corner in corners]) / GRID
    spans = list(fill_on_grid(vertices, np.cumsum([len(corners) for corners in rings]), False, nonzero))
    assert all(left <= right for _y, left, right in spans)
    for (y, _left, right), (next_y, left, _right) in pairwise(spans):
        assert (y, right) < (next_y, left)


def test_far_away_its_whole_numbers_still_fit() -> None:
    """Edges from one corner of what it reaches to the other: their products come near 2^63."""
    vertices = np.array([[-REACH, -REACH], [REACH, REACH - 1 / GRID], [REACH - 30 + 1 / GRID, REACH]])
    ends = np.array([3])
    assert is_on_grid(vertices)
    picture = np.zeros((HEIGHT, WIDTH), np.uint8)
    paint(scan_line_exact, picture, 7, vertices, ends, False, False)
    assert np.array_equal(picture, painted_by_the_text(vertices, ends, False, False))
    assert picture.any()


@pytest.mark.parametrize("count", [0, 1, 2, 5, 60, 5000])
@pytest.mark.parametrize("reach", [3, 100, int(REACH)])
def test_edges_come_by_their_first_rows_and_on_one_from_left_to_right(count: int, reach: int) -> None:
    edges = np.zeros((count + 1, FIELDS), np.int64)
    rng = np.random.default_rng(count + reach)
    edges[:, [FIRST_ROW, COLUMN]] = rng.integers(-reach, reach, (count + 1, 2), endpoint=True)
    expected = np.lexsort([edges[:count, COLUMN], edges[:count, FIRST_ROW]])
    assert np.array_equal(in_order(edges, count), expected)


@pytest.mark.parametrize("nonzero", [True, False])
def test_of_many_rings_it_paints_the_pixels_of_the_text(nonzero: bool) -> None:
    """Triangles of both windings, some of which overlap: more edges on a row than in the drawn examples."""
    rng = np.random.default_rng(8)
    corners = rng.uniform(-4, 44, (400, 1, 2)) + rng.normal(0, 2, (400, 3, 2))
    vertices, ends = np.round(corners.reshape(-1, 2) * GRID) / GRID, np.arange(3, 1201, 3)
    picture = np.zeros((HEIGHT, WIDTH), np.uint8)
    paint(scan_line_exact, picture, 7, vertices, ends, False, nonzero)
    assert np.array_equal(picture, painted_by_the_text(vertices, ends, False, nonzero))


@pytest.mark.parametrize("value", [2 * REACH, np.inf, np.nan, 1 / 8192])
def test_what_it_cannot_paint_is_left_to_the_text(value: float) -> None:
    assert not is_on_grid(np.array([[0.0, 0.0], [1.0, value]]))
