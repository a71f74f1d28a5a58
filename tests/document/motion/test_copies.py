"""A copy of a figure moves as the figure does, beside it."""

import numpy as np

from tests.document.motion.moving import HOUSE, still, track, with_tracks
from workbench.document.edits import duplicate_figures
from workbench.document.model import Circle
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of

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
