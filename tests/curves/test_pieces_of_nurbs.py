"""A NURBS in pieces is the same curve, whatever its weights, and so are its measures."""

from typing import Any

import numpy as np
from hypothesis import given, settings

from tests.curves import exact
from tests.curves.made_curves import RATIONAL_RUNS
from workbench.algorithms.curves import (
    Pieces,
    b_spline_to_bezier,
    bounding_box,
    homogeneous,
    piece_points,
    projected,
)


@settings(max_examples=60)
@given(RATIONAL_RUNS)
def test_in_pieces_it_is_the_same_curve(run: tuple[Any, ...]) -> None:
    points, weights, knots, degree, u = run
    whole = b_spline_to_bezier(homogeneous(points, weights), knots, degree)
    pieces = Pieces(whole.knots, *projected(whole.controls))
    # A rounding of u within its piece counts as often as the weights are apart.
    uncertain = exact.size_of(points) * weights.max() / weights.min()
    exact.close(piece_points(pieces, u), exact.nurbs(*run), uncertain)
    low, high = bounding_box(pieces)
    slack = 1e-12 * exact.size_of(points)
    assert (points.min(axis=0) - slack <= low).all()
    assert (high <= points.max(axis=0) + slack).all()
    assert np.isfinite(pieces.controls).all()
