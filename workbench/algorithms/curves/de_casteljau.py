"""De Casteljau's construction of a point of a Bézier curve.

level       the points of level r - 1, first the control points
next_level  those of level r, which divide the legs of the level above in the ratio u to 1 - u
r           number of a level
i           number of a point in its level
triangle    all levels so far
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.curves.parameters import BEZIER_POINTS, U, bezier_and_u
from workbench.algorithms.curves.triangle import level_rows
from workbench.algorithms.curves.triangle_marks import bezier_marks, leg_marks
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_bezier


def de_casteljau(points: NDArray[Any], u: float) -> Iterator[tuple[float, float]]:
    """Divide every leg of the control polygon in the ratio u to 1 - u, then those between, down to one point.

    Args: (n+1, 2) control points of a curve of degree n, and the parameter, 0 to 1 on the curve.
    Emits: (x, y) of every intermediate point, level by level, the point of the curve last.
    Raises: ValueError for fewer than two points or numbers that are not finite.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-8; de Casteljau, 1959.
    """
    # Begin with the control points
    refuse_bezier(points, u)
    n = len(points) - 1
    level = [(float(x), float(y)) for x, y in points]
    triangle = [level]

    for r in range(1, n + 1):
        next_level = level[:0]
        for i in range(n + 1 - r):
            # Divide a leg
            x0, y0 = level[i]
            x1, y1 = level[i + 1]
            x = (1.0 - u) * x0 + u * x1
            y = (1.0 - u) * y0 + u * y1
            next_level.append((x, y))
            yield x, y

        # Go down to the next level
        level = next_level
        triangle.append(level)


_LEG = "Divide a leg"
_ROW = "(r, i, (x0, y0), (x1, y1), (x, y))"
_MARKS = "leg_marks((x0, y0), (x1, y1), (x, y), r == n)"
_COLUMNS = ("r", "points")
_TABLES = {"Triangle": ("level_rows([*triangle, next_level])", _COLUMNS)}

ENTRY = Entry(
    function=de_casteljau,
    topic="curves",
    title="De Casteljau's construction",
    summary="Divides the legs of the control polygon, and the legs between, until one point is left.",
    parameters=(BEZIER_POINTS, U),
    arguments=bezier_and_u,
    constructs=("bezier",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-8",
    columns=("r", "i", "P_i^{r-1}", "P_{i+1}^{r-1}", "P_i^r"),
    view_functions=(level_rows, leg_marks),
    views=(
        View(
            block="Begin with the control points",
            tables={"Triangle": ("level_rows(triangle)", _COLUMNS)},
            sentence="{n + 1} control points make a curve of degree {n}; the parameter is u = {u}.",
        ),
        View(
            block=_LEG,
            when="r == n",
            row=_ROW,
            marks=_MARKS,
            tables=_TABLES,
            sentence="(1 − u) {(x0, y0)} + u {(x1, y1)} = {(x, y)}: one point is left, and it is on the "
            "curve; the last leg is its tangent.",
        ),
        View(
            block=_LEG,
            row=_ROW,
            marks=_MARKS,
            tables=_TABLES,
            sentence="Level {r}, point {i}: (1 − u) {(x0, y0)} + u {(x1, y1)} = {(x, y)}, with u = {u}.",
        ),
    ),
    laws=(
        Law(
            "The last point is the sum of the control points, each times its Bernstein polynomial.",
            "curves/test_evaluation.py::test_bezier_points_are_those_of_the_bernstein_sum",
        ),
        Law(
            "The curve begins at the first control point and ends at the last one.",
            "curves/test_evaluation.py::test_a_bezier_curve_begins_and_ends_at_its_end_points",
        ),
        Law(
            "Every point lies in the convex hull of the control points, for u from 0 to 1.",
            "curves/test_constructions.py::test_every_point_of_a_construction_lies_in_the_hull_of_the_points_that_matter",
        ),
        Law(
            "Moving, turning or stretching the control points does the same to every point.",
            "curves/test_constructions.py::test_what_is_done_to_the_control_points_is_done_to_every_point",
        ),
        Law(
            "The outer points of the levels are the control points of the two halves of the curve.",
            "curves/test_constructions.py::test_the_outer_points_of_the_levels_are_the_two_halves",
        ),
    ),
    questions=(8,),
    labs=("Curves: Bézier",),
    next_rung="b_spline_sum",
    marks=bezier_marks,
)
