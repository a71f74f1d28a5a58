"""Tracks of a document: found, put in place of others, and taken along with what they hang on."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import chain
from typing import Any

from msgspec.structs import replace

from workbench.document.addresses import new_ids, sheet_with
from workbench.document.differences import between
from workbench.document.model import Document, Sheet
from workbench.document.motion.groups import Group, group_of, value_of
from workbench.document.motion.model import Key, Motion, Track


def motion_of(sheet: Sheet) -> Motion:
    """The motion of a sheet; of one that has none, the one that it begins with."""
    return sheet.motion or Motion()


def track_on(sheet: Sheet, target: str) -> Track | None:
    """The track on this target, if there is one."""
    return None if sheet.motion is None else _by_target(sheet.motion).get(target)


@lru_cache(maxsize=8)
def _by_target(motion: Motion) -> Mapping[str, Track]:
    return {track.target: track for track in reversed(motion.tracks)}


def group_moved(sheet: Sheet, track: Track) -> Group | None:
    """What a track moves; None where what it hangs on is not there, or its keys have other numbers."""
    group = group_of(sheet, track.target)
    counts = {len(key.value) for key in track.keys}
    if group is not None and group.kind == "outline":
        return group if all(count >= 4 and count % 2 == 0 for count in counts) else None
    return group if group is not None and counts == {len(group.slots)} else None


def with_motion(document: Document, sheet: str, motion: Motion | None) -> Document:
    """``document`` with this motion on a sheet. Raises: DocumentError."""
    changed = replace(sheet_with(document, sheet), motion=motion)
    return replace(document, sheets=tuple(changed if old.id == sheet else old for old in document.sheets))


def with_track(document: Document, sheet: str, track: Track) -> Document:
    """``document`` with a track in place of the one on its target, or after the others."""
    motion = motion_of(sheet_with(document, sheet))
    tracks = {each.target: each for each in motion.tracks} | {track.target: track}
    return with_motion(document, sheet, replace(motion, tracks=tuple(tracks.values())))


def with_keys(document: Document, sheet: str, change: Callable[[tuple[Key, ...]], Iterable[Key]]) -> Document:
    """``document`` with the keys of each track of a sheet changed, in the order of their frames.

    Of two keys in one frame the one that comes later in the changed list stays; a track without keys goes.
    Raises: DocumentError.
    """
    motion = motion_of(sheet_with(document, sheet))
    tracks = []
    for track in motion.tracks:
        keys = {key.frame: key for key in change(track.keys)}
        ordered = tuple(keys[frame] for frame in sorted(keys))
        if ordered:
            tracks.append(track if ordered == track.keys else replace(track, keys=ordered))
    return with_motion(document, sheet, replace(motion, tracks=tuple(tracks)))


def tracks_of(sheet: Sheet, owners: Collection[str]) -> tuple[Track, ...]:
    """The tracks that hang on these figures or things, by their ids."""
    return tuple(track for track in motion_of(sheet).tracks if track.target.split("/")[0] in owners)


def motion_copied(sheet: Sheet, owners: Collection[str]) -> Motion | None:
    """The motion of a sheet with only the tracks of these; None where they have none."""
    tracks = tracks_of(sheet, owners)
    return replace(sheet.motion, tracks=tracks) if sheet.motion is not None and tracks else None


def with_copied_tracks(
    document: Document, sheet: str, tracks: Iterable[Track], original: Sheet, renamed: Mapping[str, str]
) -> Document:
    """``document`` with ``tracks``, which hang on what is on ``original``, copied for what is on ``sheet``.

    ``renamed`` has the ids of the copies by those of the originals. Each key keeps its distance from what the
    figures are without motion.
    """
    on = sheet_with(document, sheet)
    for track in tracks:
        target = "/".join(renamed.get(part, part) for part in track.target.split("/"))
        before, after = group_moved(original, track), group_of(on, target)
        if before is None or after is None:
            continue
        shifts = [b - a for a, b in zip(value_of(original, before), value_of(on, after), strict=True)]
        number, *names = new_ids(document, "", 1 + len(track.keys))
        keys = tuple(
            replace(key, id=f"{Key.letter}{name}", value=_shifted(key.value, shifts))
            for key, name in zip(track.keys, names, strict=True)
        )
        document = with_track(document, sheet, Track(f"{Track.letter}{number}", target, keys))
    return document


def _shifted(value: tuple[float, ...], shifts: list[float]) -> tuple[float, ...]:
    """The numbers of a key moved; an outline of another number of points moves as the first one does."""
    if len(value) != len(shifts):
        shifts = shifts[:2] * (len(value) // 2)
    return tuple(number + shift for number, shift in zip(value, shifts, strict=True))


def without_orphans(before: Document, after: Document) -> Document:
    """``after`` without the tracks of what it no longer has and ``before`` had."""
    old_sheets = {sheet.id: sheet for sheet in before.sheets}
    for sheet in after.sheets:
        old = old_sheets.get(sheet.id)
        if sheet.motion is None or old is None or not _lost(old, sheet):
            continue
        tracks = tuple(
            track
            for track in sheet.motion.tracks
            if group_of(sheet, track.target) is not None or group_of(old, track.target) is None
        )
        if len(tracks) < len(sheet.motion.tracks):
            after = with_motion(after, sheet.id, replace(sheet.motion, tracks=tracks))
    return after


def _lost(old: Sheet, sheet: Sheet) -> set[str]:
    """The ids of figures, things and their parts that ``old`` has and ``sheet`` has not."""
    lost: set[str] = set()
    for before, after in ((old.figures, sheet.figures), (_things(old), _things(sheet))):
        start, old_end, end = between(before, after)
        gone = set(chain.from_iterable(thing.ids for thing in before[start:old_end]))
        lost |= gone.difference(chain.from_iterable(thing.ids for thing in after[start:end]))
    return lost if old.scene is None or sheet.scene is not None else {"scene", *lost}


def _things(sheet: Sheet) -> tuple[Any, ...]:
    return sheet.scene.things if sheet.scene is not None else ()


def with_new_ids(motion: Motion, renamed: Mapping[str, str], fresh: Iterator[int]) -> Motion:
    """A motion with new ids for its tracks and keys, and for what they hang on those that it has now."""
    return replace(
        motion,
        tracks=tuple(
            replace(
                track,
                id=f"{track.letter}{next(fresh)}",
                target="/".join(renamed.get(part, part) for part in track.target.split("/")),
                keys=tuple(replace(key, id=f"{key.letter}{next(fresh)}") for key in track.keys),
            )
            for track in motion.tracks
        ),
    )
