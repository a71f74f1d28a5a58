"""What the canvas shows of curves: the smooth curve, its polygon, other kinds, the place at u, influence."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import marks
from workbench.algorithms.curves import Pieces, piece_points, polyline
from workbench.document.curves.pieces import goes_round, parameter_at, pieces_of
from workbench.document.model import Curve, Sheet
from workbench.panels.curves.names import look_of, point_name
from workbench.panels.curves.shape import (
    SMOOTH_PX,
    device_pieces,
    device_points,
    smooth_line,
    tangent_ends,
)
from workbench.widgets.canvas.drawing import Drawn, PenStroke

Array = NDArray[np.float64]

CURVE_INK = "accent"
MOST_NAMED = 24
MOST_HANDLES = 60
# Of more corners neither halo nor dashes can be told apart, and both take time.
MANY = 400


def others(sheet: Sheet, active: Curve | None) -> list[Drawn]:
    """The curves that are not worked on, thin."""
    lines = [
        smooth_line(sheet, figure)
        for figure in sheet.figures
        if isinstance(figure, Curve) and figure.visible and figure is not active
    ]
    return [PenStroke(line, "muted", 1.25) for line in lines if len(line)]


def beside(sheet: Sheet, curve: Curve) -> list[Drawn]:
    """The other kinds over the same points, each in its colour and pattern."""
    drawn: list[Drawn] = []
    for spline in curve.beside:
        line = smooth_line(sheet, curve, spline) if spline != curve.spline else ()
        if len(line):
            ink, pattern = look_of(spline)
            drawn.append(PenStroke(np.asarray(line), ink, 1.75, pattern))
    return drawn


def curve_line(sheet: Sheet, curve: Curve) -> list[Drawn]:
    """The curve itself."""
    line = smooth_line(sheet, curve)
    return [PenStroke(line, CURVE_INK, 2.25, haloed=len(line) < MANY)] if len(line) else []


def control_polygon(sheet: Sheet, curve: Curve, numbers: Sequence[int] = ()) -> list[Drawn]:
    """The legs between the control points, or of a path the handles of the points that are shown.

    ``numbers`` are the chosen points: of a long path only their handles are drawn.
    """
    points = device_points(sheet, curve)
    drawn: list[Drawn] = []
    if curve.spline == "bezier_path":
        shown = handles_shown(curve, numbers)
        for k in np.flatnonzero(shown).tolist():
            anchor = anchor_of(curve, k)
            if k % 3 and anchor is not None:
                drawn.append(PenStroke(points[[anchor, k]], "muted", 1.0))
        return drawn
    if len(points) > 1:
        legs = np.vstack([points, points[:1]]) if goes_round(curve) else points
        drawn.append(PenStroke(legs, "muted", 1.0, "dash" if len(legs) < MANY else "solid"))
    for k, end in tangent_ends(sheet, curve).items():
        drawn.append(PenStroke(np.array([points[k], end]), "data5", 1.25))
    return drawn


def anchor_of(curve: Curve, index: int) -> int | None:
    """The point of a path that a handle belongs to; None when it is not there yet."""
    count = len(curve.points_world)
    near = index if index % 3 == 0 else index - 1 if index % 3 == 1 else index + 1
    if near >= count:
        return 0 if curve.closed and count % 3 == 0 else None
    return near


def handles_shown(curve: Curve, numbers: Sequence[int]) -> NDArray[np.bool_]:
    """Which control points can be seen: of a long path only the handles beside the chosen points."""
    count = len(curve.points_world)
    shown = np.ones(count, bool)
    if curve.spline == "bezier_path" and count > MOST_HANDLES:
        shown = np.arange(count) % 3 == 0
        for k in numbers:
            near = np.arange(k - 4, k + 5)
            shown[near % count if curve.closed else near[(near >= 0) & (near < count)]] = True
    return shown


def names(sheet: Sheet, curve: Curve) -> list[Drawn]:
    """What the points are called, each on the side away from the others; none where there are too many."""
    points = device_points(sheet, curve)
    if len(points) > MOST_NAMED:
        return []
    middle = points.mean(axis=0)
    drawn: list[Drawn] = []
    for k, (x, y) in enumerate(points.tolist()):
        right, up = (1 if x >= middle[0] else -1), (1 if y >= middle[1] else -1)
        if k % 3 == 0 or curve.spline != "bezier_path":
            drawn.append(marks.Word(point_name(curve, k), x, y, "muted", right, up))
    return drawn


# The place at the parameter u


def place_at(sheet: Sheet, curve: Curve, share: float) -> list[Drawn]:
    """The point of the curve at a share of its parameter, which can be dragged, with its name."""
    place = point_at(sheet, curve, share)
    if place is None:
        return []
    name = f"C({parameter_at(curve, share):.4g})"
    return [
        marks.Spot(*place, "text", "ring", "large"),
        marks.Word(name, *place, "text", 1, 1, carded=True, strong=True),
    ]


def point_at(sheet: Sheet, curve: Curve, share: float) -> tuple[float, float] | None:
    """The point of the curve at a share of its parameter, device coordinates."""
    pieces = device_pieces(sheet, curve)
    if pieces is None:
        return None
    x, y = piece_points(pieces, parameter_at(curve, share)).tolist()
    return x, y


# What a point moves


def influence(curve: Curve, numbers: tuple[int, ...]) -> Array:
    """How far each piece (m,) of a curve follows these points, as a share of their way: 0 not at all.

    The curve itself is asked, with the points moved a little, so it holds for every kind.
    """
    moved = list(curve.points_world)
    for k in numbers:
        moved[k] = replace(moved[k], x=moved[k].x + 1e-3)
    try:
        one, other = pieces_of(curve), pieces_of(replace(curve, points_world=tuple(moved)))
    except ValueError:
        return np.zeros(0)
    if one.controls.shape != other.controls.shape:
        return np.ones(len(other.controls))
    way: Array = np.sqrt(((other.controls - one.controls) ** 2).sum(axis=-1)).max(axis=1) / 1e-3
    return np.where(way < 1e-6, 0.0, np.minimum(way, 1.0))


def region(sheet: Sheet, curve: Curve, strength: Array) -> list[PenStroke]:
    """The pieces that follow what is moved, the wider the more they follow."""
    pieces = device_pieces(sheet, curve)
    if pieces is None or len(strength) != len(pieces.controls):
        return []
    # Few widths, so that pieces side by side are one line, and lines of one width are painted at once
    widths = np.where(strength > 0.002, 7.0 + 2.0 * np.ceil(4.0 * strength), 0.0)
    widths[np.diff(pieces.knots) <= 0] = 0.0
    edges = np.flatnonzero(np.diff(widths, prepend=-1.0, append=-1.0))
    drawn: list[PenStroke] = []
    for first, end in pairwise(edges.tolist()):
        if widths[first] > 0:
            weights = None if pieces.weights is None else pieces.weights[first:end]
            run = Pieces(pieces.knots[first : end + 1], pieces.controls[first:end], weights)
            drawn.append(PenStroke(polyline(run, SMOOTH_PX), "data5", float(widths[first])))
    return sorted(drawn, key=lambda stroke: stroke.width)
