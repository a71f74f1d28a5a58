"""The basis functions of a curve for plotting: how much of each control point the curve takes at each u."""

from dataclasses import dataclass

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.curves import basis_table, bernstein, piece_points
from workbench.document.curves.pieces import b_spline_of, pieces_of
from workbench.document.model import B_SPLINES, Curve
from workbench.panels.curves.names import is_handle, point_name

Array = NDArray[np.float64]

SAMPLES = 241
MOST = 24
_SMALL = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Basis:
    """``values`` (m, n) at the parameters ``us`` (m,); ``numbers`` are those of the n control points shown.

    ``knots`` are (id, u), ids beginning with # where the rule makes them; ``domain`` is where the curve is.
    """

    us: Array
    values: Array
    names: tuple[str, ...]
    numbers: tuple[int, ...]
    knots: tuple[tuple[str, float], ...]
    domain: tuple[float, float] | None
    weights: tuple[float, ...]


NOTHING = Basis(np.zeros(0), np.zeros((0, 0)), (), (), (), None, ())


def knot_names(curve: Curve) -> tuple[str, ...]:
    """The knots of a B-spline: each by its id, or by # and its number where a rule makes it."""
    _around, knots, _weights = b_spline_of(curve)
    ids = [knot.id for knot in curve.knots]
    return tuple(ids[k] if k < len(ids) else f"#{k}" for k in range(len(knots)))


def basis_of(curve: Curve, share: float) -> Basis:
    """The functions of a curve; of very many those around the parameter at ``share``.

    Those of a Bézier curve are Bernstein's, those of a B-spline are of its knots, rational ones of the
    weights too; of every other kind they are measured: how far the curve follows the point.
    """
    try:
        pieces = pieces_of(curve)
    except ValueError:
        return NOTHING
    first, last = float(pieces.knots[0]), float(pieces.knots[-1])
    us = np.linspace(first, last, SAMPLES)
    count = len(curve.points_world)
    if curve.spline == "bezier":
        degree = count if curve.closed else count - 1
        values = _wrapped(bernstein(degree, us), count)
        return _chosen(curve, us, values, "B", (), None, share)
    if curve.spline in B_SPLINES:
        _around, knots, weights = b_spline_of(curve)
        values = basis_table(knots, curve.degree, us, weights if curve.spline == "nurbs" else None)
        named = tuple(zip(knot_names(curve), knots.tolist(), strict=True))
        shown = _wrapped(values, count)
        return _chosen(curve, us, shown, "R" if curve.spline == "nurbs" else "N", named, (first, last), share)
    knots_shown = tuple((f"#{k}", float(u)) for k, u in enumerate(pieces.knots.tolist()))
    numbers = _near(curve, share)
    places = piece_points(pieces, us)
    values = np.column_stack([_followed(curve, k, us, places) for k in numbers])
    names = tuple(_label(curve, k, "w") for k in numbers)
    return Basis(us, values, names, numbers, knots_shown, None, ())


def _wrapped(values: Array, count: int) -> Array:
    """The functions of points that come once more at the end of a closed curve added to the first ones."""
    made = values[:, :count].copy()
    for k in range(count, values.shape[1]):
        made[:, k % count] += values[:, k]
    return made


def _near(curve: Curve, share: float) -> tuple[int, ...]:
    """The numbers of at most ``MOST`` points, those around the place at ``share``."""
    count = len(curve.points_world)
    if count <= MOST:
        return tuple(range(count))
    middle = round(share * (count - 1))
    begin = min(max(middle - MOST // 2, 0), count - MOST)
    return tuple(range(begin, begin + MOST))


def _chosen(
    curve: Curve,
    us: Array,
    values: Array,
    letter: str,
    knots: tuple[tuple[str, float], ...],
    domain: tuple[float, float] | None,
    share: float,
) -> Basis:
    numbers = _near(curve, share)
    names = tuple(_label(curve, k, letter) for k in numbers)
    weights: tuple[float, ...] = ()
    if curve.spline == "nurbs":
        weights = tuple(curve.points_world[k].weight for k in numbers)
    return Basis(us, values[:, list(numbers)], names, numbers, knots, domain, weights)


def _label(curve: Curve, number: int, letter: str) -> str:
    return f"{letter}_{{{point_name(curve, number)[1:]}}}" + ("'" if is_handle(curve, number) else "")


def _followed(curve: Curve, number: int, us: Array, places: Array) -> Array:
    """How far the curve, at ``places`` (m, 2) at the parameters ``us`` (m,), follows a point that is moved a
    little, as a share of its way.
    """
    point = curve.points_world[number]
    size = max(1.0, abs(point.x)) * _SMALL
    moved = list(curve.points_world)
    moved[number] = replace(point, x=point.x + size)
    after = pieces_of(replace(curve, points_world=tuple(moved)))
    # A kind that is chordal in its parameter gets another range of it
    stretched = np.interp(us, us[[0, -1]], after.knots[[0, -1]])
    way = (piece_points(after, stretched) - places)[:, 0] / size
    return np.where(np.abs(way) < 1e-9, 0.0, way)
