"""How fast the methods for hidden surfaces are on many polygons; with processor times and limits.

Run with ``pytest tests/bench/test_visibility_bench.py --benchmark-enable -s``.
"""

import time

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.engine import compiled

ROUNDS = 12


def polygons(count, radius, size):
    """Triangles about circles of this radius in pixels, turned any way, anywhere in a box as deep as it is
    wide, on a grid of 1/4096 px: corners (3n, 3), faces (n, 3)."""
    chance = np.random.default_rng(0)
    width, height = size
    kept = np.zeros((0, 3, 3))
    while len(kept) < count:
        across = chance.normal(size=(count, 2, 3))
        u = across[:, 0] / np.linalg.norm(across[:, 0], axis=1)[:, None]
        v = across[:, 1] - (across[:, 1] * u).sum(axis=1)[:, None] * u
        v /= np.linalg.norm(v, axis=1)[:, None]
        angles = np.array([0.0, 2.1, 4.2]) + chance.uniform(-0.5, 0.5, (count, 3))
        middle = chance.uniform(0, 1, (count, 3)) * (width, height, width - 2 * radius) + (0, 0, radius)
        round_it = np.cos(angles)[..., None] * u[:, None] + np.sin(angles)[..., None] * v[:, None]
        corners = middle[:, None] + radius * round_it
        corners[..., :2] = np.rint(corners[..., :2] * 4096) / 4096
        corners[..., 2] /= width
        (ax, ay), (bx, by) = (
            (corners[:, 1] - corners[:, 0])[:, :2].T,
            (corners[:, 2] - corners[:, 0])[:, :2].T,
        )
        kept = np.concatenate([kept, corners[np.abs(ax * by - ay * bx) > 0.05 * radius * radius]])
    return kept[:count].reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)


@pytest.mark.parametrize(
    ("method", "count", "size", "most_ms"),
    [
        ("bsp_tree", 5_000, (800, 600), 200),
        ("depth_sort", 2_000, (800, 600), 30),
        ("area_subdivision", 50, (256, 256), 6),
        ("scan_line_surfaces", 2_000, (800, 600), 30),
    ],
)
def test_polygons_of_40_pixels(benchmark, method, count, size, most_ms):
    """The kernel alone, compiled beforehand, into a picture of the kind that the program draws."""
    function = catalogue.get(method).function
    corners, faces = polygons(count if not benchmark.disabled else 20, 40, size)
    colours, times = np.arange(1, len(faces) + 1), []

    def run():
        image = np.zeros(size[::-1], np.uint32)
        begun = time.process_time()
        compiled.paint(function, image, 0, image, corners, faces, colours)
        times.append((time.process_time() - begun) * 1e3)
        return image

    benchmark.pedantic(run, rounds=ROUNDS if not benchmark.disabled else 1, warmup_rounds=1)
    assert run().any()
    benchmark.extra_info.update(ms=min(times))
    print(f"\n{method}, {count:,} polygons: {min(times):.1f} ms, {min(times) / most_ms:.2f} of {most_ms} ms")
