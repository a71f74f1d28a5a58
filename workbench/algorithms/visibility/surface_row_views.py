"""What the scan-line method for surfaces shows of its blocks."""

import numpy as np

from workbench.algorithms.entry import View
from workbench.algorithms.marks import Mark, Ray, Spot, Stroke
from workbench.algorithms.visibility.surface_edges import Active, Edge
from workbench.algorithms.visibility.surface_words import answer, listed
from workbench.algorithms.visibility.surfaces import Surface, depth_at

COLUMNS = ("y", "x", "open surfaces", "their z", "nearest")


def polygon_rows(
    surfaces: list[Surface], flags: list[bool]
) -> list[tuple[int, float, float, float, float, str]]:
    """The polygon table: the plane of each surface, and its flag."""
    return [(n, s.A, s.B, s.C, s.D, answer(flags[n])) for n, s in enumerate(surfaces)]


def edge_rows(edges: list[Edge]) -> list[tuple[int, int, tuple[float, float], tuple[float, float], int]]:
    """The edge table: first row and the one past the last, lower and upper end, surface."""
    return [(e.y_start, e.y_end, e.low[:2], e.high[:2], e.surface) for e in edges]


def depths(surfaces: list[Surface], opened: list[int], x: float, y: int) -> tuple[float, ...]:
    """The depths of the open surfaces at a place of the scan line."""
    return tuple(depth_at(surfaces[number], x, y) for number in opened)


def row_marks(active: list[Active], y: int, x_left: int, end: int) -> tuple[Mark, ...]:
    """The scan line, where edges cross it, and the span."""
    spots = tuple(Spot(one.x, float(y), "data2", "ring") for one in active)
    span = np.array([[x_left, y], [end - 1, y]], np.float64)
    return (
        Ray(0.0, float(y), 1.0, 0.0, "accent", "thin", "dash", both_ways=True),
        *spots,
        Stroke(span, "accent", "bold"),
    )


VIEW_FUNCTIONS = (answer, depths, edge_rows, listed, polygon_rows, row_marks)

_MIDDLE = "(x_left + end - 1) / 2"
_PAINT = "Paint them with the nearest of the open surfaces"
_TABLES = {
    "Active edges": ("active", ("x", "surface", "edge")),
    "Polygon table": ("polygon_rows(surfaces, flags)", ("surface", "A", "B", "C", "D", "flag")),
    "Edge table": ("edge_rows(edges)", ("first row", "ends before", "lower end", "upper end", "surface")),
}


def _paint_view(when: str, options: str, sentence: str) -> View:
    return View(
        block=_PAINT,
        when=when,
        row=f"(y, (x_left, end - 1), listed(opened), depths(surfaces, opened, {_MIDDLE}, y), seen)",
        tables=_TABLES,
        options=options,
        answer="seen" if options != "()" else "",
        marks="row_marks(active, y, x_left, end)",
        sentence=sentence,
    )


VIEWS = (
    View(
        block="Make the polygon table and the edge table",
        tables={title: _TABLES[title] for title in ("Polygon table", "Edge table")},
        sentence="{len(surfaces)} surfaces, and {len(edges)} edges that cross a scan line.",
    ),
    View(
        block="Let edges end and begin, and put their crossings in order",
        when="active",
        sentence="Scan line y = {y} crosses {len(active)} edges.",
    ),
    _paint_view(
        "len(opened) == 1",
        "()",
        "Row {y}, x = {x_left} to {end - 1}: only the flag of surface {seen} is on, no depth is compared.",
    ),
    _paint_view(
        "True",
        "tuple(opened)",
        "Row {y}, x = {x_left} to {end - 1}: the flags of {listed(opened)} are on, with z = "
        f"{{depths(surfaces, opened, {_MIDDLE}, y)}} in the middle: surface {{seen}} is nearest.",
    ),
)
