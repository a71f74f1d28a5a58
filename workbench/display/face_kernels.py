"""The tube's frame at the speed of its memory: the same sums as in NumPy, row by row, without arrays between.

Each text writes its first argument in place. Arrays are float32 with two axes; those of several terms or
layers have their rows one block below the other. Until they are compiled NumPy serves (see ``at_hand``).
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.engine.at_hand import at_hand as known

Array = NDArray[Any]

LOWEST = np.float32(1e-6)
"""Added and taken away again it makes denormal numbers, which are a hundred times slower, 0."""


def spread_rows(
    spread: Array, drive: Array, aging: Array, along: Array, reach: Array
) -> Iterator[tuple[int, int]]:
    """Spread each row of a picture along the face, once for each row of ``aging``.

    Args: spread (ages * rows, face columns), written; drive (rows, columns); aging (ages, columns), what is
    left of a pixel at the end of its row; along (columns, face columns), its spot; reach (columns, 2), where
    that is not 0. Emits: (age, row).
    """
    rows, columns = drive.shape
    for age in range(len(aging)):
        for row in range(rows):
            onto = spread[age * rows + row]
            onto[:] = 0.0
            for x in range(columns):
                value = drive[row, x] * aging[age, x]
                if value > 0.0:
                    near = onto[reach[x, 0] : reach[x, 1]]
                    shape = along[x, reach[x, 0] : reach[x, 1]]
                    for column in range(len(near)):
                        near[column] += value * shape[column]
            yield age, row


def gather_rows(
    face: Array, spread: Array, age: int, kept: Array, across: Array, bands: Array
) -> Iterator[tuple[int, int]]:
    """What the rows of a picture leave on the rows of the face.

    Args: face (face rows, face columns), written; spread as ``spread_rows`` wrote it; which age of it; kept
    (1, rows), what is left of each row; across (face rows, rows), its spot; bands (face rows, 2), the rows
    that reach a row of the face. Emits: (face row, 0).
    """
    rows = kept.shape[1]
    for y in range(len(face)):
        onto = face[y]
        onto[:] = 0.0
        for row in range(bands[y, 0], bands[y, 1]):
            weight = across[y, row] * kept[0, row]
            if weight > 0.0:
                given = spread[age * rows + row]
                for x in range(len(onto)):
                    onto[x] += given[x] * weight
        yield y, 0


def refresh_face(
    stored: Array,
    light: Array,
    spread: Array,
    kept: Array,
    across: Array,
    bands: Array,
    factors: Array,
    layers: Array,
    shares: Array,
    lit_ends: Array,
    lowest: Array,
) -> Iterator[tuple[int, int]]:
    """Let time pass on the face, and add what the rows scanned meanwhile have left and given off.

    Args: stored (terms * face rows, face columns), the luminance of each term, written; light (layers * face
    rows, face columns), what was given off, written; spread, across and bands as ``gather_rows`` takes them,
    spread with age 0 for all energy and one age for each term; kept (1 + terms, rows), how much of each row
    fell, and of each term is left; factors (terms, 4): what a term keeps, what its light gives off, luminance
    for stored energy, energy for stored luminance; layers (terms,); shares (layers, 1), of the energy;
    lit_ends (rows, 2), where a row of age 0 is not dark; lowest (1, 1). Emits: (face row, 0).
    """
    face_rows = len(bands)
    rows = kept.shape[1]
    low = lowest[0, 0]
    for y in range(face_rows):
        for term in range(len(factors)):
            keeps, gives = factors[term, 0], factors[term, 1]
            state = stored[term * face_rows + y]
            lit = light[layers[term] * face_rows + y]
            for x in range(len(state)):
                lit[x] += state[x] * gives
                state[x] = state[x] * keeps + low - low
        for row in range(bands[y, 0], bands[y, 1]):
            fell = across[y, row] * kept[0, row]
            begin, end = lit_ends[row, 0], lit_ends[row, 1]
            if fell > 0.0 and end > begin:
                energy = spread[row, begin:end]
                for layer in range(len(shares)):
                    lit = light[layer * face_rows + y, begin:end]
                    share = fell * shares[layer, 0]
                    for x in range(len(energy)):
                        lit[x] += energy[x] * share
                for term in range(len(factors)):
                    left = across[y, row] * kept[term + 1, row] * factors[term, 2]
                    back = factors[term, 3]
                    state = stored[term * face_rows + y, begin:end]
                    lit = light[layers[term] * face_rows + y, begin:end]
                    remains = spread[(term + 1) * rows + row, begin:end]
                    for x in range(len(state)):
                        still = remains[x] * left
                        state[x] += still
                        lit[x] -= still * back
        yield y, 0


def shrink_rows(small: Array, light: Array, down: Array, bands: Array) -> Iterator[tuple[int, int]]:
    """Light on few rows: small (few, columns), written; light (rows, columns); down (few, rows); bands
    (rows, 2), the few that a row gives to. Emits: (row, 0).
    """
    small[:, :] = 0.0
    for y in range(len(light)):
        given = light[y]
        for j in range(bands[y, 0], bands[y, 1]):
            onto = small[j]
            weight = down[j, y]
            for x in range(len(given)):
                onto[x] += given[x] * weight
        yield y, 0


def print_picture(
    picture: Array,
    glow: Array,
    light: Array,
    halo: Array,
    up: Array,
    bands: Array,
    noise: Array,
    table: Array,
    scale: Array,
) -> Iterator[tuple[int, int]]:
    """The picture of one colour: light and its halo, through the square root, dithered, through the table.

    Args: picture, integers (rows, columns), top row first, written; glow (1, columns), room for a row; light
    (rows, columns), row 0 at the bottom; halo (rows, few); up (few, columns); bands (few, 2); noise (rows,
    columns); table (1, n); scale (1, 3), steps for a root of 1, the last step, the least light.
    Emits: (row, 0).
    """
    rows, columns = light.shape
    steps, last, dark = scale[0, 0], scale[0, 1], scale[0, 2]
    row = glow[0]
    colours = table[0]
    for y in range(rows):
        given = light[y]
        for x in range(columns):
            row[x] = max(given[x], dark)
        for i in range(halo.shape[1]):
            around = halo[y, i]
            near = row[bands[i, 0] : bands[i, 1]]
            shape = up[i, bands[i, 0] : bands[i, 1]]
            for x in range(len(near)):
                near[x] += around * shape[x]
        grain = noise[y]
        for x in range(columns):
            row[x] = math.sqrt(row[x]) * steps + grain[x]
        for x in range(columns):
            row[x] = min(row[x], last)
        onto = picture[rows - 1 - y]
        for x in range(columns):
            onto[x] = colours[np.uint32(row[x])]
        yield y, 0


TEXTS = spread_rows, gather_rows, refresh_face, shrink_rows, print_picture


def at_hand() -> bool:
    """Whether all of them have run compiled in this process, so that they can be used without a wait."""
    return all(known(text, "run") for text in TEXTS)


def run(text: Any, written: Array, *arguments: Any) -> None:
    """Run a text, which writes ``written`` and takes it first."""
    from workbench.engine.compiled import paint

    paint(text, written, 0, written, *arguments)


def compile_all() -> None:
    """Run each on next to nothing, which compiles it, or loads what was compiled before."""
    ones, counts = np.ones((2, 2), np.float32), np.array([(0, 2), (0, 2)])
    run(spread_rows, ones.copy(), ones, ones[:1].copy(), ones, counts)
    run(gather_rows, ones.copy(), ones, 0, ones[:1].copy(), ones, counts)
    factors = np.ones((1, 4), np.float32)
    two = np.ones((4, 2), np.float32)
    layers, lowest, shares = np.zeros(1, np.int64), np.array([[LOWEST]]), ones[:1, :1].copy()
    run(
        refresh_face,
        ones.copy(),
        ones.copy(),
        two,
        ones,
        ones,
        counts,
        factors,
        layers,
        shares,
        counts,
        lowest,
    )
    run(shrink_rows, ones.copy(), ones, ones, counts)
    picture, table = np.zeros((2, 2), np.uint32), np.zeros((1, 9), np.uint32)
    run(
        print_picture,
        picture,
        ones[:1].copy(),
        ones,
        ones,
        ones,
        counts,
        ones,
        table,
        np.ones((1, 3), np.float32),
    )
