"""Triangles through the depth buffer, in bands of rows on two threads."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.visibility.depth_buffer import depth_buffer
from workbench.engine.compiled import Stop, Stopped, paint
from workbench.language import _

THREADS = 2
# Every band of rows beyond the first costs a copy of the vertices; of few vertices, more bands share better.
_FEW_VERTICES = 20_000
_AT_ONCE = 1 << 16  # triangles, whose copies for a band take little memory
FARTHEST = 1.0


def depth_buffer_triangles(
    vertices: ArrayLike,
    faces: ArrayLike,
    colours: ArrayLike,
    size: tuple[int, int],
    stop: Stop | None = None,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Draw triangles in any order; at each pixel the nearest wins, on equal depths the first.

    The picture is that of ``depth_buffer``, to the last bit where y is on a grid of 1/4096 px, to which the
    pipeline snaps it.

    Args: vertices (n, 3), x and y in pixels, y upwards, z from 0 (near) to 1 (far); faces (m, 3), indices of
    vertices; colours (m,), 0xRRGGBB; size (width, height) in pixels. Returns the picture (height, width), 0
    where nothing was drawn, and the depth there, 1 where nothing was drawn.

    Raises:
        ValueError: a shape, an index or a number is wrong; the sentence names it.
        Stopped: ``stop`` was set; bands that were begun are finished first.
    """
    width, height = size
    if width < 1 or height < 1:
        raise ValueError(
            _("size is {width} x {height}; both must be 1 or more").format(width=width, height=height)
        )
    return drawn(*_checked(vertices, faces, colours), size, stop)


def drawn(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    colours: NDArray[np.int64],
    size: tuple[int, int],
    stop: Stop | None = None,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """The same of triangles that are known to be sound. Raises: Stopped."""
    width, height = size
    image = np.zeros((height, width), np.uint32)
    depth = np.full((height, width), FARTHEST)
    bands = THREADS if len(points) > _FEW_VERTICES else 2 * THREADS
    edges = [height * band // bands for band in range(bands + 1)]
    y = points[:, 1]

    def draw(low_row: int, end_row: int) -> None:
        """Draw what reaches these rows into them, as a picture of its own that begins at ``low_row``."""
        if stop is not None and stop.is_set:
            raise Stopped
        reaching = np.flatnonzero(_any_corner(y > low_row, corners) & _any_corner(y < end_row, corners))
        shifted = points - (0.0, low_row, 0.0) if low_row else points
        band, nearest = image[low_row:end_row], depth[low_row:end_row]
        for start in range(0, len(reaching), _AT_ONCE):
            some = reaching[start : start + _AT_ONCE]
            reached = corners.take(some, axis=0), colours.take(some)
            paint(depth_buffer, band, 0, band, nearest, shifted, *reached)

    _finish([threads().submit(draw, low, high) for low, high in pairwise(edges)])
    return image, depth


def _checked(
    vertices: ArrayLike, faces: ArrayLike, colours: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
    points = np.ascontiguousarray(vertices, np.float64)
    corners = np.ascontiguousarray(faces, np.int64)
    colour = np.ascontiguousarray(colours, np.int64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(_("vertices need three numbers each: x, y, z"))
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(_("faces need three indices each"))
    if colour.shape != (len(corners),):
        raise ValueError(_("colours need one number for each face"))
    if not np.isfinite(points).all():
        raise ValueError(_("vertices must be finite"))
    if corners.size and not 0 <= corners.min() <= corners.max() < len(points):
        raise ValueError(_("faces name a vertex that does not exist"))
    return points, corners, colour


def _any_corner(of_point: NDArray[np.bool_], corners: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which triangles (m, 3) have a corner of which this is true."""
    of_corner = of_point.take(corners)
    return of_corner[:, 0] | of_corner[:, 1] | of_corner[:, 2]  # ten times as fast as along the rows


@cache
def threads() -> ThreadPoolExecutor:
    """What works at triangles; nothing that runs there may wait for another that does."""
    return ThreadPoolExecutor(THREADS, thread_name_prefix="triangles")


def in_bands(height: int, do: Callable[[int, int], None], stop: Stop | None) -> None:
    """Do something to bands of rows, given the first and the end of each, on all threads.

    Raises: Stopped, also where the program ends and its threads take no more work; bands that were begun are
    finished first.
    """

    def unless_stopped(low: int, high: int) -> None:
        if stop is not None and stop.is_set:
            raise Stopped
        do(low, high)

    edges = [height * band // (2 * THREADS) for band in range(2 * THREADS + 1)]
    try:
        bands = [threads().submit(unless_stopped, low, high) for low, high in pairwise(edges) if low < high]
    except RuntimeError as ended:
        raise Stopped from ended
    _finish(bands)


def _finish(bands: list[Future[Any]]) -> None:
    wait(bands)
    for band in bands:
        band.result()
