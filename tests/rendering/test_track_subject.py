"""A track becomes the calls of the text that makes its in-betweens."""

import numpy as np
import pytest
from msgspec.structs import replace

from tests.algorithms.test_views import steps_of
from tests.document.motion.moving import HOUSE, sheet_of, track
from workbench.document.errors import DocumentError
from workbench.document.motion.evaluation import at
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import group_moved, motion_of
from workbench.document.samples.examples import example
from workbench.document.scene.links import Rotate3D
from workbench.document.subjects import Subject
from workbench.rendering.raster import emitted
from workbench.rendering.subjects.registry import calls_of, checked, kind_of
from workbench.rendering.subjects.track import aimed, at_frame, keys_around

RADIUS = "f1/radius_world"


def test_a_number_is_that_of_every_frame() -> None:
    moving = track(RADIUS, (2, (1.0,)), (8, (9.0,)), (20, (3.0,)), easing="ease_out")
    sheet = sheet_of(moving)
    for frame, (first, last) in ((0, (2, 8)), (5, (2, 8)), (8, (8, 20)), (40, (8, 20))):
        (call,) = calls_of(sheet, at_frame(RADIUS, frame))
        assert call.entry.slug == "tween"
        rows = emitted(call)
        assert rows[[0, -1], 0].tolist() == [first, last]
        for number, value in rows.tolist():
            assert at(sheet, int(number)).figures[0].radius_world == pytest.approx(value)  # type: ignore[union-attr]
    assert [key.frame for key in keys_around(moving, 3) or ()] == [2, 8]


def test_a_spline_is_stepped_as_one_and_a_point_number_by_number() -> None:
    sheet = sheet_of(track("f1/p1/*", (0, (1.0, 2.0)), (4, (9.0, 5.0)), (9, (3.0, 3.0)), easing="spline"))
    subject = at_frame("f1/p1/*", 2)
    assert kind_of(subject).choices(sheet, subject) == ("spline_tween", "tween")
    x, y = calls_of(sheet, subject)
    assert [row[1] for row in emitted(x).tolist()][4] == 9.0
    assert [row[1] for row in emitted(y).tolist()][9] == 3.0


@pytest.mark.parametrize("shift", [0, 2])
def test_an_outline_is_morphed(shift: int) -> None:
    house = tuple(number for corner in HOUSE for number in corner)
    triangle = (0.0, 0.0, 6.0, 0.0, 3.0, 6.0)
    sheet = sheet_of(track("f2/points_world", (0, house), (10, triangle), shift=shift))
    (call,) = calls_of(sheet, at_frame("f2/points_world", 5))
    assert call.entry.slug == "morph"
    points = at(sheet, 5).figures[1].points_world
    np.testing.assert_allclose(emitted(call), [(p.x, p.y) for p in points])


def test_without_two_keys_there_is_nothing_to_step() -> None:
    assert calls_of(sheet_of(), Subject("track")) == []
    assert calls_of(sheet_of(track(RADIUS, (2, (1.0,)))), Subject("track")) == []
    assert calls_of(sheet_of(track("f9/x", (0, (1.0,)), (4, (2.0,)))), Subject("track")) == []


@pytest.mark.parametrize(
    ("target", "values"),
    [
        ("f2/points_world", ((1.0, 2.0, 3.0, 4.0, 5.0), (1.0, 2.0, 3.0, 4.0, 5.0))),
        ("f2/points_world", ((), ())),
        (RADIUS, ((), ())),
        (RADIUS, ((1.0,), (1.0, 2.0))),
        ("f1/colour", ((1.0, 2.0), (1.0, 2.0))),
    ],
)
def test_keys_with_other_numbers_than_what_they_hang_on_give_nothing_to_step(
    target: str, values: tuple[tuple[float, ...], tuple[float, ...]]
) -> None:
    sheet = sheet_of(track(target, (0, values[0]), (4, values[1])))
    assert group_moved(sheet, motion_of(sheet).tracks[0]) is None
    assert calls_of(sheet, at_frame(target, 2)) == []
    assert calls_of(sheet, Subject("track")) == []


@pytest.mark.parametrize("arguments", [{"frame": -1}, {"frame": 0.5}, {"target": 3}, {"other": 1}])
def test_arguments_of_another_kind_are_refused(arguments: dict[str, object]) -> None:
    with pytest.raises(DocumentError):
        checked(Subject("track", arguments=arguments))  # type: ignore[arg-type]


SHORT = track(RADIUS, (0, (4.0,)), (4, (8.0,)), (12, (0.0,)))
SPLINE = track(RADIUS, (0, (4.0,)), (4, (8.0,)), (12, (0.0,)), easing="spline")


@pytest.mark.parametrize("moving", [SHORT, SPLINE])
def test_the_step_that_shows_a_frame_has_it_in_its_row(moving: Track) -> None:
    sheet = sheet_of(moving)
    for frame in range(13):
        subject, number = aimed(sheet, Subject(), RADIUS, frame)
        (call,) = calls_of(sheet, subject)
        step = steps_of(call.entry, call.arguments)[number]
        assert step.row[call.entry.columns.index("frame")] == frame
    assert aimed(sheet, Subject(), RADIUS, 13)[1] == 0


def test_an_entry_that_was_chosen_stays_while_its_track_is_the_same() -> None:
    sheet = sheet_of(SHORT)
    chosen = replace(at_frame(RADIUS, 2), entry="spline_tween")
    subject, step = aimed(sheet, chosen, RADIUS, 9)
    assert (subject.entry, step) == ("spline_tween", 10)
    assert aimed(sheet, replace(chosen, arguments={"target": "f9/x"}), RADIUS, 9)[0].entry == ""


def test_an_outline_is_stepped_from_its_start_in_every_frame() -> None:
    house = tuple(number for corner in HOUSE for number in corner)
    sheet = sheet_of(track("f2/points_world", (0, house), (10, (0.0, 0.0, 6.0, 0.0, 3.0, 6.0))))
    assert aimed(sheet, Subject(), "f2/points_world", 5) == (at_frame("f2/points_world", 5), 0)


def test_a_turn_by_euler_s_angles_is_stepped_angle_by_angle_and_by_quaternion_at_once() -> None:
    scene = example("space-house").document.sheets[0].scene
    assert scene is not None
    thing = replace(scene.objects[0], transforms=(Rotate3D("t99-", z_axis=1.0, y_axis=0.0),))
    base = replace(sheet_of(), scene=replace(scene, objects=(thing, *scene.objects[1:])))
    target = f"{thing.id}/t99-/*"
    ends = ((0, (170.0, 0.0, 0.0, 1.0)), (4, (-170.0, 0.0, 0.0, 1.0)))
    for turning, choices in (("euler", ("tween", "slerp")), ("quaternion", ("slerp",))):
        moving = track(target, *ends, turning=turning)
        sheet = replace(base, motion=sheet_of(moving).motion)
        subject = at_frame(target, 2)
        assert kind_of(subject).choices(sheet, subject) == choices
        calls = calls_of(sheet, subject)
        assert [call.entry.slug for call in calls] == [choices[0]] * len(calls)
    about_x, about_y, about_z = calls_of(
        replace(base, motion=sheet_of(track(target, *ends, turning="euler")).motion), at_frame(target, 2)
    )
    assert emitted(about_z)[:, 1] == pytest.approx([170.0, 175.0, 180.0, 185.0, 190.0])
    assert emitted(about_x)[:, 1] == pytest.approx([0.0] * 5)
    assert emitted(about_y)[:, 1] == pytest.approx([0.0] * 5)
