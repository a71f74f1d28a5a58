"""What a track would give by the equation of free fall or of a pendulum, beside the keys that imitate it."""

import math
from collections.abc import Iterable
from functools import lru_cache
from itertools import pairwise
from typing import Literal, NamedTuple

from msgspec.structs import replace

from workbench.algorithms.animation.pendulum import swing
from workbench.document.model import Sheet
from workbench.document.motion.groups import group_of, read
from workbench.document.motion.model import BEZIER_NAME, LINEAR, Key, Track
from workbench.document.motion.tracks import group_moved, motion_of, track_on
from workbench.document.transforms.links import Rotate

# As Bézier easings t^2 and 1 - (1 - t)^2 are exact: their times run evenly.
_SPEEDING_UP = (1 / 3, 0.0, 2 / 3, 1 / 3)
_SLOWING_DOWN = (1 / 3, 2 / 3, 2 / 3, 1.0)
_OF_A_FALL = ("ease_in", "ease_out")
_OF_A_SWING = "ease_in_out"
_MOST_FRAMES = 600
HALF_A_TURN = 180.0


class Equation(NamedTuple):
    """A track whose values between its keys are those of an equation, and of which one."""

    law: Literal["fall", "swing"]
    track: Track


def is_angle(sheet: Sheet, target: str) -> bool:
    """Whether a target is the angle of a turn in the plane."""
    group = group_of(sheet, target)
    if group is None:
        return False
    *link, name = group.slots[0].path
    return name == "angle" and isinstance(read(sheet, tuple(link)), Rotate)


@lru_cache(maxsize=8)
def equation_of(sheet: Sheet, target: str) -> Equation | None:
    """A height that speeds up on its way down and slows down on its way up; an angle that swings.

    None where a track is neither: no height that eases by a sine, no angle that eases in and out, or goes
    to and fro.
    """
    track = track_on(sheet, target)
    if track is None or len(track.keys) < 2 or group_moved(sheet, track) is None:
        return None
    easings = {key.easing for key in track.keys[:-1]}
    if target.endswith("/y") and easings.intersection(_OF_A_FALL):
        return Equation("fall", replace(track, keys=tuple(_falling(track.keys))))
    ways = [second.value[0] - first.value[0] for first, second in pairwise(track.keys)]
    to_and_fro = len(ways) > 1 and all(here * there < 0.0 for here, there in pairwise(ways))
    swings = to_and_fro or _OF_A_SWING in easings
    long = track.keys[-1].frame - track.keys[0].frame > _MOST_FRAMES
    if long or not (swings and is_angle(sheet, target)) or max(map(abs, ways)) >= 2.0 * HALF_A_TURN:
        return None
    return Equation("swing", replace(track, keys=tuple(_swinging(track.keys))))


def by_equation(moving: Sheet, equation: Equation) -> Sheet:
    """The sheet with a track that goes by its equation."""
    motion = motion_of(moving)
    same = equation.track.id
    tracks = tuple(equation.track if each.id == same else each for each in motion.tracks)
    return replace(moving, motion=replace(motion, tracks=tracks))


def _falling(keys: tuple[Key, ...]) -> Iterable[Key]:
    for first, second in pairwise(keys):
        down = second.value[0] < first.value[0]
        x1, y1, x2, y2 = _SPEEDING_UP if down else _SLOWING_DOWN
        yield replace(first, easing=BEZIER_NAME, x1=x1, y1=y1, x2=x2, y2=y2)
    yield keys[-1]


def _swinging(keys: tuple[Key, ...]) -> Iterable[Key]:
    """A key in every frame."""
    for first, second in pairwise(keys):
        middle, half = (first.value[0] + second.value[0]) / 2.0, (first.value[0] - second.value[0]) / 2.0
        span = second.frame - first.frame
        for frame in range(first.frame, second.frame):
            part = (frame - first.frame) / span
            angle = math.degrees(swing(math.radians(abs(half)), part)) if half else 0.0
            value = (middle + math.copysign(1.0, half) * angle,)
            yield replace(first, frame=frame, easing=LINEAR, value=value)
    yield keys[-1]
