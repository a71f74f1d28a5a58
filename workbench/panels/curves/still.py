"""What of a curve of very many points stays while a few of them are dragged, parted from what moves."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves import Pieces, polyline
from workbench.document.curves.pieces import goes_round
from workbench.document.model import Curve, Sheet
from workbench.panels.curves.scene import CURVE_INK, MANY
from workbench.panels.curves.shape import SMOOTH_PX, Array, device_pieces, device_points
from workbench.widgets.canvas.drawing import Drawn, PenStroke
from workbench.widgets.canvas.overlay import Handle, Still

# A piece that follows less than this share of the way stays where it is until the points are let go.
_FOLLOWS = 0.002


@dataclass(frozen=True, slots=True, eq=False)
class Parting:
    """``still`` is painted once; of the curve only the ``pieces`` (m,) and ``legs`` (n,) marked move."""

    still: Still
    pieces: NDArray[np.bool_]
    legs: NDArray[np.bool_]


def parted(
    sheet: Sheet,
    curve: Curve,
    moving: tuple[int, ...],
    strength: Array,
    below: list[Drawn],
    handles: list[Handle],
    polygon: bool,
) -> Parting | None:
    """The curve as it is when ``moving`` points are taken hold of; None when it is small enough without.

    ``strength`` (m,) is how far each piece follows, ``below`` what else is drawn, under the curve.
    """
    pieces = device_pieces(sheet, curve)
    count = len(curve.points_world)
    if count <= MANY or pieces is None or len(strength) != len(pieces.controls):
        return None
    follows = strength > _FOLLOWS
    legs = np.zeros(count, bool)
    if polygon and curve.spline != "bezier_path":
        for k in moving:
            legs[[(k - 1) % count, k]] = True
        below = [*below, *_legs(sheet, curve, ~legs)]
    held = {curve.points_world[k].id for k in with_handles(curve, moving)}
    staying = tuple(handle for handle in handles if handle.id.split("/")[2] not in held)
    still = Still((*below, *_runs(pieces, ~follows)), staying)
    return Parting(still, follows, legs)


def with_handles(curve: Curve, numbers: tuple[int, ...]) -> list[int]:
    """These points, and of a path the points and handles that may follow them."""
    if curve.spline != "bezier_path":
        return list(numbers)
    count = len(curve.points_world)
    near = {3 * ((k + 1) // 3) + side for k in numbers for side in (-1, 0, 1)}
    return sorted({k % count if curve.closed else k for k in near if curve.closed or 0 <= k < count})


def moving_part(sheet: Sheet, curve: Curve, parting: Parting) -> list[Drawn]:
    """The legs and pieces that follow, as they are now."""
    pieces = device_pieces(sheet, curve)
    if pieces is None or len(parting.pieces) != len(pieces.controls):
        return []
    return [*_legs(sheet, curve, parting.legs), *_runs(pieces, parting.pieces)]


def _legs(sheet: Sheet, curve: Curve, chosen: NDArray[np.bool_]) -> list[Drawn]:
    """The legs of the polygon that are chosen: leg k begins at point k, and the last closes a closed one."""
    points = device_points(sheet, curve)
    around = np.vstack([points, points[:1]]) if goes_round(curve) else points
    chosen = chosen[: len(around) - 1]
    return [PenStroke(around[a : b + 1], "muted", 1.0) for a, b in _spans(chosen)]


def _runs(pieces: Pieces, chosen: NDArray[np.bool_]) -> list[Drawn]:
    """The chosen pieces as lines."""
    drawn: list[Drawn] = []
    for a, b in _spans(chosen & (np.diff(pieces.knots) > 0)):
        weights = None if pieces.weights is None else pieces.weights[a:b]
        run = Pieces(pieces.knots[a : b + 1], pieces.controls[a:b], weights)
        drawn.append(PenStroke(polyline(run, SMOOTH_PX), CURVE_INK, 2.25))
    return drawn


def _spans(chosen: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Begin and end of each run of what is chosen."""
    edges = np.flatnonzero(np.diff(chosen.astype(np.int8), prepend=0, append=0)).tolist()
    return list(pairwise(edges))[::2]
