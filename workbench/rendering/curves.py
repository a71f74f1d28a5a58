"""Curves of the document as the lines that are drawn, device."""

from collections.abc import Iterable
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.model import Curve, Sheet
from workbench.rendering.mapping import DeviceMap, device_map
from workbench.rendering.memory import Memory

Array = NDArray[np.float64]


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
    return _device(Same(pieces_of(curve, spline)), device_map(sheet))


@lru_cache(maxsize=64)
def _device(key: Same, scale: DeviceMap) -> Pieces:
    return key.pieces._replace(controls=scale.points(key.pieces.controls))


def polyline_of(sheet: Sheet, curve: Curve, spline: str = "", tolerance_px: float | None = None) -> Array:
    """The corners (n, 2), device coordinates, of the lines that stand for a curve; none where there is none.

    No point of the curve is farther from them than the tolerance, in pixels; by default the curve's own.
    Read-only and remembered.
    """
    key = device_map(sheet), curve, spline, tolerance_px or curve.tolerance_px
    return _polylines.get(key, lambda: _polyline(*key))


def polylines_of(sheet: Sheet, curves: Iterable[Curve]) -> list[Array]:
    """That of each curve at its own tolerance."""
    scale = device_map(sheet)
    keys = [(scale, curve, "", curve.tolerance_px) for curve in curves]
    return [_polylines.get(key, partial(_polyline, *key)) for key in keys]


# A sheet of many curves is drawn at every step of a drag, each as pixels and as a smooth line.
_polylines: Memory[Array] = Memory(32 << 20)


def _polyline(scale: DeviceMap, curve: Curve, spline: str, tolerance_px: float) -> Array:
    if fault_of(curve, spline):
        return np.empty((0, 2))
    return curves.polyline(_device(Same(pieces_of(curve, spline)), scale), tolerance_px)
