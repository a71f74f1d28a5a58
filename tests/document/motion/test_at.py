"""A sheet in a frame, against the texts that are stepped, number by number."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.spatial.transform import Rotation

from tests.document.motion.moving import HOUSE, keyed_numbers, sheet_of, still, track
from workbench.algorithms.animation import morph, spline_tween, tween
from workbench.document.check import check
from workbench.document.model import Document, Polygon, Sheet
from workbench.document.motion.between import quaternion_of, turned
from workbench.document.motion.evaluation import at, in_frame, loose
from workbench.document.motion.groups import group_of, value_of
from workbench.document.motion.model import EASINGS, SPLINE, Key, Track
from workbench.document.samples.examples import example


def numbers(sheet: Sheet, target: str, frame: int) -> tuple[float, ...]:
    moved = at(sheet, frame)
    group = group_of(moved, target)
    assert group is not None
    return value_of(moved, group)


def expected(moving: Track) -> dict[int, float]:
    """The number in every frame from the first key to the last, by the texts."""
    keys = moving.keys
    rows: dict[int, float] = {keys[0].frame: keys[0].value[0]}
    if len(keys) == 1:
        return rows
    shapes = ([getattr(key, name) for key in keys] for name in ("tension", "continuity", "bias"))
    frames, values = np.array([key.frame for key in keys]), np.array([key.value[0] for key in keys])
    splined = dict(spline_tween(frames, values, *map(np.array, shapes)))
    for first, second in pairwise(keys):
        span = range(first.frame, second.frame + 1)
        if first.easing == SPLINE:
            rows |= {frame: splined[frame] for frame in span}
        else:
            code = EASINGS.index(first.easing)
            rows |= tween(first.frame, second.frame, first.value[0], second.value[0], code, *first.handles)
    return rows


@settings(max_examples=60)
@given(moving=keyed_numbers())
def test_a_number_moves_as_the_texts_say(moving: Track) -> None:
    sheet = sheet_of(moving)
    check(Document((sheet,)))
    low = 0.0 if moving.target.endswith("radius_world") else -1e6
    rows = expected(moving)
    for frame, value in rows.items():
        assert numbers(sheet, moving.target, frame) == pytest.approx((max(value, low),), rel=1e-9, abs=1e-9)
    for key in moving.keys:
        assert numbers(sheet, moving.target, key.frame) == key.value
    first, last = moving.keys[0], moving.keys[-1]
    assert numbers(sheet, moving.target, max(first.frame - 1, 0))[0] == pytest.approx(
        rows.get(first.frame - 1, first.value[0])
    )
    assert numbers(sheet, moving.target, last.frame + 9) == last.value


def test_it_is_pure_and_remembered_by_value() -> None:
    moving = track("f1/radius_world", (0, (1.0,)), (10, (6.0,)))
    sheet, again = sheet_of(moving), sheet_of(moving)
    before = repr(sheet)
    assert at(sheet, 5) is at(again, 5)
    assert at(sheet, 5).figures[0] != sheet.figures[0]
    assert at(sheet, 5).figures[1] is sheet.figures[1]
    assert repr(sheet) == before
    assert at(still().sheets[0], 5) is at(still().sheets[0], 5)
    assert at(still().sheets[0], 5) == still().sheets[0]


def test_an_outline_becomes_one_with_more_corners_by_the_course_s_rule() -> None:
    triangle = (0.0, 0.0, 6.0, 0.0, 3.0, 6.0)
    house = tuple(number for corner in HOUSE for number in corner)
    sheet = sheet_of(track("f2/points_world", (0, house), (10, triangle)))
    halfway = at(sheet, 5).figures[1]
    assert isinstance(halfway, Polygon)
    morphed = list(morph(np.array(HOUSE), np.array(triangle).reshape(-1, 2), True, 0, 0.5))
    np.testing.assert_allclose([(p.x, p.y) for p in halfway.points_world], morphed)
    assert [p.id for p in halfway.points_world] == [p.id for p in sheet.figures[1].points_world]
    assert numbers(sheet, "f2/points_world", 0) == house
    assert numbers(sheet, "f2/points_world", 10)[:2] == (0.0, 0.0)
    shrunk = sheet_of(track("f2/points_world", (0, triangle), (10, (*house, 1.0, 3.0))))
    longer = at(shrunk, 5)
    assert len(longer.figures[1].points_world) == 6
    check(Document((longer,)))


def test_a_colour_goes_through_red_green_and_blue_and_never_between_two_numbers() -> None:
    sheet = sheet_of(track("f1/colour", (0, (255.0, 0.0, 0.0)), (4, (0.0, 0.0, 255.0))))
    colours = [at(sheet, f).palette[at(sheet, f).figures[0].colour] for f in range(5)]
    assert colours == [0xFF0000, 0xBF0040, 0x800080, 0x4000BF, 0x0000FF]
    assert at(sheet, 2).palette[:8] == sheet.palette


def test_a_turn_in_space_goes_evenly_on_the_shorter_arc() -> None:
    scene = next(
        each.document.sheets[0].scene
        for each in map(example, ("space-house",))
        if each.document.sheets[0].scene is not None
    )
    from msgspec.structs import replace

    from workbench.document.scene.links import Rotate3D

    thing = replace(scene.objects[0], transforms=(Rotate3D("t99-", z_axis=1.0, y_axis=0.0),))
    base = replace(sheet_of(), scene=replace(scene, objects=(thing, *scene.objects[1:])))
    target = f"{thing.id}/t99-/*"
    moving = track(target, (0, (0.0, 0.0, 0.0, 1.0)), (4, (90.0, 0.0, 0.0, 1.0)), (8, (350.0, 0.0, 0.0, 1.0)))
    sheet = replace(base, motion=sheet_of(moving).motion)
    assert numbers(sheet, target, 1) == pytest.approx((22.5, 0.0, 0.0, 1.0))
    assert numbers(sheet, target, 4) == (90.0, 0.0, 0.0, 1.0)
    assert numbers(sheet, target, 6) == pytest.approx((40.0, 0.0, 0.0, 1.0))  # halfway back to -10


@pytest.mark.parametrize(
    ("target", "value"),
    [
        ("f9/radius_world", (1.0,)),
        ("f1/p9/x", (1.0,)),
        ("f1/name", (1.0,)),
        ("f1/visible", (1.0,)),
        ("f1/radius_world", (1.0, 2.0)),
        ("f2/points_world", (1.0, 2.0, 3.0)),
        ("scene.camera.eye", (1.0, 2.0, 3.0)),
        ("nothing", (1.0,)),
        ("f1", (1.0,)),
        ("f1/p1/x/y", (1.0,)),
        ("f1/radius_world.real", (1.0,)),
    ],
)
def test_a_track_on_what_is_not_there_moves_nothing_and_is_named(target: str, value: Any) -> None:
    sheet = sheet_of(track(target, (0, value)))
    check(Document((sheet,)))
    assert loose(sheet) == (target,)
    assert at(sheet, 3).figures == sheet.figures


def test_what_leaves_its_range_is_held_there_and_named() -> None:
    moving = track("f1/radius_world", (0, (0.0,)), (4, (8.0,)), (8, (0.0,)), (12, (8.0,)), easing=SPLINE)
    sheet = sheet_of(moving)
    frames = [in_frame(sheet, frame) for frame in range(13)]
    radii = [numbers(sheet, moving.target, frame)[0] for frame in range(13)]
    assert min(radii) == 0.0
    for frame, radius in zip(frames, radii, strict=True):
        assert frame.held in ((), (moving.target,))
        assert not frame.held or radius == 0.0
    low = sheet_of(track("f1/radius_world", (0, (-3.0,))))
    assert in_frame(low, 0).held == ("f1/radius_world",)
    assert numbers(low, "f1/radius_world", 0) == (0.0,)


def test_knots_that_cross_between_keys_stay_in_order() -> None:
    from msgspec.structs import replace

    from workbench.document.building import with_ids, without_ids
    from workbench.document.model import Curve, CurvePoint, Knot

    knots = tuple(Knot("", u) for u in (0.0, 0, 0, 1, 2, 3, 3, 3))
    points = tuple(CurvePoint("", float(x), float(x % 3)) for x in range(5))
    curve = Curve("", points, "bresenham_line", spline="b_spline", degree=2, knot_rule="free", knots=knots)
    ids = iter(range(50, 99))
    curve = with_ids(without_ids(curve), ids, ids)
    inner = curve.knots[3]
    moving = track(f"{curve.id}/{inner.id}/u", (0, (0.5,)), (4, (2.5,)))
    sheet = replace(sheet_of(moving), figures=(curve,))
    check(Document((at(sheet, 4),)))
    assert [knot.u for knot in at(sheet, 4).figures[0].knots] == [0, 0, 0, 2.5, 2.5, 3, 3, 3]  # type: ignore[union-attr]


def test_a_closed_outline_goes_to_the_vertex_that_its_key_names() -> None:
    square = (0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0)
    moving = track("f2/points_world", (0, square), (10, square), shift=1)
    sheet = sheet_of(moving)
    assert numbers(sheet, "f2/points_world", 0) == square
    assert numbers(sheet, "f2/points_world", 5) == (2.0, 0.0, 4.0, 2.0, 2.0, 4.0, 0.0, 2.0)
    assert numbers(sheet, "f2/points_world", 10) == square
    house = tuple(number for corner in HOUSE for number in corner)  # as many corners as the figure itself has
    sheet = sheet_of(track("f2/points_world", (0, house), (10, house), shift=1))
    halfway = np.reshape(numbers(sheet, "f2/points_world", 5), (-1, 2))
    np.testing.assert_allclose(halfway, (np.array(HOUSE) + np.roll(HOUSE, -1, axis=0)) / 2)


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
def test_about_one_axis_euler_s_angles_turn_as_the_quaternion_does(axis: tuple[float, ...]) -> None:
    first, second = Key("k1-", 0, (10.0, *axis)), Key("k2-", 8, (80.0, *axis))
    by_angles = Key("k3-", 0, (10.0, *axis), turning="euler")
    for part in (0.25, 0.5, 1.0):
        assert turned(by_angles, second, part) == pytest.approx(turned(first, second, part))


def test_euler_s_angles_begin_and_end_in_the_keys_and_swing_out_between() -> None:
    first = Key("k1-", 0, (120.0, 1.0, 1.0, 1.0), turning="euler")
    second = Key("k2-", 8, (170.0, -1.0, 2.0, 0.5))
    ends = Rotation.from_quat([np.roll(quaternion_of(key.value), -1) for key in (first, second)])
    ways = [Rotation.from_rotvec(_vector(turned(first, second, part))) for part in (0.0, 0.5, 1.0)]
    assert (ways[0].inv() * ends[0]).magnitude() == pytest.approx(0.0, abs=1e-9)
    assert (ways[2].inv() * ends[1]).magnitude() == pytest.approx(0.0, abs=1e-9)
    middle = Rotation.from_euler("xyz", _halfway(*ends.as_euler("xyz")))
    assert (ways[1].inv() * middle).magnitude() == pytest.approx(0.0, abs=1e-9)
    straight = (ends[0].inv() * ends[1]).magnitude()
    assert (ends[0].inv() * ways[1]).magnitude() + (ways[1].inv() * ends[1]).magnitude() > straight + 0.05


def _vector(turn: tuple[float, ...]) -> np.ndarray:
    return np.radians(turn[0]) * np.array(turn[1:]) / np.linalg.norm(turn[1:])


def _halfway(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first + 0.5 * np.remainder(second - first + np.pi, 2.0 * np.pi) - 0.5 * np.pi


def test_half_way_of_an_ease_in_and_out_is_exactly_the_middle() -> None:
    moving = track("f1/p1/x", (0, (35.0,)), (24, (-35.0,)), easing="ease_in_out")
    assert numbers(sheet_of(moving), moving.target, 12) == (0.0,)
    assert expected(moving)[12] == 0.0
