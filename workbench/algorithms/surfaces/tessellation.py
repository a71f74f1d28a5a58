"""Surfaces as triangles within a tolerance, without cracks.

The parameter rectangle is cut by whole lines, so that triangles share their corners, and lines are added
until every cell is near enough to its two triangles. That is proved, not sampled: a cell differs from the
bilinear surface over its corners, with their weights, by a surface whose control points can be written down,
and that one from its triangles by a quarter of its twist, or half of it where the weights are no products.
Source: Filip, Magedson and Markot, Surface algorithms using bounds on derivatives, 1986, for the twist.
"""

from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.surfaces.patches import Patches
from workbench.geometry.curves.halving import halves, lengths
from workbench.geometry.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

MOST_CELLS = 250_000
_TELLING = 1_024
"""Cells, from which on halving one leaves no less than about a quarter of its error: its distance from its
chord goes with the square of its side, its twist with the side. So bringing an error e to the tolerance t
takes log4(e / t) halvings or more; each makes two cells of one, and they become sqrt(e / t) or more. The sum
of these over all cells refuses only from twice the limit on, since "about a quarter" is no proof."""
NEAREST = 1e-12  # of the size of the surface: nearer than this rounding errors are all that is left


def tessellate(patches: Patches, tolerance: float) -> tuple[Array, Faces]:
    """Vertices (n, 3) and triangles (m, 3) nowhere farther than ``tolerance`` from the surface.

    Corners lie on the surface; triangles are counter-clockwise seen from where the normals point to. Edges
    that meet, as where a cylinder closes, share their corners; what has no area, as at a pole, is left out.
    Raises: ValueError for a tolerance that is not above 0, or that would take more than 250,000 cells.
    """
    refuse_tolerance(tolerance)
    cells = patches.nets
    size = float(np.abs(cells[..., :3] / cells[..., 3:]).max())
    least = max(tolerance, NEAREST * size)
    bad = np.ones(cells.shape[:2], bool)
    while True:
        errors = _bounds(cells[bad][None])[0]
        bad[bad] = errors > least  # what is near enough stays so when it is cut
        if not bad.any():
            return _triangles(_corners(cells), 1e-9 * size)
        if bad.size >= _TELLING and np.sqrt(errors / least).sum() > 2 * MOST_CELLS:
            raise _too_fine(tolerance)
        in_u = np.zeros_like(bad)
        by_u, by_v = _bends(cells[bad][None])
        in_u[bad] = (by_u >= by_v)[0]
        rows, columns = np.any(bad & in_u, axis=1), np.any(bad & ~in_u, axis=0)
        count = (len(rows) + int(rows.sum())) * (len(columns) + int(columns.sum()))
        if count > MOST_CELLS:
            raise _too_fine(tolerance)
        bad = np.repeat(np.repeat(bad, 1 + rows, axis=0), 1 + columns, axis=1)
        cells = _cut(cells, rows)
        cells = _cut(cells.transpose(1, 0, 3, 2, 4), columns).transpose(1, 0, 3, 2, 4)


def _too_fine(tolerance: float) -> ValueError:
    sentence = f"Within {tolerance:g} the surface would take more than {MOST_CELLS:,} cells"
    return ValueError(f"{sentence}; choose a larger tolerance.")


def _bounds(cells: Array) -> Array:
    """How far at most each cell (m, n) is from its two triangles."""
    p, q = cells.shape[2] - 1, cells.shape[3] - 1
    points, weights = cells[..., :3], cells[..., 3:]
    pulls = weights[:, :, [0, -1]][:, :, :, [0, -1]]
    ends = (points / weights)[:, :, [0, -1]][:, :, :, [0, -1]]
    apart = np.zeros((*cells.shape[:2], p + 2, q + 2, 3))
    over = np.zeros((*cells.shape[:2], p + 2, q + 2, 1))
    for a in (0, 1):
        for b in (0, 1):
            rows = np.array([comb(p, i) / comb(p + 1, i + a) for i in range(p + 1)])[:, None, None]
            columns = np.array([comb(q, j) / comb(q + 1, j + b) for j in range(q + 1)])[:, None]
            share = rows * columns * pulls[:, :, a, b, None, None]
            here = np.s_[:, :, a : a + p + 1, b : b + q + 1]
            apart[here] += share * (points - ends[:, :, a, b, None, None] * weights)
            over[here] += share * weights
    crossed = (pulls[:, :, 0, 0] * pulls[:, :, 1, 1], pulls[:, :, 0, 1] * pulls[:, :, 1, 0])
    plain = np.isclose(*crossed, rtol=1e-9, atol=0)[..., 0]
    errors: Array = lengths(apart / over).max(axis=(2, 3)) + np.where(plain, 0.25, 0.5) * _twists(ends)
    return errors


def _bends(cells: Array) -> tuple[Array, Array]:
    """How far the control points of each cell (m, n) bend away from chords in u, and in v.

    A twist is taken for a bend along the longer side.
    """
    points = cells[..., :3] / cells[..., 3:]
    found, sides = [], []
    for axis in (2, 3):
        legs = points - np.take(points, [0], axis=axis)
        chord = np.take(legs, [-1], axis=axis)
        square = (chord * chord).sum(axis=-1, keepdims=True)
        along = (legs * chord).sum(axis=-1, keepdims=True)
        share = np.divide(along, square, out=np.zeros_like(along), where=square > 0)
        found.append(lengths(legs - share * chord).max(axis=(2, 3)))
        sides.append(square.max(axis=(2, 3, 4)))
    twist, longer = 0.25 * _twists(points), sides[0] >= sides[1]
    return found[0] + twist * longer, found[1] + twist * ~longer


def _twists(points: Array) -> Array:
    """How far the corners of nets (m, n, p+1, q+1, 3) are from making a parallelogram."""
    return lengths(points[:, :, 0, 0] - points[:, :, 0, -1] - points[:, :, -1, 0] + points[:, :, -1, -1])


def _cut(cells: Array, chosen: NDArray[Any]) -> Array:
    """The cells (m, n, p+1, q+1, 4) with the chosen rows (m,) halved in u."""
    if not chosen.any():
        return cells
    picked = np.moveaxis(cells[chosen], 2, 1)
    flat = halves(picked.reshape(*picked.shape[:2], -1)).reshape(-1, *picked.shape[1:])
    halved = iter(np.moveaxis(flat, 1, 2))
    parts = [[next(halved), next(halved)] if cut else [row] for row, cut in zip(cells, chosen, strict=True)]
    return np.stack([row for part in parts for row in part])


def _corners(cells: Array) -> Array:
    """The corners of all cells as a grid (m+1, n+1, 3)."""
    points = cells[..., :3] / cells[..., 3:]
    inner = np.concatenate([points[:, :, 0, 0], points[-1:, :, -1, 0]])
    outer = np.concatenate([points[:, -1, 0, -1], points[-1:, -1, -1, -1]])
    quads: Array = np.concatenate([inner, outer[:, None]], axis=1)
    return quads


def _triangles(grid: Array, near: float) -> tuple[Array, Faces]:
    """Vertices and triangles of a grid; points of its border that are ``near`` to each other become one."""
    m, n = grid.shape[:2]
    points, number = grid.reshape(-1, 3), np.arange(m * n)
    at = number.reshape(m, n).copy()
    sides = [at[0], at[-1], at[:, 0], at[:, -1]]
    meeting = [(at[0], at[-1]), (at[:, 0], at[:, -1]), *((side[:-1], side[1:]) for side in sides)]
    for one, other in meeting:
        same = lengths(points[one] - points[other]) <= near
        for a, b in zip(one[same].tolist(), other[same].tolist(), strict=True):
            number[_root(number, max(a, b))] = _root(number, min(a, b))
    border = np.unique(np.concatenate(sides))
    number[border] = [_root(number, k) for k in border.tolist()]
    a, b, c, d = (number[part].ravel() for part in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]))
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    full = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    used, compact = np.unique(faces[full], return_inverse=True)
    return points[used], compact.reshape(-1, 3).astype(np.int64)


def _root(number: Faces, k: int) -> int:
    """The point that k was joined to, in the end."""
    while number[k] != k:
        k = int(number[k])
    return k
