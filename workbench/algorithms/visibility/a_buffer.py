"""The A-buffer, for surfaces that let light through: each pixel keeps a list of its fragments by depth.

light       the picture: the light of each pixel, at first that of the ground
first       of each pixel the number of its nearest fragment, or NOTHING
fragments   depth, surface, and the number of the next fragment behind, or NOTHING
opacity     what a surface stops of the light from behind it
let_through what all nearer surfaces let through
total       light of the pixel so far
head        the nearest fragment of the pixel in hand
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.fragment_lists import Fragment, put_by_depth
from workbench.algorithms.visibility.fragment_views import COLUMNS, GLASS, VIEW_FUNCTIONS, VIEWS, panes
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surfaces import (
    NOTHING,
    depth_at,
    end_row,
    first_row,
    in_view,
    span_on,
    surfaces_of,
)

Array = NDArray[Any]


def a_buffer(
    light: Array,
    vertices: Array,
    faces: Array,
    intensities: Array,
    opacities: Array,
) -> Iterator[tuple[int, int, float]]:
    """Collect the fragments of each pixel by depth, then add up its light.

    Args: light (h, w), written in place; vertices (n, 3) in pixels, z; faces
    (m, 3); intensities and opacities (m,), 0 to 1. Emits: (x, y, light).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-4.
    """
    surfaces = surfaces_of(vertices, faces)
    height, width = light.shape
    first = np.full((height, width), NOTHING)
    fragments = [Fragment(0.0, 0, NOTHING) for _surface in surfaces[:0]]

    for number in in_view(surfaces):
        surface = surfaces[number]
        for y in range(first_row(surface), end_row(surface, height)):
            x_left, end = span_on(surface, y, width)
            for x in range(x_left, end):
                # Put the fragment into the pixel's list, by its depth
                z = depth_at(surface, x, y)
                head = put_by_depth(fragments, int(first[y, x]), z, number)
                first[y, x] = head

    for y in range(height):
        for x in range(width):
            # Begin with the nearest fragment of the pixel
            k, total, let_through = int(first[y, x]), 0.0, 1.0
            if k == NOTHING:
                continue

            while k != NOTHING:
                # Add its light, and let through what it does not stop
                z, number, k = fragments[k]
                opacity = float(opacities[number])
                total += let_through * opacity * float(intensities[number])
                let_through *= 1.0 - opacity

            # Add the light of the ground, through all of them
            ground = float(light[y, x])
            total += let_through * ground
            light[y, x] = total
            yield x, y, total


ENTRY = Entry(
    function=a_buffer,
    topic="visibility",
    title="A-buffer",
    summary="Keeps for each pixel a list of all its fragments by depth, so that surfaces may shine through.",
    parameters=GLASS,
    arguments=panes,
    emits="coverage",
    emitted_columns=("x", "y", "light"),
    source="Carpenter, The A-buffer, an Antialiased Hidden Surface Method, 1984; Hearn and Baker, Computer "
    "Graphics, C Version, section 13-4",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "The light of a pixel is that of its surfaces, from the farthest on, each over what is behind.",
            "visibility/test_a_buffer.py::test_the_light_is_that_of_layers_in_fractions",
        ),
        Law(
            "Where all surfaces are opaque it shows what the depth buffer shows.",
            "visibility/test_a_buffer.py::test_opaque_surfaces_hide_as_in_the_depth_buffer",
        ),
        Law(
            "The order of the surfaces does not matter where no two depths are equal.",
            "visibility/test_a_buffer.py::test_the_order_of_the_surfaces_does_not_matter",
        ),
    ),
    not_laws=(
        "Transparent surfaces can be blended in any order: what is nearer dims what is behind it, not the "
        "other way round.",
    ),
    works_in="image space",
    questions=(7,),
    labs=("Hidden surfaces: A-buffer",),
    tie="Of equal depths the earlier one is in front",
    writes="light",
    marks=marks,
)
