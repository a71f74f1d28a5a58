"""Solids over points: the first ones that are offered, and those that a figure of the sheet is swept into."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import AnyFigure, Sheet
from workbench.document.scene.model import SpacePoint
from workbench.document.scene.solids import Extrusion, Revolution
from workbench.language import _
from workbench.panels.stage.outline import outline
from workbench.rendering.mapping import device_map

_SIZE = 2.0
_MOST_POINTS = 120
_STAR, _NET = 5, 4


def star() -> tuple[SpacePoint, ...]:
    """An outline that dents."""
    corners = [
        (radius * math.sin(math.pi * k / _STAR), radius * math.cos(math.pi * k / _STAR))
        for k, radius in enumerate((1.0, 0.45) * _STAR)
    ]
    return tuple(SpacePoint("", x, y) for x, y in corners)


def vase() -> tuple[SpacePoint, ...]:
    """A profile beside the axis, from below."""
    profile = ((0.6, 0.0), (0.85, 0.35), (0.9, 0.75), (0.55, 1.25), (0.35, 1.6), (0.5, 1.95))
    return tuple(SpacePoint("", x, y) for x, y in profile)


def hill() -> tuple[SpacePoint, ...]:
    """A net of control points, row by row, raised in its middle."""
    step = _SIZE / (_NET - 1)
    places = [(row, column) for row in range(_NET) for column in range(_NET)]
    return tuple(
        SpacePoint("", column * step - 1.0, 1.6 * (row in (1, 2)) * (column in (1, 2)), row * step - 1.0)
        for row, column in places
    )


def outline_of(sheet: Sheet, figure: AnyFigure) -> NDArray[np.float64]:
    """The longest outline of a figure (n, 2), its middle at the origin, within a square of ``_SIZE``.

    Raises: ValueError, a sentence, where it has none with an area.
    """
    curves = [device_map(sheet).world(curve) for curve in outline(sheet, figure)]
    flat = max(curves, key=len, default=np.zeros((0, 2)))
    if len(flat) and np.array_equal(flat[0], flat[-1]):
        flat = flat[:-1]
    flat = flat[:: -(-len(flat) // _MOST_POINTS)] if len(flat) else flat
    spread = np.ptp(flat, axis=0) if len(flat) > 2 else np.zeros(2)
    if not (spread > 0).all():
        raise ValueError(_("This figure does not enclose an area; choose a polygon or a curve."))
    low = flat.min(axis=0)
    swept: NDArray[np.float64] = (flat - low - spread / 2) * (_SIZE / spread.max())
    return swept


def extruded(sheet: Sheet, figure: AnyFigure) -> tuple[Extrusion, tuple[SpacePoint, ...]]:
    """A figure carried along z. Raises: ValueError."""
    return Extrusion(), tuple(SpacePoint("", x, y) for x, y in outline_of(sheet, figure).tolist())


def revolved(sheet: Sheet, figure: AnyFigure) -> tuple[Revolution, tuple[SpacePoint, ...]]:
    """A figure carried round the y axis, beside which it stands. Raises: ValueError."""
    profile = outline_of(sheet, figure)
    profile = profile - (profile[:, 0].min() - 0.25, profile[:, 1].min())
    return Revolution(closed=True), tuple(SpacePoint("", x, y) for x, y in profile.tolist())
