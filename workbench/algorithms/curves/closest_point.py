"""The point of a curve in Bézier pieces that is closest to a given one.

best        the distance of the closest point so far, which is (best_x, best_y) at best_u
parts       the parts of a piece that wait, each with the polynomials of its squared distance
bound       no point of the part that was taken is closer than that
valley      whether the distance falls and then grows along that part, so that it has one minimum
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.distance_bottom import bottom, closest_end
from workbench.algorithms.curves.distance_polynomial import box_distance, halves, outlook, whole_piece
from workbench.algorithms.curves.parameters import PIECES, pieces_and_point
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.geometry.curves.refusals import refuse_pieces

# Narrower parts have one minimum but for rounding
NARROWEST = 1e-9
# What is closer by less than this part is not worth a search
NOTHING = 1e-13


def closest_point(
    knots: NDArray[Any],
    points: NDArray[Any],
    weights: NDArray[Any],
    degree: int,
    x: float,
    y: float,
) -> Iterator[tuple[float, float, float, float]]:
    """Pass over pieces whose box is too far; divide the others until the distance has one valley.

    Args: (m+1,) ascending knots; (m (degree + 1), 2) control points, piece after piece, and their weights, 1
    for a plain curve; the degree; the given point. Emits: (u, x, y, distance) of ever closer points of the
    curve, the closest one last. Raises: ValueError. Source: Chen et al., Computing the minimum distance
    between a point and a clamped B-spline curve, 2008; Schneider, Graphics Gems, 1990.
    """
    # Begin with the closest end of a piece
    refuse_pieces(knots, points, weights, degree, x, y)
    level = np.zeros((degree + 1, 3))
    best_u, best_x, best_y, best = closest_end(knots, points, degree, x, y)
    yield best_u, best_x, best_y, best

    for j in range(len(knots) - 1):
        # Can this piece be closer?
        first = j * (degree + 1)
        u0, length = float(knots[j]), float(knots[j + 1] - knots[j])
        distance = box_distance(points, first, degree, x, y)
        searched = length > 0.0 and distance < best
        if not searched:
            continue

        parts = [whole_piece(points, weights, first, degree, x, y)]
        while parts:
            # Can this part be closer?
            part = parts.pop()
            begin, end = part.begin, part.end
            bound, valley = outlook(part)
            hopeless = bound >= best * (1.0 - NOTHING)
            divided = not hopeless and not valley and end - begin > NARROWEST

            if divided:
                # Divide it in the middle, and take the first half next
                before_middle, after_middle = halves(part)
                parts.append(after_middle)
                parts.append(before_middle)
            elif not hopeless:
                # Go down to its minimum
                v, at_x, at_y, distance = bottom(points, weights, first, x, y, begin, end, level)
                if distance < best:
                    best_u, best_x, best_y, best = u0 + v * length, at_x, at_y, distance
                    yield best_u, best_x, best_y, best


_BOX, _PART = "Can this piece be closer?", "Can this part be closer?"
_BOTTOM = "Go down to its minimum"
_ROW = "(j, begin, end, bound, best, 'skip' if hopeless else 'divide' if divided else 'search')"
_OPTIONS = "('skip', 'divide', 'search')"
_FROM = "The part of piece {j} from {begin} to {end} is nowhere closer than {bound}"

ENTRY = Entry(
    function=closest_point,
    topic="curves",
    title="Closest point of a curve",
    summary="Skips what is too far away, and divides the rest until the distance has one minimum.",
    parameters=(
        *PIECES,
        Parameter("x", "x", "float", 5.0, meaning="where the given point is"),
        Parameter("y", "y", "float", 2.0, meaning="where the given point is"),
    ),
    arguments=pieces_and_point,
    emits="points",
    source="Chen et al., Computing the minimum distance between a point and a clamped B-spline curve, 2008",
    emitted_columns=("u", "x", "y", "distance"),
    columns=("piece", "from", "to", "bound", "best", "then"),
    views=(
        View(
            block="Begin with the closest end of a piece",
            sentence="The end of a piece closest to {(x, y)} is {(best_x, best_y)}, at u = {best_u}: its "
            "distance is {best}.",
        ),
        View(
            block=_BOX,
            when="searched",
            sentence="The box of piece {j} is {distance} from {(x, y)}, less than {best}: look into it.",
        ),
        View(
            block=_BOX,
            sentence="The box of piece {j} is {distance} from {(x, y)}; a point at distance "
            "{best} is known: skip it.",
        ),
        View(
            block=_PART,
            when="hopeless",
            row=_ROW,
            options=_OPTIONS,
            answer="'skip'",
            sentence=_FROM + ", and a point at distance {best} is known: skip it.",
        ),
        View(
            block=_PART,
            when="divided",
            row=_ROW,
            options=_OPTIONS,
            answer="'divide'",
            sentence=_FROM + ", less than {best}; it may have more than one minimum: divide it.",
        ),
        View(
            block=_PART,
            row=_ROW,
            options=_OPTIONS,
            answer="'search'",
            sentence=_FROM + ", less than {best}, and has one minimum: search for it.",
        ),
        View(
            block=_BOTTOM,
            when="distance < before.best",
            sentence="The search ends at {(at_x, at_y)}, at u = {best_u}: its distance, {distance}, is the "
            "least so far.",
        ),
        View(
            block=_BOTTOM,
            sentence="The search ends at {(at_x, at_y)}: its distance, {distance}, is no less than {best}.",
        ),
    ),
    laws=(
        Law(
            "No point of the curve is closer than the last one.",
            "curves/test_closest_point.py::test_no_sample_is_closer",
        ),
        Law(
            "Each point lies on the curve, at its u, and is closer than the one before.",
            "curves/test_closest_point.py::test_each_point_lies_on_the_curve_at_its_u",
        ),
    ),
    not_laws=(
        "Also beside weights a million apart: the last 10⁻⁹ of u at an end is not searched, and the curve "
        "may run farther than is seen within one step of u.",
    ),
    questions=(8,),
    labs=("Curves: Bézier",),
)
