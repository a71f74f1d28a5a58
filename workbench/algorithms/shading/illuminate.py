"""The light of a point: ambient, and of each light what is scattered and what is mirrored.

N, V        unit normal of the surface, and the unit direction to the eye
L, d        unit direction to the light, and the distance to it
f           what the light keeps over that distance
R           where a mirror would send the light
H           halfway between L and V: quicker to find than R, and another highlight
diffuse     scattered alike in all directions
specular    mirrored, the more sharply the larger the exponent n
total       light of the point so far
"""

import math
from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.shading.directions import (
    attenuation,
    halfway,
    length,
    minus,
    mirrored,
    unit,
    vector,
)
from workbench.algorithms.visibility.back_faces import dot_product, vector_of

Array = NDArray[Any]


def illuminate(
    place: Array,
    normal: Array,
    eye: Array,
    lights: Array,
    material: Array,
    fading: Array,
    by_halfway: bool,
) -> Iterator[tuple[int, float, float, float]]:
    """Add up the light of a point of a surface.

    Args: place, normal and eye (3,), world; lights (m, 4): place, intensity;
    material (4,): k_a, k_d, k_s, n; fading (3,): a0, a1, a2; N . H for V . R.
    Emits: (light, diffuse, specular, total).
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-2.
    """
    # Begin with the ambient light
    N, V = unit(vector(normal)), unit(minus(vector(eye), vector(place)))
    k_d, k_s, n = float(material[1]), float(material[2]), float(material[3])
    total = float(material[0])

    for light in range(len(lights)):
        # Find the way to the light, and what arrives of it
        to_light = minus(vector_of(lights, light), vector(place))
        L, d = unit(to_light), length(to_light)
        f = attenuation(float(fading[0]), float(fading[1]), float(fading[2]), d)
        arriving = f * float(lights[light, 3])

        # Add what is scattered
        cosine = max(dot_product(N, L), 0.0)
        diffuse = k_d * arriving * cosine

        # Add what is mirrored
        mirror = max(dot_product(V, mirrored(L, N)), 0.0)
        if by_halfway:
            mirror = max(dot_product(N, halfway(L, V)), 0.0)
        specular = 0.0
        if cosine > 0.0:
            specular = k_s * arriving * math.pow(mirror, n)
        total += diffuse + specular
        yield light, diffuse, specular, total


def lit_point(chance: Random) -> tuple[Any, ...]:
    """Up to three lights round a point, some of them behind the surface or in the point itself."""

    def place() -> list[float]:
        return [float(chance.randint(-3, 3)) for _axis in range(3)]

    lights = np.array([[*place(), chance.randint(0, 4) / 4] for _light in range(chance.randint(0, 3))])
    material = np.array([chance.randint(0, 4) / 4 for _share in range(3)] + [float(chance.randint(1, 50))])
    fading = np.array([chance.randint(0, 4) / 4 for _power in range(3)])
    arrays = [np.array(place()) for _point in range(3)]
    return *arrays, lights.reshape(-1, 4), material, fading, chance.random() < 0.5


_MIRROR = "Add what is mirrored"
_NAME = "'N · H' if by_halfway else 'V · R'"

ENTRY = Entry(
    function=illuminate,
    topic="shading",
    title="Light of a point",
    summary="Ambient light, and of each light what the surface scatters and what it mirrors.",
    parameters=(
        Parameter("place", "P", "floats", np.zeros(3), meaning="the point of the surface, in the world"),
        Parameter("normal", "N", "floats", np.array([0.0, 0, 1]), meaning="normal of the surface there"),
        Parameter("eye", "eye", "floats", np.array([0.0, 0, 5]), meaning="where it is seen from"),
        Parameter(
            "lights", "lights", "matrix", np.array([[1.0, 2, 2, 1], [-2, 0, 1, 0.5]]), meaning="x, y, z, I"
        ),
        Parameter(
            "material",
            "material",
            "floats",
            np.array([0.1, 0.6, 0.3, 10]),
            meaning="ambient light, then k_d, k_s and n",
        ),
        Parameter("fading", "fading", "floats", np.array([1.0, 0, 0]), meaning="a0, a1, a2 of the distance"),
        Parameter("by_halfway", "N · H", "bool", False, meaning="by the halfway vector instead of V · R"),
    ),
    arguments=lit_point,
    emits="points",
    emitted_columns=("light", "diffuse", "specular", "total"),
    source="Hearn and Baker, Computer Graphics, C Version, section 14-2",
    columns=("light", "f", "N · L", "V · R or N · H", "diffuse", "specular", "total"),
    views=(
        View(block="Begin with the ambient light", sentence="The ambient light alone gives {total}."),
        View(
            block="Find the way to the light, and what arrives of it",
            sentence="Light {light} is {d} away and keeps f = {f} of its intensity.",
        ),
        View(
            block=_MIRROR,
            when="cosine == 0.0",
            row="(light, f, cosine, mirror, diffuse, specular, total)",
            options="('it adds light', 'it adds nothing')",
            answer="'it adds nothing'",
            sentence="Light {light} is not in front of the surface: N · L is not positive, and it adds "
            "nothing.",
        ),
        View(
            block=_MIRROR,
            row="(light, f, cosine, mirror, diffuse, specular, total)",
            options="('it adds light', 'it adds nothing')",
            answer="'it adds light'",
            sentence=f"Light {{light}}: N · L = {{cosine}} scatters {{diffuse}}; {{{_NAME}}} = {{mirror}} "
            "mirrors {specular}; {total} so far.",
        ),
    ),
    laws=(
        Law(
            "The light is that of the formula, by V · R and by N · H.",
            "shading/test_illuminate.py::test_the_light_is_that_of_the_formula",
        ),
        Law(
            "A light behind the surface adds nothing, and one farther away never adds more.",
            "shading/test_illuminate.py::test_light_from_behind_and_from_farther_away",
        ),
        Law(
            "Several lights add up: their order does not matter.",
            "shading/test_illuminate.py::test_lights_add_up",
        ),
    ),
    not_laws=(
        "V · R and N · H give the same highlight: the angle between N and H is half of that between V and R "
        "when all lie in one plane, so with one n that of N · H is larger.",
    ),
    labs=("Illumination",),
    frame="world",
)
