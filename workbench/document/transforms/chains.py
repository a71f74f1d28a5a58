"""Chains of transforms: the matrix of a chain, what it is made of, and the way back.

The first link of a chain acts first; its matrix stands rightmost in the product. What is switched off is
left out.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from functools import cached_property, lru_cache
from itertools import chain
from operator import attrgetter
from typing import Any

import msgspec
import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix
from workbench.document.transforms.links import AnyLink, Elementary, Link, Reflect
from workbench.language import _

LARGEST = 1e12
"""The largest number in the matrix of a chain, of whatever sign."""

# Of the product of the lengths of all columns: what rounding leaves of a determinant that is 0.
_SINGULAR = 1e-14
_IDENTITY = np.eye(3)
_MANY, _AT_ONCE = 64, 4096  # figures: from how many on it pays, and so many that the stack stays small


@lru_cache(maxsize=1 << 14)
def matrix_of(links: tuple[Link, ...]) -> Matrix | None:
    """The matrix (3, 3), or (4, 4), of a chain, world to world, remembered; None where no link of it is on.

    It may have numbers that are not finite, which no document holds.
    """
    acting = [link.matrix for link in links if link.on]
    if not acting:
        return None
    with np.errstate(over="ignore", invalid="ignore"):
        matrix = np.ascontiguousarray(transforms.product(*reversed(acting)))
    matrix.setflags(write=False)
    return matrix


def unfolded(links: Iterable[AnyLink]) -> list[Elementary]:
    """The elementary transformations of the links that are on, in the order in which they act."""
    return [part for link in links if link.on for part in link.unfolded()]


def is_singular(matrix: Matrix | None) -> bool:
    """Whether a matrix (3, 3) flattens the plane, or (4, 4) space, so that it cannot be undone; None is the
    identity."""
    if matrix is None:
        return False
    if len(matrix) == 4:
        linear = matrix[:3, :3]
        return bool(abs(np.linalg.det(linear)) <= _SINGULAR * np.linalg.norm(linear, axis=0).prod())
    (a, b), (c, d) = matrix[:2, :2].tolist()
    return bool(abs(a * d - b * c) <= _SINGULAR * np.hypot(a, c) * np.hypot(b, d))


def inverse_of(matrix: Matrix) -> Matrix:
    """The matrix that brings back. Raises: ValueError, a sentence, where it is singular."""
    if is_singular(matrix):
        raise ValueError(_flat())
    return transforms.inverse(matrix)


def _flat() -> str:
    return _("The transforms flatten this figure, so they cannot be undone; change or switch off one.")


class Transformed(
    msgspec.Struct,
    frozen=True,
    kw_only=True,
    dict=True,  # where the cached properties are kept
):
    """What has a chain of transforms; its first link acts first on the points, in the world."""

    transforms: tuple[AnyLink, ...] = ()

    @cached_property
    def matrix(self) -> Matrix | None:
        """The matrix (3, 3) of its chain, world to world; None where nothing is transformed."""
        return matrix_of(self.transforms) if self.transforms else None


def read_only_reason(figure: Transformed) -> str:
    """The sentence that says why the points of a figure cannot be dragged where they are seen; empty where
    they can."""
    return _flat() if is_singular(figure.matrix) else ""


def matrices_of(figures: Sequence[Transformed]) -> Matrix:
    """The matrices (n, 3, 3) of the chains of figures, the identity where there is none.

    Each figure keeps its own, so that thousands are asked for at once.
    """
    _evaluate(figures)
    matrices: list[Any] = [_IDENTITY if figure.matrix is None else figure.matrix for figure in figures]
    # Thousands of small arrays are joined as bytes ten times as fast as they are stacked.
    return np.frombuffer(b"".join(matrices), np.float64).reshape(-1, 3, 3)


def _evaluate(figures: Iterable[Transformed]) -> None:
    """Let each figure keep the matrix of its chain; many that have none yet are worked out together."""
    waiting: dict[int, list[Transformed]] = {}  # those that share a chain, as copies do, by what it is
    for figure in figures:
        if figure.transforms and "matrix" not in figure.__dict__:
            waiting.setdefault(id(figure.transforms), []).append(figure)
    if len(waiting) < _MANY:
        for first, *others in waiting.values():
            for other in others:
                other.__dict__["matrix"] = first.matrix
        return
    sharing = list(waiting.values())
    for start in range(0, len(sharing), _AT_ONCE):
        groups = sharing[start : start + _AT_ONCE]
        chains = [[link for link in group[0].transforms if link.on] for group in groups]
        for group, acting, matrix in zip(groups, chains, _products(chains), strict=True):
            for figure in group:
                figure.__dict__["matrix"] = matrix if acting else None


def _products(chains: Sequence[Sequence[AnyLink]]) -> Matrix:
    """The product (n, 3, 3) of each chain, read-only: the k-th links of all are multiplied at once."""
    lengths = np.array(list(map(len, chains)))
    stacked = np.tile(_IDENTITY, (max(int(lengths.max()), 1), len(chains), 1, 1))
    ends = np.cumsum(lengths)
    of = np.repeat(np.arange(len(chains)), lengths)
    at = np.arange(ends[-1]) - np.repeat(ends - lengths, lengths)
    stacked[at, of] = _link_matrices(list(chain.from_iterable(chains)))
    with np.errstate(over="ignore", invalid="ignore"):
        products = transforms.product(*stacked[::-1])
    products.setflags(write=False)
    return products


def _link_matrices(links: Sequence[AnyLink]) -> Matrix:
    """The matrices (n, 3, 3) of links, those of one kind at once."""
    matrices = np.empty((len(links), 3, 3))
    places: dict[object, list[int]] = defaultdict(list)
    for place, link in enumerate(links):
        places[link.mirror if type(link) is Reflect else type(link)].append(place)
    for here in places.values():
        alike = list(map(links.__getitem__, here))
        names = alike[0].numbers
        values = chain.from_iterable(map(attrgetter(*names), alike))
        numbers = np.fromiter(values, np.float64, len(alike) * len(names)).reshape(len(alike), -1)
        matrices[here] = alike[0].matrices(*numbers.T)
    return matrices


def transformed(matrix: Matrix, points: Matrix) -> Matrix:
    """Points (n, 2), world, under one matrix (3, 3) or each under its own (n, 3, 3)."""
    placed: Matrix = (
        matrix[..., :2, 0] * points[:, :1] + matrix[..., :2, 1] * points[:, 1:] + matrix[..., :2, 2]
    )
    return placed
