"""What is measured on a curve, drawn on the canvas: tangent, comb, circle, extrema, box, equal steps."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces, piece_points
from workbench.algorithms.marks import Word
from workbench.algorithms.numerals import with_minus
from workbench.document.curves.pieces import parameter_at
from workbench.document.model import Curve, Sheet
from workbench.panels.curves.crossings import crossing_marks
from workbench.panels.curves.shape import device_pieces, device_points
from workbench.widgets.canvas.drawing import Drawn, Marker, PenStroke, Tint

Array = NDArray[np.float64]

COMB_TEETH = 24
COMB_CELLS = 0.1
MOST_TEETH = 1600
MOST_MARKS = 400
STEPS = 16
_FAR = 40.0


def marks(sheet: Sheet, curve: Curve, shown: frozenset[str], share: float) -> list[Drawn]:
    """Everything of ``shown`` that is measured on the curve, from back to front; none without a curve."""
    pieces = device_pieces(sheet, curve)
    if pieces is None:
        return []
    u = parameter_at(curve, share)
    drawn: list[Drawn] = []
    if "hull" in shown:
        drawn += hull(device_points(sheet, curve))
    if "box" in shown:
        drawn += box(pieces)
    if "comb" in shown:
        drawn += comb(pieces, math.hypot(sheet.width_px, sheet.height_px))
    if "circle" in shown:
        drawn += circle(pieces, u)
    if "tangent" in shown:
        drawn += tangent(pieces, u)
    if "extrema" in shown:
        drawn += extrema(pieces)
    if "inflections" in shown:
        drawn += inflections(pieces)
    if "crossings" in shown:
        drawn += crossing_marks(pieces)
    if "steps_u" in shown:
        drawn += steps_of_u(pieces)
    if "steps_length" in shown:
        drawn += steps_of_length(pieces)
    return drawn


def hull(points: Array) -> list[Drawn]:
    """The convex hull of the control points, in which a Bézier curve or B-spline stays."""
    corners = curves.convex_hull(points)
    if len(corners) < 3:
        return []
    around = np.vstack([corners, corners[:1]])
    return [Tint(corners, "data3", 28), PenStroke(around, "data3", 1.25, "dash")]


def box(pieces: Pieces) -> list[Drawn]:
    """The smallest box with sides along x and y."""
    (x0, y0), (x1, y1) = (side.tolist() for side in curves.bounding_box(pieces))
    around = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])
    said = Word(f"{x1 - x0:.4g} \N{MULTIPLICATION SIGN} {y1 - y0:.4g}", x1, y0, "muted", -1, -1)
    return [PenStroke(around, "muted", 1.25, "dot"), said]


def comb(pieces: Pieces, size: float) -> list[Drawn]:
    """Teeth across the curve, the longer the more it bends; a usual one is a share of ``size``."""
    each = max(2, min(COMB_TEETH, MOST_TEETH // len(pieces.controls)))
    bends = curves.curvature_comb(pieces, each, 1.0)
    begins, way = bends[..., 0, :], bends[..., 1, :] - bends[..., 0, :]
    lengths = np.hypot(way[..., 0], way[..., 1])
    usual = float(np.percentile(lengths, 96)) if lengths.size else 0.0
    if usual <= 0.0:
        return []
    longest = COMB_CELLS * size
    scale = np.minimum(longest / usual, 1.6 * longest / np.maximum(lengths, 1e-12))
    ends = begins + scale[..., None] * way
    # One line there and back again for all the teeth of a piece; lines of one style are painted at once.
    teeth = np.stack([begins, ends, begins], axis=2).reshape(len(begins), -1, 2)
    drawn: list[Drawn] = [PenStroke(line, "muted", 0.75) for line in teeth]
    return [*drawn, *(PenStroke(line, "text", 1.5) for line in ends)]


def circle(pieces: Pieces, u: float) -> list[Drawn]:
    """The osculating circle at u, with its radius."""
    centre, radius = curves.osculating_circle(pieces, u)
    x, y = piece_points(pieces, u).tolist()
    if not math.isfinite(radius) or radius > 4000:
        return []
    angle = np.linspace(0.0, math.tau, 181)
    around = centre + radius * np.column_stack([np.cos(angle), np.sin(angle)])
    cx, cy = centre.tolist()
    return [
        PenStroke(around, "data5", 1.5, "dash"),
        PenStroke(np.array([(cx, cy), (x, y)]), "data5", 1.0),
        Marker(cx, cy, "data5", "cross", 8),
        Word(f"r = {radius:.4g}", cx, cy, "text", 0, -1, carded=True),
        Marker(x, y, "data5", "dot", 7),
    ]


def tangent(pieces: Pieces, u: float) -> list[Drawn]:
    """The derivative by u at the point, as an arrow a third of its length, which is the handle's."""
    (x, y), (dx, dy) = curves.derivatives(pieces, u, 1).tolist()
    length = math.hypot(dx, dy)
    # Of a part without meaning beside the other 0 is shown.
    said_x, said_y = (part if abs(part) > 1e-9 * length else 0.0 for part in (dx, dy))
    if length <= 0.0:
        return [Marker(x, y, "data2", "cross", 9)]
    shown = min(length / 3, _FAR) / length
    tip = np.array([x + dx * shown, y + dy * shown])
    along, across = np.array([dx, dy]) / length, np.array([-dy, dx]) / length
    barb = np.array([tip - 1.1 * along + 0.45 * across, tip, tip - 1.1 * along - 0.45 * across])
    angle = math.degrees(math.atan2(dy, dx))
    words = with_minus(f"C′ = ({said_x:.4g}, {said_y:.4g}), {angle:.0f}°")
    return [
        PenStroke(np.array([(x, y), tip]), "data2", 2.0, haloed=True),
        PenStroke(barb, "data2", 2.0),
        Marker(x, y, "data2", "dot", 7),
        Word(words, tip[0], tip[1], "text", 1, 1, carded=True),
    ]


def extrema(pieces: Pieces) -> list[Drawn]:
    """Where the curve turns back in x (upright stroke) or in y (level stroke)."""
    drawn: list[Drawn] = []
    for _u, axis, point in curves.extrema(pieces)[:MOST_MARKS]:
        x, y = point.tolist()
        half = (0.0, 1.2) if axis == 0 else (1.2, 0.0)
        drawn.append(
            PenStroke(np.array([(x - half[0], y - half[1]), (x + half[0], y + half[1])]), "data1", 2.0)
        )
        drawn.append(Marker(x, y, "data1", "square", 6))
    return drawn


def inflections(pieces: Pieces) -> list[Drawn]:
    """Where the curve changes the side it bends to."""
    at = piece_points(pieces, curves.inflections(pieces)[:MOST_MARKS]).reshape(-1, 2)
    return [Marker(x, y, "data4", "ring", 11) for x, y in at.tolist()]


def steps_of_u(pieces: Pieces) -> list[Drawn]:
    """Points at equal steps of the parameter."""
    at = piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], STEPS + 1))
    return [Marker(x, y, "data2", "ring", 9) for x, y in at.tolist()]


def steps_of_length(pieces: Pieces) -> list[Drawn]:
    """As many points at equal steps of the length."""
    at = piece_points(pieces, curves.equal_lengths(pieces, STEPS + 1))
    return [Marker(x, y, "data3", "square", 7) for x, y in at.tolist()]
