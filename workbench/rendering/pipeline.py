"""From the world to the device: the arguments that a figure's algorithm gets.

The window of a sheet is mapped onto its viewport, lines and polygons are clipped; only then are coordinates
rounded, by ``round_half_up``. The corners of a polygon are not, since its algorithm takes fractions. A circle
whose device radii differ (the scale is not the same in x and y) is drawn as an ellipse.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    SeedFill,
    Sheet,
)
from workbench.geometry.conventions import round_half_up
from workbench.rendering.clipping import line_ends, line_table, polygon_values
from workbench.rendering.limits import REACH_PX
from workbench.rendering.mapping import Call, device_map, device_radii
from workbench.rendering.segments import Lines

_ENDS = ("x0", "y0", "x1", "y1")


def line_calls_table(sheet: Sheet, figure: Lines) -> tuple[Entry, NDArray[np.int64]]:
    """The algorithm of a figure made of lines, and its arguments (n, k), a row for each of its calls."""
    entry, ends = catalogue.get(figure.drawn_with), line_table(sheet, figure)
    columns = [
        ends[:, _ENDS.index(p.name)] if p.name in _ENDS else np.full(len(ends), p.example, np.int64)
        for p in entry.parameters
    ]
    return entry, np.stack(columns, axis=1)


def _named(
    sheet: Sheet, figure: Polygon | Circle | Ellipse | SeedFill, below: NDArray[np.uint32] | None
) -> list[dict[str, Any]]:
    """For each call the values its parameters may ask for, by the names that the catalogue uses."""
    if isinstance(figure, Polygon):
        values = polygon_values(sheet, figure)
        return [] if values is None else [values]
    if not figure.points_world:
        return []
    if reach_of(sheet, figure) > REACH_PX:
        return []
    x, y = device_map(sheet).point(figure.points_world[0].x, figure.points_world[0].y)
    if isinstance(figure, Circle | Ellipse):
        radius_x, radius_y = device_radii(sheet, figure)
        rx, ry = round_half_up(radius_x), round_half_up(radius_y)
        return [{"xc": round_half_up(x), "yc": round_half_up(y), "rx": rx, "ry": ry, "r": rx}]
    return [
        {
            "image": below,
            "x": round_half_up(x),
            "y": round_half_up(y),
            "fill": colour_of(sheet, figure),
            "boundary": sheet.palette[figure.boundary % len(sheet.palette)],
        }
    ]


def reach_of(sheet: Sheet, figure: AnyFigure) -> float:
    """How far the centre, the radii or the seed of a figure reach, in pixels; 0 for one that is clipped."""
    if not isinstance(figure, Circle | Ellipse | SeedFill) or not figure.points_world:
        return 0.0
    x, y = device_map(sheet).point(figure.points_world[0].x, figure.points_world[0].y)
    radii = () if isinstance(figure, SeedFill) else device_radii(sheet, figure)
    return max(abs(x), abs(y), *radii)


def colour_of(sheet: Sheet, figure: AnyFigure) -> int:
    """The figure's colour as 0xRRGGBB."""
    return sheet.palette[figure.colour % len(sheet.palette)]


def _of_ellipses(circle: Entry) -> Entry:
    """What draws a circle that the scale makes an ellipse: as an outline or as an area, like its own text."""
    entries = [catalogue.get(slug) for slug in Ellipse.algorithms]
    return next(entry for entry in entries if entry.emits == circle.emits)


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
    entry = catalogue.get(algorithm or figure.drawn_with)
    if isinstance(figure, Line | Polyline | Curve):
        places = [_ENDS.index(p.name) if p.name in _ENDS else -1 for p in entry.parameters]
        ends = line_ends(sheet, figure)
        if places == [0, 1, 2, 3]:
            return [Call(entry, row) for row in ends]
        given = [(*row, *(p.example for p in entry.parameters)) for row in ends]
        chosen_of = [place if place >= 0 else number + 4 for number, place in enumerate(places)]
        return [Call(entry, tuple(row[at] for at in chosen_of)) for row in given]
    made: list[Call] = []
    for values in _named(sheet, figure, below):
        chosen = entry
        if "r" in values and values["rx"] != values["ry"] and any(p.name == "r" for p in entry.parameters):
            chosen = _of_ellipses(entry)
        limit = figure.recursion_limit if isinstance(figure, SeedFill) and chosen.compiles else 0
        made.append(Call(chosen, tuple(values.get(p.name, p.example) for p in chosen.parameters), limit))
    return made


def fills(figure: AnyFigure) -> bool:
    """Whether the figure reads what lies below it."""
    return isinstance(figure, SeedFill)
