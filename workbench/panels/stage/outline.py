"""The ideal geometry of figures in device coordinates: drawn thin over the pixels, and pointed at."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.curves.paths import is_path
from workbench.document.model import AnyFigure, Circle, Ellipse, Line, Polyline, SeedFill, Sheet, View
from workbench.document.model import Curve as CurveFigure
from workbench.geometry.conventions import round_half_up
from workbench.geometry.distance import polyline_distance
from workbench.memory import Memory
from workbench.rendering import figure_map, painter_of
from workbench.rendering.display_list import seen_segments
from workbench.rendering.pipeline import fills
from workbench.widgets.canvas.overlay import Handle

Curve = NDArray[np.float64]
_MOST_NAMED = 10
# Figures whose distances differ by less, as a share of the reach, are as near as one another.
_AS_NEAR = 0.125
_FLATNESS_PX = 0.005  # no corner is seen where a pixel is forty large


def outline(sheet: Sheet, figure: AnyFigure) -> tuple[Curve, ...]:
    """The whole figure as open polylines, each (n, 2), in every view, clipped to its viewport alone."""
    return outlines(sheet, [figure])[0]


def outlines(sheet: Sheet, figures: Sequence[AnyFigure]) -> list[tuple[Curve, ...]]:
    """That of each figure; those that are not at hand are made at once."""
    views = _unclipped(sheet.views)
    return _outlines.get_all(
        [(views, figure) for figure in figures],
        lambda missing: _polylines_by_figure(
            replace(sheet, figures=tuple(figures[k] for k in missing), views=views)
        ),
    )


@lru_cache(maxsize=16)
def _unclipped(views: tuple[View, ...]) -> tuple[View, ...]:
    return tuple(replace(view, clip_world=None) for view in views)


def clipped_outlines(sheet: Sheet, figures: Sequence[AnyFigure]) -> list[tuple[Curve, ...]]:
    """As ``outlines``, clipped to the clip windows too, by the sheet's clippers."""
    return _clipped.get_all(
        [(sheet.views, sheet.line_clipper, sheet.polygon_clipper, figure) for figure in figures],
        lambda missing: _polylines_by_figure(replace(sheet, figures=tuple(figures[k] for k in missing))),
    )


def prepare(sheet: Sheet, figure: AnyFigure) -> None:
    """Have the outline of a figure at hand."""
    outline(sheet, figure)


_outlines: Memory[tuple[Curve, ...]] = Memory(32 << 20)
_clipped: Memory[tuple[Curve, ...]] = Memory(8 << 20)


def _polylines_by_figure(sheet: Sheet) -> list[tuple[Curve, ...]]:
    """The polylines of each figure of a sheet: its strokes, joined where one begins at the end of another."""
    segments = seen_segments(sheet, _FLATNESS_PX)
    order = np.argsort(segments.of, kind="stable")
    table, of = segments.table[order], segments.of[order]
    parted = (table[1:, :2] != table[:-1, 2:]).any(axis=1) | (of[1:] != of[:-1])
    begins = np.flatnonzero(np.append(True, parted)[: len(of)])
    polylines: list[list[Curve]] = [[] for _figure in sheet.figures]
    for begin, end in pairwise((*begins.tolist(), len(of))):
        polylines[of[begin]].append(np.vstack([table[begin, :2], table[begin:end, 2:]]))
    return list(map(tuple, polylines))


def distance_to(curves: tuple[Curve, ...], x: float, y: float) -> float:
    """Distance from a device point to the nearest of ``curves``; infinite when there is none."""
    return min((polyline_distance(curve, x, y) for curve in curves), default=np.inf)


def figure_at(sheet: Sheet, x: float, y: float, reach: float) -> AnyFigure | None:
    """The figure whose ideal geometry is nearest to a device point, of those within ``reach`` pixels; of
    several about as near the front one. Where none is, the area that is seen there.
    """
    nearest, away = None, reach
    seen = [figure for figure in reversed(sheet.figures) if figure.visible]
    for figure, curves in zip(seen, outlines(sheet, seen), strict=True):
        here = distance_to(curves, x, y)
        if here <= away and (nearest is None or here < away - _AS_NEAR * reach):
            nearest, away = figure, here
    return nearest or _area_at(sheet, round_half_up(x), round_half_up(y))


def _area_at(sheet: Sheet, x: int, y: int) -> AnyFigure | None:
    """The figure that is seen at a pixel, if it is an area."""
    if not (0 <= x < sheet.width_px and 0 <= y < sheet.height_px):
        return None
    index = int(painter_of(sheet)[y, x])
    figure = sheet.figures[index] if index >= 0 else None
    if figure is None:
        return None
    filled = fills(figure) or catalogue.get(figure.drawn_with).emits == "spans"
    return figure if filled else None


def handles(sheet: Sheet, figure: AnyFigure, held: str = "") -> list[Handle]:
    """What of a figure can be grabbed, where the first view shows it; ``id`` is an address, ``held`` the one
    that is being dragged.
    """
    scale = figure_map(sheet, figure)
    place = f"{sheet.id}/{figure.id}"
    made: list[Handle] = []

    def add(address: str, name: str, x: float, y: float) -> None:
        shown = "" if address == held or len(figure.points_world) > _MOST_NAMED else name
        made.append(Handle(address, shown, round(x, 6), round(y, 6), address == held))

    numbers = list(range(len(figure.points_world)))
    if isinstance(figure, CurveFigure) and is_path(figure):
        numbers.sort(key=lambda k: k % 3 == 0)  # what is last covers a handle that lies on it
    for number in numbers:
        point = figure.points_world[number]
        name = _POINTS.get(type(figure), "P{k}").format(k=number)
        add(f"{place}/{point.id}/x", name, *scale.point(point.x, point.y))
    if isinstance(figure, Circle | Ellipse) and figure.points_world:
        x, y = figure.points_world[0].x, figure.points_world[0].y
        if isinstance(figure, Circle):
            add(f"{place}/radius_world", "r", *scale.point(x + figure.radius_world, y))
        else:
            add(f"{place}/radius_x_world", "rx", *scale.point(x + figure.radius_x_world, y))
            add(f"{place}/radius_y_world", "ry", *scale.point(x, y + figure.radius_y_world))
    return made


_POINTS: dict[type, str] = {Line: "P{k}", Polyline: "P{k}", Circle: "C", Ellipse: "C", SeedFill: "S"}
