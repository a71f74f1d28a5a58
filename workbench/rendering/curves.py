"""Curves of the document as Bézier pieces (world) and as the lines that are drawn (device)."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.algorithms.curves.sections import Ends
from workbench.document.model import Curve, Sheet
from workbench.rendering.mapping import device_map

Array = NDArray[np.float64]


def points_of(curve: Curve) -> Array:
    """The control points (n, 2), world."""
    return np.array([(p.x, p.y) for p in curve.points_world], np.float64).reshape(-1, 2)


def weights_of(curve: Curve) -> Array:
    """The weight of each control point (n,)."""
    return np.array([p.weight for p in curve.points_world], np.float64)


def tangents_of(curve: Curve) -> Array:
    """The derivative by u at each point (n, 2), world."""
    return np.array([(p.tangent_x, p.tangent_y) for p in curve.points_world], np.float64).reshape(-1, 2)


def b_spline_of(curve: Curve) -> tuple[Array, Array, Array]:
    """Points (n, 2), knots and weights (n,) of the B-spline; a closed one has its first points once more.

    Raises: ValueError for too few points.
    """
    points, weights = points_of(curve), weights_of(curve)
    if curve.closed and curve.knot_rule != "free":
        around, knots = curves.closed_b_spline(np.column_stack([points, weights]), curve.degree)
        return around[:, :2], knots, around[:, 2]
    if curve.knot_rule == "free":
        return points, np.array([knot.u for knot in curve.knots]), weights
    made = curves.uniform_knots if curve.knot_rule == "uniform" else curves.open_uniform_knots
    return points, made(len(points), curve.degree), weights


@lru_cache(maxsize=256)
def pieces_of(curve: Curve, spline: str = "") -> Pieces:
    """The Bézier pieces, world, of a curve as it is or as one of another kind over the same points.

    Raises: ValueError with the sentence that says what is missing, as for too few points.
    """
    points = points_of(curve)
    ends: Ends = "closed" if curve.closed else "inner" if curve.ends == "inner" else "through"
    match spline or curve.spline:
        case "bezier":
            around = np.vstack([points, points[:1]]) if curve.closed else points
            return _bezier(around[None], np.array([0.0, 1.0]))
        case "bezier_path":
            return _path(points, curve.closed)
        case "b_spline":
            controls, knots, _weights = b_spline_of(curve)
            return curves.b_spline_to_bezier(controls, knots, curve.degree)
        case "nurbs":
            controls, knots, weights = b_spline_of(curve)
            whole = curves.b_spline_to_bezier(curves.homogeneous(controls, weights), knots, curve.degree)
            flat, pulls = curves.projected(whole.controls)
            return Pieces(whole.knots, flat, pulls)
        case "hermite":
            tangents = tangents_of(curve)
            if curve.closed:
                points, tangents = np.vstack([points, points[:1]]), np.vstack([tangents, tangents[:1]])
            return curves.hermite(points, tangents)
        case "natural_cubic":
            return curves.natural_cubic(points)
        case "clamped_cubic":
            tangents = tangents_of(curve)
            return curves.clamped_cubic(points, tangents[0], tangents[-1])
        case "periodic_cubic":
            return curves.periodic_cubic(points)
        case "cardinal":
            return curves.cardinal(points, curve.tension, ends)
        case "catmull_rom":
            return curves.catmull_rom(points, curve.alpha, ends)
        case _:
            return curves.kochanek_bartels(points, curve.tension, curve.continuity, curve.bias, ends)


def _bezier(controls: Array, knots: Array) -> Pieces:
    if controls.shape[1] < 2:
        raise ValueError("There is 1 point, and 2 are needed; add 1.")
    return Pieces(knots, controls)


def _path(points: Array, closed: bool) -> Pieces:
    """Cubic pieces over point, handle, handle, point; of a closed path the last ends at the first point."""
    count = len(points) // 3 if closed else (len(points) - 1) // 3
    if count < 1:
        missing = (3 if closed else 4) - len(points)
        raise ValueError(f"There are {len(points)} points, and a piece needs {missing} more; add {missing}.")
    at = 3 * np.arange(count)[:, None] + np.arange(4)
    return Pieces(np.arange(count + 1.0), points[at % len(points) if closed else at])


def fault_of(curve: Curve, spline: str = "") -> str:
    """The sentence that says why there is no such curve yet; empty when there is one."""
    try:
        pieces_of(curve, spline)
    except ValueError as problem:
        return str(problem)
    return ""


def polyline_of(sheet: Sheet, curve: Curve, spline: str = "", tolerance_px: float | None = None) -> Array:
    """The corners (n, 2), device coordinates, of the lines that stand for a curve; none where there is none.

    No point of the curve is farther from them than the tolerance, in pixels; by default the curve's own.
    """
    if fault_of(curve, spline):
        return np.empty((0, 2))
    scale = device_map(sheet)
    knots, controls, weights = pieces_of(curve, spline)
    device = controls * np.array([scale.sx, scale.sy]) + np.array([scale.tx, scale.ty])
    return curves.polyline(Pieces(knots, device, weights), tolerance_px or curve.tolerance_px)
