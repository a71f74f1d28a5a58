"""Curves, and circles and ellipses that do not stay round, as the lines that are drawn, device."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.model import Curve, Sheet
from workbench.memory import Memory
from workbench.rendering.mapping import PlaneMap, figure_map
from workbench.rendering.rounds import Round, pieces_of_round

Array = NDArray[np.float64]

ROUND_TOLERANCE_PX = 0.05
"""Largest distance between a circle or ellipse that does not stay round and the lines that stand for it."""


class Same:
    """Pieces as a key of a cache, equal when they are the same object."""

    __slots__ = ("pieces",)

    def __init__(self, pieces: Pieces) -> None:
        self.pieces = pieces

    def __hash__(self) -> int:
        return id(self.pieces.controls)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.pieces.controls is other.pieces.controls


def device_pieces(sheet: Sheet, curve: Curve, spline: str = "") -> Pieces:
    """The Bézier pieces of a curve, device coordinates; remembered. Raises: ValueError as ``pieces_of``."""
    return _device(Same(pieces_of(curve, spline)), figure_map(sheet, curve))


@lru_cache(maxsize=64)
def _device(key: Same, scale: PlaneMap) -> Pieces:
    return key.pieces._replace(controls=scale.points(key.pieces.controls))


def polyline_of(sheet: Sheet, curve: Curve, spline: str = "", tolerance_px: float | None = None) -> Array:
    """The corners (n, 2), device coordinates, of the lines that stand for a curve; none where there is none.

    No point of the curve is farther from them than the tolerance, in pixels; by default the curve's own.
    Read-only and remembered.
    """
    key = figure_map(sheet, curve), curve, spline, tolerance_px or curve.tolerance_px
    return _polylines.get(key, lambda: _polyline(*key))


def polylines_of(sheet: Sheet, figures: Sequence[Curve | Round]) -> list[Array]:
    """That of each curve at its own tolerance, of a circle or ellipse closed and counter-clockwise or not."""
    keys = [_key(sheet, figure) for figure in figures]
    return _polylines.get_all(keys, lambda missing: _made([keys[k] for k in missing]))


_Key = tuple[PlaneMap, Curve, str, float] | tuple[PlaneMap, Round]


def _key(sheet: Sheet, figure: Curve | Round) -> _Key:
    if isinstance(figure, Round):
        return figure_map(sheet, figure), figure
    return figure_map(sheet, figure), figure, "", figure.tolerance_px


def _made(keys: Sequence[_Key]) -> list[Array]:
    """The polylines of curves and rounds; those of one degree, map and tolerance at once."""
    made: dict[int, Array] = {}
    alike: dict[tuple[int, PlaneMap, float], dict[int, Pieces]] = {}
    for k, key in enumerate(keys):
        if len(key) == 2:
            made[k] = _flattened(*key)
            continue
        scale, curve, _spline, tolerance_px = key
        try:
            pieces = pieces_of(curve)
        except ValueError:
            made[k] = _NOTHING
            continue
        if pieces.weights is None:
            alike.setdefault((pieces.degree, scale, tolerance_px), {})[k] = pieces
        else:
            made[k] = _polyline(*key)
    for (_degree, scale, tolerance_px), group in alike.items():
        ends = np.cumsum([len(pieces.controls) for pieces in group.values()])[:-1]
        controls = scale.points(np.concatenate([pieces.controls for pieces in group.values()]))
        parts = zip(group.values(), np.split(controls, ends), strict=True)
        on_device = [pieces._replace(controls=part) for pieces, part in parts]
        made.update(zip(group, curves.polylines(on_device, tolerance_px), strict=True))
    return [made[k] for k in range(len(keys))]


@np.errstate(over="ignore", invalid="ignore")
def _flattened(scale: PlaneMap, figure: Round) -> Array:
    pieces = pieces_of_round(figure)
    on_device = pieces._replace(controls=scale.points(pieces.controls))
    return curves.polyline(on_device, ROUND_TOLERANCE_PX)


# A sheet of many curves is drawn at every step of a drag, each as pixels and as a smooth line.
_polylines: Memory[Array] = Memory(32 << 20)
_NOTHING = np.empty((0, 2))


def _polyline(scale: PlaneMap, curve: Curve, spline: str, tolerance_px: float) -> Array:
    if fault_of(curve, spline):
        return _NOTHING
    return curves.polyline(_device(Same(pieces_of(curve, spline)), scale), tolerance_px)
