"""Parts of an edge, by the share t of the way from its start to its end, and what a surface hides of it."""

from typing import NamedTuple

from workbench.algorithms.visibility.depth_tests import edge_plane, eye_side
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.pieces import Plane, between, offset
from workbench.algorithms.visibility.surfaces import NEAR_ZERO, Surface, nearest_z


class Part(NamedTuple):
    """What of an edge lies from one share of its length to another; nothing where ``begin >= end``."""

    begin: float
    end: float


def ends_of(vertices: list[Corner], i: int, j: int) -> tuple[Corner, Corner]:
    """Both ends of an edge, so that it is the same edge whichever way it was given."""
    return (vertices[i], vertices[j]) if vertices[i] <= vertices[j] else (vertices[j], vertices[i])


def apart(surface: Surface, start: Corner, end: Corner) -> bool:
    """Whether boxes alone tell that a surface hides nothing of an edge."""
    low, middle, high = surface.low, surface.middle, surface.high
    left, right = min(low.x, middle.x, high.x), max(low.x, middle.x, high.x)
    if max(start.x, end.x) < left or right < min(start.x, end.x):
        return True
    if max(start.y, end.y) < low.y or high.y < min(start.y, end.y):
        return True
    return max(start.z, end.z) < nearest_z(surface)


def part_behind(plane: Plane, start: Corner, end: Corner) -> Part:
    """What of an edge is farther than a surface's plane: not what lies in it."""
    away = -eye_side(plane)
    return part_beyond(away * offset(plane, start), away * offset(plane, end), False)


def part_inside(surface: Surface, start: Corner, end: Corner, part: Part) -> Part:
    """What of a part of an edge the three sides of a surface enclose, as the eye sees it, sides included."""
    low, middle, high = surface.low, surface.middle, surface.high
    for first, second, third in ((low, middle, high), (middle, high, low), (high, low, middle)):
        side = edge_plane(first, second)
        inwards = 1.0 if offset(side, third) > 0.0 else -1.0
        kept = part_beyond(inwards * offset(side, start), inwards * offset(side, end), True)
        part = Part(max(part.begin, kept.begin), min(part.end, kept.end))
    return part


def part_beyond(at_start: float, at_end: float, with_border: bool) -> Part:
    """Where a value that changes evenly along an edge is positive; where it is 0 all along, as is asked."""
    if at_start <= 0.0 and at_end <= 0.0:
        return Part(0.0, 1.0) if with_border and at_start == 0.0 and at_end == 0.0 else Part(0.0, 0.0)
    if at_start >= 0.0 and at_end >= 0.0:
        return Part(0.0, 1.0)
    share = at_start / (at_start - at_end)
    return Part(0.0, share) if at_start > 0.0 else Part(share, 1.0)


def without(seen: list[Part], hidden: Part) -> list[Part]:
    """The parts that are left of some; what is no longer than a rounding error is dropped."""
    left = seen[:0]
    for part in seen:
        before = Part(part.begin, min(part.end, hidden.begin))
        after = Part(max(part.begin, hidden.end), part.end)
        for rest in (before, after):
            if rest.end - rest.begin > NEAR_ZERO:
                left.append(rest)
    return left


def place_at(start: Corner, end: Corner, share: float) -> Corner:
    """The point of an edge at a share of its length; the ends exactly."""
    if share == 0.0:
        return start
    return end if share == 1.0 else between(start, end, share)
