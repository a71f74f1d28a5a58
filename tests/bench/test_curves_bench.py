"""Curves beside their peers, measured by turns in one run in processor time; each test prints its ratio.

Run with ``pytest tests/bench/test_curves_bench.py --benchmark-enable -s``. Without that switch nothing is
timed, and only the results are compared. The peers bezier and geomdl are used where they are installed.
"""

import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pytest_benchmark.fixture import BenchmarkFixture
from scipy.interpolate import BSpline

from workbench.algorithms.curves import (
    Pieces,
    b_spline_curve,
    b_spline_to_bezier,
    closest_point,
    in_rows,
    natural_cubic,
    open_uniform_knots,
    piece_points,
    polyline,
)
from workbench.engine import compiled

ROUNDS = 7


def by_turns(
    benchmark: BenchmarkFixture, title: str, ours: Callable[[], Any], **peers: Callable[[], Any]
) -> None:
    """Time ours and the peers by turns, print milliseconds (best of all turns) and peer / ours."""
    runs = {"ours": ours, **peers}
    best = dict.fromkeys(runs, float("inf"))
    benchmark.pedantic(ours, rounds=1)
    for _turn in range(0 if benchmark.disabled else ROUNDS):
        for name, run in runs.items():
            start = time.process_time()
            run()
            best[name] = min(best[name], time.process_time() - start)
    if not benchmark.disabled:
        ratios = "".join(
            f"; {name} {best[name] * 1e3:.1f} ms, ratio {best[name] / best['ours']:.1f}" for name in peers
        )
        print(f"\n{title}: ours {best['ours'] * 1e3:.1f} ms{ratios}")
        benchmark.extra_info.update({name: best[name] / best["ours"] for name in peers})


def test_a_million_points_of_a_cubic_b_spline(benchmark: BenchmarkFixture) -> None:
    count = 1_000_000 if not benchmark.disabled else 10_000
    points = np.random.default_rng(1).uniform(0, 1000, (1000, 2))
    knots = open_uniform_knots(1000, 3)
    u = np.linspace(0, 997, count)

    def ours() -> NDArray[Any]:
        return compiled.collect(b_spline_curve, points, knots, 3, count)

    def scipy() -> NDArray[Any]:
        return np.asarray(BSpline(knots, points, 3)(u))

    by_turns(benchmark, f"{count:,} points of a cubic B-spline, 1,000 control points", ours, scipy=scipy)
    assert np.abs(ours() - scipy()).max() <= 1e-9


def curves_to_flatten(count: int) -> NDArray[np.float64]:
    """Cubic curves in a picture of 1000 x 1000, each within 200 pixels."""
    rng = np.random.default_rng(2)
    return np.asarray(rng.uniform(0, 800, (count, 1, 2)) + rng.uniform(0, 200, (count, 4, 2)))


@pytest.mark.parametrize(("peer", "count"), [("bezier", 10_000), ("geomdl", 1_000)])
def test_flattening_cubics(benchmark: BenchmarkFixture, peer: str, count: int) -> None:
    count = count if not benchmark.disabled else 100
    curves = curves_to_flatten(count)
    pieces = Pieces(np.arange(count + 1.0), curves)
    corners = round(len(polyline(pieces, 0.1)) / count)
    package = pytest.importorskip({"bezier": "bezier", "geomdl": "geomdl.BSpline"}[peer])

    def bezier() -> None:
        parts = np.linspace(0, 1, corners)
        for points in curves:
            package.Curve(np.asfortranarray(points.T), degree=3).evaluate_multi(parts)

    def geomdl() -> None:
        for points in curves:
            curve = package.Curve()
            curve.degree, curve.ctrlpts, curve.knotvector = 3, points.tolist(), [0, 0, 0, 0, 1, 1, 1, 1]
            curve.sample_size = corners
            assert len(curve.evalpts) == corners

    title = f"flattening {count:,} cubics to {corners} corners each (the peer without a tolerance, evenly)"
    ours = {"bezier": bezier, "geomdl": geomdl}
    by_turns(benchmark, title, lambda: polyline(pieces, 0.1), **{peer: ours[peer]})


def test_what_a_drag_of_one_of_a_thousand_points_asks_for(benchmark: BenchmarkFixture) -> None:
    points = np.random.default_rng(3).uniform(0, 1000, (1000, 2))
    knots = open_uniform_knots(1000, 3)

    def flattened() -> NDArray[Any]:
        return polyline(b_spline_to_bezier(points, knots, 3), 0.25)

    by_turns(benchmark, "a B-spline of 1,000 points as Bézier pieces, flattened", flattened)
    if not benchmark.disabled:
        start = time.process_time()
        natural_cubic(points)
        print(f"natural spline through 1,000 points: {(time.process_time() - start) * 1e3:.1f} ms")
    assert len(flattened()) > 1000


def test_the_closest_point_of_a_hundred_cubic_pieces(benchmark: BenchmarkFixture) -> None:
    rng = np.random.default_rng(4)
    pieces = natural_cubic(np.cumsum(rng.normal(size=(101, 2)), axis=0) * 30)
    asked = rng.uniform(pieces.controls.min(), pieces.controls.max(), (200, 2))
    curve = in_rows(pieces)
    dense = piece_points(pieces, np.linspace(0, 100, 20_001))

    def ours() -> list[float]:
        return [compiled.collect(closest_point, *curve, x, y)[-1, 3] for x, y in asked.tolist()]

    truth = np.array([np.hypot(*(dense - place).T).min() for place in asked])
    assert (np.array(ours()) <= truth + 1e-9).all()
    assert (np.array(ours()) >= truth - 0.5).all()
    if not benchmark.disabled:
        single = []
        for x, y in asked.tolist():
            start = time.perf_counter()
            compiled.collect(closest_point, *curve, x, y)
            single.append((time.perf_counter() - start) * 1e6)
        median, most = np.percentile(single, [50, 99])
        print(f"\nclosest point of 100 cubic pieces: {median:.0f} us a query, 99 of 100 within {most:.0f} us")
    by_turns(benchmark, "200 closest points of 100 cubic pieces", ours)
