"""Areas as a random-scan tube can hint at them: strokes across the rows that a fill would paint."""

import numpy as np

from workbench.document.model import Sheet
from workbench.rendering.display_program import Strokes
from workbench.rendering.emissions import emitted
from workbench.rendering.pipeline import colour_of
from workbench.rendering.raster import figure_calls
from workbench.rendering.rounds import is_area


def hatched(sheet: Sheet, spacing: int) -> Strokes:
    """One stroke for each span of every ``spacing``-th row of the filled figures; a single pixel has none."""
    ends: list[tuple[float, float, float, float]] = []
    colours: list[int] = []
    figures: list[int] = []
    for number, figure in enumerate(sheet.figures):
        if not figure.visible or not is_area(figure):
            continue
        for call in figure_calls(sheet, figure):
            if call.entry.emits != "spans":
                continue
            rows = np.asarray(emitted(call), np.int64).reshape(-1, 3)
            for y, left, right in rows[(rows[:, 0] % spacing == 0) & (rows[:, 2] > rows[:, 1])].tolist():
                ends.append((left, y, right, y))
                colours.append(colour_of(sheet, figure))
                figures.append(number)
    table = np.array(ends, np.float64).reshape(-1, 2, 2)
    return Strokes(table, np.array(colours, np.int64), np.array(figures, np.int64))


def filled_pixels(sheet: Sheet) -> int:
    """How many pixels the filled figures of a sheet paint, those that are painted twice counted twice."""
    spans = [
        np.asarray(emitted(call), np.int64).reshape(-1, 3)
        for figure in sheet.figures
        if figure.visible and is_area(figure)
        for call in figure_calls(sheet, figure)
        if call.entry.emits == "spans"
    ]
    return int(sum((rows[:, 2] - rows[:, 1] + 1).sum() for rows in spans if len(rows)))
