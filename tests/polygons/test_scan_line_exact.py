"""The scan-line fill against exact fractions and shapely, vertices beside pixel centres on purpose."""

from fractions import Fraction
from itertools import pairwise
from math import ceil, floor

import numpy as np
import pytest
import shapely
from hypothesis import example, given, reject, settings
from hypothesis import strategies as st

from tests.clipping.exact import hull
from tests.polygons.exact import covered
from workbench.algorithms import catalogue
from workbench.algorithms.polygons import scan_line_exact
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

whole = st.integers(-6, 9).map(float)
quarters = st.integers(-24, 36).map(lambda number: number / 4)
beside = st.tuples(st.integers(-6, 9), st.sampled_from([1e-12, -1e-12, 1e-9, -3e-16, 2.0**-11])).map(sum)
# Nearer to 0 than this, products of two coordinates leave the range of floats
any_float = st.floats(-6, 9).filter(lambda number: number == 0 or abs(number) > 1e-60)
coordinates = st.one_of(whole, quarters, beside, any_float)
Rings = tuple[list[tuple[float, float]], list[int]]


@st.composite
def polygons(draw: st.DrawFn, numbers: st.SearchStrategy[float] = coordinates) -> Rings:
    """One or two rings of any shape: crossing themselves, with repeated, collinear and level points."""
    rings = draw(
        st.lists(st.lists(st.tuples(numbers, numbers), min_size=3, max_size=6), min_size=1, max_size=2)
    )
    ends = np.cumsum([len(ring) for ring in rings]).tolist()
    return [point for ring in rings for point in ring], ends


def filled(polygon: Rings, closed: bool, nonzero: bool = False) -> list[tuple[int, int]]:
    points, ends = polygon
    rows = scan_line_exact(np.array(points, np.float64), np.array(ends), closed, nonzero)
    return [(x, y) for y, left, right in rows for x in range(left, right + 1)]


def mapped(polygon: Rings, move) -> Rings:
    return [move(x, y) for x, y in polygon[0]], polygon[1]


@given(polygons(), st.booleans(), st.booleans())
@example(([(3 + 1e-12, 0.0), (8.0, 0.0), (6.0, 5.0)], [3]), True, False)
def test_pixels_are_those_whose_centre_belongs_to_it_by_exact_fractions(polygon, closed, nonzero):
    pixels = filled(polygon, closed, nonzero)
    assert len(pixels) == len(set(pixels))
    assert set(pixels) == covered(*polygon, closed, nonzero)


@given(polygons(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed):
    pixels = filled(polygon, closed)
    assert pixels == sorted(set(pixels), key=lambda pixel: (pixel[1], pixel[0]))


@given(
    st.lists(st.tuples(coordinates, coordinates), min_size=3, max_size=8), st.randoms(use_true_random=False)
)
def test_triangles_side_by_side_fill_each_pixel_once_and_leave_no_gap(points, chance):
    """The triangles of a fan share out what they make together, the convex hull."""
    around = [(float(x), float(y)) for x, y in hull(points)]
    pixels = []
    for left, right in pairwise(around[1:]):
        triangle = [around[0], left, right]
        chance.shuffle(triangle)
        pixels += filled((triangle, [3]), False)
    assert sorted(pixels) == sorted(filled((around, [len(around)]), False) if len(around) > 2 else [])


@given(
    st.lists(st.tuples(coordinates, coordinates), min_size=3, max_size=8), st.randoms(use_true_random=False)
)
def test_triangles_of_any_net_never_overlap(points, chance):
    try:
        delaunay = shapely.delaunay_triangles(shapely.MultiPoint(points))
    except shapely.errors.GEOSException:  # it gives up on points that nearly coincide
        reject()
    triangles = [list(part.exterior.coords)[:3] for part in delaunay.geoms]
    for triangle in triangles:
        chance.shuffle(triangle)
    pixels = [pixel for triangle in triangles for pixel in filled((triangle, [3]), False)]
    assert len(pixels) == len(set(pixels))


@given(polygons(quarters))
def test_insides_are_those_of_shapely(polygon):
    points, ends = polygon
    shapes = [
        shapely.make_valid(shapely.Polygon(points[a:b])) for a, b in zip([0, *ends], ends, strict=False)
    ]
    if len(shapes) > 1 or not shapely.Polygon(points).is_simple or not shapely.Polygon(points).is_valid:
        return
    reached = {(x, y) for x in range(-8, 12) for y in range(-8, 12) if shapes[0].covers(shapely.Point(x, y))}
    within = {(x, y) for x, y in reached if shapes[0].contains(shapely.Point(x, y))}
    assert set(filled(polygon, True)) == reached
    assert within <= set(filled(polygon, False)) <= reached


@given(polygons(quarters), st.integers(-1000, 1000), st.integers(-1000, 1000), st.booleans(), st.booleans())
def test_shifted_by_whole_pixels_it_is_the_same(polygon, dx, dy, closed, nonzero):
    shifted = filled(mapped(polygon, lambda x, y: (x + dx, y + dy)), closed, nonzero)
    assert shifted == [(x + dx, y + dy) for x, y in filled(polygon, closed, nonzero)]


@given(polygons(quarters), st.sampled_from([(-1, 1), (1, -1), (-1, -1)]), st.booleans())
def test_mirrored_it_is_the_same_under_closed(polygon, signs, nonzero):
    mirrored = filled(mapped(polygon, lambda x, y: (signs[0] * x, signs[1] * y)), True, nonzero)
    kept = covered(*polygon, True, nonzero)
    fill = set(filled(polygon, True, nonzero))
    assert fill == kept
    winding_only = {(signs[0] * x, signs[1] * y) for x, y in fill}
    assert set(mirrored) == winding_only


def test_the_triangle_of_the_course():
    triangle = ([(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3])
    assert len(filled(triangle, True)) == 25
    assert len(filled(triangle, False)) == 21
    assert [x for x, y in filled(triangle, True) if y == 4] == [4, 5, 6]
    recording = record(scan_line_exact, np.array(triangle[0]), np.array([3]), True, False)
    rows = [step.row for step in Steps(catalogue.get("scan_line_exact"), recording) if step.row]
    assert len(rows) == 7
    assert rows[3][:2] == (4, "3.5, 6.5")


@pytest.mark.parametrize("nonzero", [False, True])
def test_a_star_shows_the_two_interiors(nonzero):
    star = ([(10.0, 19.0), (4.6, 2.4), (18.7, 12.7), (1.3, 12.7), (15.4, 2.4)], [5])
    assert ((10, 10) in filled(star, False, nonzero)) is nonzero


def test_far_outside_the_picture_and_thin_as_a_hair():
    hair = ([(-900_000.0, 5.0), (900_000.0, 5.0 + 1e-7), (900_000.0, 5.0)], [3])
    assert set(filled(hair, True)) >= {(x, 5) for x in range(-1000, 1000)}
    assert filled(hair, False)[:1] in ([], [(-900_000, 5)])


far = st.integers(-(2**20), 2**20).map(float) | st.floats(-(2.0**20), 2.0**20).map(
    lambda number: number if abs(number) > 1e-60 else 0.0
)


@given(
    st.lists(st.tuples(far, coordinates), min_size=3, max_size=3),
    st.booleans(),
    st.tuples(st.integers(-1000, 1000), st.integers(-1, 1)),
)
@example([(0.0, -1.0), (-1.0, 0.0), (0.0, 0.0)], True, (0, 0))
@settings(max_examples=150)
def test_far_vertices_have_their_exact_crossings(corners, closed, beside):
    """Of a triangle across two million columns; one side may pass a pixel's centre by next to nothing."""
    x, nearly = beside
    corners = [*corners[:2], (2.0 * x - corners[0][0] + nearly * 2.0**-32, 2.0 - corners[0][1])]
    rows = {}
    for y in range(-8, 11):
        crossings = []
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
            (low_x, low_y), (high_x, high_y) = sorted([(ax, ay), (bx, by)], key=lambda point: point[1])
            if low_y <= y <= high_y if closed else low_y <= y < high_y:
                if low_y == high_y:
                    crossings += [Fraction(low_x), Fraction(high_x)]
                else:
                    share = (y - Fraction(low_y)) / (Fraction(high_y) - Fraction(low_y))
                    crossings.append(Fraction(low_x) + share * (Fraction(high_x) - Fraction(low_x)))
        if crossings:
            left, right = ceil(min(crossings)), max(crossings)
            right = floor(right) if closed else ceil(right) - 1
            if left <= right:
                rows[y] = [(y, left, right)]
    joined: list[tuple[int, int, int]] = []
    for y, left, right in scan_line_exact(np.array(corners), np.array([3]), closed, False):
        # A row may come in spans that touch
        if joined and joined[-1][0] == y and joined[-1][2] + 1 == left:
            joined[-1] = (y, joined[-1][1], right)
        else:
            joined.append((y, left, right))
    assert joined == [span for y in sorted(rows) for span in rows[y]]


@pytest.mark.parametrize("closed", [False, True])
def test_between_whole_vertices_far_apart_no_crossing_is_taken_for_a_pixel(closed):
    """The nearest one is 1/200003 beside a centre, and adding up 1/m is wrong by more in the end."""
    width, height = 65_537, 200_003
    triangle = np.array([[0, 0], [width, height], [0, height]], np.float64)
    spans = list(scan_line_exact(triangle, np.array([3]), closed, False))
    last = [width * y // height if closed else -(-width * y // height) - 1 for y in range(height)]
    expected = [(y, 0, x) for y, x in enumerate(last) if x >= 0]
    assert [span for span in spans if span[0] < height] == expected
