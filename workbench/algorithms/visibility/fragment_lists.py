"""The lists of an A-buffer: the fragments of a pixel, linked from the nearest to the farthest."""

from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.surfaces import NOTHING


class Fragment(NamedTuple):
    """A surface at a pixel: its depth, its number, and the number of the next fragment behind, or NOTHING."""

    z: float
    surface: int
    behind: int


def put_by_depth(
    first: NDArray[Any], fragments: list[Fragment], x: int, y: int, z: float, surface: int
) -> None:
    """Put a fragment into the list of its pixel; of equal depths the earlier one stays in front."""
    before, after = NOTHING, int(first[y, x])
    while after != NOTHING and fragments[after].z <= z:
        before, after = after, fragments[after].behind
    if before == NOTHING:
        first[y, x] = len(fragments)
    else:
        nearer = fragments[before]
        fragments[before] = Fragment(nearer.z, nearer.surface, len(fragments))
    fragments.append(Fragment(z, surface, after))


def list_of(first: NDArray[Any], fragments: list[Fragment], x: int, y: int) -> list[Fragment]:
    """The fragments of a pixel, from the nearest to the farthest."""
    row = fragments[:0]
    k = int(first[y, x])
    while k != NOTHING:
        row.append(fragments[k])
        k = fragments[k].behind
    return row
