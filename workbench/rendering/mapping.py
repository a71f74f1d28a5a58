"""From the points of a figure through its chain and a view to the device, before clipping and rounding.

A function that takes a sheet maps by its first view; a sheet of several views is drawn as one sheet for each.
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.algorithms.viewing import window_to_viewport
from workbench.document.model import (
    AnyFigure,
    Polygon,
    Rectangle,
    Sheet,
    View,
    WorldPoint,
)
from workbench.document.transforms.chains import inverse_of, matrices_of, transformed
from workbench.rendering.rounds import radii_of

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

    def world_way(self, dx: float, dy: float) -> tuple[float, float]:
        """The way in the world that is (dx, dy) on the device."""
        return dx / self.sx, dy / self.sy


class FigureMap(NamedTuple):
    """From the points of a figure to the device: x_d = xx x + xy y + tx, y_d = yx x + yy y + ty (pixels)."""

    xx: float
    xy: float
    tx: float
    yx: float
    yy: float
    ty: float

    def point(self, x: float, y: float) -> tuple[float, float]:
        """Device coordinates of a point of the figure, not yet rounded."""
        return self.xx * x + self.xy * y + self.tx, self.yx * x + self.yy * y + self.ty

    @np.errstate(over="ignore", invalid="ignore")
    def points(self, world: NDArray[np.float64]) -> NDArray[np.float64]:
        """Device coordinates of points (..., 2) of the figure."""
        x, y = world[..., :1], world[..., 1:]
        columns = np.array([(self.xx, self.yx), (self.xy, self.yy), (self.tx, self.ty)])
        device: NDArray[np.float64] = columns[0] * x + columns[1] * y + columns[2]
        return device

    def world(self, device: NDArray[np.float64]) -> NDArray[np.float64]:
        """The points (..., 2) that are taken to device points. Raises: ValueError where no way leads back."""
        back = FigureMap.of(inverse_of(self.matrix))
        return back.points(device)

    def world_point(self, x: float, y: float) -> tuple[float, float]:
        """As ``world`` for one point, without what rounding has left in it."""
        at_x, at_y = FigureMap.of(inverse_of(self.matrix)).point(x, y)
        return round(at_x, 9), round(at_y, 9)

    def world_way(self, dx: float, dy: float) -> tuple[float, float]:
        """The way of a point of the figure that is (dx, dy) on the device. Raises: as ``world``."""
        back = FigureMap.of(inverse_of(self.matrix))
        return back.xx * dx + back.xy * dy, back.yx * dx + back.yy * dy

    @property
    def matrix(self) -> NDArray[np.float64]:
        """(3, 3)."""
        return np.array([self[:3], self[3:], (0.0, 0.0, 1.0)])

    @classmethod
    def of(cls, matrix: NDArray[np.float64]) -> "FigureMap":
        """That of a matrix (3, 3) whose last row is 0 0 1."""
        return cls(*matrix[:2].ravel().tolist())


PlaneMap = DeviceMap | FigureMap


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


def _seen_of(window: Box, viewport: Box) -> Box:
    """The middle of a window that has the viewport's proportions."""
    (width, height), (wide, high) = ((r[2] - r[0], r[3] - r[1]) for r in (window, viewport))
    scale = max(wide / width, high / height)
    x, y = (width - wide / scale) / 2, (height - high / scale) / 2
    return window[0] + x, window[1] + y, window[2] - x, window[3] - y


@lru_cache(maxsize=64)
def view_map(view: View) -> DeviceMap:
    """The map from a view's window (world) to its viewport (device)."""
    window, viewport = box(view.window_world), box(view.viewport_device)
    if view.mode == "fill":
        window = _seen_of(window, viewport)
    matrix = window_to_viewport(window, viewport, view.mode != "stretch")
    return DeviceMap(float(matrix[0, 0]), float(matrix[1, 1]), float(matrix[0, 2]), float(matrix[1, 2]))


def device_map(sheet: Sheet) -> DeviceMap:
    """The map from the window (world) of a sheet's first view to its viewport (device)."""
    return view_map(sheet.first_view)


def figure_map(sheet: Sheet, figure: AnyFigure) -> PlaneMap:
    """The map from a figure's own points through its chain and the first view to the device."""
    scale, matrix = device_map(sheet), figure.matrix
    if matrix is None:
        return scale
    (xx, xy, x), (yx, yy, y) = matrix[:2].tolist()
    sx, sy, tx, ty = scale
    return FigureMap(sx * xx, sx * xy, sx * x + tx, sy * yx, sy * yy, sy * y + ty)


@np.errstate(over="ignore", invalid="ignore")
def device_points(
    sheet: Sheet, figures: Sequence[AnyFigure], lists: Sequence[Sequence[WorldPoint]]
) -> NDArray[np.float64]:
    """All points (n, 2) of some lists, one list after the other, each of the figure in its place; device."""
    places = [place for points in lists for point in points for place in (point.x, point.y)]
    world = np.array(places, np.float64).reshape(-1, 2)
    if any(figure.transforms for figure in figures):
        of = np.repeat(np.arange(len(figures)), [len(points) for points in lists])
        chained = np.array([figure.matrix is not None for figure in figures])
        rows = np.flatnonzero(chained[of])
        world[rows] = transformed(matrices_of(figures)[of[rows]], world[rows])
    return device_map(sheet).points(world)


def device_rings(
    sheet: Sheet, figures: Sequence[Polygon]
) -> tuple[list[NDArray[np.float64]], NDArray[np.int64]]:
    """The rings (k, 2) of some polygons, device coordinates, and which of these each one is of, (n,)."""
    corners, ends, of = device_points(sheet, figures, [figure.points_world for figure in figures]), [0], []
    for number, figure in enumerate(figures):
        before = ends[-1]
        rings = figure.ring_ends or (len(figure.points_world),)
        ends += [before + end for end in rings]
        of += [number] * len(rings)
    return [corners[start:end] for start, end in pairwise(ends)], np.array(of, np.int64)


def device_radii(sheet: Sheet, figure: AnyFigure) -> tuple[float, float]:
    """Radii in pixels along x and y, not yet rounded, of one that stays round; 0 where it has none."""
    scale, (rx, ry) = device_map(sheet), radii_of(figure)
    return abs(scale.sx) * rx, abs(scale.sy) * ry
