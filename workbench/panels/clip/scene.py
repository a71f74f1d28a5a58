"""What the Clip canvas draws of a sheet: the window, its nine regions with their codes, and every line and
polygon with what is kept of it and what is cut off.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal

import numpy as np

from workbench.algorithms.clipping.cutting import bits
from workbench.algorithms.clipping.degenerate_edges import degenerate_edges
from workbench.algorithms.clipping.edges import region_code
from workbench.algorithms.clipping.window_marks import corners, degenerate_marks
from workbench.algorithms.marks import closed
from workbench.document.model import AnyFigure, Circle, Line, Polyline, Sheet
from workbench.rendering.clipping import Segment, clip_box, clipped_segment, clipper_calls, segments_of
from workbench.rendering.mapping import Box
from workbench.rendering.raster import emitted
from workbench.rendering.rounds import is_area, is_lines
from workbench.widgets.canvas.drawing import Drawn, Pattern, Region, Spot, Stroke, Word

Fate = Literal["accepted", "clipped", "rejected"]

INKS: dict[Fate, str] = {"accepted": "data3", "clipped": "data1", "rejected": "data4"}
PATTERNS: dict[Fate, Pattern] = {"accepted": "solid", "clipped": "dash", "rejected": "dot"}
MOST_CODED = 12


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of one line, ring or point; ``kept`` is the visible part of a line, or a ring's corners."""

    given: tuple[Any, ...]
    fate: Fate
    kept: tuple[tuple[float, ...], ...] = ()


def outcomes(sheet: Sheet, figure: AnyFigure) -> list[Outcome]:
    """What the sheet's clippers make of each line, ring or point of a figure."""
    window = clip_box(sheet)
    if window is None:
        return []
    if is_lines(figure):
        return [_line_outcome(sheet, segment, window) for segment in segments_of(sheet, figure)]
    found = []
    for call in clipper_calls(sheet, figure):
        rows = emitted(call).tolist()
        given = call.arguments[0].tolist() if is_area(figure) else rows
        whole: Fate = "accepted" if _same_ring(rows, given) else "clipped"
        found.append(Outcome(call.arguments, whole if rows else "rejected", tuple(map(tuple, rows))))
    return found


def _line_outcome(sheet: Sheet, segment: Segment, window: Box) -> Outcome:
    kept = clipped_segment(sheet.line_clipper, segment, window)
    if not kept:
        return Outcome(segment, "rejected")
    return Outcome(segment, "accepted" if kept[0] == segment else "clipped", kept)


def _same_ring(first: list[list[float]], second: list[list[float]]) -> bool:
    return len(first) == len(second) and sorted(map(tuple, first)) == sorted(map(tuple, second))


def tally(sheet: Sheet) -> dict[Fate, int]:
    """How many lines, rings and points of the sheet were accepted, clipped and rejected."""
    counted: dict[Fate, int] = {"accepted": 0, "clipped": 0, "rejected": 0}
    for figure in sheet.figures:
        if figure.visible:
            for outcome in outcomes(sheet, figure):
                counted[outcome.fate] += 1
    return counted


def scene(sheet: Sheet, active: AnyFigure | None, stepping: bool, codes: bool) -> Iterator[Drawn]:
    """Everything but the run: ``stepping`` leaves the active figure to it, ``codes`` labels the regions."""
    window = clip_box(sheet)
    if window is None:
        return
    yield Region(corners(window)[:4], "accent", 22)
    if codes:
        yield from _regions(sheet, window)
    yield Stroke(corners(window), "text", 2.0, haloed=True)
    coded = 0
    for figure in sheet.figures:
        if not figure.visible:
            continue
        is_active = active is not None and figure.id == active.id
        if not (is_active and stepping):
            yield from _figure(sheet, figure, window)
        if codes and isinstance(figure, Line | Polyline) and (is_active or coded < MOST_CODED):
            coded += 1
            yield from end_codes(sheet, figure, window, is_active)


def _regions(sheet: Sheet, window: Box) -> Iterator[Drawn]:
    """The window's sides prolonged, and the code of each region near its upper side."""
    left, bottom, right, top = -0.5, -0.5, sheet.width_px - 0.5, sheet.height_px - 0.5
    x0, y0, x1, y1 = window
    for x in (x0, x1):
        if left < x < right:
            yield Stroke(np.array([(x, bottom), (x, top)]), "muted", 1.0, "dash")
    for y in (y0, y1):
        if bottom < y < top:
            yield Stroke(np.array([(left, y), (right, y)]), "muted", 1.0, "dash")
    columns = ((left, x0), (max(x0, left), min(x1, right)), (x1, right))
    rows = ((bottom, y0), (max(y0, bottom), min(y1, top)), (y1, top))
    for (low_x, high_x), (low_y, high_y) in product(columns, rows):
        if high_x - low_x > 1 and high_y - low_y > 1:
            x, y = (low_x + high_x) / 2, low_y + 0.8 * (high_y - low_y)
            yield Word(bits(region_code(x, y, *window)), x, y, "muted", strong=True)


def end_codes(sheet: Sheet, figure: Line | Polyline, window: Box, carded: bool) -> Iterator[Drawn]:
    """The code of each end point, beside it, on the side that the label of a selected end leaves free."""
    seen: set[tuple[float, float]] = set()
    for x0, y0, x1, y1 in segments_of(sheet, figure)[:MOST_CODED]:
        for x, y, other_x, other_y in ((x0, y0, x1, y1), (x1, y1, x0, y0)):
            if (x, y) not in seen:
                seen.add((x, y))
                text = bits(region_code(x, y, *window))
                yield Word(text, x, y, "text", 1 if x >= other_x else -1, 1 if y < other_y else -1, carded)


def _figure(sheet: Sheet, figure: AnyFigure, window: Box) -> Iterator[Drawn]:
    for outcome in outcomes(sheet, figure):
        if is_lines(figure):
            yield from line_marks(outcome)
        elif is_area(figure):
            yield from _ring_marks(outcome, window)
        elif isinstance(figure, Circle):
            x, y = outcome.given[:2]
            shape: Literal["dot", "cross"] = "cross" if outcome.fate == "rejected" else "dot"
            yield Spot(x, y, INKS[outcome.fate], shape)


def line_marks(outcome: Outcome) -> Iterator[Drawn]:
    """A line: what is kept solid, what is cut off broken, intersections ringed."""
    x0, y0, x1, y1 = outcome.given[:4]
    ink = INKS[outcome.fate]
    if not outcome.kept:
        yield Stroke(np.array([(x0, y0), (x1, y1)]), ink, 2.0, "dot")
        return
    ax, ay, bx, by = outcome.kept[0]
    a, b = (ax, ay), (bx, by)
    for end, cut in (((x0, y0), a), ((x1, y1), b)):
        if end != cut:
            yield Stroke(np.array([end, cut]), ink, 1.5, "dash")
    yield Stroke(np.array([a, b]), ink, 2.5, haloed=True)
    for end, cut in (((x0, y0), a), ((x1, y1), b)):
        if end != cut:
            yield Spot(*cut, "data2", "ring", 7)


def _ring_marks(outcome: Outcome, window: Box) -> Iterator[Drawn]:
    """A polygon: its outline broken, what is kept solid, edges without area between them in a warning."""
    ring = np.asarray(outcome.given[0], np.float64)
    ink = INKS[outcome.fate]
    yield Stroke(closed(ring), ink, 1.5, PATTERNS[outcome.fate])
    if len(outcome.kept) > 1 and outcome.fate == "clipped":
        yield Stroke(closed(np.array(outcome.kept, np.float64)), ink, 2.5, haloed=True)
        yield from degenerate_marks(outcome.kept, window)


def degenerate_count(sheet: Sheet, figure: AnyFigure | None) -> int:
    """How many such edges the figure, clipped, has."""
    window = clip_box(sheet)
    if window is None or figure is None or not is_area(figure):
        return 0
    return sum(len(degenerate_edges(emitted(call).tolist(), window)) for call in clipper_calls(sheet, figure))
