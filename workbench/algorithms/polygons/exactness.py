"""On which polygons the arithmetic of a scan-line fill decides each pixel as exact numbers do."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.polygons.row_crossings import next_vertices

_NEAR, _FAR = 2.0**14, 2.0**20
_PARTS = 2.0**16


def is_on_quarters(vertices: NDArray[Any], _ring_ends: Any, _closed: Any, _nonzero: Any) -> bool:
    """Whether all vertices lie on quarters of a pixel, and so near that rounding decides nothing."""
    return _on_parts(vertices, 4.0, _NEAR)


def has_exact_slopes(vertices: NDArray[Any], ring_ends: NDArray[Any], closed: Any, nonzero: Any) -> bool:
    """Whether that holds, and 1/m of each edge is a multiple of 2^-16: then every sum of them is exact."""
    if not is_on_quarters(vertices, ring_ends, closed, nonzero):
        return False
    after = next_vertices(vertices, ring_ends)
    dx, dy = (vertices[after, :2] - vertices[: len(after), :2]).T
    dx, dy = dx[dy != 0.0], dy[dy != 0.0]
    slopes = dx / dy
    return bool((slopes * dy == dx).all() and (slopes * _PARTS == np.floor(slopes * _PARTS)).all())


def is_whole(vertices: NDArray[Any], _ring_ends: Any, _closed: Any, _nonzero: Any) -> bool:
    """Whether all vertices are whole, within 2^20."""
    return _on_parts(vertices, 1.0, _FAR)


def _on_parts(vertices: NDArray[Any], parts: float, reach: float) -> bool:
    places = np.asarray(vertices, np.float64) * parts
    return bool((places == np.floor(places)).all() and (np.abs(places) <= parts * reach).all())
