"""Curves in device coordinates as the panel draws and grabs them: their pieces, points and nearest places."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves import Pieces, piece_points
from workbench.document.curves.pieces import points_of
from workbench.document.model import TANGENT_SPLINES, Curve, Sheet
from workbench.rendering import curves, figure_map

Array = NDArray[np.float64]

SMOOTH_PX = 0.02
# A Hermite tangent is drawn at this share of its length, which makes it a handle of the Bézier piece.
TANGENT_SHARE = 1 / 3


def device_pieces(sheet: Sheet, curve: Curve, spline: str = "") -> Pieces | None:
    """The pieces of a curve, device coordinates; None while something is missing for it."""
    try:
        return curves.device_pieces(sheet, curve, spline)
    except ValueError:
        return None


def device_points(sheet: Sheet, curve: Curve) -> Array:
    """The control points (n, 2), device coordinates."""
    return figure_map(sheet, curve).points(points_of(curve))


def smooth_line(sheet: Sheet, curve: Curve, spline: str = "") -> Array:
    """The curve (n, 2), device coordinates, so close to it that nobody sees a corner; empty without one."""
    return curves.polyline_of(sheet, curve, spline, SMOOTH_PX)


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
    """The share 0 to 1 of the parameter whose point is nearest to (x, y), and its distance, by sampling."""
    count = max(24, min(4000, 16 * len(pieces.controls)))
    shares, line = _samples(curves.Same(pieces), count)
    start, along = line[:-1], np.diff(line, axis=0)
    square = np.maximum((along**2).sum(axis=1), 1e-300)
    part = np.clip((((x, y) - start) * along).sum(axis=1) / square, 0.0, 1.0)
    away = np.hypot(*((x, y) - start - part[:, None] * along).T)
    at = int(away.argmin())
    return float(shares[at] + part[at] * (shares[at + 1] - shares[at])), float(away[at])


@lru_cache(maxsize=8)
def _samples(key: curves.Same, count: int) -> tuple[Array, Array]:
    knots = key.pieces.knots
    shares = np.linspace(0.0, 1.0, count + 1)
    return shares, piece_points(key.pieces, knots[0] + shares * (knots[-1] - knots[0]))
