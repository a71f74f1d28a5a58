"""Curves inserted into, cut, joined, reversed, raised, converted: the same curve, by dense evaluation."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from numpy.typing import NDArray

from tests.document.made_curves import curves as made_curves
from tests.document.test_curve_edits import curve_of, the_curve, where
from workbench.algorithms import curves
from workbench.document import DocumentError
from workbench.document.building import Edit
from workbench.document.check import check
from workbench.document.curve_conversions import convert, converted
from workbench.document.curve_cutting import insert_on_curve, inserted, insertion_note, parts, split
from workbench.document.curve_degrees import lower_degree, lowered, raise_degree, raised
from workbench.document.curve_joining import align, join, mirror, reverse
from workbench.document.curve_paths import joints_of, natural_joint, place
from workbench.document.curve_pieces import fault_of, goes_round, parameter_at, pieces_of, points_of
from workbench.document.curve_settings import set_knot_rule
from workbench.document.curve_shaping import SMOOTHNESS, drag_curve, smooth_joint, smoothed, smoothing_moves
from workbench.document.model import Curve, Document
from workbench.document.sample_figures import document_of

KNOTTED = ("b_spline", "nurbs")
EXACT = ("bezier", "bezier_path", "b_spline", "nurbs")
shares = st.floats(0.01, 0.99) | st.sampled_from([0.25, 0.5])


@st.composite
def whole_curves(draw: st.DrawFn, kinds: tuple[str, ...] = (), opened: bool = False) -> Document:
    """A document with one curve that can be drawn, no free knot inside more often than its degree."""
    curve = draw(made_curves(draw(st.sampled_from(kinds)) if kinds else "", most=14))
    if opened:
        curve = replace(curve, closed=False, knot_rule="open_uniform", knots=(), degree=min(curve.degree, 3))
    assume(not fault_of(curve))
    values = [knot.u for knot in curve.knots]
    ends = () if curve.closed or not values else (values[curve.degree], values[-curve.degree - 1])
    assume(all(values.count(u) <= curve.degree or u in ends for u in set(values)))
    return document_of("Curve", 320, 200, [curve])


def dense(curve: Curve) -> NDArray[np.float64]:
    """Many points of a curve, in its order."""
    pieces = pieces_of(curve)
    return curves.piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], 401))


def off(curve: Curve, points: NDArray[np.float64]) -> float:
    """How far at most ``points`` are from a fine chain of chords of ``curve``, as a part of its size."""
    pieces = pieces_of(curve)
    size = max(float(np.abs(pieces.controls).max()), float(np.abs(points).max())) or 1.0
    chain = curves.polyline(pieces, 3e-7 * size)
    a, b = chain[:-1], chain[1:]
    way = b - a
    lengths = np.maximum((way * way).sum(axis=1), 1e-300)
    along = np.clip(((points[:, None] - a) * way).sum(axis=2) / lengths, 0.0, 1.0)
    gaps = points[:, None] - (a + along[..., None] * way)
    return float(np.sqrt((gaps * gaps).sum(axis=2).min(axis=1)).max()) / size


def same(one: Curve, other: Curve, tolerance: float = 1e-6) -> None:
    """Every point of each lies on the other one; both begin and end alike."""
    assert off(one, dense(other)[::8]) < tolerance
    assert off(other, dense(one)[::8]) < tolerance


def same_by_u(one: Curve, other: Curve) -> None:
    """Both are at the same place at every u, to a relative 1e-9."""
    size = float(np.abs(points_of(one)).max()) or 1.0
    assert float(np.abs(dense(one) - dense(other)).max()) <= 1e-9 * size


def parameter(curve: Curve, share: float) -> float:
    """A parameter that is not within rounding of a knot, but may be one."""
    u = parameter_at(curve, share)
    knots = pieces_of(curve).knots
    nearest = float(knots[np.abs(knots - u).argmin()])
    return nearest if abs(nearest - u) < 1e-4 * (knots[-1] - knots[0]) else u


@settings(max_examples=30)
@given(whole_curves(), shares)
def test_a_point_put_into_a_curve_leaves_it(document: Document, share: float) -> None:
    curve = the_curve(document)
    u = parameter(curve, share)
    try:
        new = insert_on_curve(curve.id, u)(document)
    except DocumentError as refusal:
        assume("times at most" not in str(refusal) and "already" not in str(refusal))
        raise
    assert check(new) is new
    made = the_curve(new)
    if curve.spline in EXACT:
        assert insertion_note(curve) == ""
        more = 1 if curve.spline != "bezier_path" else 3
        if made.spline == curve.spline:
            assert len(made.points_world) == len(curve.points_world) + more
        if curve.spline in KNOTTED or made.spline == "bezier":
            same_by_u(curve, made)
        else:
            same(curve, made)
            assert off(made, curves.piece_points(pieces_of(curve), u)[None]) < 1e-6
    else:
        assert insertion_note(curve).endswith(".")
        there = curves.piece_points(pieces_of(curve), u)
        assert np.abs(points_of(made) - there).max(axis=1).min() <= 1e-9 * max(np.abs(there).max(), 1.0)
    kept = {p.id for p in curve.points_world} & {p.id for p in made.points_world}
    assert len(kept) >= len(curve.points_world) - (curve.spline == "bezier") * 2


@settings(max_examples=30)
@given(whole_curves(), shares)
def test_a_curve_that_is_cut_looks_as_before(document: Document, share: float) -> None:
    curve = the_curve(document)
    u = parameter(curve, share)
    new = split(curve.id, u)(document)
    assert check(new) is new
    figures = new.sheets[0].figures
    assert len(figures) == (1 if goes_round(curve) and curve.spline != "bezier" else 2) or u in (0.0, 1.0)
    parts = [figure for figure in figures if isinstance(figure, Curve)]
    assert parts[0].id == curve.id
    assert not any(part.closed for part in parts)
    points = dense(curve)[::8]
    whole = [off(part, points[k : k + 1]) for k in range(len(points)) for part in parts]
    nearest = np.array(whole).reshape(len(points), len(parts)).min(axis=1)
    assert nearest.max() < 1e-5
    for part in parts:
        assert off(curve, dense(part)[::8]) < 1e-5


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


@settings(max_examples=60)
@given(whole_curves(EXACT, True), shares)
def test_cut_and_inserted_curves_are_at_the_same_place_at_every_u(document: Document, share: float) -> None:
    curve = the_curve(document)
    knots, u = pieces_of(curve).knots, parameter(curve, share)
    assume(knots[0] < u < knots[-1])
    where_u = np.linspace(knots[0], knots[-1], 301)
    wanted = curves.piece_points(pieces_of(curve), where_u)
    first, second = parts(curve, u)
    assert second is not None
    made = []
    for part, low, high in ((first, knots[0], u), (second, u, knots[-1])):
        inside = where_u[(where_u >= low) & (where_u <= high)]
        if curve.spline == "bezier":
            inside = (inside - low) / (high - low)
        elif curve.spline == "bezier_path":
            inside = on_path(inside, u) - (0.0 if part is first else np.ceil(u))
        made.append(curves.piece_points(pieces_of(part), inside))
    size = float(np.abs(pieces_of(curve).controls).max()) or 1.0
    np.testing.assert_allclose(np.vstack(made)[: len(made[0])], wanted[: len(made[0])], atol=1e-9 * size)
    np.testing.assert_allclose(made[1], wanted[-len(made[1]) :], atol=1e-9 * size)
    if curve.spline == "bezier_path" and u % 1.0:
        whole = pieces_of(inserted(curve, u))
        np.testing.assert_allclose(curves.piece_points(whole, on_path(where_u, u)), wanted, atol=1e-9 * size)


def on_path(u: NDArray[np.float64], cut: float) -> NDArray[np.float64]:
    """The parameters of a path after its piece around ``cut`` was divided there."""
    piece, v = np.floor(cut), cut % 1.0
    if v == 0.0:
        return u
    first, second = piece + (u - piece) / v, piece + 1.0 + (u - piece - v) / (1.0 - v)
    return np.where(u < piece, u, np.where(u <= cut, first, np.where(u < piece + 1.0, second, u + 1.0)))


def test_a_reversed_spline_of_kochanek_and_bartels_leans_the_other_way() -> None:
    places = [(0, 0), (30, 40), (60, 10), (90, 50), (95, -20)]
    how = {"tension": 0.3, "continuity": -0.4, "bias": 0.6}
    document = curve_of(places, spline="kochanek_bartels", **how)
    made = the_curve(reverse("f1")(document))
    np.testing.assert_allclose(dense(made)[::-1], dense(the_curve(document)), atol=1e-9)
    assert (made.tension, made.continuity, made.bias) == (0.3, -0.4, -0.6)


@settings(max_examples=30)
@given(whole_curves(("bezier", "b_spline", "nurbs")))
def test_a_degree_that_is_raised_leaves_the_curve_and_comes_down_again(document: Document) -> None:
    curve = the_curve(document)
    if curve.degree == 7 and curve.spline != "bezier":
        with pytest.raises(DocumentError, match="highest"):
            raise_degree(curve.id)(document)
        return
    new = raise_degree(curve.id)(document)
    assert check(new) is new
    same_by_u(curve, the_curve(new))
    if not curve.closed or curve.spline == "bezier":
        down, error = lowered(raised(curve))
        size = float(np.abs(points_of(curve)).max()) or 1.0
        assert error <= 1e-6 * size * (1.0 + size)
        assert the_curve(lower_degree(curve.id)(new)).degree == (
            curve.degree if curve.spline != "bezier" else the_curve(new).degree
        )
        assert len(down.points_world) >= len(curve.points_world) or curve.spline != "bezier"


@settings(max_examples=60)
@given(whole_curves(("bezier", "b_spline", "nurbs"), True))
def test_a_degree_that_is_lowered_is_no_farther_off_than_is_said(document: Document) -> None:
    curve = the_curve(document)
    try:
        down, error = lowered(curve)
    except ValueError:
        assert pieces_of(curve).degree == 1 or curve.spline == "nurbs"
        return
    assert pieces_of(down).degree == pieces_of(curve).degree - 1
    size = float(np.abs(points_of(curve)).max()) or 1.0
    assert float(np.abs(dense(curve) - dense(down)).max()) <= error + 1e-9 * size


@settings(max_examples=30)
@given(whole_curves(), st.sampled_from(["bezier_path", "b_spline", "nurbs", "hermite"]))
def test_a_curve_of_another_kind_is_no_farther_off_than_is_said(document: Document, kind: str) -> None:
    curve = the_curve(document)
    made, error = converted(curve, kind)
    new = convert(curve.id, kind)(document)
    assert check(new) is new
    assert the_curve(new).spline == made.spline == kind
    size = float(np.abs(points_of(made)).max()) or 1.0
    assert off(curve, dense(made)[::8]) <= error / size + 1e-6
    assert off(made, dense(curve)[::8]) <= error / size + 1e-6
    if kind != "hermite" and curve.spline != "nurbs" and pieces_of(curve).degree <= 3:
        assert error == 0.0


@settings(max_examples=30)
@given(whole_curves(("bezier_path", "b_spline", "hermite"), True), whole_curves(("b_spline",), True))
def test_two_curves_joined_look_as_both(one: Document, other: Document) -> None:
    both = document_of("Two", 320, 200, [the_curve(one), the_curve(other)])
    first, second = both.sheets[0].figures
    new = join(first.id, second.id)(both)
    assert check(new) is new
    made = the_curve(new)
    assert (made.id, len(new.sheets[0].figures)) == (first.id, 1)
    for part in (first, second):
        assert isinstance(part, Curve)
        assert off(made, dense(part)[::16]) < 1e-5


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


RANK = {"": 0, "C0": 1, "C1": 2, "C2": 3, "G0": 1, "G1": 2, "G2": 3}


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
            assert RANK[found.geometric] >= RANK[kind] or found.g1 < 1e-6
    assert smoothing_moves(made, joint, kind) == {} or kind[0] == "G" or size > 1e3


def test_g2_changes_the_lengths_of_both_handles_alone() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (50, 30), (80, 3), (90, 0)]
    curve = the_curve(curve_of(path, spline="bezier_path"))
    moves = smoothing_moves(curve, 0, "G2")
    assert set(moves) == {"p3", "p5"}
    assert moves["p3"][1] == moves["p5"][1] == 30
    made, _moved = smoothed(curve, 0, "G2")
    assert curves.joints(pieces_of(made))[0].geometric == "G2"


def test_points_are_aligned_and_mirrored() -> None:
    document = curve_of([(0, 0), (10, 20), (30, 5), (40, 40)], spline="b_spline")
    left = align(["s1/f1/p2/x", "s1/f1/p3/x"], "left")(document)
    assert where(left) == [(0, 0), (10, 20), (10, 5), (40, 40)]
    middle = align(["s1/f1/p2/x", "s1/f1/p3/x"], "middle")(document)
    assert where(middle) == [(0, 0), (10, 12.5), (30, 12.5), (40, 40)]
    turned = mirror("f1", "x")(document)
    assert where(turned) == [(40, 0), (30, 20), (10, 5), (0, 40)]
    assert where(mirror("f1", "y", ["p1", "p2"])(document))[:2] == [(0, 20), (10, 0)]
    assert mirror("f1", "x")(turned) == document


def test_a_path_that_is_mirrored_keeps_its_joints() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (50, 30), (80, 20), (90, 0)]
    document = curve_of(path, spline="bezier_path")
    for joint in joints_of(the_curve(mirror("f1", "y")(document)))[0]:
        if joint.before and joint.after:
            assert natural_joint(place(joint.before), place(joint.at), place(joint.after)) == "smooth"


def test_a_curve_with_free_closed_knots_takes_a_knot_anywhere() -> None:
    places = [(0, 0), (20, 40), (50, 50), (80, 10), (110, 0), (60, -40)]
    document = curve_of(places, spline="b_spline", closed=True)
    document = set_knot_rule("f1", "free")(document)
    for u in (0.0, 0.25, 5.75, 6.0, 3.0):
        new = insert_on_curve("f1", u)(document)
        same_by_u(the_curve(document), the_curve(new))
        assert len(the_curve(new).knots) == len(the_curve(document).knots) + 1
        before = {p.id: place(p) for p in the_curve(document).points_world}
        after = {p.id: place(p) for p in the_curve(new).points_world}
        assert before.keys() < after.keys()
        stayed = [np.allclose(after[name], at) for name, at in before.items()]
        assert sum(stayed) >= len(stayed) - 2
        document = new


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (insert_on_curve("f1", 99.0), "no u = 99"),
        (insert_on_curve("f2", 1.0), "already"),
        (split("f1", 0.0), "nothing to cut off"),
        (join("f1", "f1"), "one curve"),
        (convert("f1", "natural_cubic"), "change its kind"),
        (convert("f1", "bezier"), "several pieces"),
        (smooth_joint("f1", 9, "C1"), "no joint 9"),
        (smooth_joint("f1", 0, "C3"), "Choose one of"),
        (align(["s1/f1/p1/x"], "middling"), "Choose one of"),
        (mirror("f1", "z"), "Choose one of"),
        (raise_degree("f2"), "one degree only"),
        (join("f1", "f2"), "A closed curve"),
    ],
)
def test_what_cannot_be_done_is_refused_in_one_sentence(edit: Edit, words: str) -> None:
    places = [(0, 0), (20, 40), (50, 50), (80, 10), (110, 0)]
    one = the_curve(curve_of(places, spline="b_spline"))
    other = replace(one, spline="cardinal", closed=True)
    document = document_of("Two", 320, 200, [one, other])
    with pytest.raises(DocumentError, match=words) as refusal:
        edit(document)
    assert str(refusal.value).endswith(".")
    assert inserted(one, 0.5).knot_rule == "free"
