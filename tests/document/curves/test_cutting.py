"""Points put into curves, and curves cut in two: the same curve, by dense evaluation."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from numpy.typing import NDArray

from tests.document.curves.same_curve import (
    EXACT,
    KNOTTED,
    dense,
    off,
    parameter,
    same,
    same_by_u,
    shares,
    whole_curves,
)
from tests.document.curves.test_edits import curve_of, the_curve
from workbench.algorithms import curves
from workbench.document import DocumentError
from workbench.document.check import check
from workbench.document.curves.cutting import insert_on_curve, inserted, insertion_note, parts, split
from workbench.document.curves.paths import place
from workbench.document.curves.pieces import goes_round, pieces_of, points_of
from workbench.document.curves.settings import set_knot_rule
from workbench.document.model import Curve, CurvePoint, Document


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


def test_points_that_wait_stay_behind_the_second_part() -> None:
    path = [(0, 0), (0, 20), (20, 30), (40, 30), (60, 30), (80, 20), (90, 0), (95, 40), (70, 70)]
    for u, closed in ((1.0, False), (0.5, False), (1.5, False)):
        new = split("f1", u)(curve_of(path, spline="bezier_path", closed=closed))
        second = new.sheets[0].figures[1]
        assert [place(point) for point in second.points_world[-2:]] == path[-2:]
    opened = split("f1", 0.5)(curve_of([*path, (1, 1)], spline="bezier_path", closed=True))
    assert [place(point) for point in the_curve(opened).points_world[-1:]] == [(1, 1)]


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


@pytest.mark.parametrize("spline", ["bezier", "bezier_path", "b_spline", "catmull_rom"])
@pytest.mark.parametrize("share", [0.0, 1e-10, 1e-12, 1.0 - 1e-10, 1.0])
def test_there_is_nothing_to_cut_off_at_an_end_within_rounding(spline: str, share: float) -> None:
    points = tuple(CurvePoint(f"p{k}", 9.0 * k, 5.0 * (k % 2)) for k in range(4))
    curve = Curve("f1", points, "dda_line", 1, spline=spline)
    knots = pieces_of(curve).knots
    with pytest.raises(ValueError, match="At the end of a curve there is nothing to cut off"):
        parts(curve, float(knots[0] + share * (knots[-1] - knots[0])))
