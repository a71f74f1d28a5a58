"""The sheet in a frame. What a track gives is held in the range of its number, and what cannot be drawn is
left as the sheet stands; both are said."""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.animation.spline_tween import blends
from workbench.document.model import Figure, Sheet
from workbench.document.motion.between import with_between
from workbench.document.motion.easing import eased_parts
from workbench.document.motion.groups import Group, Path, read, written
from workbench.document.motion.keys import Interval, Keys, along, interval, joined
from workbench.document.motion.model import EASINGS, SPLINE, Track
from workbench.document.motion.tracks import group_moved
from workbench.document.scene.laws import LAWS as SCENE_LAWS
from workbench.document.scene.model import Camera, Object
from workbench.document.transforms.chains import LARGEST

Floats = NDArray[np.float64]
_SPLINE = EASINGS.index(SPLINE)


class Frame(NamedTuple):
    """The sheet in a frame, and the targets of what is not as its track would have it."""

    sheet: Sheet
    held: tuple[str, ...]


class _Write(NamedTuple):
    """What is written into one figure or thing: into structs in it, and into the parts of its lists.

    Of each struct the names of what is written and which of the values in order that is; of a part its list
    and its place first. Names are left out where all that a part has beside its id is written, in order.
    """

    path: Path
    structs: tuple[tuple[Path, tuple[str, ...], slice], ...]
    parts: tuple[tuple[str, tuple[tuple[int, tuple[str, ...], slice], ...]], ...]


class _Plan(NamedTuple):
    """What of the motion of a sheet is the same in every frame."""

    tracks: tuple[Track, ...]
    groups: tuple[Group, ...]
    keys: Keys | None
    low: Floats
    high: Floats
    order: NDArray[np.int64]
    writes: tuple[_Write, ...]
    alone: tuple[tuple[Track, Group], ...]
    alone_keys: Keys | None
    loose: tuple[str, ...]


def at(sheet: Sheet, frame: int) -> Sheet:
    """The sheet as it is in a frame, from 0; the same object where nothing moves. It is remembered."""
    return in_frame(sheet, frame).sheet


def wished(track: Track, frame: int) -> Floats:
    """The numbers (n,) of a track of numbers in a frame, before they are held in their ranges."""
    keys = joined((track,))
    return _values(keys, interval(keys, frame))


def loose(sheet: Sheet) -> tuple[str, ...]:
    """The targets of tracks that move nothing, since what they hang on is not there or has other numbers."""
    return _plan(sheet).loose if sheet.motion is not None else ()


@lru_cache(maxsize=64)
def in_frame(sheet: Sheet, frame: int) -> Frame:
    """The sheet as it is in a frame, and what is held."""
    if sheet.motion is None or not sheet.motion.tracks:
        return Frame(sheet, ())
    plan = _plan(sheet)
    held: list[str] = []
    moved = sheet
    if plan.keys is not None:
        wished = _values(plan.keys, interval(plan.keys, frame))
        values = np.clip(wished, plan.low, plan.high)
        outside = np.unique(plan.keys.track[wished != values])
        held += [plan.tracks[number].target for number in outside.tolist()]
        moved = _written_all(sheet, plan.writes, values[plan.order].tolist(), held)
    if plan.alone_keys is not None:
        before, after, t = interval(plan.alone_keys, frame)
        parts = _parts(plan.alone_keys, before, t).tolist()
        places = (before - plan.alone_keys.first).tolist(), (after - plan.alone_keys.first).tolist()
        for (track, group), first, second, part in zip(plan.alone, *places, parts, strict=True):
            moved = with_between(moved, group, track.keys[first], track.keys[second], part)
    return Frame(moved, tuple(held))


@lru_cache(maxsize=8)
def _plan(sheet: Sheet) -> _Plan:
    assert sheet.motion is not None
    together: list[tuple[Track, Group]] = []
    alone: list[tuple[Track, Group]] = []
    loose_targets: list[str] = []
    for track in sheet.motion.tracks:
        group = group_moved(sheet, track)
        if group is None:
            loose_targets.append(track.target)
        elif group.kind == "numbers" or (group.kind == "outline" and _as_many(track, group)):
            together.append((track, group))
        else:
            alone.append((track, group))
    slots = [slot for _track, group in together for slot in group.slots]
    return _Plan(
        tuple(track for track, _group in together),
        tuple(group for _track, group in together),
        joined([track for track, _group in together]) if together else None,
        np.array([slot.number.low for slot in slots]),
        np.array([slot.number.high for slot in slots]),
        *_writes(sheet, (slot.path for slot in slots)),
        tuple(alone),
        joined([_timed(track) for track, _group in alone]) if alone else None,
        tuple(loose_targets),
    )


def _timed(track: Track) -> Track:
    """The track with one number a key: of what is no number by itself only the times matter here."""
    return replace(track, keys=tuple(replace(key, value=(0.0,)) for key in track.keys))


def _as_many(track: Track, group: Group) -> bool:
    """Whether an outline has as many points in every key as the figure, each going to that of its number."""
    return all(len(key.value) == len(group.slots) and key.shift == 0 for key in track.keys)


def _writes(sheet: Sheet, paths: Iterable[Path]) -> tuple[NDArray[np.int64], tuple[_Write, ...]]:
    """The order of the values, and what is written where: figure by figure, and in each struct by struct."""
    things: dict[Path, dict[Path, list[tuple[str, int]]]] = {}
    for number, path in enumerate(paths):
        thing = path[:2] if path[0] == "figures" or path[1] == "camera" else path[:3]
        things.setdefault(thing, {}).setdefault(path[len(thing) : -1], []).append((str(path[-1]), number))
    order: list[int] = []
    writes = tuple(_write(sheet, thing, structs, order) for thing, structs in things.items())
    return np.array(order, np.int64), writes


def _write(sheet: Sheet, thing: Path, structs: dict[Path, list[tuple[str, int]]], order: list[int]) -> _Write:
    whole: list[tuple[Path, tuple[str, ...], slice]] = []
    parts: dict[str, list[tuple[int, tuple[str, ...], slice]]] = {}
    for inner, pairs in structs.items():
        names, which = tuple(name for name, _number in pairs), slice(len(order), len(order) + len(pairs))
        order += [number for _name, number in pairs]
        if len(inner) == 2 and isinstance(inner[1], int):
            all_of_it = read(sheet, (*thing, *inner)).__struct_fields__ == ("id", *names)
            parts.setdefault(str(inner[0]), []).append((inner[1], () if all_of_it else names, which))
        else:
            whole.append((inner, names, which))
    return _Write(thing, tuple(whole), tuple((name, tuple(some)) for name, some in parts.items()))


def _parts(keys: Keys, before: NDArray[np.int64], t: Floats) -> Floats:
    """The part of the way of each track; a spline goes as the time does."""
    return eased_parts(keys.easings[before], keys.handles[before], t)


def _values(keys: Keys, where: Interval) -> Floats:
    """The number of every track in the frame, before it is held in its range."""
    parts = _parts(keys, where.before, where.t)
    first = keys.start + (where.before - keys.first)[keys.track] * keys.stride
    second = keys.start + (where.after - keys.first)[keys.track] * keys.stride
    start = keys.values[first]
    values = start + parts[keys.track] * (keys.values[second] - start)
    splined = (keys.easings[where.before] == _SPLINE)[keys.track]
    if splined.any():
        own = keys.track[splined]
        h0, h1, h2, h3 = blends(where.t[own])
        span = (keys.frames[where.after] - keys.frames[where.before])[own]
        first, second = first[splined], second[splined]
        along = span * (h2 * keys.leaving[first] + h3 * keys.arriving[second])
        values[splined] = h0 * keys.values[first] + h1 * keys.values[second] + along
    return values


def values_along(track: Track, frames: Floats, group: Group | None = None) -> Floats:
    """The numbers (n, numbers) of a track at frames (n,), whole or between.

    Each number goes by itself, as those of no colour, turn or morphed outline do; given the ``group`` that
    the track moves, it is held in its range.
    """
    values = _values(*along(track, frames)).reshape(len(frames), -1)
    if group is None:
        return values
    low, high = np.array([(slot.number.low, slot.number.high) for slot in group.slots]).T
    return np.clip(values, low, high)


def _written_all(sheet: Sheet, writes: Sequence[_Write], values: list[float], held: list[str]) -> Sheet:
    figures = list(sheet.figures)
    scene: Any = sheet.scene
    for write in writes:
        path = write.path
        in_scene = path[0] == "scene"
        thing = read(scene, path[1:]) if in_scene else figures[path[1]]  # type: ignore[index]
        moved = _moved(thing, write, values)
        if not _stands(moved):
            held.append(getattr(thing, "id", "scene.camera"))
        elif in_scene:
            scene = written(scene, path[1:], moved)
        else:
            figures[path[1]] = moved  # type: ignore[index]
    return replace(sheet, figures=tuple(figures), scene=scene)


def _moved(thing: Any, write: _Write, values: list[float]) -> Any:
    """A figure or thing with its numbers, from the ``values`` in order."""
    for path, names, which in write.structs:
        changes = dict(zip(names, values[which], strict=True))
        thing = written(thing, path, replace(read(thing, path), **changes))
    if not write.parts:
        return thing
    lists: dict[str, tuple[Any, ...]] = {}
    for list_name, parts in write.parts:
        moved = list(getattr(thing, list_name))
        for place, names, which in parts:
            part = moved[place]
            moved[place] = (
                replace(part, **dict(zip(names, values[which], strict=True)))
                if names
                else type(part)(part.id, *values[which])
            )
        lists[list_name] = _ascending(moved) if list_name == "knots" else tuple(moved)
    return replace(thing, **lists)


def _ascending(knots: list[Any]) -> tuple[Any, ...]:
    """Knots of which none is less than the one before it."""
    raised = accumulate((knot.u for knot in knots), max)
    return tuple(replace(knot, u=u) for knot, u in zip(knots, raised, strict=True))


def _stands(thing: Any) -> bool:
    """Whether a thing can be drawn, as far as keys can make it one that cannot."""
    if isinstance(thing, Figure):
        matrix = thing.matrix if thing.transforms else None
        return matrix is None or bool((np.abs(matrix) <= LARGEST).all())
    if isinstance(thing, Camera | Object):
        return not any(law(thing, None) for law in SCENE_LAWS[type(thing)])
    return True
