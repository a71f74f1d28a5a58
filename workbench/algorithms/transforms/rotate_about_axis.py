"""A point turned about any axis of space, in seven steps.

a, b, c                 direction of the axis, of length 1
d                       length of its projection on the yz plane
cos_alpha, sin_alpha    the turn about x that brings the axis into the xz plane
x, y, z                 the point, as far as it is carried
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark
from workbench.algorithms.transforms.axis import STEP_NAMES, axis_steps
from workbench.algorithms.transforms.products import matrix_mark
from workbench.algorithms.transforms.refusals import refuse_axis
from workbench.geometry.angles import cosine_and_sine


def rotate_about_axis(
    theta: float,
    x: float, y: float, z: float,
    x1: float, y1: float, z1: float,
    x2: float, y2: float, z2: float,
) -> Iterator[tuple[float, float, float]]:  # fmt: skip
    """Turn a point about an axis: bring the axis onto z, turn about z, and bring it back.

    Args: angle in radians, the point, and two points of the axis, in a right-handed frame; seen with the axis
    pointing at the eye, the turn is counter-clockwise. Emits: (x, y, z) after each of the seven steps.
    Raises: ValueError. Source: Hearn and Baker, Computer Graphics, C Version, section 11-2.
    """
    # Find the direction of the axis
    dx, dy, dz = x2 - x1, y2 - y1, z2 - z1
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    refuse_axis(length)
    a, b, c = dx / length, dy / length, dz / length

    # Find the turn about x, from the projection on the yz plane
    d = math.sqrt(b * b + c * c)
    cos_alpha = c / d if d > 0.0 else 1.0
    sin_alpha = b / d if d > 0.0 else 0.0
    cos_theta, sin_theta = cosine_and_sine(theta)

    # Move the axis to the origin
    x, y, z = x - x1, y - y1, z - z1
    yield x, y, z

    # Turn the axis about x into the xz plane
    y, z = y * cos_alpha - z * sin_alpha, y * sin_alpha + z * cos_alpha
    yield x, y, z

    # Turn the axis about y onto the z axis
    x, z = x * d - z * a, x * a + z * d
    yield x, y, z

    # Turn by theta about z
    x, y = x * cos_theta - y * sin_theta, x * sin_theta + y * cos_theta
    yield x, y, z

    # Undo the turn about y
    x, z = x * d + z * a, -x * a + z * d
    yield x, y, z

    # Undo the turn about x
    y, z = y * cos_alpha + z * sin_alpha, -y * sin_alpha + z * cos_alpha
    yield x, y, z

    # Move the axis back to its place
    x, y, z = x + x1, y + y1, z + z1
    yield x, y, z


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The matrix of the step that was taken last."""
    if len(emitted):
        theta, _x, _y, _z, *ends = arguments
        step = axis_steps(theta, ends[:3], ends[3:])[len(emitted) - 1]
        yield matrix_mark(step.name, step.matrix)


def _axis_and_point(chance: Random) -> tuple[float, ...]:
    """Axes in every direction, along an axis of the frame or all but along x more often than not."""
    start = [_number(chance) for _coordinate in range(3)]
    ways = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, -1), (1, 1e-9, 0), (1, 2, 2))
    way = chance.choice((*ways, (1, chance.uniform(-9, 9), chance.uniform(-9, 9))))
    end = [value + step for value, step in zip(start, way, strict=True)]
    angle = chance.choice((0.0, math.pi / 2, math.pi, chance.uniform(-9, 9)))
    return angle, *(_number(chance) for _coordinate in range(3)), *start, *end


def _number(chance: Random) -> float:
    return float(chance.randint(-9, 9)) if chance.randint(0, 1) else chance.uniform(-1e2, 1e2)


def _place(name: str, label: str, example: float, meaning: str) -> Parameter:
    return Parameter(name, label, "float", example, -1e9, 1e9, "", meaning)


_STEPS = (
    (
        "Move the axis to the origin",
        "The first point of the axis goes to the origin: {(x, y, z)}.",
    ),
    (
        "Turn the axis about x into the xz plane",
        "With cos α = c/d = {cos_alpha} and sin α = b/d = {sin_alpha} the axis comes into the xz plane, and "
        "the point to {(x, y, z)}.",
    ),
    (
        "Turn the axis about y onto the z axis",
        "With cos β = d = {d} and sin β = a = {a} the axis comes onto z, and the point to {(x, y, z)}.",
    ),
    (
        "Turn by theta about z",
        "This is the turn itself: cos θ = {cos_theta}, sin θ = {sin_theta}, and the point is at {(x, y, z)}.",
    ),
    ("Undo the turn about y", "The inverse of step 3 brings the point to {(x, y, z)}."),
    ("Undo the turn about x", "The inverse of step 2 brings the point to {(x, y, z)}."),
    (
        "Move the axis back to its place",
        "The inverse of step 1 ends the rotation: the point is at {(x, y, z)}.",
    ),
)


def _step_view(number: int, block: str, sentence: str) -> View:
    """The view of a step; who is asked first chooses the matrix that comes next."""
    inverse = STEP_NAMES[len(STEP_NAMES) - 1 - number]
    other = STEP_NAMES[number - 1] if number else STEP_NAMES[1]
    options = tuple(dict.fromkeys((other, STEP_NAMES[number], inverse, "R_z(θ)")))
    return View(
        block=block,
        row=f"({number + 1}, {STEP_NAMES[number]!r}, x, y, z)",
        options=repr(tuple(sorted(options))),
        answer=repr(STEP_NAMES[number]),
        sentence=sentence,
    )


ENTRY = Entry(
    function=rotate_about_axis,
    topic="transforms",
    title="Rotation about any axis",
    summary="Seven matrices: two turns bring the axis onto z, a third turns the point, then all is undone.",
    parameters=(
        Parameter("theta", "θ", "float", math.radians(90), -1e6, 1e6, "rad", "angle of the turn"),
        _place("x", "x", 3.0, "the point"),
        _place("y", "y", 1.0, "the point"),
        _place("z", "z", 1.0, "the point"),
        _place("x1", "x_1", 1.0, "first point of the axis"),
        _place("y1", "y_1", 0.0, "first point of the axis"),
        _place("z1", "z_1", 1.0, "first point of the axis"),
        _place("x2", "x_2", 2.0, "second point of the axis"),
        _place("y2", "y_2", 2.0, "second point of the axis"),
        _place("z2", "z_2", 3.0, "second point of the axis"),
    ),
    arguments=_axis_and_point,
    emits="points",
    emitted_columns=("x", "y", "z"),
    source="Hearn and Baker, Computer Graphics, C Version, section 11-2",
    columns=("step", "matrix", "x", "y", "z"),
    views=(
        View(
            block="Find the direction of the axis",
            sentence="The axis goes along {(dx, dy, dz)}; divided by its length {length}, "
            "a = {a}, b = {b}, c = {c}.",
        ),
        View(
            block="Find the turn about x, from the projection on the yz plane",
            sentence="On the yz plane its projection has the length d = √(b² + c²) = {d}.",
        ),
        *(_step_view(number, *step) for number, step in enumerate(_STEPS)),
    ),
    laws=(
        Law(
            "The seven steps are one matrix, the product of the seven, but for rounding.",
            "transforms/test_texts.py::test_the_seven_steps_are_the_product_of_seven_matrices",
        ),
        Law(
            "A unit quaternion takes the point to the same place, but for rounding.",
            "transforms/test_texts.py::test_the_seven_steps_are_the_quaternion",
        ),
        Law(
            "The distance from the axis, and the place along it, stay as they are.",
            "transforms/test_texts.py::test_the_point_stays_as_far_from_the_axis",
        ),
    ),
    not_laws=("Two rotations can be exchanged: about different axes it matters which one comes first.",),
    questions=(12,),
    labs=("Transformations in 2D and 3D",),
    frame="world",
    count="7",
    marks=marks,
)
