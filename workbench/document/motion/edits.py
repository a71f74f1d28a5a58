"""Edits of the motion of a sheet: keys set, moved, scaled in time, removed, pasted; easings, length, rate.

Keys are named by their ids. Where a key comes to a frame that has one already, it takes its place.
"""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

from workbench.document.addresses import highest, new_ids, sheet_with
from workbench.document.building import Edit, checked, number, remembering, whole_number
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.motion.evaluation import at, values_along
from workbench.document.motion.groups import group_of, value_of
from workbench.document.motion.model import (
    BEZIER_NAME,
    EASINGS,
    LINEAR,
    SPLINE,
    TURNINGS,
    Key,
    Motion,
    Track,
)
from workbench.document.motion.tracks import motion_of, track_on, with_keys, with_motion, with_track
from workbench.language import _

RADII = ("radius_x_world", "radius_y_world")
_MOST_STRETCHES = 20_000
_HANDLES = ("x1", "y1", "x2", "y2")


class CopiedKey(NamedTuple):
    """A key as it is pasted: on which target, and how many frames after the first that was copied."""

    target: str
    after: int
    key: Key


@checked
def set_key(
    sheet: str, target: str, frame: int, value: Iterable[float] | None = None, easing: str = ""
) -> Edit:
    """Set a key in a frame, by default with what is seen there; where there is one, it gets the value.

    ``easing`` leads to the next key, by default that of the key before. Raises: DocumentError for a target
    that cannot be keyed.
    """
    where = whole_number(frame)

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        seen = at(on, where) if type(where) is int else on
        group = group_of(seen, target)
        if group is None:
            sentence = _("This cannot be keyed; choose a number, a point, a colour or an outline.")
            raise DocumentError(target, sentence)
        numbers = value_of(seen, group) if value is None else tuple(map(number, value))
        return with_key(document, sheet, target, where, numbers, easing)

    return edit


def with_key(
    document: Document, sheet: str, target: str, frame: int, value: tuple[float, ...], easing: str = ""
) -> Document:
    """``document`` with a key; the track is made where there is none. It is not checked."""
    track = track_on(sheet_with(document, sheet), target)
    if track is None:
        own, key = new_ids(document, "", 2)
        first = Key(f"{Key.letter}{key}", frame, value, easing or LINEAR)
        return with_track(document, sheet, Track(f"{Track.letter}{own}", target, (first,)))
    there = next((key for key in track.keys if key.frame == frame), None)
    is_new = there is None
    if there is None:
        like = next((key for key in reversed(track.keys) if key.frame < frame), track.keys[0])
        there = replace(like, id=new_ids(document, Key.letter, 1)[0], frame=frame)
    changed = replace(there, value=value, easing=easing or there.easing)
    # Between both keys vertex 0 is that of the key before; only from here on it goes to another one
    divided = next((key.id for key in reversed(track.keys) if key.frame < frame), "") if is_new else ""
    others = (replace(key, shift=0) if key.id == divided else key for key in track.keys if key.frame != frame)
    keys = tuple(sorted((*others, changed), key=lambda key: key.frame))
    return with_track(document, sheet, replace(track, keys=keys))


def _changing(sheet: str, keys: Collection[str], change: Callable[[Key], Key | None]) -> Edit:
    """Change these keys, or with None remove them; they take the places of those that stay."""
    chosen = frozenset(keys)

    def changed(track: tuple[Key, ...]) -> tuple[Key, ...]:
        new = (change(key) for key in track if key.id in chosen)
        return *(key for key in track if key.id not in chosen), *(key for key in new if key is not None)

    def edit(document: Document) -> Document:
        known = {key.id for track in motion_of(sheet_with(document, sheet)).tracks for key in track.keys}
        for missing in sorted(chosen - known):
            sentence = _("There is no key {id!r}; it may have been removed.")
            raise DocumentError(missing, sentence.format(id=missing))
        after = with_keys(document, sheet, changed)
        return remembering(document, after) if highest(after) < highest(document) else after

    return edit


@checked
def move_keys(sheet: str, keys: Collection[str], by: int) -> Edit:
    """Move keys in time by so many frames, at most so far that the first of them comes to frame 0."""
    chosen = frozenset(keys)

    def edit(document: Document) -> Document:
        tracks = motion_of(sheet_with(document, sheet)).tracks
        first = min((key.frame for track in tracks for key in track.keys if key.id in chosen), default=0)
        shift = max(whole_number(by), -first)
        return _changing(sheet, chosen, lambda key: replace(key, frame=key.frame + shift))(document)

    return edit


@checked
def raise_keys(sheet: str, target: str, keys: Collection[str], place: int, by: float) -> Edit:
    """Add ``by`` to the number at ``place`` of these keys of a track, held in the range of the number."""
    chosen = frozenset(keys)

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        track, group = track_on(on, target), group_of(on, target)
        if track is None or group is None or not 0 <= place < len(group.slots):
            sentence = _("{target} has no number {place}; choose another.")
            raise DocumentError(target, sentence.format(target=target, place=place))
        limits = group.slots[place].number

        def raised(key: Key) -> Key:
            value = min(max(key.value[place] + by, limits.low), limits.high)
            return replace(key, value=(*key.value[:place], value, *key.value[place + 1 :]))

        own = {key.id for key in track.keys}
        return _changing(sheet, chosen & own, raised)(document)

    return edit


@checked
def scale_keys(sheet: str, keys: Collection[str], factor: float, about: int) -> Edit:
    """Take keys ``factor`` times as far from the frame ``about``, to whole frames, none before frame 0.

    Raises: DocumentError where two of a track would come to one frame.
    """
    chosen = frozenset(keys)

    def scaled(key: Key) -> Key:
        return replace(key, frame=max(int(about + (key.frame - about) * factor + 0.5), 0))

    def edit(document: Document) -> Document:
        for track in motion_of(sheet_with(document, sheet)).tracks:
            frames = [scaled(key).frame for key in track.keys if key.id in chosen]
            if len(set(frames)) < len(frames):
                sentence = _("Two keys of one track would land on the same frame; scale them less.")
                raise DocumentError(track.target, sentence)
        return _changing(sheet, chosen, scaled)(document)

    return edit


@checked
def remove_keys(sheet: str, keys: Collection[str]) -> Edit:
    """Remove keys; a track without any goes too, and its number stays as the sheet has it."""
    return _changing(sheet, keys, lambda key: None)


@checked
def set_easing(sheet: str, keys: Collection[str], easing: str, **shape: float) -> Edit:
    """Let these keys lead to the next ones by an easing; ``shape`` has numbers of a key such as x1."""
    if easing not in EASINGS:
        sentence = _("There is no easing {easing!r}; choose one of {choices}.")
        raise DocumentError("easing", sentence.format(easing=easing, choices=", ".join(EASINGS)))
    numbers = {name: number(value) for name, value in shape.items()}
    return _changing(sheet, keys, lambda key: replace(key, easing=easing, **numbers))


@checked
def set_correspondence(sheet: str, key: str, shift: int) -> Edit:
    """Let vertex 0 of a closed outline go to the vertex ``shift`` of the next key, counted round."""
    return _changing(sheet, [key], lambda each: replace(each, shift=whole_number(shift)))


@checked
def set_turning(sheet: str, keys: Collection[str], turning: str) -> Edit:
    """Let a turn in space go from these keys to the next ones by quaternion or by Euler's angles."""
    if turning not in TURNINGS:
        sentence = _("There is no turning {turning!r}; choose one of {choices}.")
        raise DocumentError("turning", sentence.format(turning=turning, choices=", ".join(TURNINGS)))
    return _changing(sheet, keys, lambda key: replace(key, turning=turning))


@checked
def bend_keys(sheet: str, handles: Mapping[str, Sequence[float]]) -> Edit:
    """Let keys lead to the next ones by Bézier easings with these handles, x1, y1, x2, y2, by their ids."""
    shapes = {name: dict(zip(_HANDLES, map(number, shape), strict=True)) for name, shape in handles.items()}
    return _changing(sheet, shapes, lambda key: replace(key, easing=BEZIER_NAME, **shapes[key.id]))


@checked
def even_speed(sheet: str, target: str) -> Edit:
    """Move the inner keys of a track in time so that each way between two keys takes frames as it is long.

    What is not a spline becomes linear. Of very many frames not every one is looked at. Raises: DocumentError
    for a track without inner keys, or that stays in one place.
    """

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        track, group = track_on(on, target), group_of(on, target)
        if track is None or group is None or group.kind != "numbers" or len(track.keys) < 3:
            sentence = _("The track has no keys between its first and its last; set some.")
            raise DocumentError(target, sentence)
        first, last = track.keys[0].frame, track.keys[-1].frame
        keyed = np.array([key.frame for key in track.keys], np.float64)
        step = -(-(last - first) // _MOST_STRETCHES)
        seen = np.union1d(np.arange(first, last, step, dtype=np.float64), keyed)
        ways = np.diff(values_along(track, seen, group), axis=0)
        gone = np.append(0.0, np.cumsum(np.linalg.norm(ways, axis=1)))
        if gone[-1] == 0.0:
            raise DocumentError(target, _("The track does not move; give it keys that differ."))
        parts = (gone[np.searchsorted(seen, keyed)] / gone[-1]).tolist()
        frames = [first + round((last - first) * part) for part in parts]
        for place in range(1, len(frames) - 1):  # each key keeps a frame of its own
            frames[place] = max(frames[place], frames[place - 1] + 1)
        for place in range(len(frames) - 2, 0, -1):
            frames[place] = min(frames[place], frames[place + 1] - 1)
        keys = tuple(
            replace(key, frame=frame, easing=key.easing if key.easing == SPLINE else LINEAR)
            for key, frame in zip(track.keys, frames, strict=True)
        )
        return with_track(document, sheet, replace(track, keys=keys))

    return edit


@checked
def keep_area(sheet: str, figure: str) -> Edit:
    """Give one radius of an ellipse a key wherever the other has one, so that its area stays that of frame 0.

    Raises: DocumentError where both radii have keys, or none.
    """

    def edit(document: Document) -> Document:
        on = sheet_with(document, sheet)
        tracked = [f"{figure}/{name}" for name in RADII if track_on(on, f"{figure}/{name}") is not None]
        free = [f"{figure}/{name}" for name in RADII if f"{figure}/{name}" not in tracked]
        if len(tracked) != 1:
            raise DocumentError(
                figure,
                _("Exactly one of the two radii must have keys; set some, or remove those of the other."),
            )
        groups = [group_of(on, target) for target in (*tracked, *free)]
        (moving,), (still,) = (value_of(at(on, 0), group) for group in groups if group is not None)
        track = track_on(on, tracked[0])
        assert track is not None
        for key in track.keys:
            if key.value[0] > 0.0:
                wide = still * moving / key.value[0]
                document = with_key(document, sheet, free[0], key.frame, (wide,), key.easing)
        return document

    return edit


@checked
def insert_time(sheet: str, frame: int, count: int) -> Edit:
    """Put ``count`` frames before a frame: it, and all keys from it on, come later."""

    def edit(document: Document) -> Document:
        longer = with_keys(
            document,
            sheet,
            lambda keys: [replace(k, frame=k.frame + count) if k.frame >= frame else k for k in keys],
        )
        motion = motion_of(sheet_with(longer, sheet))
        return with_motion(longer, sheet, replace(motion, frames=motion.frames + count))

    return edit


@checked
def remove_time(sheet: str, frame: int, count: int) -> Edit:
    """Take ``count`` frames away, from a frame on, with their keys; later keys come so much earlier."""

    def earlier(keys: tuple[Key, ...]) -> Iterable[Key]:
        left = [key for key in keys if not frame <= key.frame < frame + count]
        return [replace(key, frame=key.frame - count) if key.frame >= frame else key for key in left]

    def edit(document: Document) -> Document:
        shorter = with_keys(document, sheet, earlier)
        motion = motion_of(sheet_with(shorter, sheet))
        left = replace(motion, frames=max(motion.frames - count, 1))
        return remembering(document, with_motion(shorter, sheet, left))

    return edit


@checked
def set_motion(sheet: str, frames: int | None = None, rate: float | None = None) -> Edit:
    """Set the number of frames, or how many of them a second has; keys beyond the end stay."""

    def edit(document: Document) -> Document:
        motion: Motion = motion_of(sheet_with(document, sheet))
        if frames is not None:
            motion = replace(motion, frames=whole_number(frames))
        if rate is not None:
            motion = replace(motion, rate=number(rate))
        return with_motion(document, sheet, motion)

    return edit


def copied_keys(document: Document, sheet: str, keys: Collection[str]) -> tuple[CopiedKey, ...]:
    """These keys, to be pasted later."""
    tracks = motion_of(sheet_with(document, sheet)).tracks
    chosen = [(track.target, key) for track in tracks for key in track.keys if key.id in keys]
    first = min((key.frame for _target, key in chosen), default=0)
    return tuple(CopiedKey(target, key.frame - first, key) for target, key in chosen)


@checked
def paste_keys(sheet: str, keys: Sequence[CopiedKey], frame: int) -> Edit:
    """Put copied keys on their tracks, the first of them in this frame; what is not there gets none."""

    def edit(document: Document) -> Document:
        for target, after, key in keys:
            on = sheet_with(document, sheet)
            if group_of(on, target) is None:
                continue
            track = track_on(on, target) or Track(new_ids(document, Track.letter, 1)[0], target, ())
            document = with_track(document, sheet, track)
            pasted = replace(key, id=new_ids(document, Key.letter, 1)[0], frame=frame + after)
            others = (each for each in track.keys if each.frame != pasted.frame)
            ordered = tuple(sorted((*others, pasted), key=lambda each: each.frame))
            document = with_track(document, sheet, replace(track, keys=ordered))
        return document

    return edit
