"""A point of a Bézier curve as the course defines it: the sum of control points times Bernstein polynomials.

n           degree: one less than the number of control points
k           number of a control point
binomial    C(n, k), n over k: in how many ways k of n can be chosen
blend       BEZ_{k,n}(u) = C(n, k) u^k (1 - u)^{n-k}, what the control point counts at u
x, y        the sum so far
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.curves.parameters import BEZIER_POINTS, U, bezier_and_u
from workbench.algorithms.curves.sum_marks import bernstein_marks, term_marks
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_bezier


def power(base: float, exponent: int) -> float:
    """The product of ``exponent`` factors ``base``; 1 for none."""
    product = 1.0
    for _factor in range(exponent):
        product *= base
    return product


def bernstein_curve(points: NDArray[Any], u: float) -> Iterator[tuple[float, float]]:
    """Add up the control points, each times its Bernstein polynomial at u.

    Args: (n+1, 2) control points of a curve of degree n, and the parameter, 0 to 1 on the curve.
    Emits: (x, y) of the sum after each control point, the point of the curve last.
    Raises: ValueError for fewer than two points or numbers that are not finite.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-8, equations 10-40 to 10-42.
    """
    # Begin with nothing
    refuse_bezier(points, u)
    n = len(points) - 1
    binomial = 1.0
    x, y = 0.0, 0.0

    for k in range(n + 1):
        # Add a control point times its polynomial
        blend = binomial * power(u, k) * power(1.0 - u, n - k)
        x_k, y_k = float(points[k, 0]), float(points[k, 1])
        x += x_k * blend
        y += y_k * blend
        yield x, y

        # Go on to the next binomial coefficient
        binomial = binomial * (n - k) / (k + 1)


_TERM = "Add a control point times its polynomial"
_ROW = "(k, int(binomial), blend, (x_k, y_k), (x_k * blend, y_k * blend), (x, y))"
_MARKS = "term_marks((x_k, y_k), (x, y), k == n)"
_BLEND = (
    "BEZ_{k},{n} = {int(binomial)} · {u}^{k} · {1 - u}^{n - k} = {blend}: add {blend} times "
    "{(x_k, y_k)}, which makes {(x, y)}"
)

ENTRY = Entry(
    function=bernstein_curve,
    topic="curves",
    title="Bézier curve by Bernstein polynomials",
    summary="Adds up the control points, each times its Bernstein polynomial at u.",
    parameters=(BEZIER_POINTS, U),
    arguments=bezier_and_u,
    constructs=("bezier",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-8",
    columns=("k", "C(n, k)", "BEZ_{k,n}(u)", "P_k", "P_k BEZ_{k,n}", "sum"),
    view_functions=(term_marks,),
    views=(
        View(
            block="Begin with nothing",
            sentence="{n + 1} control points make a curve of degree {n}; the parameter is u = {u}.",
        ),
        View(
            block=_TERM,
            when="k == n",
            row=_ROW,
            marks=_MARKS,
            sentence=_BLEND + ". That was the last control point, so the sum is the point of the curve.",
        ),
        View(block=_TERM, row=_ROW, marks=_MARKS, sentence=_BLEND + "."),
    ),
    laws=(
        Law(
            "The last sum is the point that de Casteljau's construction ends with.",
            "curves/test_course_texts.py::test_the_bernstein_sum_is_exact_to_rounding",
        ),
        Law(
            "The Bernstein polynomials add up to 1 at every u.",
            "curves/test_course_texts.py::test_the_polynomials_that_count_the_points_add_up_to_one",
        ),
        Law(
            "The curve begins at the first control point and ends at the last one.",
            "curves/test_course_texts.py::test_a_sum_begins_and_ends_at_its_end_points",
        ),
    ),
    questions=(8,),
    labs=("Curves: Bézier",),
    next_rung="de_casteljau",
    marks=bernstein_marks,
)
