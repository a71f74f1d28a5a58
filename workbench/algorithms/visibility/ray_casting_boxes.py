"""Ray casting through boxes in boxes: a ray that misses a box misses all in it.

boxes       the hierarchy: around all surfaces one box, in it two, and so on
order       surfaces, so that those of a box are together
total       how many boxes there are
work        boxes that may be divided
first, end  the places in the order that the box in hand has
cut         where it is divided, and middle, the place where the second part begins
waiting     boxes that the ray has yet to be tried on, the first ``count`` of them, the nearest last
box         the one that it is tried on
tried       on so many surfaces the ray was tried
nearest, seen   the nearest place so far, and whose it is, or NOTHING
"""

import math
from collections.abc import Iterator

import numpy as np

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.box_cuts import BINS, cheapest_cut, put_apart
from workbench.algorithms.visibility.box_examples import EXAMPLE, many_surfaces
from workbench.algorithms.visibility.box_views import COLUMNS, VIEW_FUNCTIONS, VIEWS, box_marks
from workbench.algorithms.visibility.boxes import (
    FEW,
    NONE,
    depth_scale,
    divide,
    extents_of,
    missed,
    nearer_first,
    one_box,
)
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE
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


def ray_casting_boxes(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int]]:
    """Put boxes in boxes around the surfaces, and cast rays through them.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (x, y, surface) of each pixel.
    Source: Hearn and Baker, Computer Graphics, C Version, section 14-6.
    """
    # Put one box around all surfaces
    surfaces = surfaces_of(vertices, faces)
    extents, order = extents_of(surfaces), np.array(in_view(surfaces), np.int64)
    boxes, bins = one_box(extents, order), np.zeros((BINS, 8))
    scale, total, work = depth_scale(boxes), 1, [0]
    while work:
        # Take a box: few surfaces stay as they are
        here = work.pop()
        first, end = int(boxes.first[here]), int(boxes.end[here])
        if end - first <= FEW:
            continue
        # Find the cut that leaves rays the least to try
        cut = cheapest_cut(extents, order, first, end, scale, bins)
        if cut.axis == NONE:
            continue
        # Put a box around each of the two parts
        middle = put_apart(extents, order, first, end, cut)
        divide(boxes, here, total, extents, order, middle)
        work.extend([total, total + 1])
        total += 2
    height, width = image.shape
    waiting = np.zeros(total, np.int64)
    for y in range(height):
        for x in range(width):
            # Cast a ray: the box around all is the first to try
            nearest, seen, tried = math.inf, NOTHING, 0
            waiting[0], count = 0, 1
            while count > 0:
                # Try the ray on the nearest box that waits
                count -= 1
                box = int(waiting[count])
                if missed(boxes, box, x, y, nearest):
                    continue
                if boxes.inner[box] != NONE:
                    # Open it: the nearer one in it comes first
                    near, far = nearer_first(boxes, box)
                    waiting[count], waiting[count + 1] = far, near
                    count += 2
                    continue
                for place in range(boxes.first[box], boxes.end[box]):
                    # Find where the ray meets a surface in it
                    number, tried = int(order[place]), tried + 1
                    surface = surfaces[number]
                    hit = covers(surface, x, y)
                    z = depth_at(surface, x, y)
                    if hit and (z < nearest or (z == nearest and number < seen)):
                        nearest, seen = z, number
            # Give the pixel the colour of the nearest
            if seen != NOTHING:
                image[y, x] = int(colours[seen])
                yield x, y, seen


ENTRY = Entry(
    function=ray_casting_boxes,
    topic="visibility",
    title="Ray casting through boxes",
    summary="Puts boxes in boxes around the surfaces; a ray that misses a box is tried on nothing in it.",
    parameters=EXAMPLE,
    arguments=many_surfaces,
    emits="pixels",
    emitted_columns=("x", "y", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 14-6; Goldsmith and Salmon, Automatic "
    "Creation of Object Hierarchies for Ray Tracing, 1987",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "Every pixel shows what ray casting shows.",
            "visibility/test_ray_casting_boxes.py::test_every_pixel_shows_what_ray_casting_shows",
        ),
        ONE_PICTURE,
        Law(
            "Each surface is in one of the boxes that stay whole, and no box leaves the one that it is in.",
            "visibility/test_ray_casting_boxes.py::test_boxes_hold_their_surfaces",
        ),
    ),
    not_laws=(
        "A ray is tried on one box at a time from front to back: boxes overlap, so it goes on until no box "
        "that waits begins nearer than what it has met.",
    ),
    works_in="image space",
    questions=(7,),
    labs=("Hidden surfaces: ray casting",),
    tie="Of equal depths the lower number is taken",
    writes="image",
    marks=box_marks,
    counted={"boxes divided": Counted("box divided", ("Put a box around each",), "divided")},
    keeps={"boxes": Kept("box", "2 * counted['boxes divided'] + 1")},
)
