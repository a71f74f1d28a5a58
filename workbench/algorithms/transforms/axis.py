"""Rotation about any axis of space: the seven matrices of the course, and a quaternion beside them."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.algorithms.transforms.chain import Matrix, product
from workbench.algorithms.transforms.space import rotation_z, translation_3d
from workbench.geometry.quaternions import quaternion_about, quaternion_matrix

STEP_NAMES = ("T(−P_1)", "R_x(α)", "R_y(−β)", "R_z(θ)", "R_y(β)", "R_x(−α)", "T(P_1)")
"""What the seven matrices are called, the one that acts first at the head."""


class Step(NamedTuple):
    """One matrix of a chain, as the course names it."""

    name: str
    matrix: Matrix


def rotation_about_axis(theta: float, first: Sequence[float], second: Sequence[float]) -> Matrix:
    """By ``theta`` about the axis from the point ``first`` to the point ``second``: seven matrices, as one.

    Raises: ValueError when both points are the same or the axis is not finite.
    """
    return product(*(step.matrix for step in reversed(axis_steps(theta, first, second))))


def rotation_by_quaternion(theta: float, first: Sequence[float], second: Sequence[float]) -> Matrix:
    """The same rotation by a unit quaternion: the axis moved to the origin, turned, and moved back.

    Raises: ValueError when both points are the same or the axis is not finite.
    """
    turn = np.eye(4)
    turn[:3, :3] = quaternion_matrix(quaternion_about(theta, unit_axis(first, second)))
    x, y, z = first
    return product(translation_3d(x, y, z), turn, translation_3d(-x, -y, -z))


def axis_steps(theta: float, first: Sequence[float], second: Sequence[float]) -> tuple[Step, ...]:
    """The seven matrices of a rotation about an axis, the one that acts first at the head.

    The axis is moved to the origin, turned about x into the xz plane (by α) and about y into the z axis (by
    -β); then comes the rotation by θ itself, and all is undone backwards.
    Source: Hearn and Baker, Computer Graphics, C Version, section 11-2.
    Raises: ValueError when both points are the same or the axis is not finite.
    """
    a, b, c = unit_axis(first, second)
    x, y, z = (float(value) for value in first)
    d = math.sqrt(b * b + c * c)
    cos_alpha, sin_alpha = (c / d, b / d) if d > 0.0 else (1.0, 0.0)
    about_x = np.array(
        [(1, 0, 0, 0), (0, cos_alpha, -sin_alpha, 0), (0, sin_alpha, cos_alpha, 0), (0, 0, 0, 1)], np.float64
    )
    about_y = np.array([(d, 0, -a, 0), (0, 1, 0, 0), (a, 0, d, 0), (0, 0, 0, 1)], np.float64)
    matrices = (
        translation_3d(-x, -y, -z),
        about_x,
        about_y,
        rotation_z(theta),
        about_y.T.copy(),
        about_x.T.copy(),
        translation_3d(x, y, z),
    )
    return tuple(map(Step, STEP_NAMES, matrices))


def unit_axis(first: Sequence[float], second: Sequence[float]) -> tuple[float, float, float]:
    """The direction (a, b, c), of length 1, from one point to another.

    Raises: ValueError when both points are the same or the axis is not finite.
    """
    along = [float(end) - float(start) for start, end in zip(first, second, strict=True)]
    largest = max(abs(value) for value in along)
    if not (all(math.isfinite(value) for value in along) and largest > 0.0):
        raise ValueError(
            f"The axis from {tuple(first)} to {tuple(second)} has no direction; give two finite points apart."
        )
    a, b, c = (value / largest for value in along)
    length = math.sqrt(a * a + b * b + c * c)
    return a / length, b / length, c / length
