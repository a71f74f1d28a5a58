"""A Bézier curve as a chain of straight lines, by dividing it until each piece is flat.

stack       the pieces that wait, each with its control points; the one nearest to the start on top
depth       for each piece on the stack, how often the curve was divided to get it
top         number of the piece on top of the stack
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.chain_marks import flattening_marks
from workbench.algorithms.curves.parameters import BEZIER_POINTS, TOLERANCE, bezier_and_tolerance
from workbench.algorithms.curves.waiting_pieces import chord, chord_of, waiting_rows
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.recorded import is_recorded
from workbench.geometry.curves.refusals import refuse_bezier

# A piece is 2^-20 of the curve then, and as near to its chord as rounding lets it be
DEEPEST = 20


def squared_distance(piece: NDArray[Any]) -> float:
    """The square of the largest distance of a control point from the straight line between both ends.

    All control points, and so the whole piece, lie as near to it.
    """
    n = len(piece) - 1
    x0, y0 = float(piece[0, 0]), float(piece[0, 1])
    dx, dy = float(piece[n, 0]) - x0, float(piece[n, 1]) - y0
    chord = dx * dx + dy * dy
    largest = 0.0
    for i in range(1, n):
        x, y = float(piece[i, 0]) - x0, float(piece[i, 1]) - y0
        along = x * dx + y * dy
        if along <= 0.0 or chord == 0.0:
            distance = x * x + y * y
        elif along >= chord:
            distance = (x - dx) * (x - dx) + (y - dy) * (y - dy)
        else:
            distance = (x * dy - y * dx) * (x * dy - y * dx) / chord
        largest = max(largest, distance)
    return largest


def divide(piece: NDArray[Any], first_half: NDArray[Any]) -> None:
    """Divide a piece in the middle by de Casteljau's construction; the second half takes its place."""
    n = len(piece) - 1
    first_half[0, 0] = piece[0, 0]
    first_half[0, 1] = piece[0, 1]
    for r in range(1, n + 1):
        for i in range(n + 1 - r):
            piece[i, 0] = 0.5 * (piece[i, 0] + piece[i + 1, 0])
            piece[i, 1] = 0.5 * (piece[i, 1] + piece[i + 1, 1])
        first_half[r, 0] = piece[0, 0]
        first_half[r, 1] = piece[0, 1]


def flatten_bezier(points: NDArray[Any], tolerance: float) -> Iterator[tuple[float, float]]:
    """Divide the curve in the middle until every piece is nearer to its chord than the tolerance.

    Args: (n+1, 2) control points; the tolerance, above 0, in the same unit.
    Emits: (x, y) of the corners of the chain, both ends of the curve included.
    Raises: ValueError for fewer than two points, numbers that are not finite, or no tolerance.
    Source: Lane and Riesenfeld, A theoretical development for the computer generation of piecewise
    polynomial surfaces, 1980; Hearn and Baker, Computer Graphics, C Version, section 10-15.
    """
    # Begin with the whole curve
    refuse_bezier(points, tolerance)
    if tolerance <= 0.0:
        raise ValueError("The tolerance must be above 0; give a larger one.")
    stack = np.zeros((DEEPEST + 1, len(points), 2))
    depth = np.zeros(DEEPEST + 1, np.int64)
    for i in range(len(points)):
        stack[0, i, 0] = points[i, 0]
        stack[0, i, 1] = points[i, 1]
    top = 0
    yield float(points[0, 0]), float(points[0, 1])

    while top >= 0:
        # Is the piece on top flat?
        distance = math.sqrt(squared_distance(stack[top]))
        flat = distance <= tolerance or depth[top] == DEEPEST

        if flat:
            # Draw its chord
            x = float(stack[top, len(points) - 1, 0])
            y = float(stack[top, len(points) - 1, 1])
            yield x, y
            top -= 1
        else:
            # Divide it in the middle
            divide(stack[top], stack[top + 1])
            depth[top] += 1
            depth[top + 1] = depth[top]
            top += 1


_FLAT = "Is the piece on top flat?"
_ROW = "(top, int(depth[top]), *chord_of(stack, top), distance, 'yes' if flat else 'no')"
_TABLES = {"Pieces that wait": ("waiting_rows(stack, depth, top)", ("piece", "divided", "from", "to"))}

ENTRY = Entry(
    function=flatten_bezier,
    topic="curves",
    title="Bézier curve, flattened",
    summary="Divides the curve in the middle until each piece is nearer to its chord than the tolerance.",
    parameters=(BEZIER_POINTS, TOLERANCE),
    arguments=bezier_and_tolerance,
    constructs=("bezier",),
    emits="points",
    source="Lane and Riesenfeld, 1980; Hearn and Baker, Computer Graphics, C Version, section 10-15",
    columns=("piece", "divided", "from", "to", "distance", "flat"),
    view_functions=(chord, chord_of, is_recorded, waiting_rows),
    views=(
        View(
            block="Begin with the whole curve",
            sentence="The chain begins at {chord(points)[0]}; no piece may be farther from its chord than "
            "{tolerance}.",
        ),
        View(
            block=_FLAT,
            when="not is_recorded(stack)",
            row=_ROW,
            options="('flat', 'divide')",
            answer="'flat' if flat else 'divide'",
            sentence="The points of piece {top} are at most {distance} from its chord, and {tolerance} is "
            "allowed: {'draw the chord' if flat else 'divide it in the middle'}.",
        ),
        View(
            block=_FLAT,
            when="flat",
            row=_ROW,
            tables=_TABLES,
            options="('flat', 'divide')",
            answer="'flat'",
            sentence="The piece from {chord_of(stack, top)[0]} to {chord_of(stack, top)[1]} is no farther "
            "than {distance} from its chord, which is not more than {tolerance}: draw the chord.",
        ),
        View(
            block=_FLAT,
            row=_ROW,
            tables=_TABLES,
            options="('flat', 'divide')",
            answer="'divide'",
            sentence="The piece from {chord_of(stack, top)[0]} to {chord_of(stack, top)[1]} may be as far as "
            "{distance} from its chord, more than {tolerance}: divide it in the middle.",
        ),
    ),
    laws=(
        Law(
            "No point of the curve is farther from the chain than the tolerance.",
            "curves/test_whole_curves.py::test_the_chain_is_within_the_tolerance",
        ),
        Law(
            "Every corner lies on the curve, in its order; both ends are corners.",
            "curves/test_whole_curves.py::test_the_corners_follow_the_curve",
        ),
        Law(
            "A straight curve that does not turn back is one line.",
            "curves/test_whole_curves.py::test_a_straight_curve_is_one_line",
        ),
    ),
    questions=(8,),
    labs=("Curves: Bézier",),
    marks=flattening_marks,
)
