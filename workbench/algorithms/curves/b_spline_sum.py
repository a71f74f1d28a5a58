"""A point of a B-spline as the course defines it: the sum of control points times blending functions.

t           the knots
n           number of the last control point
d           order of the blending functions, 1 more than their degree
k           number of a blending function and of its control point
lower       B_{k,d-1}(u) for every k
blending    B_{k,d}(u) for every k
factor      how far u is past t_k, or before t_{k+d}, as a part of the span of B_{k,d-1} or B_{k+1,d-1}
x, y        the sum so far
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.curves.parameters import B_SPLINE, B_SPLINE_U, b_spline_and_u
from workbench.algorithms.curves.sum_marks import b_spline_sum_marks, blending_rows, term_marks
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_b_spline, refuse_parameter


def b_spline_sum(
    points: NDArray[Any], knots: NDArray[Any], degree: int, u: float
) -> Iterator[tuple[float, float]]:
    """Find the blending functions at u by the Cox-de Boor recursion, and add up the control points.

    Where a function of the order below is 0, its term is left out, and so is a division by 0.

    Args: (n+1, 2) control points, n + degree + 2 knots, and u from knot t_degree to knot t_{n+1}.
    Emits: (x, y) of the sum after each term that is not 0, the point of the curve last.
    Raises: ValueError for knots that decrease or do not fit, too few points, a u outside the curve.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-9, equations 10-54 and 10-55.
    """
    # Check the knots
    refuse_b_spline(points, knots, degree)
    refuse_parameter(knots, degree, len(points), u)
    t = [float(knot) for knot in knots]
    n = len(points) - 1
    blending = [0.0 for k in range(len(t) - 1)]

    for k in range(len(t) - 1):
        at_end = u == t[n + 1]
        if t[k] < u <= t[k + 1] if at_end else t[k] <= u < t[k + 1]:
            # Of order 1, only the function of the knot span of u is not 0
            blending[k] = 1.0

    for d in range(2, degree + 2):
        lower = blending
        blending = [0.0 for k in range(len(lower) - 1)]
        for k in range(len(blending)):
            if lower[k] > 0.0:
                # Add the term of B_{k,d-1}
                factor = (u - t[k]) / (t[k + d - 1] - t[k])
                blending[k] += factor * lower[k]

            if lower[k + 1] > 0.0:
                # Add the term of B_{k+1,d-1}
                factor = (t[k + d] - u) / (t[k + d] - t[k + 1])
                blending[k] += factor * lower[k + 1]

    x, y = 0.0, 0.0
    for k in range(n + 1):
        if blending[k] > 0.0:
            # Add a control point times its function
            x_k, y_k = float(points[k, 0]), float(points[k, 1])
            x += x_k * blending[k]
            y += y_k * blending[k]
            yield x, y


_RISING = "Add the term of B_{k,d-1}"
_FALLING = "Add the term of B_{k+1,d-1}"
_TERM = "Add a control point times its function"
_LAST = "not any(blending[k + 1 : n + 1])"
_TABLES = {
    "Blending functions": ("blending_rows(lower, blending, t)", ("k", "t_k", "B_{k,d-1}", "B_{k,d}")),
}


def _falling(when: str, added: str) -> View:
    return View(
        block=_FALLING,
        when=when,
        row="(d, k, factor, lower[k + 1], factor * lower[k + 1], blending[k])",
        tables=_TABLES,
        sentence="Order {d}: ({t[k + d]} − {u}) / ({t[k + d]} − {t[k + 1]}) = {factor}, times "
        f"B_{{k + 1}},{{d - 1}} = {{lower[k + 1]}}: {added}B_{{k}},{{d}} = {{blending[k]}}.",
    )


def _term(when: str, end: str) -> View:
    sentence = "Add {blending[k]} times P_{k} = {(x_k, y_k)}: the sum is {(x, y)}."
    return View(
        block=_TERM,
        when=when,
        row="('sum', k, blending[k], (x_k, y_k), (x_k * blending[k], y_k * blending[k]), (x, y))",
        marks=f"term_marks((x_k, y_k), (x, y), {_LAST})",
        tables=_TABLES,
        sentence=f"{sentence} {end}".rstrip(),
    )


ENTRY = Entry(
    function=b_spline_sum,
    topic="curves",
    title="B-spline by blending functions",
    summary="Finds the blending functions at u by the Cox-de Boor recursion, and adds up the control points.",
    parameters=(*B_SPLINE, B_SPLINE_U),
    arguments=b_spline_and_u,
    constructs=("b_spline",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-9",
    columns=("d", "k", "factor", "times", "product", "sum"),
    view_functions=(blending_rows, term_marks),
    views=(
        View(
            block="Check the knots",
            sentence="A curve of degree {degree} with {n + 1} points has {len(t)} knots; in the course's "
            "words n = {n}, d = {degree + 1}, and n + d + 1 knots.",
        ),
        View(
            block="Of order 1, only the function of the knot span of u is not 0",
            sentence="u = {u} lies in the knot span from t_{k} = {t[k]} to {t[k + 1]}: B_{k},1 = 1, the "
            "others are 0.",
        ),
        View(
            block=_RISING,
            row="(d, k, factor, lower[k], factor * lower[k], blending[k])",
            tables=_TABLES,
            sentence="Order {d}: ({u} − {t[k]}) / ({t[k + d - 1]} − {t[k]}) = {factor}, times "
            "B_{k},{d - 1} = {lower[k]}: B_{k},{d} = {blending[k]} so far.",
        ),
        _falling("lower[k] == 0", ""),
        _falling("True", "{factor * lower[k + 1]}; with {before.blending[k]} so far, "),
        _term(_LAST, "That was the last one that counts, so the sum is the point of the curve."),
        _term("True", ""),
    ),
    laws=(
        Law(
            "The last sum is the point that de Boor's construction ends with.",
            "curves/test_course_texts.py::test_the_sum_of_a_b_spline_is_exact_to_rounding",
        ),
        Law(
            "No more than degree + 1 control points have a blending function that is not 0.",
            "curves/test_course_texts.py::test_the_sum_of_a_b_spline_is_exact_to_rounding",
        ),
        Law(
            "The blending functions add up to 1 at every u of the curve.",
            "curves/test_course_texts.py::test_the_polynomials_that_count_the_points_add_up_to_one",
        ),
        Law(
            "It is the point that SciPy's BSpline gives.",
            "curves/test_course_texts.py::test_the_sum_of_a_b_spline_is_scipys",
        ),
    ),
    not_laws=("Every partial sum lies on the curve: only the last one does.",),
    questions=(8,),
    labs=("Curves: B-spline",),
    next_rung="de_boor",
    marks=b_spline_sum_marks,
)
