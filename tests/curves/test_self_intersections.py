"""Crossings of a curve with itself against chords and against curves whose crossings are known."""

import sys

import numpy as np
import pytest
from hypothesis import given, settings

from tests.curves import exact
from tests.curves.made_curves import Array
from tests.curves.rational_curves import pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import (
    Pieces,
    natural_cubic,
    piece_points,
    self_intersections,
    self_meetings,
    self_overlaps,
)
from workbench.geometry.curves.one_way_parts import Parts, halved

ONE = np.array([0.0, 1.0])
LOOP = np.array([[0, 0], [3, 2], [-2, 2], [1, 0]], float)


def chords_that_cross(points: Array) -> int:
    """How many pairs of chords of a chain cross."""
    begin, leg = points[:-1], np.diff(points, axis=0)
    end = points[1:]

    def sides(a: Array, along: Array, c: Array) -> Array:
        to = c[None] - a[:, None]
        return np.asarray(along[:, None, 0] * to[..., 1] - along[:, None, 1] * to[..., 0])

    across = sides(begin, leg, begin) * sides(begin, leg, end) < 0
    return int(np.triu(across & across.T, 2).sum())


def test_a_loop_crosses_once_where_its_symmetry_says() -> None:
    ((u, v, point),) = self_intersections(Pieces(ONE, LOOP[None]), 1e-9)
    root = np.sqrt(3) / 4
    assert (u, v) == pytest.approx((0.5 - root, 0.5 + root), abs=1e-12)
    assert point == pytest.approx([0.5, 0.375], abs=1e-12)


def test_a_loop_with_weights_crosses_once_too() -> None:
    for weight in (0.8, 3.0):
        pieces = Pieces(ONE, LOOP[None], np.array([[1, weight, weight, 1]]))
        ((u, v, point),) = self_intersections(pieces, 1e-9)
        assert u + v == pytest.approx(1, abs=1e-9)
        assert piece_points(pieces, [u, v]) == pytest.approx(np.stack([point, point]), abs=1e-9)


@pytest.mark.parametrize(
    "points",
    [
        [[0, 0], [1, 1], [0, 1], [1, 0]],
        [[0, 0], [0, 0], [0, 0], [0, 0]],
        [[0, 0], [1, 2], [2, -1], [3, 1]],
        [[0, 0], [2, 1], [2, 2], [0, 0]],
    ],
)
def test_cusps_points_waves_and_closed_curves_do_not_cross(points: list[list[float]]) -> None:
    assert self_intersections(Pieces(ONE, np.array([points], float)), 1e-6) == []


def test_a_circle_does_not_cross_and_two_pieces_do() -> None:
    assert self_intersections(whole_circle(), 1e-9) == []
    lines = np.array([[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [1, -2]]], float)
    ((u, v, point),) = self_intersections(Pieces(np.array([0.0, 1, 3, 4]), lines), 1e-9)
    assert (u, v) == pytest.approx((0.5, 3 + 2 / 3))
    assert point == pytest.approx([2, 0])


@pytest.mark.parametrize("seed", range(4))
def test_as_many_as_fine_chords_show(seed: int) -> None:
    pieces = natural_cubic(np.random.default_rng(seed).uniform(0, 9, (14, 2)))
    found = self_intersections(pieces, 1e-9)
    assert len(found) == chords_that_cross(piece_points(pieces, np.linspace(0, 13, 2601)))
    for u, v, point in found:
        assert u < v
        assert piece_points(pieces, [u, v]) == pytest.approx(np.stack([point, point]), abs=1e-9)


@settings(max_examples=12, deadline=None)
@given(pieces_of_any_kind(most=3, degrees=(1, 4)))
def test_whatever_the_curve_each_crossing_is_one_place(pieces: Pieces) -> None:
    size = max(exact.size_of(pieces.controls), 1e-300)
    found = self_intersections(pieces, 1e-6 * size, most=50)
    assert len(found) <= 50
    for u, v, point in found:
        assert u <= v
        if (np.diff(pieces.knots) > 0).all() and pieces.weights is None:
            both = np.stack([piece_points(pieces, [u, v]), piece_points(pieces, np.nextafter([u, v], 0))])
            assert np.abs(both - point).max(axis=2).min(axis=0).max() <= 1.1e-6 * size


def test_no_more_than_was_asked_for() -> None:
    scribble = natural_cubic(np.random.default_rng(3).uniform(0, 9, (40, 2)))
    assert len(self_intersections(scribble, 1e-6, most=20)) == 20
    with pytest.raises(ValueError, match="tolerance is 0; choose a finite one above 0"):
        self_intersections(whole_circle(), 0.0)


def there_and_back(pieces: Pieces) -> Pieces:
    """The curve, and then the same way back."""
    controls = np.concatenate([pieces.controls, pieces.controls[::-1, ::-1]])
    return Pieces(np.arange(len(controls) + 1.0), controls)


def walk(count: int) -> Pieces:
    """A smooth curve in so many pieces that never meets itself: it always goes on to the right."""
    heights = np.random.default_rng(count).uniform(0, 9, count + 1)
    return natural_cubic(np.column_stack([np.arange(count + 1.0) * 3, heights]))


def test_the_same_way_back_is_one_overlap() -> None:
    (overlap,) = self_overlaps(there_and_back(walk(7)), 1e-6)
    assert (overlap.u, overlap.v) == (pytest.approx((0, 7)), pytest.approx((14, 7)))
    assert self_intersections(there_and_back(walk(7)), 1e-6) == []


def test_a_closed_line_of_two_nodes_is_one_overlap() -> None:
    there = np.array([[[0, 0], [2, 1], [4, 2], [6, 3]]], float)
    assert len(self_overlaps(there_and_back(Pieces(ONE, there)), 1e-6)) == 1


def test_only_the_stretch_that_is_shared_is_told() -> None:
    """From 2 to 5 on the line from 0 to 8, and the way there and away crosses nothing."""
    lines = [[[0, 0], [8, 0]], [[8, 0], [8, 4]], [[8, 4], [2, 0]], [[2, 0], [5, 0]], [[5, 0], [5, -3]]]
    for turned in (lines, [[point[::-1] for point in line] for line in lines]):
        crossings, (overlap,) = self_meetings(Pieces(np.arange(6.0), np.array(turned, float)), 1e-6)
        assert overlap.u == pytest.approx((0.25, 0.625), abs=1e-5)
        assert overlap.v == pytest.approx((3, 4), abs=1e-5)
        assert crossings == []


def blossoms(cubic: Array, a: float, b: float) -> Array:
    """The control points of a cubic from u = a to b."""

    def blossom(*at: float) -> Array:
        level = cubic
        for u in at:
            level = (1 - u) * level[:-1] + u * level[1:]
        return level[0]

    return np.array([blossom(a, a, a), blossom(a, a, b), blossom(a, b, b), blossom(b, b, b)])


def test_part_of_a_curve_cut_out_of_it_is_told() -> None:
    """From u = 0.2 to 0.7 of a cubic, by its blossom, joined to it by lines."""
    whole = np.array([[0, 0], [1, 3], [4, 4], [6, 9]], float)
    a, b = 0.2, 0.7
    part = blossoms(whole, a, b)
    steps = np.linspace(0, 1, 4)[:, None]
    away = (1 - steps) * whole[-1] + steps * [9, 0]
    back = (1 - steps) * [9, 0] + steps * part[0]
    (overlap,) = self_overlaps(Pieces(np.arange(5.0), np.array([whole, away, back, part])), 1e-6)
    assert overlap.u == pytest.approx((a, b), abs=1e-5)
    assert overlap.v == pytest.approx((3, 4), abs=1e-5)


@pytest.mark.parametrize("heights", [[1, -1, 1], [4, -4, 4, -4, 4]])
def test_a_touch_is_one(heights: list[float]) -> None:
    """A line along the top of a parabola, and of a curve of degree 4: (2 v - 1) to that power."""
    degree = len(heights) - 1
    x = np.linspace(0, 8, degree + 1)
    bowl = np.column_stack([x, heights])
    line = np.column_stack([x[::-1], np.zeros(degree + 1)])
    round_the_end = np.array([bowl[-1], *[[12, 1]] * (degree - 1), line[0]])
    (touch,) = self_intersections(Pieces(np.arange(4.0), np.array([bowl, round_the_end, line])), 1e-6)
    assert touch[2] == pytest.approx([4, 0], abs=0.2)
    assert touch[:2] == pytest.approx((0.5, 2.5), abs=0.03)


def test_each_crossing_of_a_way_there_and_back_is_told_once() -> None:
    loop = there_and_back(Pieces(ONE, LOOP[None]))
    crossings, overlaps = self_meetings(loop, 1e-9)
    assert [point.tolist() for _u, _v, point in crossings] == [pytest.approx([0.5, 0.375])]
    assert len(overlaps) == 1


def turned(points: Array, chance: np.random.Generator) -> Array:
    """Points (..., 2) turned and put elsewhere."""
    angle = chance.uniform(0, 7)
    rows = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return np.asarray(points @ rows.T + chance.uniform(0, 200, 2))


@pytest.mark.parametrize("seed", range(12))
def test_a_touch_is_one_wherever_it_is_and_however_it_lies(seed: int) -> None:
    """A line along the bottom of a curve of degree 2 or 4 that reaches it in one place alone."""
    chance = np.random.default_rng(seed)
    shape = [[1, -1, 1], [1, -1, 1, -1, 1]][seed % 2]
    heights, x = np.array(shape) * chance.uniform(5, 40), np.linspace(0, chance.uniform(10, 60), len(shape))
    bowl, line = np.column_stack([x, heights]), np.column_stack([x[::-1], 0 * x])
    round_the_end = np.array([bowl[-1], *[[x[-1] * 1.5, heights[0] / 2]] * (len(x) - 2), line[0]])
    pieces = Pieces(np.arange(4.0), turned(np.array([bowl, round_the_end, line]), chance))
    crossings, overlaps = self_meetings(pieces, 1e-6)
    assert overlaps == []
    assert [crossing[:2] for crossing in crossings] == [pytest.approx((0.5, 2.5), abs=0.05)]


@pytest.mark.parametrize("seed", range(12))
def test_a_part_of_any_cubic_is_told_as_what_was_cut_out(seed: int) -> None:
    """By its blossom, forwards or backwards; the oracle is what it was cut at."""
    chance = np.random.default_rng(seed)
    whole = chance.uniform(0, 60, (4, 2))
    a = chance.uniform(0, 0.6)
    b = a + chance.uniform(0.1, 0.4)
    part = blossoms(whole, a, b)[:: 1 if seed % 2 else -1]
    steps, far = np.linspace(0, 1, 4)[:, None], np.array([200.0, 300.0])
    away, back = (1 - steps) * whole[-1] + steps * far, (1 - steps) * far + steps * part[0]
    overlaps = self_overlaps(Pieces(np.arange(5.0), np.array([whole, away, back, part])), 6e-6)
    on_the_part = [each for each in overlaps if min(each.v) > 2.999]
    assert sum(end - begin for (begin, end), _v in on_the_part) == pytest.approx(b - a, abs=1e-3)
    assert min(each.u[0] for each in on_the_part) == pytest.approx(a, abs=1e-3)
    assert len(on_the_part) <= 5  # parts that go one way each


def pairs_examined(pieces: Pieces, monkeypatch: pytest.MonkeyPatch) -> int:
    """How many pairs of parts are halved in the search."""
    examined = []

    def counted(pieces: Pieces, one: Parts, other: Parts, margin: float) -> object:
        examined.append(len(one.low))
        return halved(pieces, one, other, margin)

    monkeypatch.setattr(sys.modules[self_intersections.__module__], "halved", counted)
    self_meetings(pieces, 1e-6, 100)
    return sum(examined)


def test_a_way_there_and_back_costs_no_more_than_the_way_there(monkeypatch: pytest.MonkeyPatch) -> None:
    for count in (10, 40, 160):
        there = pairs_examined(walk(count), monkeypatch)
        assert pairs_examined(there_and_back(walk(count)), monkeypatch) <= there + 400


@pytest.mark.parametrize("count", [20, 80])
def test_lines_over_one_another_and_near_ones_are_bounded(
    count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To and fro between two places, and between places that move on by a hair each time."""
    to_and_fro = np.array([[k % 2 * 50.0, k % 2 * 20.0] for k in range(count + 1)])
    hair = np.arange(count + 1.0)[:, None] * [1e-4, 1e-3]
    for points, each in (
        (to_and_fro, 1),
        (to_and_fro + hair, 65 * count),
        (to_and_fro * (1 + hair), 65 * count),
    ):
        lines = np.stack([points[:-1], points[1:]], axis=1)
        assert pairs_examined(Pieces(np.arange(count + 1.0), lines), monkeypatch) <= each * count


@pytest.mark.parametrize("short", [1e-4, -1e-4])
def test_a_tip_that_stops_short_of_a_line_by_less_than_the_tolerance_touches_it(short: float) -> None:
    lines = np.array([[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [2, short]], [[2, short], [0, 4]]])
    found = self_intersections(Pieces(np.arange(5.0), lines), 1e-3)
    assert found
    for u, v, point in found:
        assert (u, v) == pytest.approx((0.5, 3), abs=1e-4)
        assert point == pytest.approx([2, 0], abs=1e-3)
    assert not self_intersections(Pieces(np.arange(5.0), lines), 1e-5) or short < 0


def test_neighbours_that_leave_their_corner_side_by_side_may_cross_later() -> None:
    there = [[3, 3], [1.5, 1.5], [0, 0]]
    back = [[0, 0], [1, 0], [3, 9]]
    ((u, v, point),) = self_intersections(Pieces(np.arange(3.0), np.array([there, back], float)), 1e-9)
    assert (u, v) == pytest.approx((0.8125, 1.25), abs=1e-9)
    assert point == pytest.approx([0.5625, 0.5625], abs=1e-9)
