"""Fills and lines compiled beside OpenCV and Skia, by turns, on one thread; each test prints its ratios.

Run with ``pytest tests/bench/test_fill_bench.py --benchmark-enable -s``. Without that switch nothing is
timed, and only the results are compared.
"""

import time
from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from pytest_benchmark.fixture import BenchmarkFixture

from workbench.algorithms import catalogue
from workbench.engine import compiled

SIZE = 1000
ROUNDS = 400
FILL, BOUNDARY = 7, 1


def star(edges: int, size: int = SIZE) -> NDArray[np.float64]:
    """A star polygon of so many edges, corners on whole pixels, (edges, 2); a triangle for 3."""
    angle = 2 * np.pi * np.arange(edges) / edges
    radius = np.where((np.arange(edges) % 2 == 0) | (edges == 3), 0.49 * size, 0.2 * size)
    corners = np.column_stack([np.cos(angle), np.sin(angle)]) * radius[:, None] + size / 2
    return np.round(corners)


def best_of(runs: dict[str, Callable[[], Any]], rounds: int) -> dict[str, float]:
    """Seconds of the fastest turn of each; they take turns, since others share the cores."""
    found = dict.fromkeys(runs, float("inf"))
    for _turn in range(rounds):
        for name, run in runs.items():
            start = time.perf_counter()
            run()
            found[name] = min(found[name], time.perf_counter() - start)
    return found


def exponent(sizes: tuple[int, ...], seconds: list[float]) -> float:
    """By which power of the size the time grows, fitted to all of them."""
    slope, _offset = np.polyfit(np.log(sizes), np.log(seconds), 1)
    return float(slope)


@pytest.mark.parametrize("whole", [True, False], ids=["whole", "fractional"])
@pytest.mark.parametrize("edges", [3, 10, 100, 1000])
def test_star_polygons(benchmark: BenchmarkFixture, edges: int, whole: bool) -> None:
    cv2.setNumThreads(1)
    function = catalogue.get("scan_line_exact").function
    vertices, ends = star(edges), np.array([edges])
    if not whole:
        vertices += np.round(np.random.default_rng(edges).uniform(-0.5, 0.5, (edges, 2)) * 4096) / 4096
    image, peer = np.zeros((SIZE, SIZE), np.uint8), np.zeros((SIZE, SIZE), np.uint8)
    points = [np.round(vertices * 65536).astype(np.int32)]

    def ours() -> None:
        compiled.paint(function, image, FILL, vertices, ends, False, False)

    def opencv() -> None:
        cv2.fillPoly(peer, points, FILL, cv2.LINE_8, 16)

    ours()
    opencv()
    if whole:
        assert not np.any((image != 0) & (peer == 0))
    assert np.count_nonzero(peer) - np.count_nonzero(image) < 1.5 * np.count_nonzero(edge_pixels(vertices))
    benchmark(ours)
    if not benchmark.disabled:
        found = best_of({"ours": ours, "opencv": opencv}, ROUNDS if edges < 1000 else ROUNDS // 4)
        ratio = found["opencv"] / found["ours"]
        print(
            f"\nstar of {edges} {'whole' if whole else 'fractional'} edges: ours "
            f"{found['ours'] * 1e6:.1f} us, OpenCV fillPoly {found['opencv'] * 1e6:.1f} us, ratio {ratio:.2f}"
        )
        benchmark.extra_info["ratio"] = ratio


def edge_pixels(vertices: NDArray[np.float64]) -> NDArray[np.uint8]:
    """What OpenCV draws beyond the interior: its edges, all of them."""
    drawn = np.zeros((SIZE, SIZE), np.uint8)
    cv2.polylines(drawn, [vertices.astype(np.int32)], True, 1, 1, cv2.LINE_8)
    return drawn


def test_a_thousand_polygons_in_one_call(benchmark: BenchmarkFixture) -> None:
    skia = pytest.importorskip("skia")
    function = catalogue.get("scan_line_exact").function
    rng = np.random.default_rng(3)
    corners = rng.uniform(0, SIZE, (1000, 1, 2)) + rng.normal(0, 15, (1000, 3, 2))
    vertices, ends = np.round(corners.reshape(-1, 2) * 4096) / 4096, np.arange(3, 3001, 3)
    image, peer = np.zeros((SIZE, SIZE), np.uint8), np.zeros((SIZE, SIZE), np.uint8)
    path = skia.Path()
    for polygon in vertices.reshape(-1, 3, 2):
        path.addPoly([skia.Point(float(x), float(y)) for x, y in polygon + 0.5], True)  # centres at a half
    path.setFillType(skia.PathFillType.kWinding)
    kind = skia.ImageInfo.MakeA8(SIZE, SIZE)
    canvas = skia.Surface.MakeRasterDirect(kind, peer, SIZE).getCanvas()
    brush = skia.Paint(AntiAlias=False, Color=skia.ColorWHITE)

    def ours() -> None:
        compiled.paint(function, image, FILL, vertices, ends, False, True)

    def theirs() -> None:
        canvas.drawPath(path, brush)

    ours()
    theirs()
    assert ((image != 0) == (peer != 0)).mean() > 0.999
    benchmark(ours)
    if not benchmark.disabled:
        found = best_of({"ours": ours, "skia": theirs}, 60)
        ratio = found["skia"] / found["ours"]
        print(
            f"\n1,000 triangles in one call: ours {found['ours'] * 1e6:.0f} us, "
            f"Skia {found['skia'] * 1e6:.0f} us, ratio {ratio:.2f}"
        )
        benchmark.extra_info["ratio"] = ratio


def test_lines_in_one_call(benchmark: BenchmarkFixture) -> None:
    skia = pytest.importorskip("skia")
    function = catalogue.get("bresenham_line").function
    rows = np.random.default_rng(1).integers(0, SIZE, (20_000 if not benchmark.disabled else 20, 4))
    image, peer = np.zeros((SIZE, SIZE), np.uint8), np.zeros((SIZE, SIZE), np.uint8)
    kind = skia.ImageInfo.MakeA8(SIZE, SIZE)
    canvas = skia.Surface.MakeRasterDirect(kind, peer, SIZE).getCanvas()
    brush = skia.Paint(AntiAlias=False, Color=skia.ColorWHITE, StrokeWidth=0, Style=skia.Paint.kStroke_Style)
    ends = [skia.Point(float(x), float(y)) for x, y in rows.reshape(-1, 2) + 0.5]  # centres at a half

    def ours() -> None:
        compiled.paint_many(function, image, FILL, rows)

    def theirs() -> None:
        canvas.drawPoints(skia.Canvas.PointMode.kLines_PointMode, ends, brush)

    ours()
    theirs()
    assert ((image != 0) == (peer != 0)).mean() > 0.97
    benchmark(ours)
    if not benchmark.disabled:
        found = best_of({"ours": ours, "skia": theirs}, 15)
        ratio = found["skia"] / found["ours"]
        print(
            f"\n20,000 lines in one call: ours {found['ours'] * 1e3:.1f} ms, "
            f"Skia {found['skia'] * 1e3:.1f} ms, ratio {ratio:.2f}"
        )
        benchmark.extra_info["ratio"] = ratio


def disc(size: int) -> NDArray[np.uint8]:
    """An empty disc, as large as the picture lets it be, in boundary."""
    y, x = np.ogrid[:size, :size]
    radius = 0.478 * size
    return np.where((x - size / 2) ** 2 + (y - size / 2) ** 2 <= radius * radius, 0, BOUNDARY).astype(
        np.uint8
    )


def test_a_disc_by_spans(benchmark: BenchmarkFixture) -> None:
    cv2.setNumThreads(1)
    function = catalogue.get("boundary_fill_spans").function
    empty = disc(SIZE)
    image, peer = empty.copy(), empty.copy()
    middle = SIZE // 2

    def ours() -> None:
        compiled.paint(function, image, FILL, image, middle, middle, FILL, BOUNDARY)

    def opencv() -> None:
        cv2.floodFill(peer, None, (middle, middle), FILL)

    ours()
    opencv()
    assert np.array_equal(image, peer)
    assert 715_000 < np.count_nonzero(image == FILL) < 721_000
    benchmark.pedantic(ours, setup=lambda: np.copyto(image, empty), rounds=1 if benchmark.disabled else 20)
    if not benchmark.disabled:
        seconds = {"ours": float("inf"), "opencv": float("inf")}
        for _turn in range(60):
            np.copyto(image, empty)
            np.copyto(peer, empty)
            for name, run in (("ours", ours), ("opencv", opencv)):
                start = time.perf_counter()
                run()
                seconds[name] = min(seconds[name], time.perf_counter() - start)
        ratio = seconds["opencv"] / seconds["ours"]
        print(
            f"\ndisc of {np.count_nonzero(image == FILL):,} pixels: ours {seconds['ours'] * 1e3:.2f} ms, "
            f"OpenCV floodFill {seconds['opencv'] * 1e3:.2f} ms, ratio {ratio:.2f}"
        )
        benchmark.extra_info["ratio"] = ratio


def test_time_grows_with_the_edges(benchmark: BenchmarkFixture) -> None:
    """Many small triangles in one polygon: pixels and edges grow alike, crossings on a row stay few."""
    function = catalogue.get("scan_line_exact").function
    sizes = (500, 1000, 2000, 4000, 8000) if not benchmark.disabled else (500,)
    image = np.zeros((SIZE, SIZE), np.uint8)
    seconds = []
    for count in sizes:
        corners = np.random.default_rng(4).integers(0, SIZE - 12, (count, 1, 2)) + np.array(
            [[0, 0], [11, 2], [4, 11]]
        )
        vertices, ends = corners.reshape(-1, 2).astype(np.float64), np.arange(3, 3 * count + 1, 3)

        def ours(vertices: NDArray[Any] = vertices, ends: NDArray[Any] = ends) -> None:
            compiled.paint(function, image, FILL, vertices, ends, False, True)

        ours()
        seconds.append(best_of({"ours": ours}, 1 if benchmark.disabled else 20)["ours"])
    benchmark(ours)
    assert image.any()
    if not benchmark.disabled:
        print(f"\ntime grows with the edges to the power {exponent(sizes, seconds):.2f}")


def test_time_grows_with_the_pixels(benchmark: BenchmarkFixture) -> None:
    sizes = (500, 1000, 2000, 4000) if not benchmark.disabled else (500,)
    by_rows, fill = catalogue.get("scan_line_exact").function, catalogue.get("boundary_fill_spans").function
    by_lines, by_seed, pixels = [], [], []
    for size in sizes:
        vertices, ends = star(10, size), np.array([10])
        image, empty = np.zeros((size, size), np.uint8), disc(size)
        filled = empty.copy()

        def lines(image: NDArray[Any] = image, polygon: Any = (vertices, ends)) -> None:
            compiled.paint(by_rows, image, FILL, *polygon, False, False)

        def seed(filled: NDArray[Any] = filled, middle: int = size // 2) -> None:
            compiled.paint(fill, filled, FILL, filled, middle, middle, FILL, BOUNDARY)

        lines()
        turns = 1 if benchmark.disabled else 20
        by_lines.append(best_of({"lines": lines}, turns)["lines"])
        found = float("inf")
        for _turn in range(turns):
            np.copyto(filled, empty)
            found = min(found, best_of({"seed": seed}, 1)["seed"])
        by_seed.append(found)
        pixels.append(np.count_nonzero(image))
        assert np.count_nonzero(filled == FILL) == np.count_nonzero(empty == 0)
    benchmark(lines)
    if not benchmark.disabled:
        print(
            f"\ntime grows with the pixels to the power {exponent(tuple(pixels), by_lines):.2f} by scan "
            f"lines, {exponent(tuple(size * size for size in sizes), by_seed):.2f} by spans from a seed"
        )
