"""The tangents of the natural cubic spline, from a tridiagonal system of equations.

t           where in the parameter the curve passes each point
n           number of the last point
system      equation i: lower m_{i-1} + diagonal m_i + upper m_{i+1} = right, for x and for y
m           the unknown tangents, the derivatives at the points
h_before    length in the parameter of the piece before point i, t_i - t_{i-1}
h_after     length of the piece after it, t_{i+1} - t_i
factor      how many times equation i - 1 is taken off equation i
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.curves.natural_cubic_views import (
    equation_row,
    point_marks,
    system_rows,
    tangent_marks,
    times,
)
from workbench.algorithms.curves.parameters import THROUGH, points_to_pass
from workbench.algorithms.entry import Entry, Law, View
from workbench.geometry.curves.refusals import refuse_interpolation


class Equation(NamedTuple):
    """One equation for the tangents of three points that follow each other."""

    lower: float
    diagonal: float
    upper: float
    right_x: float
    right_y: float


def slope(points: NDArray[Any], t: list[float], i: int) -> tuple[float, float]:
    """The slope of the chord of piece i: the way from point i to point i + 1 by the parameter."""
    length = t[i + 1] - t[i]
    return float(points[i + 1, 0] - points[i, 0]) / length, float(points[i + 1, 1] - points[i, 1]) / length


def natural_cubic_system(
    points: NDArray[Any], knots: NDArray[Any]
) -> Iterator[tuple[float, float, float, float]]:
    """Write an equation for each point, eliminate from the first down, and solve from the last up.

    Inside, the second derivatives before and after a point agree; at both ends they are 0.

    Args: (n+1, 2) points that the curve passes, and (n+1,) where in the parameter, strictly ascending.
    Emits: (x, y, m_x, m_y), each point with its tangent, from the last to the first.
    Raises: ValueError for fewer than two points, or knots that do not ascend.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-7; de Boor, A Practical Guide to
    Splines, chapter IV; Press and others, Numerical Recipes in C, section 2.4.
    """
    # Write the equation of the first point
    refuse_interpolation(points, knots)
    t = [float(knot) for knot in knots]
    n = len(points) - 1
    slope_x, slope_y = slope(points, t, 0)
    system = [Equation(0.0, 2.0, 1.0, 3.0 * slope_x, 3.0 * slope_y)]

    for i in range(1, n):
        # Write the equation of an inner point
        h_before = t[i] - t[i - 1]
        h_after = t[i + 1] - t[i]
        left_x, left_y = slope(points, t, i - 1)
        slope_x, slope_y = slope(points, t, i)
        right_x = 3.0 * (h_after * left_x + h_before * slope_x)
        right_y = 3.0 * (h_after * left_y + h_before * slope_y)
        system.append(Equation(h_after, 2.0 * (h_before + h_after), h_before, right_x, right_y))

    # Write the equation of the last point
    slope_x, slope_y = slope(points, t, n - 1)
    system.append(Equation(1.0, 2.0, 0.0, 3.0 * slope_x, 3.0 * slope_y))

    for i in range(1, n + 1):
        # Eliminate the tangent of the point before
        above = system[i - 1]
        row = system[i]
        factor = row.lower / above.diagonal
        diagonal = row.diagonal - factor * above.upper
        right_x = row.right_x - factor * above.right_x
        right_y = row.right_y - factor * above.right_y
        system[i] = Equation(0.0, diagonal, row.upper, right_x, right_y)

    m_x, m_y = 0.0, 0.0
    for i in range(n, -1, -1):
        # Solve for a tangent with the one after it
        row = system[i]
        m_x = (row.right_x - row.upper * m_x) / row.diagonal
        m_y = (row.right_y - row.upper * m_y) / row.diagonal
        yield float(points[i, 0]), float(points[i, 1]), m_x, m_y


_TABLES = {"System": ("system_rows(system)", ("i", "m_{i-1}", "m_i", "m_{i+1}", "right x", "right y"))}
_END = (
    "At {where} point the second derivative is to be 0: {equation} = 3 times the slope of the {which} chord, "
    "{{(slope_x, slope_y)}}."
)


def _end(block: str, number: str, where: str, equation: str, which: str) -> View:
    return View(
        block=block,
        row=f"equation_row('write', {number}, system[{number}])",
        marks=f"point_marks(points, {number})",
        tables=_TABLES,
        sentence=_END.format(where=where, equation=equation, which=which),
    )


ENTRY = Entry(
    function=natural_cubic_system,
    topic="curves",
    title="Natural cubic spline, its system",
    summary="Writes an equation for the tangent at each point, and solves the tridiagonal system.",
    parameters=THROUGH,
    arguments=points_to_pass,
    constructs=("natural_cubic",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-7",
    emitted_columns=("x", "y", "m_x", "m_y"),
    columns=("step", "i", "lower", "diagonal", "upper", "right", "m_i"),
    view_functions=(system_rows, equation_row, point_marks, times),
    views=(
        _end("Write the equation of the first point", "0", "the first", "2 m_0 + m_1", "first"),
        View(
            block="Write the equation of an inner point",
            row="equation_row('write', i, system[i])",
            marks="point_marks(points, i)",
            tables=_TABLES,
            sentence="The second derivatives before and after point {i} are to agree: "
            "{times(h_after)}m_{i - 1} + {times(2 * (h_before + h_after))}m_{i} + {times(h_before)}m_{i + 1} "
            "= {(right_x, right_y)}.",
        ),
        _end("Write the equation of the last point", "n", "the last", "m_{n - 1} + 2 m_{n}", "last"),
        View(
            block="Eliminate the tangent of the point before",
            when="i == n",
            row="equation_row('eliminate', i, system[i])",
            marks="point_marks(points, i)",
            tables=_TABLES,
            sentence="Subtract {factor} times equation {i - 1} from equation {i}: "
            "{times(diagonal)}m_{i} = {(right_x, right_y)}.",
        ),
        View(
            block="Eliminate the tangent of the point before",
            row="equation_row('eliminate', i, system[i])",
            marks="point_marks(points, i)",
            tables=_TABLES,
            sentence="Subtract {factor} times equation {i - 1} from equation {i}: "
            "{times(diagonal)}m_{i} + {times(row.upper)}m_{i + 1} = {(right_x, right_y)}.",
        ),
        View(
            block="Solve for a tangent with the one after it",
            when="i == n",
            row="equation_row('solve', i, row, (m_x, m_y))",
            tables=_TABLES,
            sentence="One unknown is left in the last equation: m_{i} = {(row.right_x, row.right_y)} / "
            "{row.diagonal} = {(m_x, m_y)}.",
        ),
        View(
            block="Solve for a tangent with the one after it",
            row="equation_row('solve', i, row, (m_x, m_y))",
            tables=_TABLES,
            sentence="m_{i} = ({(row.right_x, row.right_y)} − {times(row.upper)}m_{i + 1}) / {row.diagonal} "
            "= {(m_x, m_y)}.",
        ),
    ),
    laws=(
        Law(
            "The tangents are the derivatives of SciPy's natural cubic spline.",
            "curves/test_course_texts.py::test_the_tangents_of_the_natural_spline_are_scipys",
        ),
        Law(
            "The tangents solve every equation, exactly but for rounding.",
            "curves/test_course_texts.py::test_the_tangents_of_the_natural_spline_solve_the_system",
        ),
        Law(
            "Points at equal steps along a straight line have one tangent, that of the line.",
            "curves/test_course_texts.py::test_points_on_a_line_have_its_tangent",
        ),
    ),
    questions=(8,),
    labs=("Curves: splines",),
    marks=tangent_marks,
)
