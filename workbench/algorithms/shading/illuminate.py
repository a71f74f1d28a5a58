"""The light of a point: ambient, and of each light what is scattered and what is mirrored.

N, V        unit normal of the surface, and the unit direction to the eye
L, d        unit direction to the light, and the distance to it
f           what the light keeps over that distance: min(1, 1/(a0 + a1 d + a2 d^2))
intensity   what comes of the light: f times its own, nothing where a blocker is in the way
R           where a mirror would send the light
H           halfway between L and V: quicker to find than R, and another highlight
diffuse     scattered alike in all directions
specular    mirrored, the more sharply the larger the exponent n
total       light of the point so far
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.shading.directions import halfway, mirrored, towards, unit, vector
from workbench.algorithms.shading.illumination import arriving
from workbench.algorithms.shading.model_parameters import BLOCKERS, BY_HALFWAY, EYE, lit_point
from workbench.algorithms.visibility.back_faces import dot_product

Array = NDArray[Any]


def illuminate(
    place: Array,
    normal: Array,
    eye: Array,
    lights: Array,
    material: Array,
    by_halfway: bool,
    blockers: Array,
) -> Iterator[tuple[int, float, float, float]]:
    """Add up the light of a point of a surface.

    Args: place and normal (3,), world; eye (4,): x, y, z, w, a direction where
    w = 0; lights (m, 8): likewise, then intensity, a0, a1, a2; material (4,):
    k_a, k_d, k_s, n; N . H for V . R; blockers (3 k, 3): corners of triangles.
    Emits: (light, diffuse, specular, total).
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-2.
    """
    # Begin with the ambient light
    N, V = unit(vector(normal)), unit(towards(eye, vector(place)))
    k_d, k_s, n = float(material[1]), float(material[2]), float(material[3])
    total = float(material[0])

    for light in range(len(lights)):
        # Find the way to the light, and what arrives of it
        L, d, f, intensity = arriving(lights, light, vector(place), blockers)

        # Add what is scattered
        cosine = max(dot_product(N, L), 0.0)
        diffuse = k_d * intensity * cosine

        # Add what is mirrored
        mirror = max(dot_product(V, mirrored(L, N)), 0.0)
        if by_halfway:
            mirror = max(dot_product(N, halfway(L, V)), 0.0)
        specular = 0.0
        if cosine > 0.0:
            specular = k_s * intensity * math.pow(mirror, n)
        total += diffuse + specular
        yield light, diffuse, specular, total


_ARRIVES = "Find the way to the light, and what arrives of it"
_MIRROR = "Add what is mirrored"
_NAME = "'N · H' if by_halfway else 'V · R'"

ENTRY = Entry(
    function=illuminate,
    topic="shading",
    title="Light of a point",
    summary="Ambient light, and for each lamp what the surface scatters and what it reflects.",
    parameters=(
        Parameter("place", "P", "floats", np.zeros(3), meaning="the point of the surface, in the world"),
        Parameter("normal", "N", "floats", np.array([0.0, 0, 1]), meaning="normal of the surface there"),
        EYE,
        Parameter(
            "lights",
            "lights",
            "matrix",
            np.array([[1.0, 2, 2, 1, 1, 1, 0, 0], [-2, 0, 1, 1, 0.5, 1, 0, 0]]),
            meaning="x, y, z, w, intensity, then a0, a1, a2 of the distance; with w = 0 a direction",
        ),
        Parameter(
            "material",
            "material",
            "floats",
            np.array([0.1, 0.6, 0.3, 10]),
            meaning="ambient light, then k_d, k_s and n",
        ),
        BY_HALFWAY,
        BLOCKERS,
    ),
    arguments=lit_point,
    emits="points",
    emitted_columns=("light", "diffuse", "specular", "total"),
    source="Hearn and Baker, Computer Graphics, C Version, section 14-2",
    columns=("light", "f", "N · L", "V · R or N · H", "diffuse", "specular", "total"),
    views=(
        View(block="Begin with the ambient light", sentence="The ambient light alone gives {total}."),
        View(
            block=_ARRIVES,
            when="intensity == 0.0",
            sentence="Nothing arrives from light {light}: it is switched off, or something is in its way.",
        ),
        View(
            block=_ARRIVES,
            when="d == 0.0",
            sentence="Light {light} lies in the surface itself, so it adds nothing.",
        ),
        View(
            block=_ARRIVES,
            sentence="Light {light} is {d} away and keeps f = {f} of its intensity: {intensity} arrives.",
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
            "A triangle between the point and a light takes all of it away, one beyond nothing.",
            "shading/test_illuminate.py::test_what_is_between_takes_the_light_away",
        ),
        Law(
            "Boxes in boxes around what may be in the way leave all shadows as they are.",
            "shading/test_shadow_boxes.py::test_light_is_the_same_through_boxes",
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
