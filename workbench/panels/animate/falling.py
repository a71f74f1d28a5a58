"""The path that a track would take by the equation of free fall, beside the keys that imitate it."""

from functools import lru_cache

from msgspec.structs import replace

from workbench.document.model import Sheet
from workbench.document.motion.model import BEZIER_NAME, Key
from workbench.document.motion.tracks import motion_of, track_on

# As Bézier easings t^2 and 1 - (1 - t)^2 are exact: their times run evenly.
_SPEEDING_UP = (1 / 3, 0.0, 2 / 3, 1 / 3)
_SLOWING_DOWN = (1 / 3, 2 / 3, 2 / 3, 1.0)
_BY_EQUATION = {"ease_in": _SPEEDING_UP, "ease_out": _SLOWING_DOWN}


@lru_cache(maxsize=8)
def by_equation(moving: Sheet, target: str) -> Sheet | None:
    """The sheet with a height that falls and rises by t squared where its track eases by a sine.

    None where the target is no height, or its track has no such easing.
    """
    track = track_on(moving, target)
    if (
        track is None
        or not target.endswith("/y")
        or not any(key.easing in _BY_EQUATION for key in track.keys)
    ):
        return None
    falling = replace(track, keys=tuple(map(_by_equation, track.keys)))
    motion = motion_of(moving)
    tracks = tuple(falling if each is track else each for each in motion.tracks)
    return replace(moving, motion=replace(motion, tracks=tracks))


def _by_equation(key: Key) -> Key:
    if key.easing not in _BY_EQUATION:
        return key
    x1, y1, x2, y2 = _BY_EQUATION[key.easing]
    return replace(key, easing=BEZIER_NAME, x1=x1, y1=y1, x2=x2, y2=y2)
