"""The runs of hidden surfaces on a scene: against rendering, exact planes, a plain replay, each other."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document import Camera
from workbench.document.model import Rectangle, Sheet, View, whole_sheet
from workbench.document.samples.examples import example
from workbench.document.samples.figures import PALETTE
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Material, Object, Point3D, Scene
from workbench.document.scene.solids import Box, MeshSolid
from workbench.document.subjects import Subject
from workbench.engine.compiled import collect
from workbench.engine.recorder import record
from workbench.geometry.meshes import Faces, Mesh
from workbench.rendering import render_scene
from workbench.rendering.scene.depth_measures import (
    differing,
    distance_of,
    least_distance,
    measured,
    piercing_pairs,
)
from workbench.rendering.scene.fragments import NOTHING, fragments_of
from workbench.rendering.subjects.registry import calls_of, checked, kind_of
from workbench.rendering.subjects.visibility import (
    MOST_TRIANGLES,
    depth_call,
    fault_of,
    scene_size,
    triangles_of,
    visible_objects,
    window_of,
)

SLUGS = ("overlapping-triangles", "piercing-planes", "almost-one-plane", "space-house", "space-isometric")
NEAR, FAR = 1.0, 17.0


def sheet_of(slug: str) -> Sheet:
    return example(slug).document.sheets[0]


def under(**arguments: int | bool) -> Subject:
    return checked(Subject("visibility", arguments=arguments))


def triangles_sheet(triangles: list[list[tuple[int, int, int]]]) -> Sheet:
    """Triangles of quarters of a pixel and sixteenths of depth, whose device coordinates they are."""
    places = np.array(
        [(x / 4, y / 4, -(NEAR + z * (FAR - NEAR) / 16)) for corners in triangles for x, y, z in corners]
    )
    mesh = Mesh(places, Faces.of(np.arange(len(places)).reshape(-1, 3)))
    camera = Camera("orthographic", Point3D(11.5, 7.5, 0.0), Point3D(11.5, 7.5, -1.0), near=NEAR, far=FAR)
    window = Rectangle(-12.0, -8.0, 12.0, 8.0)
    scene = Scene((Object("o1", MeshSolid(blob_of(mesh)), "m1"),), (Material("m1"),), (), camera)
    return Sheet("s1", "", 24, 16, (View("v1", window, whole_sheet(24, 16)),), PALETTE, scene=scene)


corner = st.tuples(st.integers(-8, 104), st.integers(-8, 72), st.integers(0, 16))
scenes = st.lists(st.lists(corner, min_size=3, max_size=3), min_size=1, max_size=4).map(triangles_sheet)
coarse = under(columns=24)


@pytest.mark.parametrize("slug", SLUGS)
@pytest.mark.parametrize("columns", [24, 48, 96])
def test_stepped_to_its_end_a_run_is_the_rendered_scene(slug: str, columns: int) -> None:
    sheet, subject = sheet_of(slug), under(columns=columns)
    assert sheet.scene is not None
    size = scene_size(sheet, subject)
    image, depth = render_scene(sheet.scene, "depth_buffer", size, window=window_of(sheet))
    call, device = depth_call(sheet, subject), triangles_of(sheet, subject)
    assert call is not None
    assert device is not None
    run = fragments_of(call)
    seen = run.seen(size)
    assert (run.depths(size, 1.0) == depth).all()
    shown = np.where(seen == NOTHING, 0, device.colours[seen])
    assert (shown == image).all()
    assert set(device.objects.tolist()) <= set(range(len(visible_objects(sheet.scene))))


@given(scenes)
@settings(max_examples=40)
def test_each_depth_is_that_of_the_plane_in_exact_fractions(sheet: Sheet) -> None:
    call = depth_call(sheet, coarse)
    assert call is not None
    run = fragments_of(call)
    _image, _depth, corners, triangles, _colours = call.arguments
    for k in range(len(run)):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
            tuple(map(Fraction, corner)) for corner in corners[triangles[run.surface[k]]].tolist()
        )
        C = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        A = (by - ay) * (cz - az) - (cy - ay) * (bz - az)
        B = (bz - az) * (cx - ax) - (cz - az) * (bx - ax)
        z = az - (A * (int(run.x[k]) - ax) + B * (int(run.y[k]) - ay)) / C
        assert abs(float(z) - run.z[k]) <= 1e-12


@given(scenes, st.sampled_from([0, 4, 8, 24]))
@settings(max_examples=40)
def test_stored_depths_and_pictures_are_those_of_a_plain_replay(sheet: Sheet, bits: int) -> None:
    subject = under(columns=24, bits=bits)
    call = depth_call(sheet, subject)
    assert call is not None
    run = fragments_of(call)
    image, depth = (np.array(each) for each in call.arguments[:2])
    surfaces = np.full(image.shape, NOTHING)
    for k in range(len(run)):
        x, y = int(run.x[k]), int(run.y[k])
        assert run.stored[k] == depth[y, x]
        assert run.won[k] == (run.z[k] < depth[y, x])
        if run.won[k]:
            depth[y, x], surfaces[y, x] = run.z[k], run.surface[k]
    size = scene_size(sheet, subject)
    assert (run.seen(size) == surfaces).all()
    assert (run.depths(size, float(call.arguments[1].max())) == depth).all()
    assert (run.tests(size).sum(), run.writes(size).sum()) == (len(run), run.won.sum())


@given(scenes)
@settings(max_examples=40)
def test_the_order_matters_only_where_depths_are_equal(sheet: Sheet) -> None:
    forwards, backwards = depth_call(sheet, coarse), depth_call(sheet, under(columns=24, backwards=True))
    assert forwards is not None
    assert backwards is not None
    size = scene_size(sheet, coarse)
    one, other = fragments_of(forwards), fragments_of(backwards)
    last = len(forwards.arguments[3]) - 1
    turned = other.seen(size)
    for y, x in np.argwhere(one.seen(size) != np.where(turned == NOTHING, NOTHING, last - turned)).tolist():
        here = np.sort(one.z[one.at(x, y)])
        assert here[1] - here[0] < 1e-9
    assert one.depths(size, 1.0) == pytest.approx(other.depths(size, 1.0), abs=1e-12)


@pytest.mark.parametrize("bits", [0, 4, 12, 32])
def test_stepped_and_compiled_runs_of_a_rounded_buffer_are_the_same(bits: int) -> None:
    """A buffer of whole numbers cuts off alike in every reading."""
    call = depth_call(sheet_of("almost-one-plane"), under(columns=24, bits=bits))
    assert call is not None
    recorded = record(call.entry.function, *(array.copy() for array in call.arguments))
    assert np.array_equal(collect(call.entry.function, *call.arguments), recorded.emitted.array())
    whole = call.arguments[1].dtype.kind == "i"
    assert whole == (bits > 0)


def test_fewer_bits_make_more_pixels_wrong() -> None:
    sheet = sheet_of("almost-one-plane")
    exact = depth_call(sheet, under())
    assert exact is not None
    wrong = []
    for bits in (32, 16, 12, 8):
        call = depth_call(sheet, under(bits=bits))
        assert call is not None
        wrong.append(int(differing(call, exact).sum()))
    assert wrong == [0, 0, 72, 204]


def test_the_least_distance_is_that_of_the_course() -> None:
    camera = Camera("perspective", near=1.0, far=100.0)
    share = float(Fraction(100, 99) * (1 - Fraction(1, 50)))  # z' of z = 50
    assert distance_of(camera, share) == pytest.approx(50.0)
    assert least_distance(camera, share, 8) == pytest.approx(9.706, abs=5e-4)
    assert least_distance(replace(camera, projection="orthographic"), 0.3, 8) == pytest.approx(99 / 255)


@given(st.floats(1.5, 99.0), st.integers(4, 24))
def test_depths_so_far_apart_differ_by_one_step_of_the_buffer(z: float, bits: int) -> None:
    """The formula is the derivative: over a small part of the way z' grows by that part of a step."""
    camera, steps = Camera("perspective", near=1.0, far=100.0), 2**bits - 1
    share = 100 * (z - 1) / (99 * z)
    part = 1e-6
    further = z + part * least_distance(camera, share, bits)
    assert (100 * (further - 1) / (99 * further) - share) * steps / part == pytest.approx(1.0, rel=1e-2)


@given(scenes)
@settings(max_examples=30)
def test_pairs_pierce_where_each_is_nearer_somewhere(sheet: Sheet) -> None:
    call = depth_call(sheet, coarse)
    assert call is not None
    run = fragments_of(call)
    nearer = set()
    depth = {(int(s), int(x), int(y)): z for s, x, y, z in zip(run.surface, run.x, run.y, run.z, strict=True)}
    for (a, x, y), z in depth.items():
        for b in range(len(call.arguments[3])):
            if depth.get((b, x, y), z) > z:
                nearer.add((a, b))
    assert piercing_pairs(run, (24, 16)) == {(a, b) for a, b in nearer if a < b and (b, a) in nearer}


def test_what_is_measured_adds_up() -> None:
    sheet = sheet_of("overlapping-triangles")
    calls = [depth_call(sheet, under(**each)) for each in ({"bits": 8}, {"bits": 8, "backwards": True}, {})]
    found = measured(*calls)  # type: ignore[arg-type]
    assert (found.triangles, found.fragments, found.covered, found.layered) == (2, 893, 622, 271)
    assert (found.piercing, found.rounded) == (1, 1)
    assert found.overwritten + found.covered == int(fragments_of(calls[0]).won.sum())  # type: ignore[arg-type]


def test_the_worked_example_has_its_numbers() -> None:
    call = depth_call(sheet_of("overlapping-triangles"), under())
    assert call is not None
    run = fragments_of(call)
    assert run.at(23, 15).tolist() == [331, 683]
    assert run.z[[331, 683]] == pytest.approx([0.52, 0.5075])
    assert run.stored[[331, 683]] == pytest.approx([1.0, 0.52])
    assert kind_of(under()).landmarks(sheet_of("overlapping-triangles"), under()) == (486,)


def test_a_sheet_without_a_scene_and_one_with_too_much_of_it_say_so() -> None:
    sheet = replace(sheet_of("piercing-planes"), scene=None)
    assert fault_of(sheet)
    assert calls_of(sheet, under()) == []
    piercing = sheet_of("piercing-planes")
    assert piercing.scene is not None
    box = Object("", Box(), "m1")
    many = tuple(replace(box, id=f"o{k}") for k in range(MOST_TRIANGLES // 12 + 1))
    crowded = replace(piercing, scene=replace(piercing.scene, objects=many))
    assert "12 triangles" not in fault_of(crowded)
    assert f"{12 * len(many):,} triangles" in fault_of(crowded)
    assert calls_of(crowded, under()) == []


def test_an_empty_scene_runs_without_a_fragment() -> None:
    sheet = sheet_of("piercing-planes")
    assert sheet.scene is not None
    call = depth_call(replace(sheet, scene=replace(sheet.scene, objects=())), under())
    assert call is not None
    assert len(fragments_of(call)) == 0
