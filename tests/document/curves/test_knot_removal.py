"""Knots taken out of curves: insertion undone, the error a bound, refused where it is too large."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.document.curves.same_curve import KNOTTED, parameter, same_by_u, shares, whole_curves
from tests.document.curves.test_edits import curve_of, the_curve
from workbench.algorithms.curves import piece_points
from workbench.document import DocumentError
from workbench.document.check import check
from workbench.document.curves.cutting import insert_on_curve, inserted
from workbench.document.curves.edits import set_knot_rule
from workbench.document.curves.knot_removal import remove_knot, without_knot
from workbench.document.curves.pieces import knots_of, pieces_of, points_of
from workbench.document.model import Curve, Document

PLACES = [(0.0, 0.0), (20, 40), (50, 50), (80, 10), (110, 0), (60, -40)]


def apart(one: Curve, other: Curve) -> float:
    """How far two curves are apart at the same u; a closed one may begin elsewhere."""
    first, last = pieces_of(other).knots[[0, -1]]
    us = np.linspace(*pieces_of(one).knots[[0, -1]], 401)
    there = first + (us - first) % (last - first) if one.closed else us
    gaps = piece_points(pieces_of(one), us) - piece_points(pieces_of(other), there)
    return float(np.hypot(*gaps.T).max())


@settings(max_examples=60)
@given(whole_curves(KNOTTED), shares)
def test_a_knot_that_was_put_in_comes_out_again(document: Document, share: float) -> None:
    curve = the_curve(document)
    u = parameter(curve, share)
    assume(u not in knots_of(curve) and pieces_of(curve).knots[0] < u < pieces_of(curve).knots[-1])
    made = inserted(curve, u)
    index = int(np.abs(np.array([knot.u for knot in made.knots]) - u).argmin())
    left, error = without_knot(made, index)
    size = float(np.abs(points_of(curve)).max()) or 1.0
    assert error <= 1e-7 * size
    same_by_u(left, curve)
    np.testing.assert_allclose(points_of(left), points_of(curve), atol=1e-9 * size)


@settings(max_examples=60)
@given(whole_curves(KNOTTED), st.data())
def test_a_curve_with_a_knot_less_is_no_farther_off_than_is_said(
    document: Document, data: st.DataObject
) -> None:
    curve = the_curve(set_knot_rule(the_curve(document).id, "free")(document))
    index = data.draw(st.integers(0, len(curve.knots) - 1))
    try:
        left, error = without_knot(curve, index)
    except ValueError:
        return
    if math.isinf(error):
        assert curve.spline == "nurbs"
        return
    assert {p.id for p in left.points_world} < {p.id for p in curve.points_world}
    assert {k.id for k in curve.knots} - {k.id for k in left.knots} == {curve.knots[index].id}
    size = float(np.abs(points_of(curve)).max()) or 1.0
    assert apart(curve, left) <= error + 1e-9 * size


def test_a_closed_curve_loses_any_knot_also_the_one_that_it_begins_at() -> None:
    document = set_knot_rule("f1", "free")(curve_of(PLACES, spline="b_spline", closed=True))
    for u in (0.0, 0.25, 5.75):
        finer = inserted(the_curve(document), u)
        for index, knot in enumerate(finer.knots):
            if knot.u in (u, u + 6.0):
                left, error = without_knot(finer, index)
                assert error < 1e-9
                assert len(left.knots) == 7
                assert apart(the_curve(document), left) < 1e-9


def test_a_knot_is_removed_by_its_address_and_keeps_the_others() -> None:
    document = set_knot_rule("f1", "free")(curve_of(PLACES, spline="b_spline"))
    finer = insert_on_curve("f1", 1.5)(document)
    (new,) = [knot for knot in the_curve(finer).knots if knot.u == 1.5]
    back = remove_knot(f"s1/f1/{new.id}/u")(finer)
    assert check(back) is back
    same_by_u(the_curve(back), the_curve(document))
    assert [knot.id for knot in the_curve(back).knots] == [knot.id for knot in the_curve(document).knots]
    knot = the_curve(document).knots[4]
    with pytest.raises(DocumentError, match=r"would change by up to [0-9.]+, and 0.01 is allowed"):
        remove_knot(f"s1/f1/{knot.id}/u")(document)
    assert len(the_curve(remove_knot(f"s1/f1/{knot.id}/u", 100.0)(document)).points_world) == 5


@pytest.mark.parametrize(
    ("number", "words"), [(0, "between the ends"), (9, "between the ends"), (-1, "is a point")]
)
def test_what_cannot_be_removed_is_refused_in_one_sentence(number: int, words: str) -> None:
    document = set_knot_rule("f1", "free")(curve_of(PLACES, spline="nurbs"))
    part = the_curve(document).knots[number].id if number >= 0 else "p1"
    with pytest.raises(DocumentError, match=words) as refusal:
        remove_knot(f"s1/f1/{part}/u")(document)
    assert str(refusal.value).endswith(".")
    few = set_knot_rule("f1", "free")(curve_of(PLACES[:4], spline="b_spline"))
    with pytest.raises(DocumentError, match="too few points"):
        remove_knot(f"s1/f1/{the_curve(few).knots[3].id}/u")(few)
