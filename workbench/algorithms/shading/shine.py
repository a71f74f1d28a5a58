"""What a light does on a triangle: its cosines as series, and stepped along a row."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.shading.directions import halfway, towards, unit
from workbench.algorithms.shading.illumination import arriving
from workbench.algorithms.shading.series import Bend, Differences, Series, begun, onward, series_of
from workbench.algorithms.visibility.back_faces import SpaceVector, dot_product

Array = NDArray[Any]


class Shine(NamedTuple):
    """A light on a triangle: its intensity in the middle, N . L, N . H or N . V as series, and L . V."""

    intensity: float
    scattered: Series
    mirrored: Series
    L_V: float


class RowShine(NamedTuple):
    """The same on a row, as far as it has come."""

    intensity: float
    scattered: Differences
    mirrored: Differences
    L_V: float


def shine_of(
    P: SpaceVector, bend: Bend, eye: Array, lights: Array, light: int, by_halfway: bool, blockers: Array
) -> Shine:
    """What a light does on a triangle whose middle is P."""
    came = arriving(lights, light, P, blockers)
    V = unit(towards(eye, P))
    other = V
    if by_halfway:
        other = halfway(came.L, V)
    return Shine(came.intensity, series_of(bend, came.L), series_of(bend, other), dot_product(came.L, V))


def on_row(shine: Shine, u: float, v: float) -> RowShine:
    """Where a row begins."""
    return RowShine(shine.intensity, begun(shine.scattered, u, v), begun(shine.mirrored, u, v), shine.L_V)


def next_shine(at: RowShine) -> RowShine:
    """At the next pixel."""
    return RowShine(at.intensity, onward(at.scattered), onward(at.mirrored), at.L_V)


def light_of(shines: list[RowShine], material: Array, by_halfway: bool) -> float:
    """The illumination model by the cosines as they are now; a series may come to more than 1."""
    k_d, k_s, n = float(material[1]), float(material[2]), float(material[3])
    total = float(material[0])
    for shine in shines:
        cosine = min(shine.scattered.value, 1.0)
        if cosine > 0.0:
            mirror = shine.mirrored.value
            if not by_halfway:
                mirror = 2.0 * cosine * mirror - shine.L_V
            mirror = min(max(mirror, 0.0), 1.0)
            total += shine.intensity * (k_d * cosine + k_s * math.pow(mirror, n))
    return total
