"""The ways between two orientations side by side: by angle or quaternion, by Euler's angles, by the entries
of the matrices; and the rings of Euler's angles."""

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from workbench.algorithms.animation.turns import chord_angle
from workbench.algorithms.marks import Ink, Mark, Points, Stroke, Word
from workbench.algorithms.projection import isometric
from workbench.algorithms.transforms import Matrix, rotation
from workbench.document.motion.between import part_of_the_way, quaternion_of, slerped
from workbench.document.motion.model import Key
from workbench.geometry.euler import Triple, euler_angles, euler_between, euler_quaternion, gimbal_axes
from workbench.geometry.quaternions import Quaternion, quaternion_matrix
from workbench.language import _

_APART = 2.6
_ROUND = np.linspace(0.0, math.tau, 49)
_MOST_TICKS = 24
_TICK = 0.85
_FLAG = (np.array([(0.0, 0.0, 0), (1, 0, 0)]), np.array([(1.0, 0, 0), (0.6, 0.25, 0), (0.6, 0, 0)]))
_PLANE = (
    np.array([(-0.8, 0.0, 0), (1, 0, 0)]),
    np.array([(-0.1, 0, -0.8), (0.3, 0, 0), (-0.1, 0, 0.8), (-0.1, 0, -0.8)]),
    np.array([(-0.4, 0.0, 0), (-0.8, 0.45, 0), (-0.8, 0, 0)]),
)
_NOSE = np.array([1.0, 0.0, 0.0])
INKS: tuple[Ink, ...] = ("data1", "data2", "data3")


class Way(NamedTuple):
    """One way between two orientations: its title, and at a part of it the matrix (3, 3) and how far it has
    turned, radians."""

    title: str
    matrix: Callable[[float], Matrix]
    turned: Callable[[float], float]


class Numbers(NamedTuple):
    """What a matrix does: its determinant, the least length of what was 1 long, the turn in degrees."""

    determinant: float
    length: float
    turned: float


class Ways(NamedTuple):
    """All of them, and the whole turn ``theta``, radians, between both orientations."""

    ways: tuple[Way, ...]
    theta: float


def ways_in_plane(first: float, second: float) -> Ways:
    """Between two angles, degrees."""
    start, theta = math.radians(first), math.radians(second - first)

    def by_angle(part: float) -> Matrix:
        return rotation(start + part * theta)

    return Ways(
        (Way(_("angle"), by_angle, lambda part: part * theta), _by_entries(by_angle, theta)),
        theta,
    )


def ways_in_space(p: Quaternion, q: Quaternion) -> Ways:
    """Between two orientations in space."""
    before, after = euler_angles(p), euler_angles(q)
    theta = turn_between(quaternion_matrix(p), quaternion_matrix(q))

    def by_quaternion(part: float) -> Matrix:
        return quaternion_matrix(slerped(p, q, part))

    def by_euler(part: float) -> Matrix:
        return quaternion_matrix(euler_quaternion(euler_between(before, after, part)))

    return Ways(
        (
            Way(_("quaternion"), by_quaternion, lambda part: part * theta),
            Way(_("Euler"), by_euler, lambda part: turn_between(by_euler(0.0), by_euler(part))),
            _by_entries(by_quaternion, theta),
        ),
        theta,
    )


def _by_entries(rotating: Callable[[float], Matrix], theta: float) -> Way:
    start, end = rotating(0.0), rotating(1.0)

    def by_entries(part: float) -> Matrix:
        return (1.0 - part) * start + part * end

    return Way(_("entries"), by_entries, lambda part: chord_angle(theta, part))


def turn_between(first: Matrix, second: Matrix) -> float:
    """The angle (radians, 0 to pi) of the turn from one rotation in space to another."""
    turn = second @ first.T
    sine = math.hypot(turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1])
    return math.atan2(sine, float(np.trace(turn)) - 1.0)


def numbers_of(way: Way, part: float) -> Numbers:
    """Those of a way at a part of it."""
    matrix = way.matrix(part)
    shortest = float(np.linalg.svd(matrix, compute_uv=False)[-1])
    return Numbers(float(np.linalg.det(matrix)), shortest, math.degrees(way.turned(part)))


@lru_cache(maxsize=8)
def ways_between(keys: tuple[Key, Key], flat: bool) -> Ways:
    """Those between the angles of two keys, or in space between their turns."""
    first, second = (key.value for key in keys)
    if flat:
        return ways_in_plane(first[0], second[0])
    return ways_in_space(quaternion_of(first), quaternion_of(second))


def drawn(keys: tuple[Key, Key], frame: int, flat: bool) -> Iterator[Mark]:
    """A figure for each way, two in a row, in the frame, and a tick for its tip in each frame."""
    first, second = keys
    part = part_of_the_way(first, second, min(max(frame, first.frame), second.frame))
    yield from _ticks(keys, flat)
    for place, (way, ink) in enumerate(zip(ways_between(keys, flat).ways, INKS, strict=False)):
        for line in _FLAG if flat else _PLANE:
            yield Stroke(_on_paper(line @ way.matrix(part).T, flat) + _middle(place), ink, "thin")


@lru_cache(maxsize=8)
def _ticks(keys: tuple[Key, Key], flat: bool) -> tuple[Mark, ...]:
    """What is the same in every frame between two keys."""
    first, second = keys
    frames = np.linspace(first.frame, second.frame, min(second.frame - first.frame, _MOST_TICKS) + 1)
    parts = [part_of_the_way(first, second, each) for each in frames.tolist()]
    marks: list[Mark] = []
    for place, way in enumerate(ways_between(keys, flat).ways):
        middle = _middle(place)
        marks += _ball(middle, way.title)
        ticks = (np.outer((_TICK, 1.0), way.matrix(part) @ _NOSE) for part in parts)
        marks += (Stroke(_on_paper(tick, flat) + middle, "muted", "hair") for tick in ticks)
    return tuple(marks)


def rings(angles: Triple, place: int) -> Iterator[Mark]:
    """The axes of Euler's angles as two rings carry them; where x and z line up, both lie in one plane."""
    middle = _middle(place)
    yield Word(_("Euler's rings"), middle[0], middle[1] + 1.05, "text", 0, 1)
    axes = [np.array(axis) for axis in gimbal_axes(angles)]
    for size, (one, other), ink in ((0.9, (axes[2], axes[1]), "data3"), (0.72, (axes[1], axes[0]), "data2")):
        circle = size * (np.outer(np.cos(_ROUND), one) + np.outer(np.sin(_ROUND), _across(one, other)))
        yield Stroke(_on_paper(circle, False) + middle, ink, "thin")  # type: ignore[arg-type]
    for name, axis, size, ink in zip("xyz", axes, (0.72, 0.8, 0.9), ("data1", "data2", "data3"), strict=True):
        line = _on_paper(np.array([-size * axis, size * axis]), False) + middle
        yield Stroke(line, ink, "thin", "dash")  # type: ignore[arg-type]
        x, y = (1.2 * line[1] - 0.2 * middle).tolist()
        yield Word(name, x, y, ink, 0, 0)  # type: ignore[arg-type]


def lined_up(angles: Triple) -> float:
    """The angle, degrees, between the axes of x and z: 0 where the rings lock."""
    about_x, _about_y, about_z = gimbal_axes(angles)
    along = abs(sum(a * b for a, b in zip(about_x, about_z, strict=True)))
    return math.degrees(math.acos(min(along, 1.0)))


def whole(count: int) -> Points:
    """The corners of what holds so many figures, two in a row."""
    rows, columns = (count + 1) // 2, min(count, 2)
    return np.array([(-1.15, 1.45), ((columns - 1) * _APART + 1.15, -(rows - 1) * _APART - 1.15)])


def _middle(place: int) -> Points:
    return np.array([place % 2 * _APART, -(place // 2) * _APART])


def _across(one: Points, other: Points) -> Points:
    return other - (other @ one) * one


def _ball(middle: Points, title: str) -> Iterator[Mark]:
    yield Stroke(np.column_stack([np.cos(_ROUND), np.sin(_ROUND)]) + middle, "muted", "hair", "dash")
    yield Word(title, middle[0], middle[1] + 1.05, "text", 0, 1)


def _on_paper(points: Points, flat: bool) -> Points:
    """From above, or isometric."""
    return points[:, :2] if flat else points @ np.asarray(isometric())[:2, :3].T
