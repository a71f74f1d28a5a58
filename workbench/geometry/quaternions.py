"""Unit quaternions as rotations of space: (w, x, y, z) = (cos(theta/2), sin(theta/2) times the axis)."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.angles import cosine_and_sine

Quaternion = tuple[float, float, float, float]


def quaternion_about(theta: float, axis: tuple[float, float, float]) -> Quaternion:
    """The rotation by ``theta`` (radians) about the direction ``axis``, of length 1."""
    cos, sin = cosine_and_sine(theta / 2)
    a, b, c = axis
    return cos, sin * a, sin * b, sin * c


def quaternion_product(p: Quaternion, q: Quaternion) -> Quaternion:
    """The rotation ``q`` and after it ``p``."""
    pw, px, py, pz = p
    qw, qx, qy, qz = q
    return (
        pw * qw - px * qx - py * qy - pz * qz,
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """The rotation that undoes ``q``, a unit quaternion."""
    w, x, y, z = q
    return w, -x, -y, -z


def rotated(q: Quaternion, point: tuple[float, float, float]) -> tuple[float, float, float]:
    """The point turned about the origin: q (0, point) q*."""
    _w, x, y, z = quaternion_product(quaternion_product(q, (0.0, *point)), conjugate(q))
    return x, y, z


def quaternion_matrix(q: Quaternion) -> NDArray[np.float64]:
    """The rotation matrix (3, 3) of a quaternion, brought to length 1.

    Raises: ValueError when it is zero or not finite.
    """
    largest = max(map(abs, q))
    if not (all(map(math.isfinite, q)) and largest > 0.0):
        raise ValueError(f"The quaternion {q} is not a rotation; give one that is finite and not zero.")
    w, x, y, z = (part / largest for part in q)
    length = w * w + x * x + y * y + z * z
    return np.array(
        [
            (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
        ],
        np.float64,
    ) / length  # fmt: skip
