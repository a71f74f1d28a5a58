"""Circles and ellipses under their chains: what is drawn of them, and why.

A circle stays one under moves, turns, reflections and equal scaling, an ellipse while its axes lie along x
and y. Whatever else a chain makes of them is drawn as its exact curve, four rational quadratics, flattened:
an outline by a line algorithm, an area by that of polygons.
"""

import math
from typing import TypeGuard

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import Pieces
from workbench.document.model import AnyFigure, Circle, Curve, Ellipse, Line, Polygon, Polyline
from workbench.document.transforms.expressing import axes_stay, radii_under, stays_circle
from workbench.language import _

Array = NDArray[np.float64]
Round = Circle | Ellipse
Lines = Line | Polyline | Curve | Round
"""What is drawn as lines: of circles and ellipses outlines that do not stay round."""
Area = Polygon | Round
"""What is drawn as an area with corners: of circles and ellipses filled ones that do not stay round."""

_S = math.sqrt(0.5)
# A quarter of the unit circle after the other, counter-clockwise, with the weights of its control points.
_CORNERS = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], float)
_QUARTERS = _CORNERS[2 * np.arange(4)[:, None] + np.arange(3)]
_WEIGHTS = np.tile([1.0, _S, 1.0], (4, 1))


def is_lines(figure: AnyFigure) -> TypeGuard[Lines]:
    """Whether lines are what is scan converted of a figure."""
    return isinstance(figure, Line | Polyline | Curve) or (
        isinstance(figure, Circle | Ellipse) and not stays_round(figure) and not _is_filled(figure)
    )


def is_area(figure: AnyFigure) -> TypeGuard[Area]:
    """Whether an area with corners is what is scan converted of a figure."""
    return isinstance(figure, Polygon) or (
        isinstance(figure, Circle | Ellipse) and not stays_round(figure) and _is_filled(figure)
    )


def _is_filled(figure: Round) -> bool:
    return catalogue.get(figure.drawn_with).emits == "spans"


def stays_round(figure: Round) -> bool:
    """Whether the algorithms of its kind can draw what the chain makes of a circle or ellipse."""
    if figure.matrix is None:
        return True
    if isinstance(figure, Circle):
        return stays_circle(figure.matrix, figure.radius_world)
    return axes_stay(figure.matrix, *figure.radii_world)


def radii_of(figure: AnyFigure) -> tuple[float, float]:
    """Radii along x and y, world, of what the chain makes of one that stays round; 0 where it has none."""
    if figure.matrix is None:
        return figure.radii_world
    return figure.with_radii(*radii_under(figure.matrix, *figure.radii_world)).radii_world


def reason(figure: AnyFigure) -> str:
    """The sentence that says why a figure is not drawn by its own algorithm; empty where it is."""
    if not isinstance(figure, Circle | Ellipse) or stays_round(figure):
        return ""
    if isinstance(figure, Circle):
        text = _("The transforms turn this circle into an ellipse, so its exact curve is drawn as {parts}.")
    else:
        text = _("The transforms rotate this ellipse's axes, so its exact curve is drawn as {parts}.")
    return text.format(parts=_("a filled polygon") if is_area(figure) else _("short lines"))


def pieces_of_round(figure: Round) -> Pieces:
    """The exact curve before the chain, counter-clockwise from the right: rational quadratics, world."""
    centre = figure.points_world[0]
    controls = _QUARTERS * figure.radii_world + (centre.x, centre.y)
    return Pieces(np.arange(5.0), controls, _WEIGHTS)
