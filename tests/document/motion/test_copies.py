"""A copy of a figure or an object moves as what was copied does, beside it."""

import math

import numpy as np

from tests.document.motion.moving import HOUSE, still, track, with_tracks
from workbench.document.building import moved_by
from workbench.document.check import check
from workbench.document.edits import add_moving_figures, duplicate_figures, move_points
from workbench.document.model import AnyFigure, Circle, Document
from workbench.document.motion.auto_key import auto_key
from workbench.document.motion.edits import set_key
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of
from workbench.document.samples.examples import blank_sheet
from workbench.document.scene import edits as scene_edits
from workbench.document.scene.links import Rotate3D
from workbench.document.scene.model import Object
from workbench.document.scene.solids import Box
from workbench.exchange.figures import read_figures, write_figures
from workbench.exchange.objects import read_object, write_object

HOUSE_NOW = tuple(number for corner in HOUSE for number in corner)
TRIANGLE = (0.0, 0.0, 6.0, 0.0, 3.0, 6.0)


def test_a_copy_has_tracks_of_its_own_and_keeps_its_distance() -> None:
    document = with_tracks(
        still(),
        track("f1/p1/*", (0, (10.0, 10.0)), (8, (30.0, 4.0)), easing="ease_in"),
        track("f1/radius_world", (2, (4.0,)), (6, (9.0,))),
        track("f1/colour", (0, (255.0, 0.0, 0.0)), (8, (0.0, 0.0, 255.0))),
        track("f2/points_world", (0, HOUSE_NOW), (8, TRIANGLE)),
    )
    after = duplicate_figures(["f1", "f2"], 5.0, -2.0)(document)
    sheet = after.sheets[0]
    first, copy, house, other = sheet.figures
    assert len(motion_of(sheet).tracks) == 8
    ids = [key.id for each in motion_of(sheet).tracks for key in each.keys]
    assert len(set(ids)) == len(ids)
    for frame in range(10):
        seen = {figure.id: figure for figure in at(sheet, frame).figures}
        one, two = seen[first.id], seen[copy.id]
        assert isinstance(one, Circle)
        assert isinstance(two, Circle)
        assert two.radius_world == one.radius_world
        assert two.colour == one.colour
        for mine, its in ((one, two), (seen[house.id], seen[other.id])):
            places = [(p.x + 5.0, p.y - 2.0) for p in mine.points_world]
            np.testing.assert_allclose([(p.x, p.y) for p in its.points_world], places)


def test_a_copy_of_what_does_not_move_has_no_tracks() -> None:
    document = with_tracks(still(), track("f1/radius_world", (2, (4.0,)), (6, (9.0,))))
    after = duplicate_figures(["f2"])(document)
    assert motion_of(after.sheets[0]) == motion_of(document.sheets[0])


def test_a_track_that_moves_nothing_is_not_copied() -> None:
    document = with_tracks(still(), track("f2/points_world", (0, HOUSE_NOW[:5]), (8, HOUSE_NOW[:5])))
    sheet = duplicate_figures(["f2"], 5.0, -2.0)(document).sheets[0]
    assert len(sheet.figures) == 3
    assert [each.target for each in motion_of(sheet).tracks] == ["f2/points_world"]


def pasted(document: Document, figures: list[AnyFigure], dx: float, target: Document) -> Document:
    """``figures`` of a document through the clipboard's text onto another one, moved by ``dx``."""
    held = read_figures(write_figures(document.sheets[0], figures))
    moved = [moved_by(figure, dx, 0.0) for figure in held.figures]
    assert held.motion is not None
    return add_moving_figures(target.sheets[0].id, moved, held.figures, held.motion)(target)


def test_what_is_pasted_on_another_sheet_moves_as_where_it_was_copied() -> None:
    document = with_tracks(
        still(),
        track("f1/p1/*", (0, (10.0, 10.0)), (8, (30.0, 4.0)), easing="ease_in"),
        track("f1/colour", (0, (255.0, 0.0, 0.0)), (8, (0.0, 0.0, 255.0))),
        track("f2/points_world", (0, HOUSE_NOW), (8, TRIANGLE)),
        frames=120,
    )
    there = pasted(document, list(document.sheets[0].figures), 3.0, blank_sheet())
    motion = motion_of(there.sheets[0])
    assert (motion.frames, len(motion.tracks)) == (120, 3)
    for frame in range(10):
        was, copy = at(document.sheets[0], frame), at(there.sheets[0], frame)
        assert len(copy.figures) == 2
        for one, two in zip(was.figures, copy.figures, strict=True):
            assert was.palette[one.colour] == copy.palette[two.colour]
            places = [(p.x + 3.0, p.y) for p in one.points_world]
            np.testing.assert_allclose([(p.x, p.y) for p in two.points_world], places)


def test_of_several_figures_only_the_copied_ones_take_their_tracks_and_a_sheet_keeps_its_own_length() -> None:
    document = with_tracks(
        still(),
        track("f1/radius_world", (2, (4.0,)), (6, (9.0,))),
        track("f2/points_world", (0, HOUSE_NOW), (8, TRIANGLE)),
    )
    other = with_tracks(still(), track("f1/p1/x", (0, (1.0,)), (4, (3.0,))), frames=12)
    there = pasted(document, [document.sheets[0].figures[0]], 0.0, other)
    motion = motion_of(there.sheets[0])
    assert motion.frames == 12
    assert [len(each.keys) for each in motion.tracks] == [2, 2]
    ids = [name for each in motion.tracks for name in (each.id, *(key.id for key in each.keys))]
    assert len(set(ids)) == len(ids)
    circle = at(there.sheets[0], 4).figures[-1]
    assert isinstance(circle, Circle)
    assert circle.radius_world == 6.5
    assert write_figures(still().sheets[0], still().sheets[0].figures).find(b"motion") == -1
    assert check(there) == there


def turning_box() -> Object:
    return Object("", solid=Box(), material="", transforms=(Rotate3D(""),))


def test_an_object_takes_its_tracks_when_it_is_duplicated_or_pasted() -> None:
    document = scene_edits.add_object("s1", turning_box())(blank_sheet())
    scene = document.sheets[0].scene
    assert scene is not None
    thing, material = scene.objects[0], scene.materials[0]
    turn = thing.transforms[0].id
    for frame, angle in ((0, 0.0), (10, 90.0)):
        document = set_key("s1", f"{thing.id}/{turn}/*", frame, (angle, 0.0, 1.0, 0.0))(document)
    twice = scene_edits.duplicate_object(thing.id, 4.0)(document)
    held = read_object(write_object(document.sheets[0], thing, material))
    assert held.motion is not None
    empty = scene_edits.add_object("s1", turning_box())(blank_sheet())
    elsewhere = scene_edits.move_last_object_as("s1", held.thing, held.motion)(empty)
    for changed, count in ((twice, 2), (elsewhere, 1)):
        moved = at(changed.sheets[0], 5).scene
        assert moved is not None
        assert len(motion_of(changed.sheets[0]).tracks) == count
        rotation = moved.objects[-1].transforms[0]
        assert isinstance(rotation, Rotate3D)
        assert math.isclose(rotation.angle, 45.0)


def test_a_figure_whose_colour_moves_is_duplicated_in_any_frame() -> None:
    red, blue = (255.0, 0.0, 0.0), (0.0, 0.0, 255.0)
    document = with_tracks(still(), track("f1/colour", (0, red), (8, blue)))
    own = document.sheets[0].palette
    for frame in range(10):
        after = auto_key(duplicate_figures(["f1"]), "s1", frame, new_tracks=False)(document)
        first, copy, *_others = after.sheets[0].figures
        assert first == document.sheets[0].figures[0]
        assert after.sheets[0].palette[: len(own)] == own
        for later in range(10):
            seen = {figure.id: figure for figure in at(after.sheets[0], later).figures}
            assert seen[copy.id].colour == seen[first.id].colour
        kept = auto_key(move_points({f"s1/{first.id}/p1/x": (3.0, 4.0)}), "s1", frame, new_tracks=False)(
            document
        )
        assert kept.sheets[0].palette == own  # what no figure uses passes with the frame
