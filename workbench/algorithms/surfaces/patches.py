"""Tensor product surfaces in Bézier patches, which every Bézier and B-spline surface becomes.

A control net is (rows, columns, 3): u goes down the rows, v along the columns.
Source: Hearn and Baker, Computer Graphics, C Version, sections 10-8 and 10-11; The NURBS Book, chapter 4.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.blossom import b_spline_to_bezier
from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.rational import homogeneous

Array = NDArray[np.float64]


class Patches(NamedTuple):
    """A grid of Bézier patches in homogeneous points.

    ``u_knots`` (m+1,), ``v_knots`` (n+1,): patch (i, j) lies from knot i to i + 1 and from knot j to j + 1.
    ``nets`` (m, n, p+1, q+1, 4): its control points (w x, w y, w z, w); plain surfaces have the weight 1.
    """

    u_knots: Array
    v_knots: Array
    nets: Array


def bezier_patch(net: ArrayLike, weights: ArrayLike | None = None) -> Patches:
    """The one patch over a control net (p+1, q+1, 3), u and v from 0 to 1; ``weights`` (p+1, q+1) above 0.

    Raises: ValueError for a net or weights of another shape, or numbers that are not finite.
    """
    whole = _lifted(net, weights)
    return Patches(np.array([0.0, 1.0]), np.array([0.0, 1.0]), whole[None, None])


def b_spline_patch(
    net: ArrayLike,
    u_knots: ArrayLike,
    v_knots: ArrayLike,
    degrees: tuple[int, int] = (3, 3),
    weights: ArrayLike | None = None,
) -> Patches:
    """The patches of a B-spline surface over a control net (a, b, 3), one for each pair of full knot spans.

    Args: a + p + 1 and b + q + 1 knots for ``degrees`` (p, q); ``weights`` (a, b) above 0 make it a NURBS.
    Raises: ValueError for what does not fit together.
    """
    whole = _lifted(net, weights)
    p, q = degrees
    along_u = b_spline_to_bezier(whole.reshape(len(whole), -1), u_knots, p)
    m = len(along_u.controls)
    columns = np.moveaxis(along_u.controls.reshape(m, p + 1, -1, 4), 2, 0)
    along_v = b_spline_to_bezier(columns.reshape(len(columns), -1), v_knots, q)
    nets = along_v.controls.reshape(-1, q + 1, m, p + 1, 4)
    return Patches(along_u.knots, along_v.knots, np.ascontiguousarray(nets.transpose(2, 0, 3, 1, 4)))


def _lifted(net: ArrayLike, weights: ArrayLike | None) -> Array:
    """The control net (a, b, 4) in homogeneous points."""
    points = np.asarray(net, float)
    if points.ndim != 3 or points.shape[-1] != 3 or min(points.shape[:2]) < 2:
        raise ValueError("A control net has 2 rows or more of 2 points or more; give each x, y and z.")
    flat = points.reshape(-1, 3)
    refuse(faults(flat))
    pulls = np.ones(len(flat)) if weights is None else np.asarray(weights, float).reshape(-1)
    return homogeneous(flat, pulls).reshape(*points.shape[:2], 4)
