"""The test of one point against exact crossings, shapely, and the pixels that a fill paints."""

from fractions import Fraction

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn
from shapely import Point, Polygon

from tests.polygons.exact import rings_of, winding_left_of
from workbench.algorithms.polygons import inside_outside, scan_line_exact

near = st.integers(0, 10).map(float) | st.floats(0, 10, allow_nan=False, width=32)


@st.composite
def areas(draw: DrawFn) -> tuple[np.ndarray, np.ndarray]:
    """One or two rings of three to seven corners on a small grid, or near it; degenerate ones on purpose."""
    sizes = draw(st.lists(st.integers(3, 7), min_size=1, max_size=2))
    corners = draw(st.lists(st.tuples(near, near), min_size=sum(sizes), max_size=sum(sizes)))
    return np.array(corners, np.float64), np.cumsum(sizes).astype(np.int64)


def counts(vertices: np.ndarray, ring_ends: np.ndarray, x: float, y: float) -> tuple[int, int]:
    """Winding number and number of crossings that the text emits."""
    turns = [turn for _x, _y, turn in inside_outside(vertices, ring_ends, x, y, False)]
    return sum(turns), len(turns)


def beside(
    vertices: np.ndarray, ring_ends: np.ndarray, x: float, y: float, to_the_left: bool
) -> tuple[int, int]:
    """The exact winding number and crossings of the ray from a point to one side."""
    mirror = 1 if to_the_left else -1
    turned = [(mirror * Fraction(a), Fraction(b)) for a, b in vertices.tolist()]
    return winding_left_of(rings_of(turned, ring_ends.tolist()), mirror * Fraction(x), Fraction(y))


@given(areas(), near, near)
def test_the_verdict_is_that_of_the_exact_crossings(
    area: tuple[np.ndarray, np.ndarray], x: float, y: float
) -> None:
    vertices, ring_ends = area
    winding, count = counts(vertices, ring_ends, x, y)
    left_winding, left_count = beside(vertices, ring_ends, x, y, to_the_left=True)
    # Every row is crossed as often upwards as downwards: what is not on one side is on the other.
    assert winding == -left_winding
    assert (count - left_count) % 2 == 0


@given(areas(), st.booleans())
def test_it_says_of_every_centre_what_the_fill_does(
    area: tuple[np.ndarray, np.ndarray], nonzero: bool
) -> None:
    vertices, ring_ends = area
    painted = {
        (x, y)
        for y, left, right in scan_line_exact(vertices, ring_ends, False, nonzero)
        for x in range(left, right + 1)
    }
    for y in range(-1, 12):
        for x in range(-1, 12):
            winding, count = counts(vertices, ring_ends, x, y)
            inside = winding != 0 if nonzero else count % 2 == 1
            assert inside == ((x, y) in painted), (x, y)


@given(areas(), near, near)
def test_a_ring_turned_round_changes_no_verdict(
    area: tuple[np.ndarray, np.ndarray], x: float, y: float
) -> None:
    vertices, ring_ends = area
    starts = [0, *ring_ends[:-1].tolist()]
    turned = np.concatenate([vertices[a:b][::-1] for a, b in zip(starts, ring_ends.tolist(), strict=True)])
    assert counts(turned, ring_ends, x, y) == (
        -counts(vertices, ring_ends, x, y)[0],
        counts(vertices, ring_ends, x, y)[1],
    )


@given(st.lists(st.tuples(near, near), min_size=3, max_size=7), near, near)
def test_shapely_finds_the_same(corners: list[tuple[float, float]], x: float, y: float) -> None:
    polygon, point = Polygon(corners), Point(x, y)
    assume(polygon.is_valid and polygon.exterior.distance(point) > 1e-9)
    vertices = np.array(corners, np.float64)
    winding, count = counts(vertices, np.array([len(corners)]), x, y)
    assert (winding != 0) == (count % 2 == 1) == polygon.contains(point)
