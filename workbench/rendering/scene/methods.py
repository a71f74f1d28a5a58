"""Every method for hidden surfaces on the same device triangles.

A method is any entry of visibility that takes a picture and triangles, and depths if it keeps them.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.algorithms.visibility import a_buffer
from workbench.algorithms.visibility.surfaces import NOTHING, depth_at, surface_of
from workbench.engine.stopping import Stop
from workbench.geometry.meshes import Array, Index
from workbench.rendering.mapping import Call
from workbench.rendering.scene.viewpoint import Size

FARTHEST = 1.0
_GIVEN = {"image", "depth", "vertices", "faces", "colours"}

METHODS: tuple[str, ...] = tuple(
    entry.slug for entry in catalogue.topic("visibility") if {"image"} < set(entry.parameter_names) <= _GIVEN
)
"""Their slugs, in teaching order."""


A_BUFFER = a_buffer.__name__
"""A method, too, but one that adds up light: where all is opaque its picture is that of the others."""


def method_call(
    method: str,
    corners: Array,
    triangles: Index,
    colours: Index | Array,
    size: Size,
    opacities: Array | None = None,
) -> Call:
    """The call that paints device triangles with a method into a new picture of ``size``, (width, height).

    Args: as of ``DeviceTriangles``; a slug of METHODS, or A_BUFFER, for which colours are light, and
    opacities (t,), 0 to 1, by default 1.
    """
    width, height = size
    given: dict[str, Any] = {
        "image": np.zeros((height, width), np.uint32),  # for which kernels are compiled ahead
        "depth": np.full((height, width), FARTHEST),
        "vertices": corners,
        "faces": triangles,
        "colours": colours,
        "light": np.zeros((height, width)),
        "intensities": np.asarray(colours, np.float64),
        "opacities": np.ones(len(triangles)) if opacities is None else opacities,
    }
    entry = catalogue.get(method)
    return Call(entry, tuple(given[name] for name in entry.parameter_names))


def surfaces_seen(
    method: str,
    corners: Array,
    triangles: Index,
    size: Size,
    compiling: bool = False,
    stop: Stop | None = None,
) -> Index:
    """(height, width) the number of the triangle that a method shows at each pixel, or NOTHING.

    Without ``compiling`` the plain reading serves until the kernel is there. Raises: ValueError, a sentence,
    where it would need too many pieces; Stopped.
    """
    from workbench.engine.compiled import paint

    numbers = np.arange(1, len(triangles) + 1)
    call = method_call(method, corners, triangles, numbers, size)
    image: NDArray[Any] = call.arguments[0]
    paint(call.entry.function, image, 0, *call.arguments, compiling=compiling)
    if stop is not None:
        stop.check()
    return image.astype(np.int64) - 1


def picture_by(
    method: str, corners: Array, triangles: Index, colours: Index, size: Size
) -> tuple[NDArray[np.uint32], Array]:
    """The picture (h, w), uint32, that a method paints, and the depth of what each pixel shows, 1 of nothing.

    A faster text draws for one that names it. Its kernel is compiled if need be. Raises: ValueError, as
    ``surfaces_seen``.
    """
    faster = catalogue.get(method).drawn_by
    seen = surfaces_seen(faster.slug if faster else method, corners, triangles, size, compiling=True)
    covered = seen != NOTHING
    image = np.zeros(seen.shape, np.uint32)
    image[covered] = colours[seen[covered]]
    return image, depths_of(seen, corners, triangles)


def depths_of(seen: Index, corners: Array, triangles: Index) -> Array:
    """(h, w) the depth of the triangle that each pixel shows, by the formula of all methods; 1 of nothing."""
    depth_of_all: Any = depth_at  # its arithmetic is that of arrays, too
    depth = np.full(seen.shape, FARTHEST)
    pixels = np.flatnonzero(seen != NOTHING)
    pixels = pixels[np.argsort(seen.flat[pixels], kind="stable")]  # those of one triangle stand together
    numbers, starts = np.unique(seen.flat[pixels], return_index=True)
    for number, here in zip(numbers.tolist(), np.split(pixels, starts[1:]), strict=False):
        y, x = np.divmod(here, seen.shape[1])
        depth.flat[here] = depth_of_all(surface_of(corners, triangles, number), x, y)
    return depth


def seen_after(entry: Entry, rows: NDArray[Any], size: Size) -> Index:
    """(height, width) the triangle that each pixel shows, or NOTHING, after a method that keeps no depths has
    emitted ``rows``."""
    seen = np.full(size[::-1], NOTHING)
    if entry.emits == "spans":
        for y, left, right, surface in rows.tolist():
            seen[y, left : right + 1] = surface
    elif len(rows):
        seen[rows[:, 1], rows[:, 0]] = rows[:, 2]
    return seen
