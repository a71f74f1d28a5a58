"""A chain stage by stage: every elementary transformation with its symbols, and the products up to it.

Stage 0 is the figure as it was drawn; stage k is what the first k elementary transformations have made of it.
"""

from collections import Counter
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix, SymbolicMatrix
from workbench.algorithms.transforms.symbols import scaling_by, translation_by
from workbench.algorithms.transforms.terms import constant, place
from workbench.document.transforms.links import (
    Affine,
    AnyLink,
    Elementary,
    Reflect,
    Rotate,
    Scale,
    Shear,
    Translate,
)

Entries = dict[tuple[int, int], tuple[str, float]]
"""Row and column of a cell that holds a number of the link: the attribute, and the sign before it."""

_TRANSLATION: Entries = {(0, 2): ("tx", 1.0), (1, 2): ("ty", 1.0)}
_SCALING: Entries = {(0, 0): ("sx", 1.0), (1, 1): ("sy", 1.0)}
_SHEAR: Entries = {(0, 1): ("sh_x", 1.0), (1, 0): ("sh_y", 1.0)}
_AFFINE: Entries = {(i, j): (f"m{i + 1}{j + 1}", 1.0) for i in range(2) for j in range(3)}


class Stage(NamedTuple):
    """One elementary transformation of ``link``, the ``part``-th of its ``parts`` from 0; ``number`` counts
    those of the chain from 1. ``entries`` are the cells of its matrix that are numbers of the link.
    """

    number: int
    link: AnyLink
    part: int
    parts: int
    elementary: Elementary
    symbols: SymbolicMatrix
    entries: Entries


def stages(chain: Iterable[AnyLink]) -> list[Stage]:
    """The stages of the links that are on, in the order in which they act."""
    return list(_stages(tuple(link for link in chain if link.on)))


@lru_cache(maxsize=256)
def _stages(acting: tuple[AnyLink, ...]) -> tuple[Stage, ...]:
    kinds = Counter(type(link) for link in acting)
    seen: Counter[type] = Counter()
    made: list[Stage] = []
    for link in acting:
        seen[type(link)] += 1
        index = str(seen[type(link)]) if kinds[type(link)] > 1 else ""
        parts = link.unfolded()
        for part, (elementary, (symbols, entries)) in enumerate(
            zip(parts, _symbolic(link, index), strict=True)
        ):
            made.append(Stage(len(made) + 1, link, part, len(parts), elementary, symbols, entries))
    return tuple(made)


def products(of: list[Stage]) -> list[Matrix]:
    """The matrix (3, 3) up to each stage, the last that of the chain.

    Every cell is added from the left, as the text that is stepped adds it, so that both show the same.
    """
    matrices: list[Matrix] = []
    with np.errstate(over="ignore", invalid="ignore"):
        for stage in of:
            matrix = stage.elementary.matrix
            matrices.append(_times(matrix, matrices[-1]) if matrices else matrix)
    return matrices


def _times(a: Matrix, b: Matrix) -> Matrix:
    product: Matrix = a[:, :1] * b[:1] + a[:, 1:2] * b[1:2] + a[:, 2:] * b[2:]
    return product


def _symbolic(link: AnyLink, index: str) -> Iterator[tuple[SymbolicMatrix, Entries]]:
    """The matrices of a link as the course writes them, one for each that it unfolds into, in their order."""
    match link:
        case Translate():
            yield transforms.symbolic_translation(link.tx, link.ty, index), _TRANSLATION
        case Rotate():
            turn = transforms.symbolic_rotation(np.radians(link.angle), index)
            yield from _about(link, "pivot", (turn, {}), index)
        case Scale():
            yield from _about(
                link, "pivot", (transforms.symbolic_scaling(link.sx, link.sy, index), _SCALING), index
            )
        case Reflect(mirror="point"):
            yield from _about(link, "pivot", (scaling_by(constant(-1), constant(-1)), {}), index)
        case Reflect():
            mirrored = transforms.symbolic_reflection(0.0, 0.0, np.radians(link.angle), index)
            first, second, last = mirrored.cells
            nothing = constant(0)
            at_origin = mirrored._replace(cells=((*first[:2], nothing), (*second[:2], nothing), last))
            yield from _about(link, "pivot", (at_origin, {}), index)
        case Shear():
            slanted = transforms.symbolic_shear(link.sh_x, link.sh_y, index=index)
            first, second, last = slanted.cells
            nothing = constant(0)
            at_axes = slanted._replace(cells=((*first[:2], nothing), (*second[:2], nothing), last))
            yield from _about(link, "ref", (at_axes, _SHEAR), index)
        case Affine():
            yield transforms.symbolic_matrix(link.matrix, "G", index), _AFFINE


def _about(
    link: Rotate | Scale | Reflect | Shear, of: str, at_origin: tuple[SymbolicMatrix, Entries], index: str
) -> Iterator[tuple[SymbolicMatrix, Entries]]:
    """The fixed point brought to the origin, what happens there, and back; as ``links`` unfolds it."""
    x, y = (getattr(link, f"{axis}_{of}") for axis in "xy")
    if x == 0.0 and y == 0.0:
        yield at_origin
        return
    letter = "p" if of == "pivot" else of
    there_x, there_y = (
        place(f"{axis}_{letter}{index}" if len(letter + index) == 1 else f"{axis}_{{{letter}{index}}}", value)
        for axis, value in (("x", x), ("y", y))
    )
    entries: Entries = {(0, 2): (f"x_{of}", -1.0), (1, 2): (f"y_{of}", -1.0)}
    yield translation_by(-there_x, -there_y), entries
    yield at_origin
    yield translation_by(there_x, there_y), {cell: (name, 1.0) for cell, (name, _sign) in entries.items()}
