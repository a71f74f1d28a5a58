"""A drag without a window: one of 1,000 points of a curve of each kind, one of 2,001 corners of a polyline.

Each move is an edit, the frame buffer, the display list and the outline; printed are the median and the 99th
percentile. Garbage is collected between the moves, as the program does while it is idle.
"""

import gc
import math
from time import perf_counter, thread_time

import numpy as np
import pytest

from workbench.document import edits
from workbench.document.curves.settings import set_spline
from workbench.document.model import SPLINES, Curve, CurvePoint, Document, Polyline
from workbench.document.samples.figures import document_of, polyline
from workbench.rendering import display_list, frame_buffer
from workbench.rendering.curves import polyline_of

MOVES = 100


def spiral(count: int) -> list[tuple[float, float]]:
    angle, radius = np.linspace(0, 40, count), np.linspace(5, 95, count)
    x, y = 160 + 1.5 * radius * np.cos(angle), 100 + radius * np.sin(angle)
    return list(zip(x.tolist(), y.tolist(), strict=True))


def drawn(kind: str) -> Document:
    """The spiral as a polyline, or by one kind of curve."""
    if kind == "polyline":
        return document_of("Polyline", 320, 200, [polyline(spiral(2001), 1, "", False)])
    points = tuple(CurvePoint("", x, y) for x, y in spiral(1000))
    return set_spline("f1", kind)(document_of("Curve", 320, 200, [Curve("", points, "bresenham_line")]))


@pytest.mark.parametrize("kind", ["polyline", *(kind for kind in SPLINES if kind != "bezier")])
def test_one_point_is_dragged(kind: str) -> None:
    document = drawn(kind)
    figure = document.sheets[0].figures[0]
    assert isinstance(figure, Curve | Polyline)
    point = figure.points_world[500]
    taken = []
    gc.disable()
    try:
        for k in range(MOVES):
            place = point.x + 3 * math.sin(k * 0.1), point.y + 3 * math.cos(k * 0.13)
            begun, worked = perf_counter(), thread_time()
            document = edits.move_points({f"s1/f1/{point.id}/x": place})(document)
            sheet = document.sheets[0]
            frame_buffer(sheet)
            display_list(sheet)
            now = sheet.figures[0]
            if isinstance(now, Curve):
                polyline_of(sheet, now)
            taken.append((perf_counter() - begun, thread_time() - worked))
            if k % 20 == 19:
                gc.collect()
    finally:
        gc.enable()
    (middle, own), (late, _own) = np.percentile(np.array(taken[5:]) * 1000, [50, 99], axis=0)
    print(f"\n{kind}: {middle:.1f} ms, of the processor {own:.1f}; 99th percentile {late:.1f} ms")
    assert own < 12.0
