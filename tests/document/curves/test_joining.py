"""Curves joined, reversed, aligned and mirrored."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from tests.document.curves.same_curve import dense, off, same, whole_curves
from tests.document.curves.test_edits import curve_of, the_curve, where
from workbench.algorithms import curves
from workbench.algorithms.transforms import reflection
from workbench.document import DocumentError
from workbench.document.check import check
from workbench.document.curves.conversions import converted
from workbench.document.curves.joining import align, join, joined, reverse
from workbench.document.curves.paths import closed_path, joints_of, natural_joint, place
from workbench.document.curves.pieces import fault_of, goes_round, pieces_of
from workbench.document.model import NEIGHBOUR_SPLINES, Curve, Document
from workbench.document.samples.figures import document_of
from workbench.document.transforms.edits import apply_matrix, apply_to_points


@settings(max_examples=30)
@given(whole_curves())
def test_a_curve_that_is_reversed_looks_the_same_and_twice_is_as_it_was(document: Document) -> None:
    curve = the_curve(document)
    new = reverse(curve.id)(document)
    made = the_curve(new)
    assert {p.id for p in made.points_world} == {p.id for p in curve.points_world}
    size = float(np.abs(pieces_of(curve).controls).max()) or 1.0
    if not curve.closed:
        np.testing.assert_allclose(dense(made)[::-1], dense(curve), atol=1e-9 * size)
    same(curve, made)
    twice = the_curve(reverse(curve.id)(new))
    assert twice.points_world == curve.points_world
    np.testing.assert_allclose([k.u for k in twice.knots], [k.u for k in curve.knots], atol=1e-9)


def test_a_reversed_spline_of_kochanek_and_bartels_leans_the_other_way() -> None:
    places = [(0, 0), (30, 40), (60, 10), (90, 50), (95, -20)]
    how = {"tension": 0.3, "continuity": -0.4, "bias": 0.6}
    document = curve_of(places, spline="kochanek_bartels", **how)
    made = the_curve(reverse("f1")(document))
    np.testing.assert_allclose(dense(made)[::-1], dense(the_curve(document)), atol=1e-9)
    assert (made.tension, made.continuity, made.bias) == (0.3, -0.4, -0.6)


@settings(max_examples=30)
@given(whole_curves(("bezier_path", "b_spline", "hermite"), True), whole_curves(("b_spline",), True))
def test_two_curves_joined_look_as_both(one: Document, other: Document) -> None:
    both = document_of("Two", 320, 200, [the_curve(one), the_curve(other)])
    first, second = both.sheets[0].figures
    if first.spline == "bezier_path" and len(first.points_world) % 3 != 1:
        with pytest.raises(DocumentError, match="do not make a whole piece yet"):
            join(first.id, second.id)(both)
        return
    new = join(first.id, second.id)(both)
    assert check(new) is new
    made = the_curve(new)
    assert (made.id, len(new.sheets[0].figures)) == (first.id, 1)
    for part in (first, second):
        assert isinstance(part, Curve)
        assert off(made, dense(part)[::16]) < 1e-5


@settings(max_examples=40)
@given(whole_curves((), True), whole_curves((), True), st.booleans())
def test_a_joined_curve_is_no_farther_off_than_is_said(one: Document, other: Document, alike: bool) -> None:
    """Whatever the kinds; with ``alike`` the second has that of the first, whose rule then goes on."""
    first, second = the_curve(one), the_curve(other)
    if alike:
        second = replace(second, spline=first.spline, degree=first.degree, alpha=first.alpha, ends=first.ends)
    assume(not (fault_of(first) or fault_of(second) or goes_round(first) or goes_round(second)))
    paths = [curve for curve in (first, second) if curve.spline == "bezier_path"]
    assume(all(len(curve.points_world) % 3 == 1 for curve in paths))
    made, error = joined(first, second)
    size = max(float(np.abs(pieces_of(each).controls).max()) for each in (made, first, second)) or 1.0
    for part in (first, second):
        assert curves.distances(pieces_of(made), dense(part)[::8]).max() <= error + 1e-9 * size
    assert error < 300  # of curves that are as large


KINDS = ("natural_cubic", "clamped_cubic", "hermite", "cardinal")


@pytest.mark.parametrize("spline", KINDS)
def test_curves_that_go_on_by_their_rule_are_off_and_that_is_told(spline: str) -> None:
    one = the_curve(curve_of([(0, 0), (10, 30), (30, 30), (40, 0)], spline=spline))
    points = tuple(replace(p, x=p.x + 40, y=3 * p.y, tangent_x=9.0) for p in one.points_world)
    made, error = joined(one, replace(one, points_world=points))
    assert len(made.points_world) == 7
    here = curves.distances(
        pieces_of(made), np.concatenate([dense(one), dense(replace(one, points_world=points))])
    )
    assert 0.5 < here.max() <= error < 20 * here.max()


def test_quartics_are_joined_as_near_as_is_told() -> None:
    one = the_curve(curve_of([(0, 0), (10, 90), (30, -50), (50, 70), (40, 0)], spline="bezier"))
    other = replace(one, points_world=tuple(replace(p, x=p.x + 40) for p in one.points_world))
    made, error = joined(one, other)
    there = curves.distances(pieces_of(made), np.concatenate([dense(one), dense(other)]))
    assert 0.0 < there.max() <= error <= 0.01
    exact = joined(converted(one, "bezier_path")[0], converted(other, "bezier_path")[0])
    assert exact[1] == 0.0


@pytest.mark.parametrize("spline", ["bezier_path", "b_spline", "natural_cubic"])
@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3, 1e5])
@pytest.mark.parametrize("away", [0.0, 7e5])
def test_ends_merge_by_the_size_of_the_curves(spline: str, size: float, away: float) -> None:
    """Within rounding of that, or of coordinates so large; not at a thousandth of it, wherever they lie."""
    shape = size * np.array([(0, 0), (1, 3), (3, 3), (4, 0)]) / 4 + away
    for gap, merged in ((0.0, True), (max(1e-10 * size, 2e-10 * bool(away)), True), (1e-3 * size, False)):
        next_shape = shape + np.array([size + gap, 0])
        one, other = (the_curve(curve_of(places.tolist(), spline=spline)) for places in (shape, next_shape))
        count = len(joined(one, other)[0].points_world)
        assert count == (7 if merged else 8 if spline == "natural_cubic" else 10)


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e5])
@pytest.mark.parametrize("away", [0.0, 7e5])
def test_a_path_is_closed_in_one_point_by_its_size(size: float, away: float) -> None:
    for gap, points in ((0.0, 6), (max(1e-10, 2e-10 * bool(away) / size), 6), (1e-3, 9)):
        path = [(0, 0), (1, 3), (3, 3), (4, 0), (3, -3), (1, -3), (gap, 0)]
        places = (size * np.array(path) + away).tolist()
        curve = the_curve(curve_of(places, spline="bezier_path"))
        assert len(closed_path(curve).points_world) == points, gap


def test_two_open_b_splines_stay_a_b_spline() -> None:
    one = the_curve(curve_of([(0, 0), (10, 30), (30, 30), (40, 0)], spline="b_spline"))
    other = replace(one, points_world=tuple(replace(p, x=p.x + 40) for p in one.points_world))
    both = document_of("Two", 320, 200, [other, one])
    made = the_curve(join("f1", "f2")(both))
    assert (made.spline, made.degree, len(made.points_world)) == ("b_spline", 3, 7)
    far = replace(other, points_world=tuple(replace(p, y=p.y + 9) for p in other.points_world))
    made = the_curve(join("f2", "f1")(document_of("Two", 320, 200, [far, one])))
    assert len(made.points_world) == 10
    assert off(made, dense(far)) < 1e-6


@pytest.mark.parametrize("spline", NEIGHBOUR_SPLINES)
def test_curves_whose_ends_only_steer_are_joined_where_they_are_drawn(spline: str) -> None:
    places = [(0, 0), (20, 40), (50, 50), (80, 10), (110, 0)]
    one = the_curve(curve_of(places, spline=spline, ends="inner"))
    other = replace(one, points_world=tuple(replace(p, x=p.x + 60, y=p.y - 30) for p in one.points_world))
    made = the_curve(join("f1", "f2")(document_of("Two", 320, 200, [one, other])))
    assert len(pieces_of(made).controls) == 4
    assert off(made, dense(one)) < 1e-6
    assert off(made, dense(other)) < 1e-6


def test_points_are_aligned_and_mirrored() -> None:
    document = curve_of([(0, 0), (10, 20), (30, 5), (40, 40)], spline="b_spline")
    left = align(["s1/f1/p2/x", "s1/f1/p3/x"], "left")(document)
    assert where(left) == [(0, 0), (10, 20), (10, 5), (40, 40)]
    middle = align(["s1/f1/p2/x", "s1/f1/p3/x"], "middle")(document)
    assert where(middle) == [(0, 0), (10, 12.5), (30, 12.5), (40, 40)]
    across, upright = reflection(20.0, 0.0, np.pi / 2), reflection(0.0, 10.0, 0.0)
    turned = apply_matrix(["f1"], across)(document)
    np.testing.assert_allclose(where(turned), [(40, 0), (30, 20), (10, 5), (0, 40)], atol=1e-12)
    two = apply_to_points(["s1/f1/p1/x", "s1/f1/p2/x"], upright)(document)
    np.testing.assert_allclose(where(two)[:2], [(0, 20), (10, 0)], atol=1e-12)
    assert where(two)[2:] == where(document)[2:]


def test_a_path_that_is_mirrored_keeps_its_joints() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (50, 30), (80, 20), (90, 0)]
    document = curve_of(path, spline="bezier_path")
    for joint in joints_of(the_curve(apply_matrix(["f1"], reflection(0.0, 15.0, 0.0))(document)))[0]:
        if joint.before and joint.after:
            assert natural_joint(place(joint.before), place(joint.at), place(joint.after)) == "smooth"
