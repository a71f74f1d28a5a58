"""A scene as a student looks at it: flat faces by the depth buffer, edges as lines.

Edges are lines of their own, not pixels, so that they stay thin and smooth; the depth buffer of the same
picture tells which part of each is seen.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.geometry.conventions import top_row_first
from workbench.geometry.meshes import Array, Index
from workbench.rendering.scene.render import device_triangles, placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint
from workbench.rendering.scene.volume import DEPTH_PLANES, LEAST_W, clip_segments
from workbench.rendering.triangles import drawn, in_bands

MOST_EDGES = 20_000
_MOST_SAMPLES = 400_000
_LONGEST_PX = 4_000
_SLACK = 1e-7
_OPAQUE = 0xFF000000


class EdgePicture(NamedTuple):
    """``pixels`` (h, w), 0xAARRGGBB, row 0 at the bottom, 0 where nothing is, None where faces are not drawn;
    ``seen`` and ``hidden`` segments (n, 4) as (x0, y0, x1, y1) in pixels, y upwards, and of which of the
    scene's objects each is (n,). Scenes of more than MOST_EDGES edges have none.
    """

    pixels: NDArray[np.uint32] | None
    seen: Array
    seen_of: Index
    hidden: Array
    hidden_of: Index


def edge_picture(scene: Scene, size: Size, window: Rectangle, faces: bool = True) -> EdgePicture:
    """The scene as its camera sees it in this window, with or without its faces. Raises: ValueError."""
    ends, owners = _edges(scene, Viewpoint.of(scene.camera, size, window, np.zeros((0, 3))))
    none, nobody = np.zeros((0, 4)), np.zeros(0, np.int64)
    if not faces:
        return EdgePicture(None, ends[:, [0, 1, 3, 4]], owners, none, nobody)
    device = device_triangles(placed(scene), scene.lights, scene.camera, size, window)
    image, depth = drawn(device.corners, device.triangles, device.colours | _OPAQUE, size)
    pixels = top_row_first(np.ascontiguousarray(top_row_first(image)))  # as a screen wants it in memory
    parts, of, seen = _split(ends, depth)
    return EdgePicture(pixels, parts[seen], owners[of[seen]], parts[~seen], owners[of[~seen]])


def image_over_nothing(image: NDArray[np.uint32], depth: Array) -> NDArray[np.uint32]:
    """A picture (h, w), 0xRRGGBB, as 0xAARRGGBB, 0 where its depths say that nothing is.

    In memory its top row comes first, as a screen wants it.
    """
    rows = np.empty_like(image)

    def show(first: int, end: int) -> None:
        band = rows[first:end]
        np.multiply(top_row_first(depth)[first:end] < 1.0, np.uint32(_OPAQUE), out=band)
        band |= top_row_first(image)[first:end]

    in_bands(len(rows), show, None)
    return top_row_first(rows)


def _edges(scene: Scene, viewpoint: Viewpoint) -> tuple[Array, Index]:
    """Both ends (n, 6) of each edge as (x, y, depth, x, y, depth), and the number of its object."""
    numbers = [number for number, thing in enumerate(scene.objects) if thing.visible]
    parts, owners = [np.zeros((0, 6))], [np.zeros(0, np.int64)]
    things = placed(scene)
    corners = sum(len(mesh.faces.corners) for mesh, *_rest in things)
    # Two faces at most meet at nearly every edge: far too many need not be told apart.
    if corners > 4 * MOST_EDGES or sum(len(lasting.edges) for *_rest, lasting in things) > MOST_EDGES:
        return parts[0], owners[0]
    for number, (mesh, *_rest, lasting) in zip(numbers, things, strict=True):
        begin, end, _of = clip_segments(viewpoint.homogeneous(mesh.vertices), lasting.edges, DEPTH_PLANES)
        good = (begin[:, 3] > LEAST_W) & (end[:, 3] > LEAST_W)
        parts.append(np.concatenate([_on_device(viewpoint, each[good]) for each in (begin, end)], axis=1))
        owners.append(np.full(len(parts[-1]), number))
    return np.concatenate(parts), np.concatenate(owners)


def _on_device(viewpoint: Viewpoint, points: Array) -> Array:
    x, y, z = (points[:, :3] / points[:, 3:]).T
    device = viewpoint.device
    return np.stack([x * device[0, 0] + device[0, 2], y * device[1, 1] + device[1, 2], z], axis=1)


def _split(ends: Array, depth: Array) -> tuple[Array, Index, NDArray[np.bool_]]:
    """Edges cut where the depth buffer begins or ceases to hide them: the parts (n, 4), of which edge each
    is, and whether it is seen."""
    if not len(ends):
        return ends[:, :4], np.zeros(0, np.int64), np.zeros(0, np.bool_)
    height, width = depth.shape
    begin, end = ends[:, :3], ends[:, 3:]
    lengths = np.abs(end - begin)[:, :2].max(axis=1)
    counts = np.clip(np.ceil(lengths), 1, _LONGEST_PX).astype(np.int64) + 1
    if counts.sum() > _MOST_SAMPLES:
        counts = np.maximum(counts * _MOST_SAMPLES // counts.sum(), 2)
    of = np.repeat(np.arange(len(ends)), counts)
    firsts = np.cumsum(counts) - counts
    share = (np.arange(len(of)) - firsts[of]) / (counts[of] - 1)
    x, y, z = (begin[of] + share[:, None] * (end - begin)[of]).T
    column, row = np.floor(x + 0.5), np.floor(y + 0.5)
    within = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    column, row = (np.where(within, each, 0).astype(np.int64) for each in (column, row))
    seen = ~within | (z <= _farthest_around(depth, row, column) + _SLACK)
    begins = np.flatnonzero((np.diff(of, prepend=-1) != 0) | (np.diff(seen, prepend=seen[:1]) != 0))
    after = np.append(begins[1:], len(of))
    # A part reaches to where the next one of the same edge begins.
    last = np.where((after < len(of)) & (of[np.minimum(after, len(of) - 1)] == of[begins]), after, after - 1)
    parts = np.stack([x[begins], y[begins], x[last], y[last]], axis=1)
    return parts, of[begins], seen[begins]


def _farthest_around(depth: Array, row: Index, column: Index) -> Array:
    """The greatest depth at pixels and their eight neighbours, so that no face hides its own edge."""
    height, width = depth.shape
    farthest = np.where((row % max(height - 1, 1) == 0) | (column % max(width - 1, 1) == 0), np.inf, 0.0)
    for down in (-1, 0, 1):
        for right in (-1, 0, 1):
            beside = depth[np.clip(row + down, 0, height - 1), np.clip(column + right, 0, width - 1)]
            farthest = np.maximum(farthest, beside)
    return farthest
