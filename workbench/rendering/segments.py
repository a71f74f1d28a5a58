"""Lines, polylines and curves as tables of segments: mapped, clipped and cut all at once.

A row is (x0, y0, x1, y1), device coordinates. What lies inside a window is not changed by clipping, so that
only the others are given to a text; the rows are the same as if all were, and in the same order.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import Curve, Line, Polyline, Sheet
from workbench.engine.at_hand import at_hand
from workbench.rendering.curves import polylines_of
from workbench.rendering.emissions import emitted
from workbench.rendering.limits import clip_segments
from workbench.rendering.mapping import Box, Call, device_points
from workbench.rendering.rounds import Lines, Round

Segment = tuple[float, float, float, float]
Table = NDArray[np.float64]


class Segments(NamedTuple):
    """Segments (n, 4) of several figures, and which of these each one is of, (n,), ascending."""

    table: Table
    of: NDArray[np.int64]


def segments(sheet: Sheet, figures: Sequence[Lines]) -> Segments:
    """What figures are made of, not clipped; of a curve the chords that stand for it."""
    curves: dict[int, Curve | Round] = {}
    straight_ones: dict[int, Line | Polyline] = {}
    for k, figure in enumerate(figures):
        if isinstance(figure, Line | Polyline):
            straight_ones[k] = figure
        else:
            curves[k] = figure
    if not curves:
        return _straight(sheet, list(straight_ones.values()), np.arange(len(figures)))
    chains = polylines_of(sheet, list(curves.values()))
    chords = _chains(np.concatenate(chains), [len(chain) for chain in chains], np.array(list(curves)))
    if not straight_ones:
        return chords
    straight = _straight(sheet, list(straight_ones.values()), np.array(list(straight_ones)))
    of = np.concatenate([straight.of, chords.of])
    order = np.argsort(of, kind="stable")
    return Segments(np.concatenate([straight.table, chords.table])[order], of[order])


def _straight(sheet: Sheet, figures: Sequence[Line | Polyline], numbers: NDArray[np.int64]) -> Segments:
    chains = [
        (*figure.points_world, figure.points_world[0])
        if isinstance(figure, Polyline) and figure.closed and len(figure.points_world) > 2
        else figure.points_world
        for figure in figures
    ]
    return _chains(device_points(sheet, figures, chains), [len(chain) for chain in chains], numbers)


def _chains(corners: Table, lengths: list[int], numbers: NDArray[np.int64]) -> Segments:
    """The segments from each corner (m, 2) to the next one of the same chain."""
    of = np.repeat(numbers, lengths)
    joined = of[1:] == of[:-1]
    table = np.hstack([corners[:-1], corners[1:]])
    return Segments(table, of[1:]) if joined.all() else Segments(table[joined], of[1:][joined])


def inside(table: Table, window: Box) -> NDArray[np.bool_]:
    """Which segments (n,) have both ends in the window, its edges included."""
    xmin, ymin, xmax, ymax = window
    low, high = np.array([xmin, ymin, xmin, ymin]), np.array([xmax, ymax, xmax, ymax])
    both: NDArray[np.bool_] = np.all((table >= low) & (table <= high), axis=1)
    return both


def clipped_segment(slug: str, segment: Segment, window: Box) -> tuple[Segment, ...]:
    """What a line clipper keeps of a segment: one segment or none."""
    rows = emitted(Call(catalogue.get(slug), (*segment, *window))).tolist()
    return tuple((float(x0), float(y0), float(x1), float(y1)) for x0, y0, x1, y1 in rows)


def clipped(slug: str, whole: Segments, window: Box) -> Segments:
    """What a line clipper keeps of each segment."""
    kept = inside(whole.table, window)
    if kept.all():
        return whole
    crossing = whole.table[~kept]
    function = catalogue.get(slug).function
    if at_hand(function, "collect_many"):
        from workbench.engine.compiled import collect_many

        rows = np.hstack([crossing, np.broadcast_to(window, crossing.shape)])
        values, ends = collect_many(function, rows, compiling=False)
        return _with_parts(whole, kept, values, np.diff(ends, prepend=0))
    parts = [clipped_segment(slug, (x0, y0, x1, y1), window) for x0, y0, x1, y1 in crossing.tolist()]
    return _with_parts(
        whole, kept, _table([row for part in parts for row in part]), np.array([len(part) for part in parts])
    )


def cut(whole: Segments, window: Box) -> Segments:
    """What of each segment lies in a rectangle; without those of which nothing does."""
    kept = inside(whole.table, window)
    if kept.all():
        return whole
    parts, seen = clip_segments(whole.table[~kept], window)
    return _with_parts(whole, kept, parts, seen.astype(np.int64))


def _with_parts(
    whole: Segments, kept: NDArray[np.bool_], parts: Table, counts: NDArray[np.int64]
) -> Segments:
    """Segments with those that are not kept replaced by ``parts``, so many for each."""
    each = np.ones(len(kept), np.int64)
    each[~kept] = counts
    rows = np.repeat(np.arange(len(kept)), each)
    table = whole.table[rows]
    table[~kept[rows]] = parts
    return Segments(table, whole.of[rows])


def rounded(table: Table) -> NDArray[np.int64]:
    """The nearest pixels of coordinates, by the rule of ``round_half_up``."""
    nearest: NDArray[np.int64] = np.floor(table + 0.5).astype(np.int64)
    return nearest


def _table(rows: Sequence[Segment]) -> Table:
    return np.array(rows, np.float64).reshape(-1, 4)
