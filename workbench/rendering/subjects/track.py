"""A track between two of its keys: the in-betweens of its numbers, a spline, a morph, or a turn in space."""

from typing import Any

import numpy as np
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.algorithms.animation import morph, slerp, spline_tween, tween
from workbench.algorithms.marks import Frame, Mark
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.motion.between import corners, quaternion_of
from workbench.document.motion.groups import Group, group_of
from workbench.document.motion.model import EASINGS, EULER, MAX_FRAMES, SPLINE, Key, Track
from workbench.document.motion.tracks import group_moved, motion_of, track_on
from workbench.document.subjects import Subject
from workbench.geometry.euler import euler_angles, euler_between
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, mapped, register

Interval = tuple[Key, Key]
KIND = "track"
TWEEN, SPLINE_TWEEN, MORPH, SLERP = (text.__name__ for text in (tween, spline_tween, morph, slerp))
_SHAPES = ("tension", "continuity", "bias")


def is_of_a_track(subject: Subject) -> bool:
    """Whether the frames between keys are what is stepped."""
    return subject.kind == KIND


def at_frame(target: str, frame: int) -> Subject:
    """The in-betweens of a track around a frame."""
    return Subject(KIND, arguments={"target": target, "frame": frame})


def aimed(sheet: Sheet, subject: Subject, target: str, frame: int) -> tuple[Subject, int]:
    """The subject that steps the track on ``target`` where a frame is, and the step that shows this frame.

    It keeps the entry of ``subject`` where that is of the same track, and its keys where the frame lies
    between them. Step 0 where no step shows the frame: it lies before the first key or after the last one,
    or an outline is stepped, vertex by vertex.
    """
    track, outline = track_on(sheet, target), _is_outline(sheet, target)
    around = keys_stepped(sheet, subject, target, frame)
    first, last = (frame, frame) if around is None else (around[0].frame, around[1].frame)
    entry = subject.entry if subject.arguments.get("target") == target else ""
    aim = replace(at_frame(target, frame if outline else first), entry=entry)
    choices = _choices(sheet, aim)
    if entry not in choices:
        aim = replace(aim, entry="")
    if track is not None and choices and (aim.entry or choices[0]) == SPLINE_TWEEN:
        first, last = track.keys[0].frame, track.keys[-1].frame
    return aim, 0 if outline or not first <= frame <= last else frame - first + 1


def keys_stepped(sheet: Sheet, subject: Subject, target: str, frame: int) -> Interval | None:
    """The two keys of the track on ``target`` that are stepped where a frame is: those of ``subject`` where
    the frame lies between them, so that the last step of two keys is theirs; else those around the frame.
    """
    track, own = track_on(sheet, target), subject.arguments.get("frame", frame)
    if track is None:
        return None
    if subject.arguments.get("target") == target and not _is_outline(sheet, target):
        assert isinstance(own, int)
        around = keys_around(track, own)
        if around is not None and around[0].frame <= frame <= around[1].frame:
            return around
    return keys_around(track, frame)


def _is_outline(sheet: Sheet, target: str) -> bool:
    group = group_of(sheet, target)
    return group is not None and group.kind == "outline"


def track_of(sheet: Sheet, subject: Subject) -> Track | None:
    """The track that a subject names, or else the first one; None where the sheet has none that moves."""
    target = str(subject.arguments.get("target", ""))
    if target and (track := track_on(sheet, target)) is not None:
        return track
    return next((each for each in motion_of(sheet).tracks if group_moved(sheet, each) is not None), None)


def keys_around(track: Track, frame: int) -> Interval | None:
    """The two keys between which a frame lies, at an end the last two; None where there is but one."""
    if len(track.keys) < 2:
        return None
    place = sum(key.frame <= frame for key in track.keys[1:-1])
    return track.keys[place], track.keys[place + 1]


def _found(sheet: Sheet, subject: Subject) -> tuple[Track, Group, Key, Key] | None:
    track = track_of(sheet, subject)
    group = None if track is None else group_moved(sheet, track)
    frame = subject.arguments.get("frame", 0)
    assert isinstance(frame, int)
    around = None if track is None else keys_around(track, frame)
    if track is None or group is None or around is None:
        return None
    return track, group, *around


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    keyed = _found(sheet, subject)
    if keyed is None:
        return ()
    _track, group, key, _following = keyed
    if group.kind == "outline":
        return (MORPH,)
    if group.kind == "turn":
        return (TWEEN, SLERP) if key.turning == EULER else (SLERP,)
    return (SPLINE_TWEEN, TWEEN) if key.easing == SPLINE else (TWEEN, SPLINE_TWEEN)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    found, choices = _found(sheet, subject), _choices(sheet, subject)
    if found is None or (subject.entry and subject.entry not in choices):
        return []
    track, group, first, second = found
    slug = subject.entry or choices[0]
    entry = catalogue.get(slug)
    if slug == MORPH:
        return [Call(entry, _morph_arguments(sheet, group, subject, first, second))]
    if slug == SLERP:
        ends = (np.array(quaternion_of(key.value), np.float64) for key in (first, second))
        return [Call(entry, (*ends, second.frame - first.frame - 1))]
    if slug == SPLINE_TWEEN:
        frames = np.array([key.frame for key in track.keys], np.int64)
        shapes = [np.array([getattr(key, name) for key in track.keys], np.float64) for name in _SHAPES]
        values = np.array([key.value for key in track.keys], np.float64)
        return [Call(entry, (frames, column.copy(), *shapes)) for column in values.T]
    code = EASINGS.index(first.easing) if first.easing != SPLINE else EASINGS.index("linear")
    pairs = zip(
        *(_euler_degrees(first, second) if group.kind == "turn" else (first.value, second.value)), strict=True
    )
    return [Call(entry, (first.frame, second.frame, a, b, code, *first.handles)) for a, b in pairs]


def _morph_arguments(
    sheet: Sheet, group: Group, subject: Subject, first: Key, second: Key
) -> tuple[Any, ...]:
    figure = sheet.figures[int(group.slots[0].path[1])]
    outlines = [corners(key) for key in (first, second)]
    frame = subject.arguments.get("frame", 0)
    assert isinstance(frame, int)
    t = min(max((frame - first.frame) / (second.frame - first.frame), 0.0), 1.0)
    return *outlines, bool(getattr(figure, "closed", True)), first.shift, t


def _euler_degrees(first: Key, second: Key) -> tuple[list[float], list[float]]:
    """Euler's angles of both keys, degrees about x, y and z, as each goes by itself."""
    before, after = (euler_angles(quaternion_of(key.value)) for key in (first, second))
    start, end = (np.degrees(euler_between(before, after, part)).tolist() for part in (0.0, 1.0))
    return start, end


def _on_device(sheet: Sheet, subject: Subject, frame: Frame, marks: Any) -> tuple[Mark, ...]:
    """Outlines lie in the picture; what goes over time does not."""
    return mapped(sheet, subject, frame, marks) if frame == "world" else ()


register(
    KIND,
    SubjectKind(
        title=_("The frames between two keys"),
        invitation=_("Set two keys on a track, to see the frames between them worked out step by step."),
        calls=_calls,
        choices=_choices,
        entries=(TWEEN, SPLINE_TWEEN, MORPH, SLERP),
        arguments={
            "target": Given(""),
            "frame": Given(0, Number(label=_("frame"), low=0, high=MAX_FRAMES - 1, whole=True, keyed=False)),
        },
        on_device=_on_device,
    ),
)
