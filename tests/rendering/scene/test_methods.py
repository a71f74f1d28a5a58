"""All methods for hidden surfaces on scenes of documents: where they agree and err, what they count."""

from functools import cache
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms.visibility import depth_buffer
from workbench.document.samples.examples import example
from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.rendering.scene import METHODS as RENDERED
from workbench.rendering.scene import methods
from workbench.rendering.scene.arena import MethodRun, run_methods, timed
from workbench.rendering.scene.methods import A_BUFFER, METHODS, depths_of, method_call, surfaces_seen
from workbench.rendering.scene.render import device_triangles, placed
from workbench.rendering.subjects.visibility import surface_call

SIZE = (24, 18)
WHERE_NOTHING_PIERCES = {"painter", "scan_line_surfaces"}


def scene_of(slug: str) -> Scene:
    scene = example(slug).document.sheets[0].scene
    assert scene is not None
    return scene


@cache
def runs(slug: str) -> dict[str, MethodRun]:
    return {run.method: run for run in run_methods(scene_of(slug), SIZE)}


def test_every_method_that_takes_triangles_is_one() -> None:
    assert set(METHODS) == {
        "depth_buffer",
        "painter",
        "depth_sort",
        "bsp_tree",
        "scan_line_surfaces",
        "area_subdivision",
        "octree",
        "ray_casting",
        "ray_casting_boxes",
    }
    assert set(RENDERED) == set(METHODS)


@pytest.mark.parametrize("slug", ["piercing-planes", "overlapping-triangles", "space-house"])
def test_they_show_what_ray_casting_shows_unless_they_presume_that_nothing_pierces(slug: str) -> None:
    for method, run in runs(slug).items():
        assert (run.seen >= 0).any()
        if method not in WHERE_NOTHING_PIERCES:
            assert not run.different.any(), method


def test_on_planes_that_pierce_those_that_presume_otherwise_err() -> None:
    found = runs("piercing-planes")
    assert {method for method, run in found.items() if run.different.any()} == WHERE_NOTHING_PIERCES


def test_work_is_counted() -> None:
    found = runs("piercing-planes")
    assert all(run.tests > 0 for run in found.values())
    assert found["depth_sort"].counted["splits"] >= 1
    assert found["bsp_tree"].counted["splits"] >= 1
    assert found["area_subdivision"].counted["squares divided"] >= 1
    apart = runs("overlapping-triangles")
    assert apart["ray_casting"].tests > apart["scan_line_surfaces"].tests


def test_depths_are_those_of_the_depth_buffer() -> None:
    scene = scene_of("piercing-planes")
    device = device_triangles(placed(scene), scene.lights, scene.camera, SIZE, None)
    call = method_call(depth_buffer.__name__, device.corners, device.triangles, device.colours, SIZE)
    for _fragment in depth_buffer(*call.arguments):
        pass
    seen = surfaces_seen(depth_buffer.__name__, device.corners, device.triangles, SIZE)
    assert np.array_equal(depths_of(seen, device.corners, device.triangles), call.arguments[1])


def test_depths_of_many_triangles_look_at_each_pixel_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def counted(_surface: object, x: np.ndarray, _y: np.ndarray) -> np.ndarray:
        asked.append(x.size)
        return np.zeros(x.size)

    monkeypatch.setattr(methods, "depth_at", counted)
    monkeypatch.setattr(methods, "surface_of", lambda _corners, _triangles, number: number)
    seen = np.arange(24 * 18).reshape(18, 24) - 1
    compared: list[int] = []

    class Seen(np.ndarray):
        def __eq__(self, other: object) -> Any:
            compared.append(self.size)
            return super().__eq__(other)

    depth = depths_of(seen.view(Seen), np.zeros((0, 3)), np.zeros((0, 3), int))
    assert depth[0, 0] == 1.0
    assert not depth.flat[1:].any()
    assert sum(asked) == seen.size - 1
    assert sum(compared) <= 2 * seen.size


def test_time_is_that_of_a_thread() -> None:
    assert 0 <= timed(scene_of("piercing-planes"), SIZE, depth_buffer.__name__) < 60


def test_the_a_buffer_lets_light_through_as_the_materials_say() -> None:
    """0.8 and 0.4, both half transparent, on black: 0.5 x 0.8 + 0.5 x 0.5 x 0.4."""
    document = example("arena-coplanar").document
    (sheet,) = document.sheets
    assert sheet.scene is not None
    materials = tuple(replace(each, opacity=0.5) for each in sheet.scene.materials)
    sheet = replace(sheet, scene=replace(sheet.scene, materials=materials))
    call = surface_call(sheet, Subject("visibility", entry=A_BUFFER))
    assert call is not None
    light, *_rest, intensities, opacities = call.arguments
    assert (opacities == 0.5).all()
    list(call.entry.function(*call.arguments))
    first, second = intensities[0], intensities[-1]
    assert light[6, 10] == pytest.approx(0.5 * first)
    assert light[26, 40] == pytest.approx(0.5 * second)
    assert light[15, 24] == pytest.approx(0.5 * first + 0.25 * second)
