"""The energy that a Gaussian spot leaves on the face, per pixel: the text ``beam_spot`` at once.

Two forms. Strokes in any direction are sampled at the pixel centres; that conserves energy to 2 exp(-2 pi^2
s^2) per axis, with s the spot's standard deviation in pixels: keep s >= 0.6. Rows of a raster are
integrated over the pixels in both directions and conserve it for any spot. The law that text and closed
form are equal: ``scanning/test_scanning.py::test_the_tube_deposits_what_the_text_says``.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.error_function import erf, erfc_scaled

Floats = NDArray[np.float64]

DWELL = 1e-4
"""A stroke shorter than this many standard deviations is a dwell, a round spot; that is 4e-10 off."""

_NEGLIGIBLE = 1e-9


@dataclass(frozen=True, slots=True)
class Patch:
    """What a stroke leaves in a box of the face; ``along``, ``across``: pixel centres in spot widths."""

    rows: slice
    columns: slice
    values: Floats
    along: Floats
    across: Floats
    length: float
    energy_per_pixel: float


def _span(low: float, high: float, pitch: float, count: int) -> slice:
    first = math.floor(low / pitch)
    last = math.ceil(high / pitch)
    return slice(min(max(first, 0), count), min(max(last, 0), count))


def stroke_energy(
    size_px: tuple[int, int],
    size_mm: tuple[float, float],
    start_mm: tuple[float, float],
    end_mm: tuple[float, float],
    spot_mm: float,
    energy: float,
    reach: float = 8.0,
) -> Patch:
    """Energy per pixel of a stroke at constant speed (millimetres); it sums to ``energy``."""
    pitch_x, pitch_y = size_mm[0] / size_px[0], size_mm[1] / size_px[1]
    (x0, y0), (x1, y1) = start_mm, end_mm
    margin = reach * spot_mm
    columns = _span(min(x0, x1) - margin, max(x0, x1) + margin, pitch_x, size_px[0])
    rows = _span(min(y0, y1) - margin, max(y0, y1) + margin, pitch_y, size_px[1])
    x = ((np.arange(columns.start, columns.stop) + 0.5) * pitch_x - x0) / spot_mm
    y = ((np.arange(rows.start, rows.stop) + 0.5) * pitch_y - y0) / spot_mm
    length_mm = math.hypot(x1 - x0, y1 - y0)
    length = length_mm / spot_mm
    cosine, sine = ((x1 - x0) / length_mm, (y1 - y0) / length_mm) if length_mm > 0.0 else (1.0, 0.0)
    along = x[None, :] * cosine + y[:, None] * sine
    across = y[:, None] * cosine - x[None, :] * sine
    area = pitch_x * pitch_y / (spot_mm * spot_mm)
    profile = np.exp(-0.5 * across * across) / math.sqrt(2.0 * math.pi)
    if length < DWELL:
        middle = along - 0.5 * length
        lengthwise = np.exp(-0.5 * middle * middle) / math.sqrt(2.0 * math.pi)
    else:
        lengthwise = (erf(along / math.sqrt(2.0)) - erf((along - length) / math.sqrt(2.0))) * (0.5 / length)
    return Patch(rows, columns, energy * area * profile * lengthwise, along, across, length, energy * area)


def stroke_remainder(patch: Patch, duration: float) -> Floats:
    """What of a stroke is still stored when the beam arrives, if all decays with one time constant.

    ``duration`` is the time of the stroke in time constants. The exponentially modified Gaussian exp(m (u -
    L) + m^2/2) [erfc((u - L + m)/sqrt 2) - erfc((u + m)/sqrt 2)] / (2 L), with m = duration / L and all
    lengths in spot widths, written with the scaled erfc wherever its factors would overflow.
    """
    if patch.length < DWELL:
        return patch.values * (-math.expm1(-duration) / duration)
    u, length = patch.along, patch.length
    rate = duration / length
    root = math.sqrt(2.0)
    profile = np.exp(-0.5 * patch.across * patch.across) / math.sqrt(2.0 * math.pi)

    def tail(offset: Floats, factor: float) -> Floats:
        argument = (offset + rate) / root
        ahead = argument > 0.0
        result = np.empty_like(offset)
        result[ahead] = erfc_scaled(argument[ahead]) * np.exp(-0.5 * offset[ahead] ** 2)
        behind = offset[~ahead]
        result[~ahead] = np.exp(rate * behind + 0.5 * rate * rate) * (1.0 - erf(argument[~ahead]))
        return result * factor

    lengthwise = (tail(u - length, 1.0) - tail(u, math.exp(-duration))) * (0.5 / length)
    return np.maximum(patch.energy_per_pixel * profile * lengthwise, 0.0)


def narrowed(values: NDArray[Any], kind: Any) -> NDArray[Any]:
    """Shares (0 to 1) as ``kind``; in float32 what is too small to matter becomes 0: denormals are slow."""
    if np.dtype(kind) == np.float32:
        values = np.where(np.abs(values) < _NEGLIGIBLE, 0.0, values)
    return np.ascontiguousarray(values, dtype=kind)


def _integral(z: Floats) -> Floats:
    """The integral of erf: z erf(z) + exp(-z^2) / sqrt(pi)."""
    return z * erf(z) + np.exp(-z * z) / math.sqrt(math.pi)


NEAR = 6.2, 8.6
"""How many standard deviations a spot is followed, in float32 and in float64: beyond lies less than 1e-9 of
it, or less than what a double can tell.
"""


def _near(low: Floats, high: Floats, edges: Floats, reach_mm: float) -> tuple[NDArray[np.int64], int]:
    """The first of the cells between ``edges`` that each stretch reaches, and how many at most."""
    first = np.clip(np.searchsorted(edges, low - reach_mm) - 1, 0, len(edges) - 2)
    last = np.clip(np.searchsorted(edges, high + reach_mm), 1, len(edges) - 1)
    return first, int((last - first).max())


def across_rows(centres: NDArray[Any], edges: NDArray[Any], spot: float, near: float = NEAR[1]) -> Floats:
    """Share of rows at ``centres`` (n,) that falls between ``edges`` (m + 1,): (m, n); one unit for all."""
    first, width = _near(centres, centres, edges, near * spot)
    cells = first[:, None] + np.arange(width + 1)
    there = cells[:, 1:] < len(edges)
    cells = np.minimum(cells, len(edges) - 1)
    shares = np.diff(0.5 * erf((edges[cells] - centres[:, None]) / (math.sqrt(2.0) * spot)), axis=1)
    return _scattered(shares, cells, there, len(edges) - 1).T


def along_row(cuts: NDArray[Any], edges: NDArray[Any], spot: float, near: float = NEAR[1]) -> Floats:
    """Share of each piece between ``cuts`` (n + 1,) that falls between ``edges`` (m + 1,): (m, n)."""
    width = math.sqrt(2.0) * spot
    first, count = _near(cuts[:-1], cuts[1:], edges, near * spot)
    cells = first[:, None] + np.arange(count + 1)
    there = cells[:, 1:] < len(edges)
    cells = np.minimum(cells, len(edges) - 1)
    begun, ended = (_integral((edges[cells] - cut[:, None]) / width) for cut in (cuts[:-1], cuts[1:]))
    shares = np.diff(begun - ended, axis=1) * (width / (2.0 * np.diff(cuts)[:, None]))
    return _scattered(shares, cells, there, len(edges) - 1).T


def _scattered(shares: Floats, cells: NDArray[np.int64], there: NDArray[np.bool_], count: int) -> Floats:
    """Shares (n, k) of the cells (n, k + 1) that are ``there``, in rows of all cells (n, count)."""
    whole = np.zeros((len(shares), count))
    rows = np.broadcast_to(np.arange(len(shares))[:, None], shares.shape)
    whole[rows[there], cells[:, :-1][there]] = shares[there]
    return whole


def ends(shares: NDArray[Any], least: float = 0.0) -> NDArray[np.int64]:
    """The first and the end of what is more than ``least`` in each row (n, 2); the same where nothing is."""
    there = shares > least
    first = there.argmax(axis=1)
    end = np.where(there.any(axis=1), shares.shape[1] - there[:, ::-1].argmax(axis=1), first)
    return np.ascontiguousarray(np.stack([first, end], axis=1), np.int64)
