"""What the A-buffer takes and shows: panes of glass, lists of fragments, light added up."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter, View
from workbench.algorithms.visibility.fragment_lists import Fragment, list_from
from workbench.algorithms.visibility.scene import SCENE, scene

GLASS = (
    Parameter("light", "light", "depth", np.full((10, 14), 0.2), meaning="the picture, at first the ground"),
    *(parameter for parameter in SCENE if parameter.name in ("vertices", "faces")),
    Parameter(
        "intensities", "intensities", "floats", np.array([0.8, 0.4]), meaning="light of each triangle, 0 to 1"
    ),
    Parameter(
        "opacities",
        "opacities",
        "floats",
        np.array([0.5, 0.5]),
        meaning="what each stops, 0 to 1",
    ),
)

COLUMNS = ("pixel", "surface", "z", "stops", "light so far", "lets through")


def panes(chance: Random) -> tuple[Any, ...]:
    """One or two triangles, of any light and opacity."""
    image, _depth, vertices, faces, _colours = scene(chance)
    shares = [[chance.randint(0, 4) / 4 for _face in faces] for _kind in ("light", "opacity")]
    light = np.full(image.shape, chance.randint(0, 4) / 4)
    return light, vertices, faces, np.array(shares[0]), np.array(shares[1])


def list_rows(fragments: list[Fragment], head: int) -> list[tuple[int, float]]:
    """The list of a pixel: surface and depth of each fragment, the nearest first."""
    return [(one.surface, one.z) for one in list_from(fragments, head)]


VIEW_FUNCTIONS = (list_rows,)

_COLUMNS = ("surface", "z")

VIEWS = (
    View(
        block="Put the fragment into the pixel's list, by its depth",
        row="((x, y), number, z, '–', '–', '–')",
        considers="(x, y)",
        candidates="((x, y),)",
        chosen="((x, y),)",
        tables={"List of the pixel": ("list_rows(fragments, head)", _COLUMNS)},
        sentence="{(x, y)}: surface {number} at z = {z} goes into the list, which has "
        "{len(list_rows(fragments, head))} fragments now.",
    ),
    View(
        block="Add its light, and let through what it does not stop",
        row="((x, y), number, z, opacity, total, let_through)",
        considers="(x, y)",
        candidates="((x, y),)",
        chosen="((x, y),)",
        tables={"Fragments behind": ("list_rows(fragments, k)", _COLUMNS)},
        sentence="{(x, y)}: surface {number} stops {opacity} of the light and adds its own, {total} so far; "
        "{let_through} of what is behind still gets through.",
    ),
    View(
        block="Add the light of the ground, through all of them",
        row="((x, y), 'ground', '–', '–', total, '–')",
        considers="(x, y)",
        candidates="((x, y),)",
        chosen="((x, y),)",
        sentence="{(x, y)}: {let_through} of the ground's {ground} gets through all of them, so its light is "
        "{total}.",
    ),
)
