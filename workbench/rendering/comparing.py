"""Two runs on the same input: which pixels they share, which not, and which of those are ties."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import AnyFigure, Sheet
from workbench.geometry.distance import circle_distance, ellipse_distance, line_distance, line_tie
from workbench.rendering.mapping import Call
from workbench.rendering.raster import emitted, figure_calls, pixels

Cells = NDArray[np.int64]

ONLY_FIRST, ONLY_SECOND, BOTH, TIE_FIRST, TIE_SECOND = 1, 2, 3, 4, 5
"""Classes of pixels; 0 is neither, a tie is where the ideal curve passes exactly half way."""


class Comparison(NamedTuple):
    """Pixels (n, 2) in the device frame, each once, in order of row and column.

    ``tied`` are those that only one of the two painted because the ideal line passes exactly half way between
    it and the other's choice; they are in neither ``only_first`` nor ``only_second``.
    """

    both: Cells
    only_first: Cells
    only_second: Cells
    tied_first: Cells
    tied_second: Cells

    @property
    def ties(self) -> int:
        """Places where the two differ by a tie; a pixel of each belongs to one place."""
        return max(len(self.tied_first), len(self.tied_second))


def figure_pixels(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> Cells:
    """The pixels (n, 2) of a figure in the order in which its algorithm, or another, paints them.

    Of spans what lies in the picture.
    """
    whole = 0, sheet.width_px - 1, 0, sheet.height_px - 1
    parts = [pixels(call.entry, emitted(call), whole) for call in figure_calls(sheet, figure, algorithm)]
    return np.concatenate(parts) if parts else np.empty((0, 2), np.int64)


def compare(sheet: Sheet, figure: AnyFigure, first: str, second: str) -> Comparison:
    """What two algorithms of the catalogue make of one figure. Raises LookupError for an unknown one."""
    sets = [figure_pixels(sheet, figure, algorithm) for algorithm in (first, second)]
    return in_common(sets[0], sets[1], figure_calls(sheet, figure, first))


def in_common(first: Cells, second: Cells, calls: Sequence[Call]) -> Comparison:
    """What two lists of pixels (n, 2) have in common; ``calls`` have the ideal lines that may be ties."""
    sets = [{(x, y) for x, y in cells.tolist()} for cells in (first, second)]
    lines = [call.arguments[:4] for call in calls if is_line(call)]
    only = [sets[0] - sets[1], sets[1] - sets[0]]
    tied = [
        {(x, y) for x, y in side if any(line_tie(x0, y0, x1, y1, x, y) for x0, y0, x1, y1 in lines)}
        for side in only
    ]
    return Comparison(
        _cells(sets[0] & sets[1]),
        _cells(only[0] - tied[0]),
        _cells(only[1] - tied[1]),
        _cells(tied[0]),
        _cells(tied[1]),
    )


def is_line(call: Call) -> bool:
    """Whether the call paints a straight line from its first four arguments, x0, y0, x1, y1."""
    ends = call.entry.parameter_names[:4] == ("x0", "y0", "x1", "y1")
    return ends and call.entry.emits in ("pixels", "coverage")


def distances(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> NDArray[np.float64]:
    """Distance of every painted pixel from the ideal curve, in pixels, in the order of painting.

    Positive above a line and outside a circle or ellipse. Empty for figures without an ideal curve.
    """
    parts = []
    for call in figure_calls(sheet, figure, algorithm):
        points = pixels(call.entry, emitted(call)).astype(np.float64)
        names = [p.name for p in call.entry.parameters]
        if is_line(call):
            x0, y0, x1, y1 = call.arguments[:4]
            parts.append(line_distance(x0, y0, x1, y1, points))
        elif names[:3] == ["xc", "yc", "r"]:
            xc, yc, r = call.arguments[:3]
            parts.append(circle_distance(xc, yc, r, points))
        elif names[:4] == ["xc", "yc", "rx", "ry"]:
            xc, yc, rx, ry = call.arguments[:4]
            parts.append(ellipse_distance(xc, yc, rx, ry, points))
    return np.concatenate(parts) if parts else np.empty(0)


def _cells(cells: set[tuple[int, int]]) -> Cells:
    return np.array(sorted(cells, key=lambda p: (p[1], p[0])), np.int64).reshape(-1, 2)


def compare_classes(
    size: tuple[int, int],
    first: NDArray[np.integer],
    second: NDArray[np.integer],
    ties: NDArray[np.integer] | None = None,
) -> NDArray[np.uint8]:
    """The (h, w) classes of two lists of cells, each (n, 2), on a picture of ``size`` (width, height).

    Cells outside the picture drop out; ``ties`` counts only where the two differ.
    """
    classes = np.zeros((size[1], size[0]), np.uint8)
    for cells, value in ((first, ONLY_FIRST), (second, ONLY_SECOND)):
        x, y = _inside(size, cells)
        classes[y, x] |= value
    if ties is not None:
        tied = np.zeros(classes.shape, bool)
        x, y = _inside(size, ties)
        tied[y, x] = True
        classes[tied & ((classes == ONLY_FIRST) | (classes == ONLY_SECOND))] += TIE_FIRST - ONLY_FIRST
    return classes


def _inside(
    size: tuple[int, int], cells: NDArray[np.integer]
) -> tuple[NDArray[np.integer], NDArray[np.integer]]:
    x, y = cells.reshape(-1, 2).T
    kept = (x >= 0) & (x < size[0]) & (y >= 0) & (y < size[1])
    return x[kept], y[kept]
