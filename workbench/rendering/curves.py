"""Curves, and circles and ellipses that do not stay round, as the lines that are drawn, device."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.curves.pieces import pieces_of
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
    return _remembered([(figure_map(sheet, curve), curve, spline, tolerance_px or curve.tolerance_px)])[0]


def polylines_of(sheet: Sheet, figures: Sequence[Curve | Round]) -> list[Array]:
    """That of each curve at its own tolerance, of a circle or ellipse closed and counter-clockwise or not."""
    tolerances = [
        ROUND_TOLERANCE_PX if isinstance(figure, Round) else figure.tolerance_px for figure in figures
    ]
    return _remembered(
        [
            (figure_map(sheet, figure), figure, "", tolerance)
            for figure, tolerance in zip(figures, tolerances, strict=True)
        ]
    )


_Key = tuple[PlaneMap, Curve | Round, str, float]  # of a curve the spline, or none for its own; the tolerance


def _remembered(keys: Sequence[_Key]) -> list[Array]:
    return _polylines.get_all(keys, lambda missing: _flattened_together([keys[k] for k in missing]))


@np.errstate(over="ignore", invalid="ignore")
def _flattened_together(keys: Sequence[_Key]) -> list[Array]:
    """The polylines of curves and rounds; those of one degree, map and tolerance at once."""
    chains: dict[int, Array] = {}
    alike: dict[tuple[int, PlaneMap, float], dict[int, Pieces]] = {}
    for k, (scale, figure, spline, tolerance_px) in enumerate(keys):
        try:
            pieces = pieces_of_round(figure) if isinstance(figure, Round) else pieces_of(figure, spline)
        except ValueError:
            chains[k] = _NOTHING
            continue
        if pieces.weights is None:
            alike.setdefault((pieces.degree, scale, tolerance_px), {})[k] = pieces
        else:
            on_device = pieces._replace(controls=scale.points(pieces.controls))
            chains[k] = curves.polyline(on_device, tolerance_px)
    for (_degree, scale, tolerance_px), group in alike.items():
        ends = np.cumsum([len(pieces.controls) for pieces in group.values()])[:-1]
        controls = scale.points(np.concatenate([pieces.controls for pieces in group.values()]))
        parts = zip(group.values(), np.split(controls, ends), strict=True)
        all_on_device = [pieces._replace(controls=part) for pieces, part in parts]
        chains.update(zip(group, curves.polylines(all_on_device, tolerance_px), strict=True))
    return [chains[k] for k in range(len(keys))]


# A sheet of many curves is drawn at every step of a drag, each as pixels and as a smooth line.
_polylines: Memory[Array] = Memory(32 << 20)
_NOTHING = np.empty((0, 2))
