"""What the picture of many figures costs when all of them have changed, and of many curves after one edit.

Printed are the median and the least time of this thread, in milliseconds, by the plain texts and by kernels.
"""

import time
from collections.abc import Callable

import numpy as np
import pytest
from msgspec.structs import replace

from tests.bench.large_document import large
from workbench.algorithms import catalogue
from workbench.document.model import AnyFigure, Circle, Polygon, Polyline, Sheet, WorldPoint
from workbench.document.samples.figures import document_of
from workbench.engine.warm import compile_use, work
from workbench.rendering import display_list, frame_buffer

KINDS = ("polylines", "polygons", "circles", "mixed")
FIGURES, TURNS = 100, 15


@pytest.fixture(scope="module", params=["plain", "kernels"])
def reading(request: pytest.FixtureRequest) -> str:
    """First by the plain texts, then, with all that pictures need at hand, by kernels."""
    if request.param == "kernels":
        slugs = [entry.slug for entry in catalogue.entries()]
        for slug, use in work(slugs, ("paint_batch", "collect_many", "collect")):
            compile_use(catalogue.get(slug), use)
    return str(request.param)


def figures(kind: str, seed: int) -> list[AnyFigure]:
    """100 figures on 320 x 240: polylines of 10 segments, polygons of 10 corners, circles, or mixed."""
    random = np.random.default_rng(seed)
    made: list[AnyFigure] = []
    for number in range(FIGURES):
        places = random.uniform((0, 0), (320, 240), (11, 2)).tolist()
        points = tuple(WorldPoint(f"p{k}", x, y) for k, (x, y) in enumerate(places))
        radius = float(random.uniform(2, 60))
        several = (
            Polyline(f"f{number}", points, "bresenham_line"),
            Polygon(f"f{number}", points[:10], "scan_line_exact"),
            Circle(f"f{number}", points[:1], "midpoint_circle", radius_world=radius),
        )
        made.append(several[number % 3 if kind == "mixed" else KINDS.index(kind)])
    return made


def report(title: str, act: Callable[[Sheet], object], sheets: list[Sheet]) -> None:
    """Print what ``act`` takes for each of some sheets."""
    times = []
    for sheet in sheets:
        begun = time.thread_time()
        act(sheet)
        times.append((time.thread_time() - begun) * 1e3)
    print(f"\n{title}: median {np.median(times):.2f}, least {min(times):.2f} ms")


@pytest.mark.parametrize("kind", KINDS)
def test_a_hundred_figures_have_changed(reading: str, kind: str) -> None:
    sheets = [document_of("x", 320, 240, figures(kind, seed)).sheets[0] for seed in range(TURNS)]
    report(f"100 {kind} by {reading}, of which all have changed", frame_buffer, sheets)


def test_one_of_ten_thousand_curves_has_changed(reading: str) -> None:
    (sheet,) = large().sheets
    report(f"10,000 curves by {reading}, the first time", frame_buffer, [sheet])
    edited = []
    curve = sheet.figures[5000]
    for turn in range(TURNS):
        first = replace(curve.points_world[0], x=float(turn))
        moved = replace(curve, points_world=(first, *curve.points_world[1:]))
        edited.append(replace(sheet, figures=(*sheet.figures[:5000], moved, *sheet.figures[5001:])))
    report(f"10,000 curves by {reading}, one edit", frame_buffer, edited)
    report(f"their strokes, one edit, by {reading}", display_list, edited)
