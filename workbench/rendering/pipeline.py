"""From the world to the device: the arguments that a figure's algorithm gets.

The window of a sheet is mapped onto its viewport; only then are coordinates rounded, by ``round_half_up``.
A circle whose device radii differ (the scale is not the same in x and y) is drawn as an ellipse.
"""

import itertools
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.algorithms.viewing import window_to_viewport
from workbench.document.model import (
    AnyFigure,
    Circle,
    Ellipse,
    Line,
    Polyline,
    Rectangle,
    SeedFill,
    Sheet,
)
from workbench.geometry.conventions import round_half_up
from workbench.rendering.limits import REACH_PX, within_reach

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


class Call(NamedTuple):
    """One run of an algorithm: the entry and what its function is given, in device coordinates."""

    entry: Entry
    arguments: tuple[Any, ...]


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


def _segments(figure: Line | Polyline) -> list[tuple[float, float, float, float]]:
    points = [(point.x, point.y) for point in figure.points_world]
    if isinstance(figure, Polyline) and figure.closed and len(points) > 2:
        points.append(points[0])
    return [(*a, *b) for a, b in itertools.pairwise(points)]


def world_segments(figure: Line | Polyline) -> list[tuple[float, float, float, float]]:
    """The segments (x0, y0, x1, y1) of a line or polyline, in world coordinates."""
    return _segments(figure)


def device_radii(sheet: Sheet, figure: Circle | Ellipse) -> tuple[float, float]:
    """Radii in pixels along x and y, not yet rounded."""
    scale = device_map(sheet)
    if isinstance(figure, Circle):
        return abs(scale.sx) * figure.radius_world, abs(scale.sy) * figure.radius_world
    return abs(scale.sx) * figure.radius_x_world, abs(scale.sy) * figure.radius_y_world


def _named(sheet: Sheet, figure: AnyFigure, below: NDArray[np.uint32] | None) -> list[dict[str, Any]]:
    """For each call the values its parameters may ask for, by the names that the catalogue uses."""
    scale = device_map(sheet)
    if isinstance(figure, Line | Polyline):
        calls: list[dict[str, Any]] = []
        for x0, y0, x1, y1 in _segments(figure):
            ends = within_reach(*scale.point(x0, y0), *scale.point(x1, y1), sheet.width_px, sheet.height_px)
            if ends is not None:
                calls.append(dict(zip(("x0", "y0", "x1", "y1"), map(round_half_up, ends), strict=True)))
        return calls
    if not figure.points_world:
        return []
    x, y = scale.point(figure.points_world[0].x, figure.points_world[0].y)
    if isinstance(figure, Circle | Ellipse):
        radius_x, radius_y = device_radii(sheet, figure)
        if max(abs(x), abs(y), radius_x, radius_y) > REACH_PX:
            return []
        rx, ry = round_half_up(radius_x), round_half_up(radius_y)
        return [{"xc": round_half_up(x), "yc": round_half_up(y), "rx": rx, "ry": ry, "r": rx}]
    if max(abs(x), abs(y)) > REACH_PX:
        return []
    return [
        {
            "image": below,
            "x": round_half_up(x),
            "y": round_half_up(y),
            "fill": colour_of(sheet, figure),
            "boundary": sheet.palette[figure.boundary % len(sheet.palette)],
        }
    ]


def colour_of(sheet: Sheet, figure: AnyFigure) -> int:
    """The figure's colour as 0xRRGGBB."""
    return sheet.palette[figure.colour % len(sheet.palette)]


def calls(
    sheet: Sheet,
    figure: AnyFigure,
    algorithm: str | None = None,
    below: NDArray[np.uint32] | None = None,
) -> list[Call]:
    """What runs to draw ``figure``, under its own algorithm or under another of the catalogue.

    ``below`` is the picture (h, w) beneath a seed fill, which copies nothing: hand it a copy where the text
    writes. Raises LookupError when the catalogue has no such algorithm.
    """
    entry = catalogue.get(algorithm or figure.algorithm)
    made: list[Call] = []
    for values in _named(sheet, figure, below):
        chosen = entry
        if "r" in values and values["rx"] != values["ry"] and any(p.name == "r" for p in entry.parameters):
            chosen = catalogue.get("midpoint_ellipse")
        made.append(Call(chosen, tuple(values.get(p.name, p.example) for p in chosen.parameters)))
    return made


def fills(figure: AnyFigure) -> bool:
    """Whether the figure reads what lies below it."""
    return isinstance(figure, SeedFill)
