"""De Boor's construction of a point of a B-spline.

span        number of the knot span that u lies in: t_span <= u < t_{span+1}
level       the points of level r - 1, first the degree + 1 control points that matter
next_level  those of level r
r           number of a level
j           number of a leg of the level
i           number of the point on it, counted as the control points are
triangle    all levels so far
alpha       how far u lies from t_i to t_{i+p+1-r}, as a part of 1
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.curves.knot_views import IN_SPAN, KNOT_TABLES, NEXT_SPAN, basis_rows, knot_rows
from workbench.algorithms.curves.parameters import B_SPLINE, B_SPLINE_U, b_spline_and_u
from workbench.algorithms.curves.triangle import level_rows
from workbench.algorithms.curves.triangle_marks import b_spline_marks, leg_marks
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_b_spline, refuse_parameter


def de_boor(
    points: NDArray[Any], knots: NDArray[Any], degree: int, u: float
) -> Iterator[tuple[float, float]]:
    """Find the knot span of u, then divide legs of the control polygon as u divides the knots around it.

    Args: (n+1, 2) control points, n + degree + 2 knots, and u from knot t_degree to knot t_{n+1}.
    Emits: (x, y) of every intermediate point, level by level, the point of the curve last.
    Raises: ValueError for knots that decrease or do not fit, too few points, a u outside the curve.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-9; de Boor, 1972.
    """
    # Check the knots
    refuse_b_spline(points, knots, degree)
    refuse_parameter(knots, degree, len(points), u)
    span = degree

    while span < len(points) - 1 and u >= knots[span + 1]:
        # Go on to the next knot span
        span += 1

    # Leave out a span without length
    while knots[span] == knots[span + 1]:
        span -= 1

    # Begin with the control points that matter
    level = [(float(x), float(y)) for x, y in points[span - degree : span + 1]]
    triangle = [level]

    for r in range(1, degree + 1):
        next_level = level[:0]
        for j, i in enumerate(range(span - degree + r, span + 1)):
            # Divide a leg
            left = float(knots[i])
            right = float(knots[i + degree + 1 - r])
            alpha = (u - left) / (right - left)
            x0, y0 = level[j]
            x1, y1 = level[j + 1]
            x = (1.0 - alpha) * x0 + alpha * x1
            y = (1.0 - alpha) * y0 + alpha * y1
            next_level.append((x, y))
            yield x, y

        # Go down to the next level
        level = next_level
        triangle.append(level)


_LEG = "Divide a leg"
_ROW = "(r, i, alpha, (x0, y0), (x1, y1), (x, y))"
_MARKS = "leg_marks((x0, y0), (x1, y1), (x, y), r == degree)"
_COLUMNS = ("r", "points")
_TABLES = {"Triangle": ("level_rows([*triangle, next_level])", _COLUMNS), **KNOT_TABLES}

ENTRY = Entry(
    function=de_boor,
    topic="curves",
    title="De Boor's construction",
    summary="Finds the knot span of u and divides the legs of degree + 1 control points down to one point.",
    parameters=(*B_SPLINE, B_SPLINE_U),
    arguments=b_spline_and_u,
    constructs=("b_spline",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-9",
    columns=("r", "i", "α", "d_{i-1}^{r-1}", "d_i^{r-1}", "d_i^r"),
    view_functions=(level_rows, leg_marks, basis_rows, knot_rows),
    views=(
        View(
            block="Check the knots",
            sentence="A curve of degree {degree} with {len(points)} points has {len(knots)} knots; in the "
            "course's words n = {len(points) - 1}, d = {degree + 1}, and n + d + 1 knots. Is u in "
            "span {span}?",
        ),
        NEXT_SPAN,
        View(
            block="Begin with the control points that matter",
            tables={"Triangle": ("level_rows(triangle)", _COLUMNS), **KNOT_TABLES},
            sentence=IN_SPAN,
        ),
        View(
            block=_LEG,
            when="r == degree",
            row=_ROW,
            marks=_MARKS,
            tables=_TABLES,
            sentence="α = ({u} − {left}) / ({right} − {left}) = {alpha}: "
            "(1 − α) {(x0, y0)} + α {(x1, y1)} = {(x, y)}. One point is left, and it is on the curve.",
        ),
        View(
            block=_LEG,
            row=_ROW,
            marks=_MARKS,
            tables=_TABLES,
            sentence="α = ({u} − {left}) / ({right} − {left}) = {alpha}: "
            "(1 − α) {(x0, y0)} + α {(x1, y1)} = {(x, y)}.",
        ),
    ),
    laws=(
        Law(
            "The last point is the sum of the control points, each times its basis function.",
            "curves/test_evaluation.py::test_b_spline_points_are_exact_to_rounding",
        ),
        Law(
            "Only degree + 1 control points matter.",
            "curves/test_constructions.py::test_only_degree_and_one_control_points_matter",
        ),
        Law(
            "Every point lies in the convex hull of the control points that matter.",
            "curves/test_constructions.py::test_every_point_of_a_construction_lies_in_the_hull_of_the_points_that_matter",
        ),
        Law(
            "Moving, turning or stretching the control points does the same to every point.",
            "curves/test_constructions.py::test_what_is_done_to_the_control_points_is_done_to_every_point",
        ),
        Law(
            "With knots at the two ends only, it is de Casteljau's construction.",
            "curves/test_evaluation.py::test_without_inner_knots_it_is_de_casteljaus_construction",
        ),
    ),
    not_laws=(
        "The curve begins at the first control point: only where the first knot is repeated often enough.",
    ),
    questions=(8,),
    labs=("Curves: B-spline",),
    next_rung="de_boor_rational",
    marks=b_spline_marks,
)
