"""Triangles through the depth buffer, in bands of rows on two threads."""

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import cache
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.visibility import depth_front_first, depth_tiles
from workbench.algorithms.visibility.depth_front_first import depth_buffer_front_first
from workbench.algorithms.visibility.depth_tiles import depth_buffer_tiles
from workbench.engine.at_hand import at_hand
from workbench.engine.compiled import Stop, Stopped, paint, ready_on
from workbench.language import _

T = TypeVar("T")
Text = Callable[..., Iterator[tuple[Any, ...]]]

THREADS = 2
_FEW_ITEMS = 4_096
_MANY_TRIANGLES = 10_000  # each band of rows looks at all of them; of fewer, more bands share better
FARTHEST = 1.0


def depth_buffer_triangles(
    vertices: ArrayLike,
    faces: ArrayLike,
    colours: ArrayLike,
    size: tuple[int, int],
    stop: Stop | None = None,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Draw triangles in any order; at each pixel the nearest wins, on equal depths the first.

    The picture is that of ``depth_buffer``, to the last bit.

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
    return _drawn(*_checked(vertices, faces, colours), size, stop, False)


def drawn(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    colours: NDArray[np.int64],
    size: tuple[int, int],
    stop: Stop | None = None,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """The same of a scene's triangles, which are known to be sound. Raises: Stopped.

    Of many, most are those of solids, counter-clockwise seen from outside.
    """
    return _drawn(points, corners, colours, size, stop, len(corners) > _MANY_TRIANGLES)


def _drawn(
    points: NDArray[np.float64],
    corners: NDArray[np.int64],
    colours: NDArray[np.int64],
    size: tuple[int, int],
    stop: Stop | None,
    front_first: bool,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    width, height = size
    image, depth = np.empty((height, width), np.uint32), np.empty((height, width))

    def draw(low_row: int, end_row: int) -> None:
        band, nearest = image[low_row:end_row], depth[low_row:end_row]

        def clear() -> None:
            band.fill(0)  # here, as what was just written is at hand
            nearest.fill(FARTHEST)

        clear()
        if front_first:
            ties = np.zeros(1, np.int64)
            paint(depth_buffer_front_first, band, 0, band, nearest, ties, points, corners, colours, low_row)
            if not ties[0]:
                return
            clear()
        paint(depth_buffer_tiles, band, 0, band, nearest, points, corners, colours, None, 0.0, low_row)

    in_bands(height, draw, stop, bands_for(len(corners)))
    return image, depth


def are_drawn_at_once() -> bool:
    """Whether triangles are drawn without compiling anything before."""
    return ready_on(depth_buffer_tiles, *depth_tiles.EXAMPLE) and ready_on(
        depth_buffer_front_first, *depth_front_first.EXAMPLE
    )


def bands_for(triangles: int) -> int:
    """How many bands of rows so many triangles are drawn in."""
    return THREADS if triangles > _MANY_TRIANGLES else 2 * THREADS


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


@cache
def _threads() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(THREADS, thread_name_prefix="triangles")


def begin(work: Callable[..., T], *arguments: Any) -> "Future[T]":
    """Do a work on one of the threads that work at triangles; none may wait for another.

    Raises: Stopped, where the program ends and its threads take no more work.
    """
    try:
        return _threads().submit(work, *arguments)
    except RuntimeError as ended:
        raise Stopped from ended


def in_bands(
    height: int, do: Callable[[int, int], None], stop: Stop | None, count: int = 2 * THREADS
) -> None:
    """Do something to ``count`` bands of rows, given the first and the end of each, on all threads.

    The thread that asks does the last one. Raises: Stopped, also as ``begin`` does; bands that were begun are
    finished first.
    """

    def unless_stopped(low: int, high: int) -> None:
        if stop is not None and stop.is_set:
            raise Stopped
        do(low, high)

    edges = [height * band // count for band in range(count + 1)]
    spans = [(low, high) for low, high in pairwise(edges) if low < high]
    bands = [begin(unless_stopped, low, high) for low, high in spans[:-1]]
    try:
        for low, high in spans[-1:]:
            unless_stopped(low, high)
    finally:
        wait(bands)
    for band in bands:
        band.result()


def written_in_shares(count: int, text: Text, share: Callable[[int, int], tuple[Any, ...]]) -> None:
    """Run a text on all of ``count`` items, on each thread a share of them.

    ``share`` gives its arguments, the first of which is written, for the items from the first to the end. Few
    items are done at once, and wait for no compiler; nor does an interface for one that is not loaded.
    """
    few = count <= _FEW_ITEMS
    here = few and threading.current_thread() is threading.main_thread()
    flavour = "interpreted" if here and not at_hand(text, "run") else ""

    def do(first: int, end: int) -> None:
        arguments = share(first, end)
        paint(text, arguments[0], 0, *arguments, compiling=not few, flavour=flavour)

    in_bands(count, do, None, 1 if few else THREADS)
