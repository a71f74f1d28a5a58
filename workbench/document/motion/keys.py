"""All keys of a motion as arrays, each track's after the other's, so that a frame is worked out at once."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation.spline_tween import nearness, shaped
from workbench.document.motion.model import EASINGS, SPLINE, Track

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]
_CODES = {name: number for number, name in enumerate(EASINGS)}


class TrackKeys(NamedTuple):
    """The keys of one track: frames and easings (n,), handles (n, 4), values and slopes (n, numbers)."""

    frames: Whole
    easings: Whole
    handles: Floats
    values: Floats
    leaving: Floats
    arriving: Floats


class Keys(NamedTuple):
    """Those of many tracks. ``first`` and ``last`` (t,): the places of each track's own first and last key.

    ``values``, ``leaving`` and ``arriving`` are flat, key after key; of each number of all tracks ``track``
    is that of its track, ``start`` where its first value stands, ``stride`` how far it is to its next one.
    """

    first: Whole
    last: Whole
    ordered: Whole
    frames: Whole
    easings: Whole
    handles: Floats
    values: Floats
    leaving: Floats
    arriving: Floats
    track: Whole
    start: Whole
    stride: Whole


_SPAN = 1 << 21
"""More than there are frames: a track's keys stand this far from the next track's in ``ordered``."""


@lru_cache(maxsize=1 << 14)
def keys_of(track: Track) -> TrackKeys:
    """The keys of a track whose values all have as many numbers."""
    keys = track.keys
    frames = np.array([key.frame for key in keys], np.int64)
    values = np.array([key.value for key in keys], np.float64)
    leaving, arriving = np.zeros_like(values), np.zeros_like(values)
    if any(key.easing == SPLINE for key in keys) and len(keys) > 1:
        slopes = np.diff(values, axis=0) / np.diff(frames)[:, None]
        for k, key in enumerate(keys):
            to_key, on = slopes[max(k - 1, 0)], slopes[min(k, len(keys) - 2)]
            leaving[k], arriving[k] = shaped(
                to_key,
                on,
                nearness(frames, k),
                key.tension,
                key.continuity,
                key.bias,
            )
    easings = np.array([_CODES[key.easing] for key in keys], np.int64)
    return TrackKeys(frames, easings, np.array([key.handles for key in keys]), values, leaving, arriving)


def joined(tracks: Sequence[Track]) -> Keys:
    """The keys of ``tracks``, at least one."""
    each = [keys_of(track) for track in tracks]
    counts = np.array([len(keys.frames) for keys in each])
    widths = np.array([keys.values.shape[1] for keys in each])
    last = np.cumsum(counts) - 1
    begins = np.append(0, np.cumsum(counts * widths)[:-1])
    number = np.arange(widths.sum()) - np.repeat(np.cumsum(widths) - widths, widths)
    frames = np.concatenate([keys.frames for keys in each])
    return Keys(
        last - counts + 1,
        last,
        frames + _SPAN * np.repeat(np.arange(len(each)), counts),
        frames,
        np.concatenate([keys.easings for keys in each]),
        np.concatenate([keys.handles for keys in each]),
        np.concatenate([keys.values.ravel() for keys in each]),
        np.concatenate([keys.leaving.ravel() for keys in each]),
        np.concatenate([keys.arriving.ravel() for keys in each]),
        np.repeat(np.arange(len(each)), widths),
        np.repeat(begins, widths) + number,
        np.repeat(widths, widths),
    )


class Interval(NamedTuple):
    """Where a frame lies among the keys of each track: places of the keys around it, part of the time."""

    before: Whole
    after: Whole
    t: Floats


def interval(keys: Keys, frame: int) -> Interval:
    """That of a frame; before a track's first key and from its last one on both keys are the same."""
    place = np.searchsorted(keys.ordered, frame + _SPAN * np.arange(len(keys.first)), side="right") - 1
    return _around(keys, place, frame)


def along(track: Track, frames: Floats) -> tuple[Keys, Interval]:
    """One track at many frames (n,), whole or between: as n tracks with the same keys, each at a frame."""
    keys = joined([track])
    n, width = len(frames), len(keys.start)
    many = keys._replace(
        first=np.zeros(n, np.int64),
        last=np.full(n, len(keys.frames) - 1),
        track=np.repeat(np.arange(n), width),
        start=np.tile(keys.start, n),
        stride=np.tile(keys.stride, n),
    )
    return many, _around(many, np.searchsorted(keys.frames, frames, side="right") - 1, frames)


def _around(keys: Keys, place: Whole, frame: int | Floats) -> Interval:
    before = np.maximum(place, keys.first)
    after = np.where(place < keys.first, before, np.minimum(before + 1, keys.last))
    span = keys.frames[after] - keys.frames[before]
    t = (frame - keys.frames[before]) / np.maximum(span, 1)
    return Interval(before, after, np.where(span > 0, t, 0.0))
