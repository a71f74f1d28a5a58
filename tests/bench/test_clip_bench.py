"""Clipping compiled beside the same texts interpreted, in one run; each test prints its ratio.

Run with ``pytest tests/bench/test_clip_bench.py --benchmark-enable -s``. Without that switch nothing is
timed, and only the results are compared.
"""

import functools
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pytest_benchmark.fixture import BenchmarkFixture

from workbench.algorithms import catalogue
from workbench.engine import compiled

WINDOW = (200.0, 150.0, 800.0, 650.0)
SEGMENTS = 100_000
SIZES = (25_000, 50_000, 100_000, 200_000, 400_000)
ROUNDS = 5


def rows(count: int) -> NDArray[np.float64]:
    """Segments with ends spread over 1000 x 800: some inside, some outside, most cut once or twice."""
    ends = np.random.default_rng(3).uniform((0, 0, 0, 0), (1000, 800, 1000, 800), (count, 4))
    return np.hstack([ends, np.tile(WINDOW, (count, 1))])


def best(run: Callable[[], Any], rounds: int = ROUNDS) -> float:
    """Seconds of processor time of the fastest of several runs: others may share the cores."""
    found = float("inf")
    for _round in range(rounds):
        start = time.thread_time()
        run()
        found = min(found, time.thread_time() - start)
    return found


@pytest.mark.parametrize("slug", ["cohen_sutherland", "liang_barsky"])
def test_many_segments(benchmark: BenchmarkFixture, slug: str) -> None:
    function = catalogue.get(slug).function
    table = rows(SEGMENTS)
    arguments = table.tolist()

    def interpreted() -> list[tuple[float, ...]]:
        return [emitted for row in arguments for emitted in function(*row)]

    values, ends = benchmark(compiled.collect_many, function, table)
    assert len(ends) == SEGMENTS
    assert np.array(interpreted()).tobytes() == values.tobytes()
    if benchmark.disabled:
        return
    ours = best(lambda: compiled.collect_many(function, table))
    plain = best(interpreted, 2)
    print(
        f"\n{slug}: {SEGMENTS:,} segments, {len(values):,} visible; compiled {ours / SEGMENTS * 1e9:.0f} ns "
        f"each, interpreted {plain / SEGMENTS * 1e9:.0f} ns each, ratio {plain / ours:.0f}"
    )
    benchmark.extra_info.update(ratio=plain / ours, ns_per_segment=ours / SEGMENTS * 1e9)
    times = [float("inf")] * len(SIZES)
    for _turn in range(ROUNDS):
        for number, count in enumerate(SIZES):
            run = functools.partial(compiled.collect_many, function, rows(count))
            times[number] = min(times[number], best(run, 2))
    exponent = np.polyfit(np.log(SIZES), np.log(times), 1)[0]
    listed = ", ".join(f"{n:,}: {t * 1e3:.2f} ms" for n, t in zip(SIZES, times, strict=True))
    print(f"{slug}: time grows as segments to the power {exponent:.2f} ({listed})")


def test_a_polygon_of_many_corners(benchmark: BenchmarkFixture) -> None:
    function = catalogue.get("sutherland_hodgman").function
    angles = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    radii = np.where(np.arange(1000) % 2, 500.0, 250.0)
    star = np.column_stack([500 + radii * np.cos(angles), 400 + radii * np.sin(angles)])

    def interpreted() -> list[tuple[float, float]]:
        return list(function(star, *WINDOW))

    values = benchmark(compiled.collect, function, star, *WINDOW)
    assert np.array(interpreted()).tobytes() == values.tobytes()
    if not benchmark.disabled:
        ours, plain = best(lambda: compiled.collect(function, star, *WINDOW), 50), best(interpreted)
        print(
            f"\nsutherland_hodgman: 1,000 corners, compiled {ours * 1e6:.0f} us, interpreted "
            f"{plain * 1e6:.0f} us, ratio {plain / ours:.0f}"
        )
