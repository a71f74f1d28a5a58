"""Curves of one degree more, which stay the same, and of one less, as near as is said."""

import numpy as np
import pytest
from hypothesis import given, settings
from msgspec.structs import replace

from tests.document.curves.same_curve import dense, same_by_u, whole_curves
from tests.document.curves.test_edits import the_curve
from workbench.document import DocumentError
from workbench.document.check import check
from workbench.document.curves.degrees import lower_degree, lowered, raise_degree, raised
from workbench.document.curves.pieces import MAX_BEZIER_DEGREE, fault_of, pieces_of, points_of
from workbench.document.model import Curve, CurvePoint, Document


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


def test_a_bezier_curve_has_a_highest_degree() -> None:
    places = [(float(7 * k % 31), float(5 * k % 23)) for k in range(MAX_BEZIER_DEGREE + 2)]
    points = tuple(CurvePoint("", x, y) for x, y in places)
    highest = Curve("", points[:-1], "bresenham_line", spline="bezier")
    assert not fault_of(highest)
    assert pieces_of(highest).degree == MAX_BEZIER_DEGREE
    for over in (replace(highest, points_world=points), replace(highest, closed=True)):
        assert f"degree {MAX_BEZIER_DEGREE + 1}" in fault_of(over)
    with pytest.raises(ValueError, match="highest"):
        raised(highest)
