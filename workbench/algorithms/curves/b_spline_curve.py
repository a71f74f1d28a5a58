"""A whole B-spline, at equal steps of u.

span        number of the knot span
powers      the curve's polynomial in this span: the factors of 1, v, v^2 and so on
v           where u lies in the span, from -1/2 to 1/2
k           number of the sample
step        how far u goes from sample to sample
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.chain_marks import chain_marks
from workbench.algorithms.curves.parameters import B_SPLINE, b_spline_and_samples
from workbench.algorithms.curves.span_polynomial import span_polynomial
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.geometry.curves.refusals import refuse_b_spline


def b_spline_curve(
    points: NDArray[Any], knots: NDArray[Any], degree: int, samples: int
) -> Iterator[tuple[float, float]]:
    """Go through the knot spans from left to right, make each one's polynomial, and emit its samples.

    Args: (n+1, 2) control points, n + degree + 2 knots, and how many samples, 2 or more, from the first u of
    the curve to the last one. Emits: (x, y) of each sample.
    Raises: ValueError for knots that decrease or do not fit, too few points or samples.
    Source: de Boor, A Practical Guide to Splines, chapter X (the piecewise polynomial form).
    """
    # Check the knots
    refuse_b_spline(points, knots, degree)
    if samples < 2:
        raise ValueError("A curve needs two samples or more; ask for more.")
    first = float(knots[degree])
    last = float(knots[len(points)])
    step = (last - first) / (samples - 1)
    powers = np.zeros((degree + 1, 2))
    work = np.zeros((3, degree + 1, 2))
    u = first
    k = 0

    for span in range(degree, len(points)):
        # Go on to the next knot span
        left = float(knots[span])
        right = float(knots[span + 1])
        until = right if right < last else math.inf
        per_length = 0.0
        if left < right and u < until and k < samples:
            span_polynomial(points, knots, degree, span, powers, work)
            per_length = 1.0 / (right - left)

        while u < until and per_length > 0.0 and k < samples:
            # Emit the next sample
            v = (u - left) * per_length - 0.5
            x = float(powers[degree, 0])
            y = float(powers[degree, 1])
            for power in range(degree - 1, -1, -1):
                x = x * v + float(powers[power, 0])
                y = y * v + float(powers[power, 1])
            yield x, y
            k += 1
            u = first + step * k if k < samples - 1 else last


ENTRY = Entry(
    function=b_spline_curve,
    topic="curves",
    title="B-spline, sampled",
    summary="Finds the polynomial of each knot span once, and evaluates it at equal steps of u.",
    parameters=(*B_SPLINE, Parameter("samples", "samples", "int", 13, low=2, high=1_000_000)),
    arguments=b_spline_and_samples,
    constructs=("b_spline",),
    emits="points",
    source="de Boor, A Practical Guide to Splines, chapter X",
    columns=("k", "u_k", "span", "v", "x", "y"),
    views=(
        View(
            block="Go on to the next knot span",
            when="left == right",
            sentence="Span {span} is empty: t = {left} twice.",
        ),
        View(
            block="Go on to the next knot span",
            tables={"Polynomial of the span": ("powers", ("x", "y"))},
            sentence="Span {span} goes from {left} to {right}.",
        ),
        View(
            block="Emit the next sample",
            row="(k - 1, before.u, span, v, x, y)",
            tables={"Polynomial of the span": ("powers", ("x", "y"))},
            sentence="At u = {before.u}, which is v = {v} from the middle of span {span}, the polynomial is "
            "{(x, y)}.",
        ),
    ),
    laws=(
        Law(
            "Each sample is the sum of the control points, each times its basis function.",
            "curves/test_whole_curves.py::test_samples_are_exact_to_rounding",
        ),
        Law(
            "The samples lie at equal steps of u, both ends of the curve included.",
            "curves/test_whole_curves.py::test_samples_are_exact_to_rounding",
        ),
        Law(
            "A polynomial of this degree or less is reproduced.",
            "curves/test_whole_curves.py::test_a_polynomial_of_its_degree_is_reproduced",
        ),
    ),
    questions=(8,),
    labs=("Curves: B-spline",),
    next_rung="flatten_bezier",
    count="samples",
    marks=chain_marks,
)
