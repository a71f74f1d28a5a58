"""Curves dragged by the curve itself, and joints made smooth."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.document.curves.same_curve import shares, whole_curves
from tests.document.curves.test_edits import curve_of, the_curve
from workbench.algorithms import curves
from workbench.algorithms.transforms import reflection
from workbench.document.curves.cutting import insert_on_curve
from workbench.document.curves.paths import natural_joint, place
from workbench.document.curves.pieces import parameter_at, pieces_of
from workbench.document.curves.shaping import SMOOTHNESS, drag_curve, smooth_joint, smoothed, smoothing_moves
from workbench.document.edits import set_attribute
from workbench.document.model import Document
from workbench.document.transforms.edits import apply_to_points

flip = reflection(0.0, 10.0, 0.0)


@settings(max_examples=30)
@given(whole_curves(), shares, st.floats(-30, 30), st.floats(-30, 30))
def test_a_dragged_curve_comes_under_the_pointer(
    document: Document, share: float, dx: float, dy: float
) -> None:
    curve = the_curve(document)
    assume(not (curve.spline == "catmull_rom" and curve.alpha > 0))
    u = parameter_at(curve, share)
    before = curves.piece_points(pieces_of(curve), u)
    made = the_curve(drag_curve(curve.id, u, dx, dy)(document))
    after = curves.piece_points(pieces_of(made), u)
    size = max(float(np.abs(before).max()), abs(dx), abs(dy), 1.0)
    np.testing.assert_allclose(after, before + np.array([dx, dy]), atol=1e-7 * size)


def test_a_dragged_catmull_rom_comes_under_the_pointer() -> None:
    document = curve_of([(0, 0), (30, 40), (60, 40), (90, 0), (95, -20)], spline="catmull_rom")
    curve = the_curve(document)
    knots = pieces_of(curve).knots
    u = float(0.7 * knots[1] + 0.3 * knots[2])
    before = curves.piece_points(pieces_of(curve), u)
    made = the_curve(drag_curve("f1", u, 5, -7)(document))
    knots = pieces_of(made).knots
    after = curves.piece_points(pieces_of(made), 0.7 * knots[1] + 0.3 * knots[2])
    np.testing.assert_allclose(after, before + np.array([5, -7]), atol=1e-9)
    assert made.points_world[3:] == curve.points_world[3:]


def bend(steps: NDArray[np.float64]) -> float:
    """The curvature at the begin of a Bézier curve from the steps (n, 2) between its control points."""
    (ax, ay), (bx, by) = steps[:2].tolist()
    return (1.0 - 1.0 / len(steps)) * (ax * by - ay * bx) / math.hypot(ax, ay) ** 3


@settings(max_examples=30)
@given(whole_curves(("bezier_path", "b_spline")), st.sampled_from(SMOOTHNESS), st.data())
def test_a_joint_that_is_made_smooth_is(document: Document, kind: str, data: st.DataObject) -> None:
    curve = the_curve(document)
    count = len(pieces_of(curve).controls) - (not curve.closed)
    assume(count > 0)
    joint = data.draw(st.integers(0, count - 1))
    try:
        made, moved = smoothed(curve, joint, kind)
    except ValueError:
        assert curve.degree < 3 or len(curve.points_world) < 6
        return
    now = the_curve(smooth_joint(curve.id, joint, kind)(document))
    assert {
        p.id for p, q in zip(curve.points_world, now.points_world, strict=True) if place(p) != place(q)
    } == set(moved)
    found = curves.joints(pieces_of(made), curve.closed, 1e-5)[joint]
    size = float(np.abs(pieces_of(curve).controls).max())
    if kind[0] == "C":
        assert found.c1 <= 1e-6 * max(size, 1.0)
        assert kind == "C1" or found.c2 <= 1e-5 * max(size, 1.0)
    elif np.isfinite(found.g1):
        sides = [
            np.diff(pieces_of(made).controls[(joint + k) % (count + (not curve.closed))], axis=0)
            for k in (0, 1)
        ]
        short = min(math.hypot(*sides[0][-1]), math.hypot(*sides[1][0]))
        if short > 1e-3 * size:
            assert found.g1 < 1e-6
            if kind == "G2":
                bends = [bend(sides[0][::-1]), -bend(sides[1])]
                assert abs(bends[0] - bends[1]) <= 1e-5 * max(*map(abs, bends), 1.0 / size)
    assert smoothing_moves(made, joint, kind) == {} or kind[0] == "G" or size > 1e3


def test_a_joint_that_is_made_smooth_leaves_the_kind_of_the_others() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (60, 30.02), (80, 20), (90, 0), (95, 40), (70, 70), (80, 80)]
    document = curve_of(path, spline="bezier_path")
    document = set_attribute("s1/f1/p4/joint", "smooth")(document)
    curve = the_curve(document)
    assert natural_joint(*(place(curve.points_world[k]) for k in (2, 3, 4))) != "corner"
    for edit in (
        smooth_joint("f1", 1, "G1"),
        apply_to_points(["s1/f1/p8/x"], flip),
        insert_on_curve("f1", 0.5),
    ):
        (joint,) = [p.joint for p in the_curve(edit(document)).points_world if p.id == "p4"]
        assert joint != "corner"


def test_handles_that_are_transformed_take_those_opposite_along() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (60, 30), (80, 20), (90, 0)]
    document = set_attribute("s1/f1/p4/joint", "symmetric")(curve_of(path, spline="bezier_path"))
    for point in ("p3", "p5", "p2"):
        made = the_curve(apply_to_points(["s1/f1/p1/x", f"s1/f1/{point}/x"], flip)(document))
        before, at, after = (place(made.points_world[k]) for k in (2, 3, 4))
        np.testing.assert_allclose(np.subtract(at, before), np.subtract(after, at), atol=1e-9)
        assert made.points_world[3].joint == "symmetric"


def test_g2_changes_the_lengths_of_both_handles_alone() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (50, 30), (80, 3), (90, 0)]
    curve = the_curve(curve_of(path, spline="bezier_path"))
    moves = smoothing_moves(curve, 0, "G2")
    assert set(moves) == {"p3", "p5"}
    assert moves["p3"][1] == moves["p5"][1] == 30
    made, _moved = smoothed(curve, 0, "G2")
    assert curves.joints(pieces_of(made))[0].geometric == "G2"


@pytest.mark.parametrize("spline", ["b_spline", "catmull_rom", "natural_cubic"])
@pytest.mark.parametrize("kind", ["G1", "C1"])
def test_what_is_smooth_already_stays_where_it_is(spline: str, kind: str) -> None:
    curve = the_curve(curve_of([(5, 5), (15, 30), (30, 35), (45, 8), (60, 10), (70, 30)], spline=spline))
    assert smoothing_moves(curve, 0, kind) == {}
    assert smoothing_moves(curve, 1, kind) == {}


@pytest.mark.parametrize("lengths", [(0.0, 0.0), (1e-7, 0.0), (5.0, 4.0)])
def test_beside_a_straight_piece_the_other_handle_turns(lengths: tuple[float, float]) -> None:
    one, other = lengths
    path = [(0, 0), (one, 0), (30 - other, 0), (30, 0), (40, 9), (50, 30), (60, 30)]
    for turned in (False, True):
        points = path[::-1] if turned else path
        curve = the_curve(curve_of(points, spline="bezier_path"))
        made, moves = smoothed(curve, 0, "G1")
        assert list(moves) == [curve.points_world[2 if turned else 4].id]
        assert curves.joints(pieces_of(made), tolerance=1e-6)[0].geometric >= "G1"
        ((x, y),) = moves.values()
        assert math.isclose(math.dist((x, y), (30, 0)), math.dist((40, 9), (30, 0)))
        assert smoothing_moves(made, 0, "G1") == {}
