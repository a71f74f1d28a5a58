"""Polygons in space clipped to the view volume, after the projection and before the division by w.

polygon, clipped    the corners that a plane takes, and those that it hands on
start, end          the side, from one corner to the next, homogeneous
d_start, d_end      how far inside the plane they are; negative outside. Linear in x, y, z and w
"""

from collections.abc import Iterator
from random import Random
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.projection.view_volume_views import VIEW_FUNCTIONS, VIEWS

Array = NDArray[Any]

NEAR, FAR, LEFT, RIGHT, BOTTOM, TOP = 0, 1, 2, 3, 4, 5


class HomogeneousPoint(NamedTuple):
    """A point in space before the division by w."""

    x: float
    y: float
    z: float
    w: float


def corner_of(vertices: Array, k: int) -> HomogeneousPoint:
    """A row of ``vertices``."""
    x, y = float(vertices[k, 0]), float(vertices[k, 1])
    z, w = float(vertices[k, 2]), float(vertices[k, 3])
    return HomogeneousPoint(x, y, z, w)


def inside_by(plane: int, p: HomogeneousPoint, xmin: float, ymin: float, xmax: float, ymax: float) -> float:
    """How far inside a plane of the view volume: 0 <= z <= w, xmin w <= x <= xmax w, and so for y."""
    if plane == NEAR:
        return p.z
    if plane == FAR:
        return p.w - p.z
    if plane == LEFT:
        return p.x - xmin * p.w
    if plane == RIGHT:
        return xmax * p.w - p.x
    if plane == BOTTOM:
        return p.y - ymin * p.w
    return ymax * p.w - p.y


def cut(inner: HomogeneousPoint, outer: HomogeneousPoint, d_inner: float, d_outer: float) -> HomogeneousPoint:
    """Where a side meets the plane, always computed from its inner end, as its other polygon does."""
    u = d_inner / (d_inner - d_outer)
    x = inner.x + u * (outer.x - inner.x)
    y = inner.y + u * (outer.y - inner.y)
    z = inner.z + u * (outer.z - inner.z)
    w = inner.w + u * (outer.w - inner.w)
    return HomogeneousPoint(x, y, z, w)


def clip_to_view_volume(
    vertices: Array, ring_ends: Array, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[int, float, float, float, float]]:
    """Clip polygons to six planes, one after the other, as Sutherland and Hodgman do.

    The near plane comes first: what it leaves lies before the eye, w > 0.

    Args: (n, 4) corners after the projection, of which z is 0 at the near
    plane and w at the far one; (m,) one past the last corner of each ring;
    the window on the view plane. Emits: (ring, x, y, z, w) of each corner.
    Source: Hearn and Baker, Computer Graphics, C Version, section 12-5.
    """
    first = 0
    for ring in range(len(ring_ends)):
        # Take the whole polygon
        polygon = [corner_of(vertices, k) for k in range(first, ring_ends[ring])]
        first = int(ring_ends[ring])

        for plane in (NEAR, FAR, LEFT, RIGHT, BOTTOM, TOP):
            # Begin an empty list for this plane
            clipped = polygon[:0]

            for i in range(len(polygon)):
                # Clip the side that ends at this corner
                start, end = polygon[i - 1], polygon[i]
                d_start = inside_by(plane, start, xmin, ymin, xmax, ymax)
                d_end = inside_by(plane, end, xmin, ymin, xmax, ymax)
                if d_start >= 0.0 and d_end >= 0.0:
                    clipped.append(end)
                elif d_start >= 0.0:
                    clipped.append(cut(start, end, d_start, d_end))
                elif d_end >= 0.0:
                    clipped.append(cut(end, start, d_end, d_start))
                    clipped.append(end)

            # Hand the list on to the next plane
            polygon = clipped

        # Emit the corners that are left
        for corner in polygon:
            yield ring, corner.x, corner.y, corner.z, corner.w


_EXAMPLE = np.array([[-3.0, -1, -1, -0.5], [2, -1, 0.5, 1.5], [1, 2, 1.5, 1.25], [-0.5, 0.5, 0.25, 1]])


def _polygons_and_window(chance: Random) -> tuple[Any, ...]:
    """One or two rings on whole numbers, many of them on a plane, at w = 0 or behind the eye."""
    counts = [chance.choice((0, 3, 3, 4, 6)) for _ring in range(chance.randint(1, 2))]
    corners = [
        [float(chance.randint(-4, 4)) for _axis in range(3)] + [float(chance.randint(-2, 4))]
        for _corner in range(sum(counts))
    ]
    vertices = np.array(corners, np.float64).reshape(-1, 4)
    return vertices, np.cumsum(counts), -1.0, -1.0, 1.0, float(chance.choice((1, 2)))


ENTRY = Entry(
    function=clip_to_view_volume,
    topic="projection",
    title="Clipping to the view volume",
    summary="Clips polygons in space at six planes before the division by w, so that nothing behind the eye "
    "is projected.",
    parameters=(
        Parameter("vertices", "P_i", "matrix", _EXAMPLE, meaning="x, y, z and w of each corner"),
        Parameter("ring_ends", "ends", "ints", np.array([4]), meaning="one past the last corner of each"),
        Parameter("xmin", "xw_{min}", "float", -1.0, -1e6, 1e6, meaning="the window on the view plane"),
        Parameter("ymin", "yw_{min}", "float", -1.0, -1e6, 1e6),
        Parameter("xmax", "xw_{max}", "float", 1.0, -1e6, 1e6),
        Parameter("ymax", "yw_{max}", "float", 1.0, -1e6, 1e6),
    ),
    arguments=_polygons_and_window,
    emits="points",
    emitted_columns=("polygon", "x", "y", "z", "w"),
    source="Hearn and Baker, Computer Graphics, C Version, section 12-5",
    columns=("polygon", "plane", "from", "to", "inside by, from", "inside by, to", "case"),
    view_functions=VIEW_FUNCTIONS,
    views=VIEWS,
    laws=(
        Law(
            "Every corner that is left lies in the view volume, but for rounding, and none behind the eye.",
            "projection/test_view_volume.py::test_what_is_left_lies_in_the_view_volume",
        ),
        Law(
            "Of a convex polygon exactly what lies in the view volume is left.",
            "projection/test_view_volume.py::test_of_a_convex_polygon_exactly_what_lies_in_the_volume_is_left",
        ),
        Law(
            "Two polygons that share a side are cut at the same points of it.",
            "projection/test_view_volume.py::test_a_shared_side_is_cut_at_the_same_points",
        ),
    ),
    not_laws=(
        "One may divide by w first and clip afterwards: what is behind the eye would come out before it.",
    ),
    questions=(1,),
    labs=("Projections",),
    frame="view",
)
