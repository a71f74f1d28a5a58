"""The A-buffer, for surfaces that let light through: each pixel keeps a list of its fragments by depth.

light       the picture: the light of each pixel, at first that of the ground
first       of each pixel the number of its nearest fragment, or NOTHING
fragments   depth, surface, and the number of the next fragment behind, or NOTHING
opacity     what a surface stops of the light from behind it
let_through what all nearer surfaces let through
total       light of the pixel so far
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.fragment_lists import Fragment, put_by_depth
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
    light: Array, vertices: Array, faces: Array, intensities: Array, opacities: Array
) -> Iterator[tuple[int, int, float]]:
    """Collect the fragments of each pixel by depth, then add up its light.

    Args: light (h, w), written in place; vertices (n, 3) in pixels, z; faces
    (m, 3); intensities and opacities (m,), 0 to 1. Emits: (x, y, light).
    Sources: Carpenter, The A-buffer, 1984; Hearn and Baker, section 13-4.
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
                put_by_depth(first, fragments, x, y, z, number)

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

            # The ground is seen through all of them
            light[y, x] = total + let_through * light[y, x]
            yield x, y, float(light[y, x])
