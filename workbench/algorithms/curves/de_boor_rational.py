"""De Boor's construction of a point of a B-spline whose points have weights.

span        number of the knot span that u lies in: t_span <= u < t_{span+1}
level       the points of level r - 1 with their weights, first the degree + 1 control points that matter
next_level  those of level r
r           number of a level
j           number of a leg of the level
i           number of the point on it, counted as the control points are
alpha       how far u lies from t_i to t_{i+p+1-r}, as a part of 1
beta        1 - alpha, exact where alpha is nearly 1: a heavy weight makes much of little
share       what the second end gives to the new point: alpha, drawn to the end that weighs more
triangle    all levels so far
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.curves.knot_views import IN_SPAN, KNOT_TABLES, NEXT_SPAN, basis_rows, knot_rows
from workbench.algorithms.curves.parameters import B_SPLINE, B_SPLINE_U, WEIGHTS, nurbs_and_u
from workbench.algorithms.curves.triangle import level_rows, weight_rows
from workbench.algorithms.curves.triangle_marks import b_spline_marks, leg_marks
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_b_spline, refuse_parameter, refuse_weights


def de_boor_rational(
    points: NDArray[Any], weights: NDArray[Any], knots: NDArray[Any], degree: int, u: float
) -> Iterator[tuple[float, float]]:
    """Divide legs as de Boor's construction does, each nearer to the end that weighs more.

    It is the plain construction of the points (w x, w y, w), projected: the weights are divided as u divides
    the knots, and a leg as its ends weigh then.

    Args: (n+1, 2) control points, their weights (n+1,) above 0, n + degree + 2 knots, and u from knot
    t_degree to knot t_{n+1}. Emits: (x, y) of every intermediate point, level by level, that of the curve
    last. Raises: ValueError for weights that are not above 0, knots that decrease or do not fit, too few
    points, a u outside the curve. Source: Piegl and Tiller, The NURBS Book, section 4.2; Farin, section 13.7.
    """
    # Check knots and weights
    refuse_b_spline(points, knots, degree)
    refuse_weights(weights, len(points))
    refuse_parameter(knots, degree, len(points), u)
    span = degree

    while span < len(points) - 1 and u >= knots[span + 1]:
        # Go on to the next knot span
        span += 1

    # Leave out a span without length
    while knots[span] == knots[span + 1]:
        span -= 1

    # Begin with the control points that matter
    first = span - degree
    level = [(float(points[i, 0]), float(points[i, 1]), float(weights[i])) for i in range(first, span + 1)]
    triangle = [level]

    for r in range(1, degree + 1):
        next_level = level[:0]
        for j, i in enumerate(range(first + r, span + 1)):
            # Divide a leg
            left = float(knots[i])
            right = float(knots[i + degree + 1 - r])
            alpha = (u - left) / (right - left)
            beta = (right - u) / (right - left)
            x0, y0, w0 = level[j]
            x1, y1, w1 = level[j + 1]
            w = beta * w0 + alpha * w1
            share = alpha * w1 / w
            x = beta * w0 / w * x0 + share * x1
            y = beta * w0 / w * y0 + share * y1
            next_level.append((x, y, w))
            yield x, y

        # Go down to the next level
        level = next_level
        triangle.append(level)


_LEG = "Divide a leg"
_ROW = "(r, i, alpha, w0, w1, w, share, (x, y))"


def _tables(levels: str) -> dict[str, tuple[str, tuple[str, ...]]]:
    return {
        "Triangle": (f"level_rows({levels})", ("r", "points")),
        "Weights": (f"weight_rows({levels})", ("r", "weights")),
        **KNOT_TABLES,
    }


ENTRY = Entry(
    function=de_boor_rational,
    topic="curves",
    title="De Boor's construction with weights",
    summary="Divides the legs of degree + 1 control points down to one point, as the weights pull.",
    parameters=(B_SPLINE[0], WEIGHTS, *B_SPLINE[1:], B_SPLINE_U),
    arguments=nurbs_and_u,
    constructs=("nurbs",),
    emits="points",
    source="Piegl and Tiller, The NURBS Book, section 4.2",
    columns=("r", "i", "α", "w_{i-1}^{r-1}", "w_i^{r-1}", "w_i^r", "share", "d_i^r"),
    view_functions=(level_rows, leg_marks, weight_rows, basis_rows, knot_rows),
    views=(
        NEXT_SPAN,
        View(block="Begin with the control points that matter", tables=_tables("triangle"), sentence=IN_SPAN),
        View(
            block=_LEG,
            row=_ROW,
            marks="leg_marks((x0, y0), (x1, y1), (x, y), r == degree)",
            tables=_tables("[*triangle, next_level]"),
            sentence="α = {alpha}, so the weight is (1 − α) {w0} + α {w1} = {w}; the leg is divided at "
            "α {w1} / {w} = {share}: {(x, y)}.",
        ),
    ),
    laws=(
        Law(
            "The last point is the sum of the control points, each times weight and basis function, "
            "divided by the sum of those products.",
            "curves/test_evaluation.py::test_points_of_rational_b_splines_are_exact_to_rounding",
        ),
        Law(
            "With equal weights it is the plain construction.",
            "curves/test_evaluation.py::test_points_of_rational_b_splines_are_exact_to_rounding",
        ),
        Law(
            "All weights times the same number give the same points.",
            "curves/test_constructions.py::test_all_weights_times_the_same_number_give_the_same_points",
        ),
        Law(
            "Every point lies in the convex hull of the control points that matter.",
            "curves/test_constructions.py::test_every_point_of_a_construction_lies_in_the_hull_of_the_points_that_matter",
        ),
    ),
    questions=(8,),
    labs=("Curves: B-spline",),
    marks=b_spline_marks,
)
