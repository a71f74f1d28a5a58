"""Each crossing of a curve with itself once: what several pairs of its parts tell of is one."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.halving import lengths
from workbench.geometry.curves.newton_crossings import Crossing
from workbench.geometry.curves.pieces import Pieces, piece_points

# Of the shortest piece: crossings nearer to each other than that are one, if they are in one place too
_APART = 0.01
# The same, if the curve stays in one place with itself from one to the other
_TOUCH = 0.1


def different_crossings(
    pieces: Pieces, crossings: list[Crossing], tolerance: float, short: float
) -> list[Crossing]:
    """The crossings in the order of u, each once, and each touch once."""
    ordered = sorted(crossings, key=lambda crossing: crossing[:2])
    kept: list[Crossing] = []
    for k in np.flatnonzero(~_touching(pieces, ordered, ordered[1:], tolerance, short)):
        u, v, point = ordered[k]
        near = [other for other in kept if max(u - other[0], abs(v - other[1])) <= _TOUCH * short]
        known = any(
            max(u - other_u, abs(v - other_v)) <= _APART * short
            and np.abs(point - other).max() <= 4.0 * tolerance
            for other_u, other_v, other in near
        )
        if not near or not (
            known or _touching(pieces, near, [ordered[k]] * len(near), tolerance, short).any()
        ):
            kept.append(ordered[k])
    return kept


def _touching(
    pieces: Pieces, some: list[Crossing], others: list[Crossing], tolerance: float, short: float
) -> NDArray[np.bool_]:
    """Of each crossing, whether the curve is in one place with itself all the way to the other one."""
    to = np.array([crossing[:2] for crossing in others]).reshape(-1, 2)
    at = np.array([crossing[:2] for crossing in some]).reshape(-1, 2)
    way = to - at[: len(to)]
    touching = np.zeros(len(at), bool)
    near = np.flatnonzero(np.abs(way).max(axis=1, initial=0.0) <= _TOUCH * short)
    u, v = (at[near, None] + way[near, None] * np.linspace(0.0, 1.0, 5)[:, None]).transpose(2, 0, 1)
    touching[near] = lengths(piece_points(pieces, u) - piece_points(pieces, v)).max(axis=1) <= tolerance
    return touching
