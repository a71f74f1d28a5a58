"""Curves in device coordinates as the panel draws and grabs them: their pieces, points and nearest places."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curves.pieces import points_of
from workbench.document.model import TANGENT_SPLINES, AnyFigure, Curve, Sheet
from workbench.rendering import curves as drawn_curves
from workbench.rendering import figure_map

Array = NDArray[np.float64]

SMOOTH_PX = 0.02
# A Hermite tangent is drawn at this share of its length, which makes it a handle of the Bézier piece.
TANGENT_SHARE = 1 / 3


def device_pieces(sheet: Sheet, curve: Curve, spline: str = "") -> Pieces | None:
    """The pieces of a curve, device coordinates; None while something is missing for it."""
    try:
        return drawn_curves.device_pieces(sheet, curve, spline)
    except ValueError:
        return None


def device_points(sheet: Sheet, curve: Curve) -> Array:
    """The control points (n, 2), device coordinates."""
    return figure_map(sheet, curve).points(points_of(curve))


def smooth_line(sheet: Sheet, curve: Curve, spline: str = "") -> Array:
    """The curve (n, 2), device coordinates, so close to it that nobody sees a corner; empty without one."""
    return drawn_curves.polyline_of(sheet, curve, spline, SMOOTH_PX)


def prepare(sheet: Sheet, figure: AnyFigure) -> None:
    """Have the smooth line of a curve at hand."""
    if isinstance(figure, Curve):
        smooth_line(sheet, figure)


def has_tangent(curve: Curve, index: int) -> bool:
    """Whether the derivative at a point is given and may be dragged."""
    if curve.spline not in TANGENT_SPLINES:
        return False
    return curve.spline == "hermite" or index in (0, len(curve.points_world) - 1)


def tangent_ends(sheet: Sheet, curve: Curve) -> dict[int, tuple[float, float]]:
    """For each point with a tangent the end of its handle, device coordinates."""
    if curve.spline not in TANGENT_SPLINES:
        return {}
    scale = figure_map(sheet, curve)
    return {
        k: scale.point(p.x + TANGENT_SHARE * p.tangent_x, p.y + TANGENT_SHARE * p.tangent_y)
        for k, p in enumerate(curve.points_world)
        if has_tangent(curve, k)
    }


def nearest_share(pieces: Pieces, x: float, y: float) -> tuple[float, float]:
    """The share 0 to 1 of the parameter whose point is nearest to (x, y), and its distance."""
    u, away = curves.closest_place(pieces, (x, y))
    begin, end = pieces.knots[0], pieces.knots[-1]
    return float((u - begin) / (end - begin)), away
