"""From one orientation in space to another, evenly about one axis: spherical linear interpolation.

sign            −1 where the second quaternion is taken with the other sign, for the shorter arc
omega           the angle between both quaternions, half of the turn
t               the part of the time that is over, j / (n + 1)
a, b            how much of each quaternion is taken
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation.refusals import refuse_in_betweens, refuse_quaternion
from workbench.algorithms.animation.turns import (
    rounded_degrees,
    straight_turn_degrees,
    turn_degrees,
    turns_in_question,
)
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke, along

NEARLY_EQUAL = 1e-9
"""Below this angle, radians, the arc and its chord are the same to the last digit."""


def slerp(first: NDArray[Any], second: NDArray[Any], n: int) -> Iterator[tuple[float, float, float, float]]:
    """Emit the orientations from the first key to the second, with n in-betweens, on the shorter arc.

    Args: (4,) quaternions w, x, y, z, brought to length 1, and the number of in-betweens. Emits: (w, x, y, z)
    of length 1, both keys included; the second one has the sign that is nearer to the first.
    Raises: ValueError for a quaternion of no length. Source: Shoemake, Animating rotation with quaternion
    curves, 1985.
    """
    # Take the nearer of the two quaternions that mean the second orientation
    refuse_in_betweens(n)
    w0, x0, y0, z0 = normalised(first)
    w1, x1, y1, z1 = normalised(second)
    cosine = w0 * w1 + x0 * x1 + y0 * y1 + z0 * z1
    sign = 1.0 if cosine >= 0.0 else -1.0
    w1, x1, y1, z1 = sign * w1, sign * x1, sign * y1, sign * z1

    # Measure the angle between them
    apart = length(w1 - w0, x1 - x0, y1 - y0, z1 - z0)
    omega = 2.0 * math.atan2(apart, length(w1 + w0, x1 + x0, y1 + y0, z1 + z0))

    for j in range(n + 2):
        # Go that fraction of the angle
        t = j / (n + 1)
        a, b = shares(omega, t)
        yield a * w0 + b * w1, a * x0 + b * x1, a * y0 + b * y1, a * z0 + b * z1


def shares(omega: float, t: float) -> tuple[float, float]:
    """How much of each of two unit vectors makes the one that is the part t of the angle between them."""
    if omega < NEARLY_EQUAL:
        return 1.0 - t, t
    sine = math.sin(omega)
    return math.sin((1.0 - t) * omega) / sine, math.sin(t * omega) / sine


def length(w: float, x: float, y: float, z: float) -> float:
    """The length of a quaternion."""
    return math.sqrt(w * w + x * x + y * y + z * z)


def normalised(quaternion: NDArray[Any]) -> tuple[float, float, float, float]:
    """The quaternion brought to length 1."""
    w = float(quaternion[0])
    x = float(quaternion[1])
    y = float(quaternion[2])
    z = float(quaternion[3])
    size = length(w, x, y, z)
    refuse_quaternion(size)
    return w / size, x / size, y / size, z / size


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The plane of both quaternions: the arc on the unit circle, its chord, and the in-betweens so far."""
    omega = now.get("omega", _angle_of(*arguments[:2]))
    arc = np.linspace(0.0, omega, 17)
    yield Stroke(np.column_stack([np.cos(arc), np.sin(arc)]), "muted", "thin")
    yield Stroke(along((1.0, 0.0), (math.cos(omega), math.sin(omega))), "data2", "hair", "dash")
    n, count = arguments[2], len(emitted)
    for j in range(count if count <= MOST_SPOTS else 0):
        t = j / (n + 1)
        x, y = math.cos(t * omega), math.sin(t * omega)
        yield Stroke(along((0.0, 0.0), (x, y)), "data1", "hair")
        yield Spot(x, y, "accent" if j == count - 1 else "data1", "dot")
        yield Spot(1.0 - t + t * math.cos(omega), t * math.sin(omega), "data2", "ring", "small")


def _angle_of(first: NDArray[Any], second: NDArray[Any]) -> float:
    p, q = np.array(normalised(first)), np.array(normalised(second))
    q = q if p @ q >= 0.0 else -q
    return 2.0 * math.atan2(float(np.linalg.norm(q - p)), float(np.linalg.norm(q + p)))


def _arguments(chance: Random) -> tuple[Any, ...]:
    first = _quaternion(chance)
    near = first + chance.choice((0.0, 1e-12, 1e-6)) * _quaternion(chance)
    second = chance.choice((_quaternion(chance), near, -near))
    return first, second, chance.choice((0, 1, 3, chance.randint(0, 12)))


def _quaternion(chance: Random) -> NDArray[np.float64]:
    parts = [chance.choice((0.0, 1.0, -1.0, chance.uniform(-1.0, 1.0))) for _part in range(3)]
    return np.array([chance.choice((1.0, 0.5, -2.0)), *parts])


ENTRY = Entry(
    function=slerp,
    topic="animation",
    title="Slerp: turning evenly in space",
    summary="Goes from one quaternion to the other along the shorter arc, by the same angle in each frame.",
    parameters=(
        Parameter("first", "q_0", "floats", np.array([1.0, 0, 0, 0]), meaning="quaternion w, x, y, z"),
        Parameter(
            "second",
            "q_1",
            "floats",
            np.array([math.sqrt(0.5), 0, 0, math.sqrt(0.5)]),
            meaning="another; this one is a quarter turn about z",
        ),
        Parameter("n", "n", "int", 3, low=0, high=100_000, meaning="the number of in-betweens"),
    ),
    arguments=_arguments,
    emits="cells",
    emitted_columns=("w", "x", "y", "z"),
    source="Shoemake, Animating rotation with quaternion curves, 1985",
    columns=("j", "t", "a", "b", "turn", "straight"),
    view_functions=(turn_degrees, straight_turn_degrees, rounded_degrees, turns_in_question),
    views=(
        View(
            block="Take the nearer of the two quaternions that mean the second orientation",
            when="sign < 0",
            sentence="q_0 · q_1 = {cosine} is negative, so −q_1, the same orientation, is nearer: take it.",
        ),
        View(
            block="Take the nearer of the two quaternions that mean the second orientation",
            sentence="q_0 · q_1 = {cosine} is not negative, so this is the shorter arc.",
        ),
        View(
            block="Measure the angle between them",
            sentence="The quaternions are ω = {math.degrees(omega)}° apart, "
            "and the figure turns by twice that, {turn_degrees(omega, 1.0)}°.",
        ),
        View(
            block="Go that fraction of the angle",
            when="omega < 1e-9",
            row="(j, t, a, b, turn_degrees(omega, t), straight_turn_degrees(omega, t))",
            sentence="t = {j} / {n + 1} = {t}: both orientations are the same, so nothing turns.",
        ),
        View(
            block="Go that fraction of the angle",
            row="(j, t, a, b, turn_degrees(omega, t), straight_turn_degrees(omega, t))",
            options="turns_in_question(omega, j / (n + 1))",
            answer="rounded_degrees(turn_degrees(omega, t))",
            sentence="t = {j} / {n + 1} = {t}: a = sin((1 − t) ω) / sin ω = {a}, b = sin(t ω) / sin ω = {b}; "
            "turned by {turn_degrees(omega, t)}°, and on the straight way it would be "
            "{straight_turn_degrees(omega, t)}°.",
        ),
    ),
    laws=(
        Law("Every in-between has length 1.", "animation/test_slerp.py::test_every_in_between_has_length_1"),
        Law(
            "From each in-between to the next it turns by the same angle about the same axis.",
            "animation/test_slerp.py::test_it_turns_evenly_about_one_axis",
        ),
        Law(
            "It takes the shorter of the two arcs.", "animation/test_slerp.py::test_the_shorter_arc_is_taken"
        ),
        Law(
            "It begins and ends in the keys' orientations.",
            "animation/test_slerp.py::test_it_begins_and_ends_in_the_keys_orientations",
        ),
    ),
    not_laws=(
        "Going straight from one quaternion to the other is just as good: it turns faster in the middle.",
    ),
    questions=(9,),
    labs=("Animation: key frames and in-betweens",),
    marks=marks,
    frame="view",
    count="n + 2",
)
