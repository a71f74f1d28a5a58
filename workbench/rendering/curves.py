"""Curves, and circles and ellipses that do not stay round, as the lines that are drawn, device."""

from collections.abc import Iterable
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.model import Curve, Sheet
from workbench.rendering.mapping import PlaneMap, figure_map
from workbench.rendering.memory import Memory
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


def polylines_of(sheet: Sheet, figures: Iterable[Curve | Round]) -> list[Array]:
    """That of each curve at its own tolerance, of a circle or ellipse closed and counter-clockwise or not."""
    return [
        _polyline_of_round(sheet, figure) if isinstance(figure, Round) else polyline_of(sheet, figure)
        for figure in figures
    ]


def _polyline_of_round(sheet: Sheet, figure: Round) -> Array:
    key = figure_map(sheet, figure), figure
    return _polylines.get(key, partial(_flattened, *key))


@np.errstate(over="ignore", invalid="ignore")
def _flattened(scale: PlaneMap, figure: Round) -> Array:
    pieces = pieces_of_round(figure)
    on_device = pieces._replace(controls=scale.points(pieces.controls))
    return curves.polyline(on_device, ROUND_TOLERANCE_PX)


# A sheet of many curves is drawn at every step of a drag, each as pixels and as a smooth line.
_polylines: Memory[Array] = Memory(32 << 20)


def _polyline(scale: PlaneMap, curve: Curve, spline: str, tolerance_px: float) -> Array:
    if fault_of(curve, spline):
        return np.empty((0, 2))
    return curves.polyline(_device(Same(pieces_of(curve, spline)), scale), tolerance_px)
