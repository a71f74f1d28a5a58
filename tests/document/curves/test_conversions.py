"""Curves as curves of another kind, as near as is said."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.document.curves.same_curve import dense, off, whole_curves
from tests.document.curves.test_edits import the_curve
from workbench.document.check import check
from workbench.document.curves.conversions import convert, converted
from workbench.document.curves.pieces import pieces_of, points_of
from workbench.document.model import Curve, CurvePoint, Document


@settings(max_examples=30)
@given(whole_curves(), st.sampled_from(["bezier_path", "b_spline", "nurbs", "hermite"]))
def test_a_curve_of_another_kind_is_no_farther_off_than_is_said(document: Document, kind: str) -> None:
    curve = the_curve(document)
    if curve.spline == "bezier_path" != kind and len(curve.points_world) % 3 != (not curve.closed):
        with pytest.raises(ValueError, match="do not make a whole piece yet"):
            converted(curve, kind)
        return
    made, error = converted(curve, kind)
    new = convert(curve.id, kind)(document)
    assert check(new) is new
    assert the_curve(new).spline == made.spline == kind
    size = float(np.abs(points_of(made)).max()) or 1.0
    assert off(curve, dense(made)[::8]) <= error / size + 1e-6
    assert off(made, dense(curve)[::8]) <= error / size + 1e-6
    if kind != "hermite" and curve.spline != "nurbs" and pieces_of(curve).degree <= 3:
        assert error == 0.0


@pytest.mark.parametrize("kind", ["b_spline", "nurbs"])
@pytest.mark.parametrize("pieces", [1, 2, 5])
def test_a_path_that_goes_round_stays_closed_as_a_b_spline(kind: str, pieces: int) -> None:
    chance = np.random.default_rng(pieces)
    points = tuple(CurvePoint(f"p{k}", *xy) for k, xy in enumerate(chance.uniform(0, 50, (3 * pieces, 2))))
    path = Curve("f1", points, "dda_line", 1, spline="bezier_path", closed=True)
    made, error = converted(path, kind)
    assert made.closed
    assert len(made.points_world) == 3 * pieces
    assert error < 1e-12
    np.testing.assert_allclose(pieces_of(made).controls, pieces_of(path).controls, atol=1e-9)
