"""The scenes on which it is known which methods fail, what methods keep, how times grow, the two spaces."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document.model import Sheet
from workbench.document.samples.arena import READY
from workbench.document.samples.examples import example
from workbench.engine.stopping import Stop, Stopped
from workbench.rendering.scene import growth
from workbench.rendering.scene.arena import MethodRun, device_of, methods_for, runs_of
from workbench.rendering.scene.back_face_calls import BACK_FACES
from workbench.rendering.scene.growth import Growth, cut_up, exponent, foretell, growth_of
from workbench.rendering.scene.methods import METHODS, method_call, surfaces_seen
from workbench.rendering.scene.spaces import Measures, in_object_space, space_rows
from workbench.rendering.subjects.visibility import window_of

SIZE = (24, 16)
FAIL = {
    "arena-ring": {"painter"},
    "piercing-planes": {BACK_FACES, "painter", "scan_line_surfaces"},
    "arena-bracket": {BACK_FACES, "painter"},
    "arena-coplanar": set(),
    "arena-solid": set(),
}


def sheet_of(slug: str) -> Sheet:
    return example(slug).document.sheets[0]


def runs(slug: str, methods: tuple[str, ...] = ()) -> list[MethodRun]:
    sheet = sheet_of(slug)
    assert sheet.scene is not None
    chosen = methods or methods_for(sheet.scene.camera)
    return list(runs_of(sheet.scene, SIZE, window_of(sheet), chosen))


def test_every_ready_scene_is_told_of() -> None:
    assert set(FAIL) == set(READY)


@pytest.mark.parametrize("slug", READY)
def test_on_each_ready_scene_those_fail_that_theory_says(slug: str) -> None:
    done = runs(slug)
    assert {run.method for run in done if run.different.any()} == FAIL[slug]
    for run in done:
        if run.different.any():
            assert catalogue.get(run.method).fails_where


def test_what_is_kept_is_what_the_text_holds_at_most() -> None:
    """Against the variables of the texts themselves, while they run."""
    held: dict[str, Any] = {
        "depth_buffer": lambda now: now["depth"].size,
        "painter": lambda now: len(now["order"]),
        "depth_sort": lambda now: len(now["pieces"]),
        "bsp_tree": lambda now: len(now["pieces"]),
        "scan_line_surfaces": lambda now: len(now["edges"]),
        "area_subdivision": lambda now: len(now["waiting"]),
        "octree": lambda now: len(now["waiting"]),
    }
    exact = {"depth_buffer", "painter", "depth_sort", "bsp_tree"}
    sheet = sheet_of("piercing-planes")
    assert sheet.scene is not None
    device = device_of(sheet.scene, SIZE, window_of(sheet))
    for run in runs("piercing-planes", tuple(held)):
        call = method_call(run.method, device.corners, device.triangles, device.colours, SIZE)
        text = call.entry.function(*call.arguments)
        most = 0
        for _emitted in text:
            most = max(most, held[run.method](text.gi_frame.f_locals))  # type: ignore[attr-defined]
        kept = list(run.keeps.values())[-1]
        assert most == kept if run.method in exact else 0 < most <= kept, run.method


def test_a_triangle_cut_into_four_paints_the_same_pixels() -> None:
    sheet = sheet_of("arena-ring")
    assert sheet.scene is not None
    device = device_of(sheet.scene, SIZE, window_of(sheet))
    finer = cut_up(device, 2)
    assert len(finer.triangles) == 16 * len(device.triangles)
    one, two = (surfaces_seen("depth_buffer", each.corners, each.triangles, SIZE) for each in (device, finer))
    assert np.array_equal(one >= 0, two >= 0)
    owners = [np.where(seen >= 0, each.objects[seen], -1) for seen, each in ((one, device), (two, finer))]
    assert np.array_equal(*owners)


@pytest.mark.parametrize("power", [0.0, 0.5, 1.0, 2.0])
def test_a_power_is_fitted_exactly_and_gone_on_with(power: float) -> None:
    points = [(n, 3e-4 * n**power) for n in (10, 40, 160)]
    assert exponent(points) == pytest.approx(power, abs=1e-9)
    assert foretell(points, 640) == pytest.approx(3e-4 * 640**power)


def test_no_power_is_fitted_to_one_number() -> None:
    assert exponent([(10, 1.0), (10, 2.0)]) is None
    assert exponent([(10, 0.0), (20, 1.0)]) is None


def test_what_would_take_too_long_is_foretold(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def square(_method: str, _scene: object, device: Any, size: tuple[int, int], _stop: object) -> float:
        asked.append(size[0] * size[1])
        return len(device.triangles) * float(size[0] * size[1]) ** 2 * 1e-9

    monkeypatch.setattr(growth, "time_of", square)
    sheet = sheet_of("arena-ring")
    assert sheet.scene is not None
    told = growth_of("painter", sheet.scene, SIZE, window_of(sheet))
    assert not told.measured
    assert told.at_ten == pytest.approx(6 * float(SIZE[0] * SIZE[1] * 100) ** 2 * 1e-9)
    assert max(asked) < SIZE[0] * SIZE[1] * 100
    by_pixels, by_polygons = told.exponents
    assert by_pixels == pytest.approx(2.0)
    assert by_polygons == pytest.approx(1.0)
    assert all(b == 4 * a for (a, _s), (b, _t) in pairwise(told.by_polygons))


def test_a_measurement_is_stopped() -> None:
    sheet, stop = sheet_of("arena-ring"), Stop()
    assert sheet.scene is not None
    stop.set()
    with pytest.raises(Stopped):
        growth_of("painter", sheet.scene, SIZE, window_of(sheet), stop)


def test_the_table_of_the_two_spaces_tells_the_numbers_of_the_scene() -> None:
    done = {run.method: run for run in runs("arena-ring", ("painter", "bsp_tree", "area_subdivision"))}
    times = {"painter": Growth("painter", ((1, 1.0), (10, 10.0)), ((1, 1.0), (10, 100.0)), 1.0, True)}
    rows = {row.feature: row for row in space_rows(Measures(done, done, times))}
    wrong = int(done["painter"].different.sum())
    assert f"wrong here: Painter's algorithm {wrong} px" in rows["Accuracy"].object_space
    assert "no pixel is wrong here" in rows["Accuracy"].image_space
    squares = done["area_subdivision"].counted["squares divided"]
    assert f"Area subdivision {squares:,} squares divided, then {squares:,}" in rows["Precision"].image_space
    assert "Painter's algorithm n^2.0" in rows["Cost, n polygons"].object_space
    assert "Painter's algorithm p^1.0" in rows["Cost, p pixels"].object_space
    assert rows["Examples"].image_space == "Area subdivision"
    assert in_object_space(BACK_FACES)
    assert [method for method in METHODS if not in_object_space(method)] == [
        "depth_buffer",
        "scan_line_surfaces",
        "area_subdivision",
        "ray_casting",
        "ray_casting_boxes",
    ]


def test_the_table_is_there_before_anything_is_measured() -> None:
    assert all(row.object_space and row.image_space for row in space_rows(Measures()))


def test_where_nothing_is_seen_no_cost_grows_with_polygons(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(growth, "FACTORS", (1, 2))
    sheet = sheet_of("arena-ring")
    assert sheet.scene is not None
    hidden = tuple(replace(each, visible=False) for each in sheet.scene.objects)
    told = growth_of("painter", replace(sheet.scene, objects=hidden), SIZE, window_of(sheet))
    assert told.by_polygons == ()
    assert len(told.by_pixels) == 2
