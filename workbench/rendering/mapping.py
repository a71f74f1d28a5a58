"""From the world to the device, before anything is clipped or rounded."""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.algorithms.viewing import window_to_viewport
from workbench.document.model import Circle, Ellipse, Polygon, Rectangle, Sheet, WorldPoint

Box = tuple[float, float, float, float]
"""A rectangle as (xmin, ymin, xmax, ymax)."""


class DeviceMap(NamedTuple):
    """The diagonal matrix from world to device: x_d = sx x_w + tx, y_d = sy y_w + ty (pixels)."""

    sx: float
    sy: float
    tx: float
    ty: float

    def point(self, x: float, y: float) -> tuple[float, float]:
        """Device coordinates of a world point, not yet rounded."""
        return self.sx * x + self.tx, self.sy * y + self.ty

    def points(self, world: NDArray[np.float64]) -> NDArray[np.float64]:
        """Device coordinates of world points (..., 2)."""
        device: NDArray[np.float64] = world * (self.sx, self.sy) + (self.tx, self.ty)
        return device

    def world(self, device: NDArray[np.float64]) -> NDArray[np.float64]:
        """World coordinates of device points (..., 2)."""
        found: NDArray[np.float64] = (device - (self.tx, self.ty)) / (self.sx, self.sy)
        return found

    def world_point(self, x: float, y: float) -> tuple[float, float]:
        """World coordinates of a device point, without what rounding has left in them."""
        return round((x - self.tx) / self.sx, 9), round((y - self.ty) / self.sy, 9)


class Call(NamedTuple):
    """One run of an algorithm: the entry and what its function is given, in device coordinates.

    A text that calls itself is stopped ``recursion_limit`` calls deep; 0 for all others.
    """

    entry: Entry
    arguments: tuple[Any, ...]
    recursion_limit: int = 0


def box(rectangle: Rectangle) -> Box:
    """The sides of a rectangle in the order that the viewing functions take."""
    return rectangle.xmin, rectangle.ymin, rectangle.xmax, rectangle.ymax


@lru_cache(maxsize=64)
def _device_map(window: Box, viewport: Box) -> DeviceMap:
    matrix = window_to_viewport(window, viewport, False)
    return DeviceMap(float(matrix[0, 0]), float(matrix[1, 1]), float(matrix[0, 2]), float(matrix[1, 2]))


def device_map(sheet: Sheet) -> DeviceMap:
    """The map from the sheet's window (world) to its viewport (device)."""
    return _device_map(box(sheet.window_world), box(sheet.viewport_device))


@np.errstate(over="ignore", invalid="ignore")
def device_points(sheet: Sheet, chains: Iterable[Sequence[WorldPoint]]) -> NDArray[np.float64]:
    """All points (n, 2) of some chains, one chain after the other, device coordinates."""
    places = [place for chain in chains for point in chain for place in (point.x, point.y)]
    return device_map(sheet).points(np.array(places, np.float64).reshape(-1, 2))


def device_rings(
    sheet: Sheet, figures: Sequence[Polygon]
) -> tuple[list[NDArray[np.float64]], NDArray[np.int64]]:
    """The rings (k, 2) of some polygons, device coordinates, and which of these each one is of, (n,)."""
    corners, ends, of = device_points(sheet, [figure.points_world for figure in figures]), [0], []
    for number, figure in enumerate(figures):
        before = ends[-1]
        rings = figure.ring_ends or (len(figure.points_world),)
        ends += [before + end for end in rings]
        of += [number] * len(rings)
    return [corners[start:end] for start, end in pairwise(ends)], np.array(of, np.int64)


def device_radii(sheet: Sheet, figure: Circle | Ellipse) -> tuple[float, float]:
    """Radii in pixels along x and y, not yet rounded."""
    scale = device_map(sheet)
    if isinstance(figure, Circle):
        return abs(scale.sx) * figure.radius_world, abs(scale.sy) * figure.radius_world
    return abs(scale.sx) * figure.radius_x_world, abs(scale.sy) * figure.radius_y_world
