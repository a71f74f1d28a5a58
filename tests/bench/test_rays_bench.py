"""Ray casting through boxes, and the octree, on 100,000 triangles beside Embree, on one thread.

Run with ``pytest tests/bench/test_rays_bench.py --benchmark-enable -s``.
"""

import time

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.engine import compiled

SIZE = 800, 600
COUNT = 100_000
ROUNDS = 4


def on_grid(corners):
    """Corners (n, 3) of the device, x and y on a grid of 1/4096 px."""
    corners[:, :2] = np.rint(corners[:, :2] * 4096) / 4096
    return corners


def bumpy(count):
    """A closed surface like a sphere with bumps, of about so many triangles that share corners."""
    around = int(np.sqrt(count / 2))
    along = count // (2 * around)
    u, v = np.meshgrid(
        np.linspace(0, 2 * np.pi, around, endpoint=False), np.linspace(0.002, np.pi - 0.002, along + 1)
    )
    r = 1 + 0.15 * np.sin(7 * u) * np.sin(5 * v) ** 2 + 0.05 * np.sin(31 * u + 17 * v) * np.sin(v)
    places = np.stack([r * np.sin(v) * np.cos(u), r * np.cos(v), -r * np.sin(v) * np.sin(u)], -1)
    scale = 0.95 * SIZE[1] / np.ptp(places[..., 1])
    corners = places.reshape(-1, 3) * (scale, scale, 0.4) + (SIZE[0] / 2, SIZE[1] / 2, 0.5)
    i, j = np.meshgrid(np.arange(along), np.arange(around), indexing="ij")
    a, b = (i * around + j).ravel(), (i * around + (j + 1) % around).ravel()
    faces = np.concatenate([np.stack([a, b, b + around], 1), np.stack([a, b + around, a + around], 1)])
    return on_grid(corners), faces


def soup(count):
    """Triangles of about eight pixels anywhere, some twenty behind each other."""
    chance = np.random.default_rng(0)
    middles = chance.uniform(0, 1, (count, 1, 3)) * (*SIZE, 1)
    corners = middles + chance.normal(size=(count, 3, 3)) * (8, 8, 8 / SIZE[0])
    return on_grid(corners.reshape(-1, 3)), np.arange(3 * count).reshape(-1, 3)


def best(do, clock):
    """The least seconds of some runs, and what the last gave."""
    times = []
    for _round in range(ROUNDS):
        begun = clock()
        given = do()
        times.append(clock() - begun)
    return min(times), given


def by_embree(corners, faces):
    """Seconds for its hierarchy and for a ray through each pixel, and the triangles it meets."""
    scenes = pytest.importorskip("embreex.rtcore_scene")
    from embreex import rtcore
    from embreex.mesh_construction import TriangleMesh

    device = rtcore.EmbreeDevice()
    deep = (corners * (1, 1, SIZE[0])).astype(np.float32)
    far = np.array([[0, 0, -9]], np.float32), np.array([[0, 0, 1]], np.float32)

    def build():
        scene = scenes.EmbreeScene(device)
        TriangleMesh(scene, deep, faces.astype(np.int32))
        scene.run(*far)  # which commits it
        return scene

    y, x = np.mgrid[: SIZE[1], : SIZE[0]]
    start = np.stack([x.ravel(), y.ravel(), np.full(x.size, -1)], 1).astype(np.float32)
    way = np.repeat(far[1], x.size, axis=0)
    # Whatever threads it builds on, all of their time counts
    built, scene = best(build, time.process_time)
    traced, met = best(lambda: scene.run(start, way), time.thread_time)
    return built, traced, np.asarray(met).reshape(SIZE[::-1])


def by_text(slug, corners, faces):
    """Seconds of a text for a picture of one pixel, which are those of building, and for the whole picture
    beyond that; and the triangles that it shows."""
    function, colours = catalogue.get(slug).function, np.arange(1, len(faces) + 1)

    def draw(size):
        image = np.zeros(size[::-1], np.uint32)
        compiled.paint(function, image, 0, image, corners, faces, colours)
        return image.astype(np.int64) - 1

    draw((1, 1))
    built, _image = best(lambda: draw((1, 1)), time.thread_time)
    whole, seen = best(lambda: draw(SIZE), time.thread_time)
    return built, whole - built, seen


@pytest.mark.parametrize("make", [bumpy, soup], ids=lambda make: make.__name__)
def test_rays_beside_embree(benchmark, make):
    if benchmark.disabled:
        pytest.skip("measured with --benchmark-enable only")
    corners, faces = make(COUNT)
    built, traced, met = by_embree(corners, faces)
    ours = by_text("ray_casting_boxes", corners, faces)
    cells = by_text("octree", corners, faces)
    assert (ours[2] == cells[2]).mean() > 0.9999
    assert (ours[2] == met).mean() > 0.95  # which has single precision
    ratios = {
        "build": ours[0] / built,
        "trace": ours[1] / traced,
        "octree": (cells[0] + cells[1]) / (built + traced),
    }
    print(f"\n{make.__name__}, {len(faces):,} triangles; Embree {built * 1e3:.0f} + {traced * 1e3:.0f} ms")
    print(
        f"  boxes: build {ours[0] * 1e3:.0f} ms, {ratios['build']:.2f} of Embree's; trace "
        f"{ours[1] * 1e3:.0f} ms, {ratios['trace']:.2f} (at most 3.5)"
    )
    print(f"  octree: {(cells[0] + cells[1]) * 1e3:.0f} ms, {ratios['octree']:.2f} of both (at most 8)")
    benchmark.extra_info.update(ratios)
    benchmark.pedantic(lambda: None)


def test_shadows_through_boxes(benchmark):
    """A ball, 3,480 triangles, in a light, each corner and each pixel tried with boxes and without."""
    from workbench.document.scene.model import Camera, Light, Material, Object, Point3D, Scene
    from workbench.document.scene.solids import Sphere
    from workbench.rendering.scene import shaded

    if benchmark.disabled:
        pytest.skip("measured with --benchmark-enable only")
    light = Light("l1", Point3D(2.0, 2.0, 3.0), distant=False)
    camera = Camera(eye=Point3D(1.0, 2.0, 6.0))
    scene = Scene((Object("o1", Sphere(1.0, 60, 30), "m1"),), (Material("m1"),), (light,), camera)

    def draw(size):
        return shaded.shaded(scene, "phong", size, None, shaded.Model(shadows=True))[0]

    draw((8, 8))
    size = 160, 120
    boxed, picture = best(lambda: draw(size), time.process_time)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(shaded, "_boxed", lambda blockers, _stop: blockers)
        begun = time.process_time()
        plain_picture = draw(size)
        plain = time.process_time() - begun
    assert np.array_equal(picture, plain_picture)
    print(f"\nshadows at 160 x 120: {boxed * 1e3:.0f} ms, without boxes {plain * 1e3:.0f} ms")
    benchmark.extra_info.update(ratio=plain / boxed)
    benchmark.pedantic(lambda: None)
