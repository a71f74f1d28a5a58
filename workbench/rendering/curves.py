"""Curves of the document as the lines that are drawn, device."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curve_pieces import (
    b_spline_of,
    fault_of,
    pieces_of,
    points_of,
    tangents_of,
    weights_of,
)
from workbench.document.model import Curve, Sheet
from workbench.rendering.mapping import device_map

__all__ = [
    "b_spline_of",
    "device_pieces",
    "fault_of",
    "pieces_of",
    "points_of",
    "polyline_of",
    "tangents_of",
    "weights_of",
]

Array = NDArray[np.float64]


def device_pieces(sheet: Sheet, curve: Curve, spline: str = "") -> Pieces:
    """The Bézier pieces of a curve, device coordinates. Raises: ValueError as ``pieces_of``."""
    scale = device_map(sheet)
    knots, controls, weights = pieces_of(curve, spline)
    device = controls * np.array([scale.sx, scale.sy]) + np.array([scale.tx, scale.ty])
    return Pieces(knots, device, weights)


def polyline_of(sheet: Sheet, curve: Curve, spline: str = "", tolerance_px: float | None = None) -> Array:
    """The corners (n, 2), device coordinates, of the lines that stand for a curve; none where there is none.

    No point of the curve is farther from them than the tolerance, in pixels; by default the curve's own.
    """
    if fault_of(curve, spline):
        return np.empty((0, 2))
    return curves.polyline(device_pieces(sheet, curve, spline), tolerance_px or curve.tolerance_px)
