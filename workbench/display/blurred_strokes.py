"""Strokes on a face as rows of dots that are blurred: the whole list without the compiled text.

It stands in for ``beam_strokes`` until that is compiled. A dot is shared by the nine pixels around it, as a
quadratic B-spline is: a quarter of a square pixel wide wherever it lies. What that lacks of the width of the
spot comes from blurring rows and columns.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SPACING = 1.5  # in widths of the spot, which leaves no beads
_MOST_DOTS = 200_000
_AT_ONCE = 100_000
_SHARED_VARIANCE = 0.25
_NEAR = 4.0
_NARROWEST = 0.54

Floats = NDArray[np.float64]


def blur_strokes(face: Floats, strokes: NDArray[Any], sigma_px: float, of_all: float = 1.0) -> None:
    """Add to a face (h, w) what strokes (n, 5) leave: x0, y0, x1, y1 in pixels, and their energy.

    ``of_all``: their share of a list, which has so many dots at most, however often parts of it are drawn.
    A spot narrower than ``_NARROWEST`` is drawn that wide.
    """
    sigma_px = max(sigma_px, _NARROWEST)
    ways = strokes[:, 2:4] - strokes[:, 0:2]
    lengths = np.hypot(*ways.T)
    spacing = max(_SPACING * sigma_px, float(lengths.sum()) / (_MOST_DOTS * of_all))
    counts = np.maximum(np.ceil(lengths / spacing), 1).astype(np.int64)
    taps = _taps(math.sqrt(sigma_px * sigma_px - _SHARED_VARIANCE))
    margin = len(taps) // 2
    rows, columns = (side + 2 * margin for side in face.shape)
    sharp = np.zeros((rows, columns))
    ends = np.cumsum(counts)
    first = 0
    while first < len(strokes):
        last = max(int(np.searchsorted(ends, ends[first] + _AT_ONCE)), first + 1)
        part = counts[first:last]
        of = np.repeat(np.arange(first, last), part)
        number = np.arange(len(of)) - np.repeat(np.cumsum(part) - part, part)
        share = (number + 0.5) / counts[of]
        x, y = (strokes[of, 0:2] + ways[of] * share[:, None] + margin).T
        _share_dots(sharp, x, y, strokes[of, 4] / counts[of])
        first = last
    face += _blurred(_blurred(sharp, taps).T, taps).T


def _share_dots(sharp: Floats, x: Floats, y: Floats, energy: Floats) -> None:
    """Add dots, each to the nine pixels around it; those that reach beyond are left out."""
    rows, columns = sharp.shape
    column, row = np.rint(x).astype(np.int64), np.rint(y).astype(np.int64)
    inside = (column > 0) & (column < columns - 1) & (row > 0) & (row < rows - 1)
    column, row = column[inside], row[inside]
    across, upwards = _weights(x[inside] - column), _weights(y[inside] - row)
    at = row * columns + column
    flat = sharp.reshape(-1)
    for up, of_row in zip((-columns, 0, columns), upwards, strict=True):
        given = of_row * energy[inside]
        for right, of_column in zip((-1, 0, 1), across, strict=True):
            flat += np.bincount(at + up + right, given * of_column, sharp.size)


def _weights(offset: Floats) -> tuple[Floats, Floats, Floats]:
    """Of the pixels before, at and behind, for what lies ``offset`` (-1/2 to 1/2) from the middle one."""
    return 0.5 * (0.5 - offset) ** 2, 0.75 - offset * offset, 0.5 * (0.5 + offset) ** 2


def _taps(sigma_px: float) -> Floats:
    reach = math.ceil(_NEAR * sigma_px)
    taps: Floats = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma_px) ** 2)
    taps /= taps.sum()
    return taps


def _blurred(rows: Floats, taps: Floats) -> Floats:
    """Each row blurred, without its margins."""
    length = rows.shape[1] - len(taps) + 1
    blurred = np.zeros((rows.shape[0], length))
    for shift, weight in enumerate(taps):
        blurred += weight * rows[:, shift : shift + length]
    return blurred
