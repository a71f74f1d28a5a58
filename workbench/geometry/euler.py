"""Orientations in space as three angles (Euler): about x, then y, then z, axes that stay where they are.

The matrix is R_z R_y R_x. As three rings in one another the outer one turns about z, the middle one about y
as z has turned it, the inner one about x as both have.
"""

import math

from workbench.geometry.quaternions import (
    Quaternion,
    quaternion_about,
    quaternion_matrix,
    quaternion_product,
    rotated,
)

Triple = tuple[float, float, float]
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
_LOCKED = 1e-9
"""Below this cosine of the middle angle only the sum or difference of the others is known."""


def euler_quaternion(angles: Triple) -> Quaternion:
    """The orientation that these angles (radians, about x, y, z) make."""
    x, y, z = (quaternion_about(angle, axis) for angle, axis in zip(angles, (X, Y, Z), strict=True))
    return quaternion_product(z, quaternion_product(y, x))


def euler_angles(orientation: Quaternion) -> Triple:
    """The angles (radians) of an orientation, that about y up to a quarter turn; there that about x is 0."""
    matrix = quaternion_matrix(orientation).tolist()
    cosine = math.hypot(matrix[2][1], matrix[2][2])
    y = math.atan2(-matrix[2][0], cosine)
    if cosine < _LOCKED:
        return 0.0, y, math.atan2(-matrix[0][1], matrix[1][1])
    return math.atan2(matrix[2][1], matrix[2][2]), y, math.atan2(matrix[1][0], matrix[0][0])


def euler_between(first: Triple, second: Triple, part: float) -> Triple:
    """Each angle by itself a part of its way, the shorter way round."""
    x, y, z = (a + part * math.remainder(b - a, math.tau) for a, b in zip(first, second, strict=True))
    return x, y, z


def gimbal_axes(angles: Triple) -> tuple[Triple, Triple, Triple]:
    """Where the axes of x, y and z lie as the rings carry them; z stays."""
    _x, y, z = angles
    middle = quaternion_about(z, Z)
    inner = quaternion_product(middle, quaternion_about(y, Y))
    return rotated(inner, X), rotated(middle, Y), Z
