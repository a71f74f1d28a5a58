"""The illumination model as a function: what a point of a surface sends to the eye.

A row of lights is x, y, z, w, I, a0, a1, a2: a point of the world, or with w = 0 a direction; its intensity;
and the coefficients of its attenuation. A row of materials is k_a, k_d, k_s, n, the first with the ambient
light in it. Blockers are corners (3 k, 3) of triangles of the world that may take the light away, and boxes
around them as of ``shadow_boxes``.
"""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.shading.directions import (
    attenuation,
    cross_product,
    halfway,
    length,
    minus,
    mirrored,
    towards,
    unit,
)
from workbench.algorithms.shading.shadow_boxes import is_box, passes_by
from workbench.algorithms.visibility.back_faces import SpaceVector, dot_product, vector_of

Array = NDArray[Any]

JUST_OFF = 1e-6
"""So much of the way to the light a surface is not in its own way."""


class Arriving(NamedTuple):
    """What of a light comes to a point: from where (unit L), from how far, and how much of it."""

    L: SpaceVector
    d: float
    f: float
    intensity: float


def arriving(lights: Array, light: int, place: SpaceVector, blockers: Array) -> Arriving:
    """What of a light comes to a place; nothing where something is in the way."""
    way = towards(lights[light], place)
    d = length(way)
    f = attenuation(float(lights[light, 5]), float(lights[light, 6]), float(lights[light, 7]), d)
    reach = 1.0
    if lights[light, 3] == 0.0:
        f, reach = 1.0, math.inf
    intensity = f * float(lights[light, 4])
    if in_shadow(place, way, reach, blockers):
        intensity = 0.0
    return Arriving(unit(way), d, f, intensity)


def in_shadow(place: SpaceVector, way: SpaceVector, reach: float, blockers: Array) -> bool:
    """Whether a ray from a place along a way meets a triangle before it has gone ``reach`` ways.

    What is in a box that it passes by is left out.
    """
    k = 0
    while k < len(blockers):
        if is_box(blockers, k):
            if passes_by(place, way, reach, blockers, k):
                k += int(blockers[k + 2, 0])
        else:
            a, b, c = vector_of(blockers, k), vector_of(blockers, k + 1), vector_of(blockers, k + 2)
            if JUST_OFF < met_at(place, way, a, b, c) < reach:
                return True
        k += 3
    return False


def met_at(place: SpaceVector, way: SpaceVector, a: SpaceVector, b: SpaceVector, c: SpaceVector) -> float:
    """After how many ways a ray meets a triangle; -1 where it does not.

    Source: Moller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection, 1997.
    """
    to_b, to_c = minus(b, a), minus(c, a)
    p = cross_product(way, to_c)
    volume = dot_product(to_b, p)
    if volume == 0.0:
        return -1.0
    from_a = minus(place, a)
    share_b = dot_product(from_a, p) / volume
    q = cross_product(from_a, to_b)
    share_c = dot_product(way, q) / volume
    if share_b < 0.0 or share_c < 0.0 or share_b + share_c > 1.0:
        return -1.0
    return dot_product(to_c, q) / volume


def light_at(
    place: SpaceVector,
    normal: SpaceVector,
    material: Array,
    eye: Array,
    lights: Array,
    by_halfway: bool,
    blockers: Array,
) -> float:
    """The total that ``illuminate`` comes to."""
    N, V = unit(normal), unit(towards(eye, place))
    k_d, k_s, n = float(material[1]), float(material[2]), float(material[3])
    total = float(material[0])
    for light in range(len(lights)):
        if dot_product(N, towards(lights[light], place)) <= 0.0:
            continue  # before anything is tried that may be in the way
        came = arriving(lights, light, place, blockers)
        if by_halfway:
            mirror = dot_product(N, halfway(came.L, V))
        else:
            mirror = dot_product(V, mirrored(came.L, N))
        cosine = dot_product(N, came.L)
        total += came.intensity * (k_d * cosine + k_s * math.pow(max(mirror, 0.0), n))
    return total


def corner_lights(
    places: Array,
    normals: Array,
    materials: Array,
    eye: Array,
    lights: Array,
    by_halfway: bool,
    blockers: Array,
) -> Iterator[tuple[float]]:
    """The light of each of many points (n, 3) with normals (n, 3) and materials (n, 4).

    Emits: (light,).
    """
    for k in range(len(places)):
        place, normal = vector_of(places, k), vector_of(normals, k)
        yield (light_at(place, normal, materials[k], eye, lights, by_halfway, blockers),)
