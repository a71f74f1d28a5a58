"""Why is this pixel as it is: which calls of which figures emitted it, and as which of their emissions."""

from typing import NamedTuple

import numpy as np

from workbench.document.model import Sheet
from workbench.rendering.mapping import Call
from workbench.rendering.raster import calls_in_views, emitted, painter_of, seen_bounds


class Touch(NamedTuple):
    """One emission on the pixel asked about.

    ``figure`` is the index on the sheet, ``figure_id`` its id, ``call_number`` which call of its algorithm (a
    polyline makes several, and each view its own), ``emission`` the number of the emitted row in that call,
    from 0. ``last`` is true for the emission whose colour stands.
    """

    figure: int
    figure_id: str
    call_number: int
    call: Call
    emission: int
    last: bool


def _emissions(call: Call, x: int, y: int) -> list[int]:
    rows = emitted(call)
    if len(rows) == 0:
        return []
    if call.entry.emits == "spans":
        touching = (rows[:, 0] == y) & (rows[:, 1] <= x) & (x <= rows[:, 2])
    else:
        touching = (rows[:, 0] == x) & (rows[:, 1] == y)
    return [int(k) for k in np.flatnonzero(touching)]


def why(sheet: Sheet, x: int, y: int) -> list[Touch]:
    """Every emission on device pixel (x, y), in the order of painting; empty when no figure touched it."""
    touches: list[Touch] = []
    for place, seen in enumerate(sheet.seen):
        for index, figure in enumerate(sheet.figures):
            x_first, x_last, y_first, y_last = seen_bounds(seen, figure)
            if not figure.visible or not (x_first <= x <= x_last and y_first <= y <= y_last):
                continue
            in_views = calls_in_views(sheet, figure)
            before = sum(map(len, in_views[:place]))
            for number, call in enumerate(in_views[place], before):
                touches.extend(
                    Touch(index, figure.id, number, call, emission, False)
                    for emission in _emissions(call, x, y)
                )
    if touches and int(painter_of(sheet)[y, x]) == touches[-1].figure:
        touches[-1] = touches[-1]._replace(last=True)
    return touches
