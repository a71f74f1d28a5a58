"""What the Transform canvas draws: the plane with its axes, the figure at every stage, one point's way."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Word
from workbench.algorithms.numerals import with_minus
from workbench.algorithms.transforms import Matrix
from workbench.document.model import AnyFigure, Line, Polygon, Polyline, Rectangle, Sheet, View
from workbench.document.transforms.chains import is_singular, transformed
from workbench.document.transforms.stages import Stage, products, stages
from workbench.memory import Memory
from workbench.panels.stage.outline import outline
from workbench.panels.transform.told import place_text
from workbench.rendering.extent import world_extent
from workbench.rendering.mapping import DeviceMap, device_map
from workbench.widgets.canvas.drawing import Drawn, Marker, Pattern, PenStroke, Tint

Points = NDArray[np.float64]
Area = tuple[float, float, float, float]
"""A part of the plane, device: left, bottom, right, top."""

MOST_GHOSTS = 9
_INKS: tuple[Ink, ...] = ("data2", "data3", "data4", "data5", "data6")
_PATTERNS: tuple[Pattern, ...] = ("dash", "dot", "solid")
_GRID_PX, _LABEL_PX = 22.0, 52.0
_HEAD_PX, _HEAD_ANGLE = 10.0, 0.35
_ARC_STEPS = 24
_AXIS_PX = 90.0
_FARTHEST = 3


@dataclass(frozen=True, slots=True)
class Shows:
    """What is drawn: ``axes`` moves the axes instead of the points; ``lit`` is a stage that is pointed at."""

    ghosts: bool = True
    axes: bool = False
    vertex: int = 0
    lit: int | None = None


def ink_of_stage(number: int, count: int) -> tuple[Ink, Pattern]:
    """The ink and the pattern of the figure after stage ``number`` of ``count``; 0 is as drawn."""
    if number == 0:
        return "muted", "solid"
    if number == count:
        return "data1", "solid"
    return _INKS[(number - 1) % len(_INKS)], _PATTERNS[(number - 1) % 3]


def ghosts_of(count: int) -> list[int]:
    """The stages that are drawn, of so many: where there are too many, the first and the last of them."""
    if count <= MOST_GHOSTS:
        return list(range(count + 1))
    return [*range(MOST_GHOSTS - 1), count - 1, count]


def plane(scale: DeviceMap, area: Area, unit: float) -> Iterator[Drawn]:
    """Grid, both axes and their numbers in an area; ``unit`` device units are one logical pixel."""
    left, bottom, right, top = area
    (x0, y0), (x1, y1) = scale.world_point(left, bottom), scale.world_point(right, top)
    for low, high, factor, across in ((x0, x1, scale.sx, True), (y0, y1, scale.sy, False)):
        step = round_step(_GRID_PX * unit / abs(factor))
        for k in range(math.ceil(min(low, high) / step), math.floor(max(low, high) / step) + 1):
            x, y = scale.point(k * step, k * step)
            ends = [(x, bottom), (x, top)] if across else [(left, y), (right, y)]
            yield PenStroke(np.array(ends, np.float64), "grid", 1.0)
    origin_x, origin_y = scale.point(0.0, 0.0)
    yield PenStroke(np.array([(left, origin_y), (right, origin_y)]), "muted", 1.0)
    yield PenStroke(np.array([(origin_x, bottom), (origin_x, top)]), "muted", 1.0)
    at_x, at_y = min(max(origin_x, left), right), min(max(origin_y, bottom), top)
    for low, high, factor, across in ((x0, x1, scale.sx, True), (y0, y1, scale.sy, False)):
        step = round_step(_LABEL_PX * unit / abs(factor))
        for k in range(math.ceil(min(low, high) / step), math.floor(max(low, high) / step) + 1):
            x, y = scale.point(k * step, k * step)
            edge = min(abs(x - left), abs(right - x)) if across else min(abs(y - bottom), abs(top - y))
            if k and edge > 14 * unit:
                text = with_minus(f"{k * step:g}")
                yield Word(text, x, at_y, "muted", 0, -1) if across else Word(text, at_x, y, "muted", -1, 0)
    yield Word("x", right, at_y, "muted", -1, 1)
    yield Word("y", at_x, top, "muted", 1, -1)


def round_step(least: float) -> float:
    """The least of 1, 2 and 5 times powers of ten that is not smaller."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= least * (1 - 1e-9))


def curves_of(sheet: Sheet, figure: AnyFigure) -> tuple[Points, ...]:
    """A figure as it was drawn, as polylines (n, 2) on the device; a drag of its chain changes none of it."""
    drawn = replace(figure, transforms=(), visible=True)
    return _curves.get((sheet.views, drawn), lambda: _curves_of(sheet, drawn))


_curves: Memory[tuple[Points, ...]] = Memory(4 << 20)


def _curves_of(sheet: Sheet, figure: AnyFigure) -> tuple[Points, ...]:
    scale = device_map(sheet)
    points = np.array([(p.x, p.y) for p in figure.points_world], np.float64).reshape(-1, 2)
    match figure:
        case Line():
            return (scale.points(points),)
        case Polyline():
            whole = np.concatenate([points, points[:1]]) if figure.closed else points
            return (scale.points(whole),)
        case Polygon():
            ends = figure.ring_ends or (len(points),)
            rings = [points[a:b] for a, b in zip((0, *ends), ends, strict=False)]
            return tuple(scale.points(np.concatenate([ring, ring[:1]])) for ring in rings)
    return _whole(sheet, figure)


def _whole(sheet: Sheet, figure: AnyFigure) -> tuple[Points, ...]:
    """The outline as the first view places it, past the edge of its viewport too."""
    extent = world_extent(replace(sheet, figures=(figure,)))
    if extent is None:
        return ()
    scale, xmin, ymin, xmax, ymax = device_map(sheet), *extent
    room = max(xmax - xmin, ymax - ymin, 1.0)  # a curve may reach beyond its points
    window = Rectangle(xmin - room, ymin - room, xmax + room, ymax + room)
    viewport = Rectangle(*scale.point(window.xmin, window.ymin), *scale.point(window.xmax, window.ymax))
    return outline(replace(sheet, views=(View("", window, viewport),)), figure)


def on_device(scale: DeviceMap, matrix: Matrix | None) -> Matrix:
    """What a matrix of the world makes of device points (3, 3)."""
    if matrix is None:
        return np.eye(3)
    there = np.array([(scale.sx, 0.0, scale.tx), (0.0, scale.sy, scale.ty), (0.0, 0.0, 1.0)])
    back = np.array(
        [
            (1 / scale.sx, 0.0, -scale.tx / scale.sx),
            (0.0, 1 / scale.sy, -scale.ty / scale.sy),
            (0.0, 0.0, 1.0),
        ]
    )
    mapped: Matrix = there @ matrix @ back
    return mapped


def placed(curves: tuple[Points, ...], matrix: Matrix) -> tuple[Points, ...]:
    """Curves under a matrix."""
    return tuple(transformed(matrix, curve) for curve in curves)


def reach(sheet: Sheet, figure: AnyFigure | None) -> Area | None:
    """How far a figure goes at all its stages, device; beyond the picture at most so many times its size as
    leaves something to be seen. None where nothing is transformed.
    """
    if figure is None or not figure.transforms:
        return None
    scale, curves = device_map(sheet), curves_of(sheet, figure)
    made = [None, *products(stages(figure.transforms))]
    places = np.concatenate(
        [np.zeros((0, 2)), *(curve for each in made for curve in placed(curves, on_device(scale, each)))]
    )
    places = places[np.isfinite(places).all(axis=1)]
    if not len(places):
        return None
    size = np.array([sheet.width_px, sheet.height_px], np.float64)
    low, high = -_FARTHEST * size, (1 + _FARTHEST) * size
    left, bottom = np.clip(places.min(axis=0), low, high).tolist()
    right, top = np.clip(places.max(axis=0), low, high).tolist()
    return left, bottom, right, top


def others(sheet: Sheet, figure: AnyFigure | None) -> tuple[PenStroke, ...]:
    """The figures that are not worked on, thin; the same from move to move of a drag."""
    rest = tuple(each for each in sheet.figures if each.visible and (figure is None or each.id != figure.id))
    return _thin(replace(sheet, figures=rest, scene=None))


@lru_cache(maxsize=4)
def _thin(sheet: Sheet) -> tuple[PenStroke, ...]:
    scale = device_map(sheet)
    return tuple(
        PenStroke(curve, "muted", 1.25)
        for each in sheet.figures
        for curve in placed(curves_of(sheet, each), on_device(scale, each.matrix))
    )


def figure_at_stages(sheet: Sheet, figure: AnyFigure, shows: Shows, unit: float) -> Iterator[Drawn]:
    """The figure as drawn, after each stage, and after the last; with the way of one of its points."""
    chain, scale = stages(figure.transforms), device_map(sheet)
    made: list[Matrix | None] = [None, *products(chain)]
    curves, count = curves_of(sheet, figure), len(chain)
    area = isinstance(figure, Polygon)
    seen = ghosts_of(count) if shows.ghosts else ([0, count] if count else [0])
    for number in seen:
        ink, pattern = ink_of_stage(number, count)
        last, lit = number == count, number == shows.lit
        for curve in placed(curves, on_device(scale, made[number])):
            if not np.isfinite(curve).all():
                continue
            if area or lit:
                yield Tint(curve, ink, 56 if last or lit else 16)
            yield PenStroke(curve, ink, 3.0 if lit else 2.25 if last and count else 1.25, pattern)
    if count and figure.points_world:
        yield from _way(figure, chain, made, shows, scale, unit)
    for number in seen if count else ():
        ink, _pattern = ink_of_stage(number, count)
        middle = _middle(placed(curves, on_device(scale, made[number])))
        if middle is not None:
            yield Word(str(number), *middle, "text" if number == shows.lit else ink, 0, 0, True, True)


def _middle(curves: tuple[Points, ...]) -> tuple[float, float] | None:
    if not curves:
        return None
    corners = np.concatenate([curve[:-1] if len(curve) > 2 else curve for curve in curves])
    x, y = corners.mean(axis=0).tolist()
    return (x, y) if math.isfinite(x) and math.isfinite(y) else None


def _way(
    figure: AnyFigure,
    chain: list[Stage],
    made: list[Matrix | None],
    shows: Shows,
    scale: DeviceMap,
    unit: float,
) -> Iterator[Drawn]:
    """One point from stage to stage, with where it was drawn and where it has come to."""
    vertex = figure.points_world[min(shows.vertex, len(figure.points_world) - 1)]
    start = np.array([(vertex.x, vertex.y)])
    places = [start if matrix is None else transformed(matrix, start) for matrix in made]
    if shows.ghosts and len(chain) <= MOST_GHOSTS:
        for stage, before, after in zip(chain, places, places[1:], strict=False):
            way = (
                _arc(stage, before)
                if stage.elementary.name == "rotation"
                else np.concatenate([before, after])
            )
            yield from arrow(scale.points(way), unit)
    for k, ink in ((0, "muted"), (-1, "data1")):
        x, y = places[k][0].tolist()
        if math.isfinite(x) and math.isfinite(y):
            device_x, device_y = scale.point(x, y)
            yield Marker(device_x, device_y, ink, "dot", 8 if k else 6)
            right = -1 if k and x < places[0][0, 0] else 1
            yield Word(place_text(x, y), device_x, device_y, "text", right, 1 if k == 0 else 0, True, bool(k))


def _arc(stage: Stage, start: Points) -> Points:
    """The way of a point that is turned about the origin, world."""
    (x, y), (angle,) = start[0].tolist(), stage.elementary.arguments
    shown = math.remainder(angle, math.tau) if abs(angle) > math.tau else angle
    turns = math.atan2(y, x) + np.linspace(0.0, shown, _ARC_STEPS + 1)
    return math.hypot(x, y) * np.stack([np.cos(turns), np.sin(turns)], axis=1)


def arrow(points: Points, unit: float, ink: Ink = "text") -> Iterator[Drawn]:
    """A line with a head at its end."""
    if not np.isfinite(points).all():
        return
    length = float(np.hypot(*np.diff(points, axis=0).T).sum())
    if length < 1.5 * _HEAD_PX * unit:
        return
    yield PenStroke(points, ink, 1.25)
    tip, way = points[-1], points[-1] - points[-2]
    angle = math.atan2(way[1], way[0])
    size = _HEAD_PX * unit
    sides = [
        (tip[0] - size * math.cos(angle + turn), tip[1] - size * math.sin(angle + turn))
        for turn in (_HEAD_ANGLE, -_HEAD_ANGLE)
    ]
    yield Tint(np.array([tuple(tip), *sides], np.float64), ink, 255)


def moved_axes(sheet: Sheet, figure: AnyFigure, shows: Shows, unit: float) -> Iterator[Drawn]:
    """The figure where it was drawn, and the axes that the chain moves, with a point's new coordinates."""
    scale, matrix = device_map(sheet), figure.matrix
    for curve in curves_of(sheet, figure):
        if isinstance(figure, Polygon):
            yield Tint(curve, "data1", 56)
        yield PenStroke(curve, "data1", 2.25)
    if matrix is None or not np.isfinite(matrix).all():
        return
    for direction, name in (((1.0, 0.0), "x′"), ((0.0, 1.0), "y′")):
        origin = np.array([0.0, 0.0])
        length = _AXIS_PX * unit / abs(scale.sx)
        ends = transformed(
            matrix, np.array([origin - np.multiply(direction, length), np.multiply(direction, 2 * length)])
        )
        device = scale.points(ends)
        yield PenStroke(device, "data2", 1.75, "dash")
        yield from arrow(np.array([device.mean(axis=0), device[1]]), unit, "data2")
        tip_x, tip_y = device[1].tolist()
        yield Word(name, tip_x, tip_y, "data2", 1, 1, False, True)
    origin_x, origin_y = scale.points(transformed(matrix, np.zeros((1, 2))))[0].tolist()
    yield Marker(origin_x, origin_y, "data2", "ring", 10)
    if figure.points_world and not is_singular(matrix):
        point = figure.points_world[min(shows.vertex, len(figure.points_world) - 1)]
        x, y, _w = np.linalg.solve(matrix, (point.x, point.y, 1.0)).tolist()
        device_x, device_y = scale.point(point.x, point.y)
        yield Marker(device_x, device_y, "data1")
        yield Word(place_text(point.x, point.y), device_x, device_y, "text", 1, 1, True)
        yield Word(f"x′, y′ = {place_text(x, y)}", device_x, device_y, "data2", 1, -1, True, True)
