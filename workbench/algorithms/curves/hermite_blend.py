"""A point of a cubic Hermite piece: its end points and tangents, each times a blending function.

h0, h1      H_0(u) and H_1(u), what the two end points count
h2, h3      H_2(u) and H_3(u), what the two tangents count
x, y        the sum so far
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.parameters import HERMITE, U, hermite_and_u
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.marks import Ink, Mark, Spot, Stroke, along
from workbench.geometry.curves.refusals import refuse_hermite


def hermite_blend(points: NDArray[Any], tangents: NDArray[Any], u: float) -> Iterator[tuple[float, float]]:
    """Add up both end points and both tangents, each times its blending function at u.

    Args: (2, 2) the points where the piece begins and ends; (2, 2) its derivatives by u there; u, 0 to 1.
    Emits: (x, y) of the sum after each of the four, the point of the curve last.
    Raises: ValueError unless there are two points and two tangents, all finite.
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-7, equations 10-31 and 10-32.
    """
    # Find the four blending functions
    refuse_hermite(points, tangents, u)
    x0, y0 = float(points[0, 0]), float(points[0, 1])
    x1, y1 = float(points[1, 0]), float(points[1, 1])
    dx0, dy0 = float(tangents[0, 0]), float(tangents[0, 1])
    dx1, dy1 = float(tangents[1, 0]), float(tangents[1, 1])
    u2 = u * u
    u3 = u2 * u
    h0 = 2.0 * u3 - 3.0 * u2 + 1.0
    h1 = -2.0 * u3 + 3.0 * u2
    h2 = u3 - 2.0 * u2 + u
    h3 = u3 - u2

    # Begin with the first point
    x = h0 * x0
    y = h0 * y0
    yield x, y

    # Add the last point
    x += h1 * x1
    y += h1 * y1
    yield x, y

    # Add the tangent at the first point
    x += h2 * dx0
    y += h2 * dy0
    yield x, y

    # Add the tangent at the last point
    x += h3 * dx1
    y += h3 * dy1
    yield x, y


def hermite_marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The ends with a third of their tangents; the sum of the two points lies on the chord, and leaves it."""
    points, tangents = (np.asarray(each, np.float64) for each in arguments[:2])
    yield Stroke(points, "text", "hair", "dot")
    inks: tuple[Ink, Ink] = ("data3", "data4")
    for (x, y), (dx, dy), ink in zip(points.tolist(), tangents.tolist(), inks, strict=True):
        yield Stroke(along((x, y), (x + dx / 3.0, y + dy / 3.0)), ink, "thin")
        yield Spot(x, y, ink, "square", "medium")
    if len(emitted) > 1:
        yield Stroke(np.asarray(emitted[1:], np.float64), "data2", "medium")
        x, y = emitted[-1].tolist()
        yield Spot(x, y, "text" if ended else "accent", "ring", "large")


def function_rows(h0: float, h1: float, h2: float, h3: float) -> list[tuple[str, str, str, float]]:
    """The four blending functions: (its name, its formula, what it belongs to, its value)."""
    return [
        ("H_0", "2u³ − 3u² + 1", "P_0", h0),
        ("H_1", "−2u³ + 3u²", "P_1", h1),
        ("H_2", "u³ − 2u² + u", "DP_0", h2),
        ("H_3", "u³ − u²", "DP_1", h3),
    ]


_TABLES = {
    "Blending functions": ("function_rows(h0, h1, h2, h3)", ("function", "formula", "of", "at u")),
}
_ON_CURVE = "which is the point of the curve"


def _view(block: str, k: int, of: str, x: str, y: str, sentence: str, marks: str) -> View:
    row = f"('{of}', 'H_{k}', h{k}, ({x}, {y}), (h{k} * {x}, h{k} * {y}), (x, y))"
    return View(block=block, row=row, tables=_TABLES, marks=marks, sentence=sentence)


ENTRY = Entry(
    function=hermite_blend,
    topic="curves",
    title="Hermite curve by blending functions",
    summary="Adds up both end points and both tangents, each times its blending function at u.",
    parameters=(*HERMITE, U),
    arguments=hermite_and_u,
    constructs=("hermite",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-7",
    columns=("of", "function", "H_k(u)", "times", "product", "sum"),
    view_functions=(function_rows, along, Spot, Stroke),
    views=(
        View(
            block="Find the four blending functions",
            tables=_TABLES,
            sentence="At u = {u} the blending functions are H_0 = {h0}, H_1 = {h1}, H_2 = {h2}, H_3 = {h3}.",
        ),
        _view(
            "Begin with the first point",
            0,
            "P_0",
            "x0",
            "y0",
            "H_0 P_0 = {h0} times {(x0, y0)} = {(x, y)}.",
            "(Spot(x0, y0, 'accent', 'ring', 'large'),)",
        ),
        _view(
            "Add the last point",
            1,
            "P_1",
            "x1",
            "y1",
            "Add H_1 P_1 = {h1} times {(x1, y1)}: H_0 + H_1 = 1, so the sum {(x, y)} lies on the chord.",
            "(Stroke(along((x0, y0), (x1, y1)), 'data2', 'medium'),)",
        ),
        _view(
            "Add the tangent at the first point",
            2,
            "DP_0",
            "dx0",
            "dy0",
            "Add H_2 DP_0 = {h2} times the tangent {(dx0, dy0)}: the sum is {(x, y)}.",
            "(Stroke(along((x - h2 * dx0, y - h2 * dy0), (x, y)), 'data3', 'medium'),)",
        ),
        _view(
            "Add the tangent at the last point",
            3,
            "DP_1",
            "dx1",
            "dy1",
            "Add H_3 DP_1 = {h3} times the tangent {(dx1, dy1)}: the sum is {(x, y)}, " + _ON_CURVE + ".",
            "(Stroke(along((x - h3 * dx1, y - h3 * dy1), (x, y)), 'data4', 'medium'),)",
        ),
    ),
    laws=(
        Law(
            "The last sum is the point of the cubic that has these ends and these tangents.",
            "curves/test_course_texts.py::test_the_hermite_sum_is_exact_to_rounding_and_scipys",
        ),
        Law(
            "H_0 + H_1 = 1 at every u, so the second sum lies on the chord.",
            "curves/test_course_texts.py::test_the_two_points_of_a_hermite_piece_make_a_point_of_the_chord",
        ),
        Law(
            "The curve begins at the first point and ends at the last one.",
            "curves/test_course_texts.py::test_a_sum_begins_and_ends_at_its_end_points",
        ),
    ),
    questions=(8,),
    labs=("Curves: Hermite",),
    next_rung="natural_cubic_system",
    marks=hermite_marks,
)
