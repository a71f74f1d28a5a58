"""Keys set, moved, scaled, removed, pasted, by edits that are undone as one value; and auto-key."""

from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.motion.moving import still, track, with_tracks
from workbench.document.addresses import changed, highest, resolve
from workbench.document.edits import (
    add_sheet,
    both,
    move_figures,
    move_points,
    remove_figures,
    remove_point,
    rename_figure,
    set_attribute,
)
from workbench.document.errors import DocumentError
from workbench.document.fields import numbers_of
from workbench.document.model import Circle, Document
from workbench.document.motion.auto_key import auto_key
from workbench.document.motion.edits import (
    copied_keys,
    insert_time,
    move_keys,
    paste_keys,
    remove_keys,
    remove_time,
    scale_keys,
    set_correspondence,
    set_easing,
    set_key,
    set_motion,
    set_turning,
)
from workbench.document.motion.evaluation import at
from workbench.document.motion.model import Key, Motion
from workbench.document.storage.files import Stored, decode, encode

RADIUS = "f1/radius_world"


def keys_on(document: Document, target: str) -> list[tuple[int, tuple[float, ...]]]:
    motion = document.sheets[0].motion
    tracks = [each for each in (motion.tracks if motion else ()) if each.target == target]
    return [(key.frame, key.value) for each in tracks for key in each.keys]


def ids_in(document: Document, *frames: int, target: str = RADIUS) -> list[str]:
    motion = document.sheets[0].motion
    assert motion is not None
    return [
        key.id for each in motion.tracks if each.target == target for key in each.keys if key.frame in frames
    ]


def moving() -> Document:
    """The radius in frames 0, 10 and 20, and the ball's place in 0 and 20."""
    document = still()
    for edit in (
        set_key("s1", RADIUS, 0),
        set_key("s1", RADIUS, 10, (8.0,), "ease_in"),
        set_key("s1", RADIUS, 20, (2.0,)),
        set_key("s1", "f1/p1/*", 0),
        set_key("s1", "f1/p1/*", 20, (30.0, 10.0)),
    ):
        document = edit(document)
    return document


def radius(document: Document, frame: int) -> float:
    figure = at(document.sheets[0], frame).figures[0]
    assert isinstance(figure, Circle)
    return figure.radius_world


def test_a_key_holds_what_is_seen_in_its_frame() -> None:
    document = moving()
    assert keys_on(document, RADIUS) == [(0, (4.0,)), (10, (8.0,)), (20, (2.0,))]
    between = set_key("s1", RADIUS, 5)(document)
    assert keys_on(between, RADIUS)[1] == (5, (6.0,))
    again = set_key("s1", RADIUS, 5, (1.0,))(between)
    assert keys_on(again, RADIUS)[1] == (5, (1.0,))
    assert ids_in(again, 5) == ids_in(between, 5)
    assert highest(again) > highest(document)


@pytest.mark.parametrize("target", ["f1/name", "f1/algorithm", "f7/radius_world", "scene.camera.eye", ""])
def test_what_cannot_be_keyed_is_said(target: str) -> None:
    with pytest.raises(DocumentError, match="cannot be keyed"):
        set_key("s1", target, 0)(still())


@pytest.mark.parametrize(
    ("frame", "value"), [(-1, (1.0,)), (10**6, (1.0,)), (0, (float("nan"),)), (0.5, (1.0,))]
)
def test_a_key_outside_of_time_or_number_is_refused(frame: Any, value: tuple[float, ...]) -> None:
    with pytest.raises(DocumentError, match=r"frame|value"):
        set_key("s1", RADIUS, frame, value)(still())


def test_two_keys_in_one_frame_of_a_file_are_refused() -> None:
    twice = with_tracks(still(), track(RADIUS, (4, (1.0,)), (4, (2.0,))))
    with pytest.raises(DocumentError, match=r"tracks\[0\]\.keys\[1\]\.frame is 4, not after 4"):
        encode(Stored(twice))


def test_two_tracks_on_one_number_are_refused() -> None:
    first, second = track(RADIUS, (0, (1.0,))), track(RADIUS, (5, (1.0,)))
    second = replace(second, id="a99-", keys=(replace(second.keys[0], id="k99-"),))
    with pytest.raises(DocumentError, match="another track has too"):
        encode(Stored(with_tracks(still(), first, second)))


@pytest.mark.parametrize(("name", "value"), [("rate", 0.0), ("rate", 1e3), ("frames", 0), ("frames", 10**7)])
def test_a_rate_of_0_and_too_many_frames_are_refused(name: str, value: float) -> None:
    with pytest.raises(DocumentError, match=name):
        set_motion("s1", **{name: value})(moving())  # type: ignore[arg-type]
    assert set_motion("s1", frames=10**6)(moving()).sheets[0].motion.frames == 10**6  # type: ignore[union-attr]


def test_an_easing_that_runs_back_in_time_is_refused() -> None:
    document = moving()
    with pytest.raises(DocumentError, match=r"x1 is 1\.5"):
        set_easing("s1", ids_in(document, 0), "bezier", x1=1.5)(document)
    eased = set_easing("s1", ids_in(document, 0, 10), "bezier", x1=0.5, y1=-1.0)(document)
    assert radius(eased, 2) < 4.0


def test_moved_keys_take_the_place_of_others_and_none_comes_before_the_start() -> None:
    document = moving()
    moved = move_keys("s1", ids_in(document, 10), 10)(document)
    assert keys_on(moved, RADIUS) == [(0, (4.0,)), (20, (8.0,))]
    back = move_keys("s1", ids_in(document, 10, 20), -15)(document)
    assert keys_on(back, RADIUS) == [(0, (8.0,)), (10, (2.0,))]
    assert move_keys("s1", ids_in(document, 0), -3)(document) == document
    with pytest.raises(DocumentError, match="no key 'k999'"):
        move_keys("s1", ["k999"], 1)(document)


def test_keys_are_scaled_in_time() -> None:
    document = moving()
    every = ids_in(document, 0, 10, 20)
    assert [f for f, _v in keys_on(scale_keys("s1", every, 0.5, 0)(document), RADIUS)] == [0, 5, 10]
    assert [f for f, _v in keys_on(scale_keys("s1", every, 2.0, 10)(document), RADIUS)] == [0, 10, 30]
    with pytest.raises(DocumentError, match="land on the same frame"):
        scale_keys("s1", every, 0.01, 0)(document)


def test_time_is_put_in_and_taken_out() -> None:
    document = moving()
    longer = insert_time("s1", 10, 5)(document)
    assert [f for f, _v in keys_on(longer, RADIUS)] == [0, 15, 25]
    assert longer.sheets[0].motion.frames == 54  # type: ignore[union-attr]
    assert remove_time("s1", 10, 5)(longer).sheets == document.sheets
    shorter = remove_time("s1", 5, 10)(document)
    assert [f for f, _v in keys_on(shorter, RADIUS)] == [0, 10]
    assert keys_on(shorter, "f1/p1/*") == [(0, (10.0, 10.0)), (10, (30.0, 10.0))]


def test_removed_keys_are_gone_and_a_track_without_keys_too() -> None:
    document = moving()
    fewer = remove_keys("s1", ids_in(document, 10))(document)
    assert [f for f, _v in keys_on(fewer, RADIUS)] == [0, 20]
    assert keys_on(remove_keys("s1", ids_in(document, 0, 10, 20))(document), RADIUS) == []
    assert radius(remove_keys("s1", ids_in(document, 0, 10, 20))(document), 10) == 4.0


def test_copied_keys_are_pasted_with_easing_and_shape() -> None:
    document = moving()
    document = set_easing("s1", ids_in(document, 10), "bezier", x1=0.75)(document)
    copied = copied_keys(document, "s1", ids_in(document, 10, 20))
    pasted = paste_keys("s1", copied, 30)(document)
    assert keys_on(pasted, RADIUS)[3:] == [(30, (8.0,)), (40, (2.0,))]
    motion = pasted.sheets[0].motion
    assert motion is not None
    key = next(key for each in motion.tracks for key in each.keys if key.frame == 30)
    assert (key.easing, key.x1) == ("bezier", 0.75)
    elsewhere = paste_keys("s1", copied, 5)(still())
    assert keys_on(elsewhere, RADIUS) == [(5, (8.0,)), (15, (2.0,))]


def test_the_keys_of_a_removed_figure_go_with_it() -> None:
    document = set_key("s1", "f2/colour", 3)(moving())
    gone = remove_figures(["f1"])(document)
    assert [each.target for each in gone.sheets[0].motion.tracks] == ["f2/colour"]  # type: ignore[union-attr]
    corner = document.sheets[0].figures[1].points_world[2].id
    keyed = set_key("s1", f"f2/{corner}/x", 0)(document)
    assert keys_on(keyed, f"f2/{corner}/x")
    assert not keys_on(remove_point(f"s1/f2/{corner}/x")(keyed), f"f2/{corner}/x")
    assert keys_on(move_figures(["f1"], 2.0, 1.0)(document), RADIUS)


def test_changes_of_keys_have_addresses() -> None:
    document = moving()
    moved = move_keys("s1", ids_in(document, 10), 2)(document)
    track_id = document.sheets[0].motion.tracks[0].id  # type: ignore[union-attr]
    (key,) = ids_in(document, 10)
    assert {str(each) for each in changed(document, moved)} == {f"s1/{track_id}/{key}/frame"}
    set_by_hand = set_attribute(f"s1/{track_id}/{key}/frame", 12)(document)
    assert set_by_hand.sheets == moved.sheets


@pytest.mark.parametrize("name", [*numbers_of(Key), *numbers_of(Motion)])
def test_every_number_of_a_motion_has_an_address_and_a_range(name: str) -> None:
    document = moving()
    motion = document.sheets[0].motion
    assert motion is not None
    track_id, key = motion.tracks[0].id, motion.tracks[0].keys[0]
    if name == "value":
        at_number = f"s1/{track_id}/{key.id}/value.0"
        assert resolve(document, at_number) == 4.0
        return
    kind, place = (
        (Key, f"s1/{track_id}/{key.id}/{name}") if name in numbers_of(Key) else (Motion, f"s1/motion.{name}")
    )
    number = numbers_of(kind)[name]
    for wrong in (number.low - 1, number.high + 1):
        with pytest.raises(DocumentError, match=name):
            set_attribute(place, number.type(wrong))(document)
    kept = set_attribute(place, number.type(number.low))(document)
    assert resolve(kept, place) == number.low


def test_a_sheet_added_beside_itself_has_a_motion_of_its_own() -> None:
    document = moving()
    twice = add_sheet(document.sheets[0])(document)
    copy = twice.sheets[1]
    assert copy.motion is not None
    first = copy.figures[0]
    assert [each.target for each in copy.motion.tracks] == [
        f"{first.id}/radius_world",
        f"{first.id}/{first.points_world[0].id}/*",
    ]
    assert at(copy, 10).figures[0].radius_world == 8.0  # type: ignore[union-attr]
    assert decode(encode(Stored(twice))).document == twice


def test_auto_key_turns_what_is_keyed_into_keys() -> None:
    document = moving()
    edit = both(set_attribute("s1/f1/radius_world", 5.0), move_points({"s1/f1/p1/x": (3.0, 4.0)}))
    done = auto_key(edit, "s1", 15)(document)
    assert keys_on(done, RADIUS) == [(0, (4.0,)), (10, (8.0,)), (15, (5.0,)), (20, (2.0,))]
    assert keys_on(done, "f1/p1/*")[1] == (15, (3.0, 4.0))
    assert done.sheets[0].figures == document.sheets[0].figures
    assert done.sheets[0].palette == document.sheets[0].palette


def test_auto_key_makes_tracks_that_begin_with_the_old_value() -> None:
    done = auto_key(move_figures(["f2"], 5.0, 0.0), "s1", 12)(still())
    (start, first), (end, second) = keys_on(done, "f2/points_world")
    assert (start, end) == (0, 12)
    assert second == tuple(number + 5.0 * (place % 2 == 0) for place, number in enumerate(first))
    assert done.sheets[0].figures == still().sheets[0].figures
    one = auto_key(move_figures(["f1"], 5.0, 0.0), "s1", 12)(still())
    assert keys_on(one, "f1/p1/*") == [(0, (10.0, 10.0)), (12, (15.0, 10.0))]
    at_once = auto_key(set_attribute("s1/f1/radius_world", 2.0), "s1", 0)(still())
    assert keys_on(at_once, RADIUS) == [(0, (2.0,))]


def test_without_new_tracks_what_has_none_changes_in_all_frames() -> None:
    done = auto_key(set_attribute("s1/f1/radius_world", 2.0), "s1", 12, new_tracks=False)(still())
    assert done.sheets[0].motion is None
    assert radius(done, 3) == 2.0
    both_kinds = both(set_attribute("s1/f1/radius_world", 1.0), rename_figure("f1", "Sun"))
    done = auto_key(both_kinds, "s1", 10, new_tracks=False)(moving())
    assert keys_on(done, RADIUS)[1] == (10, (1.0,))
    assert done.sheets[0].figures[0].name == "Sun"
    assert radius(done, 0) == 4.0


def test_auto_key_keeps_what_cannot_be_keyed_and_what_is_gone() -> None:
    document = set_key("s1", "f2/colour", 0, (255.0, 0.0, 0.0))(moving())
    done = auto_key(remove_figures(["f1"]), "s1", 10)(document)
    assert [figure.id for figure in done.sheets[0].figures] == ["f2"]
    assert [each.target for each in done.sheets[0].motion.tracks] == ["f2/colour"]  # type: ignore[union-attr]
    assert done.sheets[0].palette == document.sheets[0].palette
    assert done.sheets[0].figures[0] == document.sheets[0].figures[1]


OUTLINE = "f2/points_world"
SQUARE = (0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 4.0)


def _seen(document: Document, frame: int) -> list[tuple[float, float]]:
    return sorted((p.x, p.y) for p in at(document.sheets[0], frame).figures[1].points_world)


def test_a_correspondence_is_an_edit_that_a_new_key_between_does_not_disturb() -> None:
    document = with_tracks(still(), track(OUTLINE, (0, SQUARE), (12, SQUARE)))
    (first,) = ids_in(document, 0, target=OUTLINE)
    turned = set_correspondence("s1", first, 1)(document)
    assert _seen(document, 6) == [(0.0, 0.0), (0.0, 4.0), (4.0, 0.0), (4.0, 4.0)]
    assert _seen(turned, 6) == [(0.0, 2.0), (2.0, 0.0), (2.0, 4.0), (4.0, 2.0)]
    assert decode(encode(Stored(turned))).document == turned
    divided = set_key("s1", OUTLINE, 6)(turned)
    for frame in range(13):
        np.testing.assert_allclose(_seen(divided, frame), _seen(turned, frame))
    with pytest.raises(DocumentError, match="shift"):
        set_correspondence("s1", first, -1)(document)


def test_how_a_turn_goes_on_is_chosen_by_key() -> None:
    document = with_tracks(still(), track(OUTLINE, (0, SQUARE), (12, SQUARE)))
    keys = ids_in(document, 0, target=OUTLINE)
    after = set_turning("s1", keys, "euler")(document)
    motion = after.sheets[0].motion
    assert motion is not None
    assert [key.turning for key in motion.tracks[0].keys] == ["euler", "quaternion"]
    with pytest.raises(DocumentError, match="no turning"):
        set_turning("s1", keys, "entries")(document)
