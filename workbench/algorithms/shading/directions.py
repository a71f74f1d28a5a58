"""Directions of the illumination model: unit vectors and the angles between them."""

import math
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.visibility.back_faces import SpaceVector, dot_product


def vector(xyz: NDArray[Any]) -> SpaceVector:
    """An array (3,) as a vector."""
    return SpaceVector(float(xyz[0]), float(xyz[1]), float(xyz[2]))


def minus(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    """From b to a."""
    return SpaceVector(a.x - b.x, a.y - b.y, a.z - b.z)


def towards(target: NDArray[Any], place: SpaceVector) -> SpaceVector:
    """From a place to a target (x, y, z, w): a point of the world, or with w = 0 a direction."""
    w = float(target[3])
    x, y, z = float(target[0]), float(target[1]), float(target[2])
    return SpaceVector(x - w * place.x, y - w * place.y, z - w * place.z)


def between(a: SpaceVector, b: SpaceVector, share: float) -> SpaceVector:
    """From a to b by a share of the way."""
    return SpaceVector(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z))


def middle_of(a: SpaceVector, b: SpaceVector, c: SpaceVector) -> SpaceVector:
    """The mean of three places."""
    return SpaceVector((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0, (a.z + b.z + c.z) / 3.0)


def cross_product(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    """a x b."""
    return SpaceVector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)


def length(a: SpaceVector) -> float:
    """How long a vector is."""
    return math.sqrt(dot_product(a, a))


def unit(a: SpaceVector) -> SpaceVector:
    """A vector of length 1 in the same direction; the zero vector stays."""
    size = length(a)
    if size == 0.0:
        return a
    return SpaceVector(a.x / size, a.y / size, a.z / size)


def mirrored(L: SpaceVector, N: SpaceVector) -> SpaceVector:
    """R = 2 (N . L) N - L: the direction in which a mirror sends light from L."""
    twice = 2.0 * dot_product(N, L)
    return SpaceVector(twice * N.x - L.x, twice * N.y - L.y, twice * N.z - L.z)


def halfway(L: SpaceVector, V: SpaceVector) -> SpaceVector:
    """H, the direction halfway between L and V."""
    return unit(SpaceVector(L.x + V.x, L.y + V.y, L.z + V.z))


def attenuation(a0: float, a1: float, a2: float, d: float) -> float:
    """f = min(1, 1 / (a0 + a1 d + a2 d^2)): what a light at distance d keeps; 1 where that divides by 0."""
    divisor = a0 + a1 * d + a2 * d * d
    if divisor <= 1.0:
        return 1.0
    return 1.0 / divisor
