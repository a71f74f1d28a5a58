"""Ray casting: through each pixel a ray from the eye, which meets the nearest surface first.

x, y        the pixel; on the device all rays run along z
number      the surface that the ray is tried on
hit         whether the ray meets it
z           where it does
nearest, seen   the nearest place so far, and whose it is, or NOTHING
"""

import math
from collections.abc import Iterator

from workbench.algorithms.entry import DrawnBy, Entry, Law
from workbench.algorithms.visibility.ray_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE, SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import (
    NOTHING,
    Colours,
    Picture,
    Triangles,
    Vertices,
    covers,
    depth_at,
    in_view,
    surfaces_of,
)


def ray_casting(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int]]:
    """Cast a ray through each pixel; the nearest surface gives its colour.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (x, y, surface) of each pixel.
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-10.
    """
    surfaces = surfaces_of(vertices, faces)
    numbers = in_view(surfaces)
    height, width = image.shape
    for y in range(height):
        for x in range(width):
            # Cast a ray through the centre of the pixel
            nearest, seen = math.inf, NOTHING

            for number in numbers:
                # Find where the ray meets the surface
                surface = surfaces[number]
                hit = covers(surface, x, y)
                z = depth_at(surface, x, y)
                if hit and z < nearest:
                    nearest, seen = z, number

            # Give the pixel the colour of the nearest
            if seen != NOTHING:
                image[y, x] = int(colours[seen])
                yield x, y, seen


_THROUGH_BOXES = Law(
    "Through boxes in boxes every pixel shows the same.",
    "visibility/test_ray_casting_boxes.py::test_every_pixel_shows_what_ray_casting_shows",
)

ENTRY = Entry(
    function=ray_casting,
    topic="visibility",
    title="Ray casting",
    summary="Casts a ray through the centre of each pixel; the surface that it meets first gives the colour.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="pixels",
    emitted_columns=("x", "y", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-10",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(ONE_PICTURE, _THROUGH_BOXES),
    not_laws=(
        "A ray must be tried on every surface: this first rung does so; boxes around many at once save most "
        "of the work.",
    ),
    works_in="image space",
    questions=(7,),
    labs=("Hidden surfaces: ray casting",),
    next_rung="ray_casting_boxes",
    drawn_by=DrawnBy("ray_casting_boxes", _THROUGH_BOXES),
    tie="Of equal depths the lower number is taken",
    writes="image",
    marks=marks,
)
