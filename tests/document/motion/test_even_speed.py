"""Equal speed along the path: the inner keys move in time, by the lengths of the ways between them."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.document.motion.moving import still, track, with_tracks
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.motion.edits import even_speed
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import track_on

POINT = "f1/p1/*"


def steps(document: Document, last: int) -> list[float]:
    """How far the point goes from each frame to the next."""
    places = [at(document.sheets[0], frame).figures[0].points_world[0] for frame in range(last + 1)]
    return [math.dist((a.x, a.y), (b.x, b.y)) for a, b in pairwise(places)]


def frames_of(document: Document) -> list[int]:
    made = track_on(document.sheets[0], POINT)
    assert made is not None
    return [key.frame for key in made.keys]


def test_ways_take_times_as_they_are_long() -> None:
    keys = (0, (0.0, 0.0)), (2, (30.0, 0.0)), (20, (30.0, 10.0))
    after = even_speed("s1", POINT)(with_tracks(still(), track(POINT, *keys, easing="ease_in")))
    assert frames_of(after) == [0, 15, 20]
    assert steps(after, 20) == pytest.approx([2.0] * 20)


def test_a_spline_becomes_more_even() -> None:
    keys = (0, (0.0, 0.0)), (4, (30.0, 5.0)), (30, (34.0, 20.0)), (40, (0.0, 25.0))
    document = with_tracks(still(), track(POINT, *keys, easing="spline"))
    after = even_speed("s1", POINT)(document)
    before, now = steps(document, 40), steps(after, 40)
    assert max(now) / min(now) < max(before) / min(before) / 2
    made = track_on(after.sheets[0], POINT)
    assert made is not None
    assert {key.easing for key in made.keys} == {"spline"}


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=3, max_size=9), st.integers(0, 3))
def test_keys_keep_frames_of_their_own(places: list[tuple[int, int]], spare: int) -> None:
    """Also where a way has no length, and where there is a frame for each key and none to spare."""
    keys = [(number * (1 + spare), (float(x), float(y))) for number, (x, y) in enumerate(places)]
    document = with_tracks(still(), track(POINT, *keys))
    if len(set(places)) == 1:
        with pytest.raises(DocumentError, match="does not move"):
            even_speed("s1", POINT)(document)
        return
    frames = frames_of(even_speed("s1", POINT)(document))
    assert frames == sorted(set(frames))
    assert (frames[0], frames[-1]) == (0, keys[-1][0])


def test_without_inner_keys_that_is_said() -> None:
    document = with_tracks(still(), track(POINT, (0, (0.0, 0.0)), (9, (5.0, 5.0))))
    with pytest.raises(DocumentError, match="no keys between"):
        even_speed("s1", POINT)(document)
