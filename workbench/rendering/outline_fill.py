"""The outline of a polygon, drawn, and a seed inside it: what a seed fill needs to paint the same area."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import CALLS
from workbench.document.model import Line, Polygon, Sheet
from workbench.geometry.conventions import round_half_up
from workbench.rendering.clipping import visible_rings
from workbench.rendering.mapping import Call
from workbench.rendering.pipeline import calls, colour_of
from workbench.rendering.raster import emitted, pixels

Cells = NDArray[np.int64]
_DEEPEST = 1000


class OutlineFill(NamedTuple):
    """The seed fill ``call`` (None when the outline has no inside), and the outline's pixels (n, 2)."""

    call: Call | None
    outline: Cells


def outline_fill(sheet: Sheet, polygon: Polygon, slug: str) -> OutlineFill:
    """Draw the sides of ``polygon`` on an empty picture and fill them from a pixel far from their ends.

    Sides and area are drawn by what lines and polygons begin with. The seed is the pixel of the area, off the
    outline, that is nearest to the middle of all such.
    """
    cells = _outline(sheet, polygon)
    paper = sheet.palette[sheet.background % len(sheet.palette)]
    boundary = colour_of(sheet, polygon)
    fill = next(colour for colour in (0x7F7F7F, 0x808080, 0x818181) if colour not in (paper, boundary))
    if boundary == paper:
        return OutlineFill(None, cells)
    image = np.full((sheet.height_px, sheet.width_px), paper, np.uint32)
    image[cells[:, 1], cells[:, 0]] = boundary
    fills = calls(sheet, polygon, Polygon.algorithms[0])
    inside = [pixels(call.entry, emitted(call)) for call in fills]
    area = _seen(np.concatenate(inside), sheet) if inside else cells[:0]
    free = area[image[area[:, 1], area[:, 0]] == paper]
    if not len(free):
        return OutlineFill(None, cells)
    away = np.abs(free - np.median(free, axis=0)).sum(axis=1)
    x, y = (int(value) for value in free[int(away.argmin())])
    given = {"image": image, "x": x, "y": y, "fill": fill, "boundary": boundary}
    entry = catalogue.get(slug)
    limit = _DEEPEST if entry.stack == CALLS else 0
    return OutlineFill(Call(entry, tuple(given[p.name] for p in entry.parameters), limit), cells)


def _outline(sheet: Sheet, polygon: Polygon) -> Cells:
    function = catalogue.get(Line.algorithms[0]).function
    spans: list[tuple[int, int]] = []
    for ring in visible_rings(sheet, [polygon])[0]:
        corners = [(round_half_up(x), round_half_up(y)) for x, y in ring.tolist()]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            spans += [(int(x), int(y)) for x, y in function(*start, *end)]
    return _seen(np.array(sorted(set(spans)), np.int64).reshape(-1, 2), sheet)


def _seen(cells: Cells, sheet: Sheet) -> Cells:
    x, y = cells[:, 0], cells[:, 1]
    return cells[(x >= 0) & (x < sheet.width_px) & (y >= 0) & (y < sheet.height_px)]
