"""Curves that can be drawn, made by hypothesis, and whether two of them are the same."""

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from msgspec.structs import replace
from numpy.typing import NDArray

from tests.document.curves.made_curves import curves as made_curves
from workbench.algorithms import curves
from workbench.document.curves.pieces import fault_of, parameter_at, pieces_of, points_of
from workbench.document.model import Curve, Document
from workbench.document.samples.figures import document_of

KNOTTED = ("b_spline", "nurbs")
EXACT = ("bezier", "bezier_path", "b_spline", "nurbs")
shares = st.floats(0.01, 0.99) | st.sampled_from([0.25, 0.5])


@st.composite
def whole_curves(draw: st.DrawFn, kinds: tuple[str, ...] = (), opened: bool = False) -> Document:
    """A document with one curve that can be drawn, no free knot inside more often than its degree."""
    curve = draw(made_curves(draw(st.sampled_from(kinds)) if kinds else "", most=14))
    if opened:
        curve = replace(curve, closed=False, knot_rule="open_uniform", knots=(), degree=min(curve.degree, 3))
    assume(not fault_of(curve))
    values = [knot.u for knot in curve.knots]
    ends = () if curve.closed or not values else (values[curve.degree], values[-curve.degree - 1])
    assume(all(values.count(u) <= curve.degree or u in ends for u in set(values)))
    return document_of("Curve", 320, 200, [curve])


def dense(curve: Curve) -> NDArray[np.float64]:
    """Many points of a curve, in its order."""
    pieces = pieces_of(curve)
    return curves.piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], 401))


def off(curve: Curve, points: NDArray[np.float64]) -> float:
    """How far at most ``points`` are from a fine chain of chords of ``curve``, as a part of its size."""
    pieces = pieces_of(curve)
    size = max(float(np.abs(pieces.controls).max()), float(np.abs(points).max())) or 1.0
    chain = curves.polyline(pieces, 3e-7 * size)
    a, b = chain[:-1], chain[1:]
    way = b - a
    lengths = np.maximum((way * way).sum(axis=1), 1e-300)
    along = np.clip(((points[:, None] - a) * way).sum(axis=2) / lengths, 0.0, 1.0)
    gaps = points[:, None] - (a + along[..., None] * way)
    return float(np.sqrt((gaps * gaps).sum(axis=2).min(axis=1)).max()) / size


def same(one: Curve, other: Curve, tolerance: float = 1e-6) -> None:
    """Every point of each lies on the other one; both begin and end alike."""
    assert off(one, dense(other)[::8]) < tolerance
    assert off(other, dense(one)[::8]) < tolerance


def same_by_u(one: Curve, other: Curve) -> None:
    """Both are at the same place at every u, to a relative 1e-9."""
    size = float(np.abs(points_of(one)).max()) or 1.0
    assert float(np.abs(dense(one) - dense(other)).max()) <= 1e-9 * size


def parameter(curve: Curve, share: float) -> float:
    """A parameter that is not within rounding of a knot, but may be one."""
    u = parameter_at(curve, share)
    knots = pieces_of(curve).knots
    nearest = float(knots[np.abs(knots - u).argmin()])
    return nearest if abs(nearest - u) < 1e-4 * (knots[-1] - knots[0]) else u
