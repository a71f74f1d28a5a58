"""The lists of an A-buffer: the fragments of a pixel, linked from the nearest to the farthest."""

from typing import NamedTuple

from workbench.algorithms.visibility.surfaces import NOTHING


class Fragment(NamedTuple):
    """A surface at a pixel: its depth, its number, and the number of the next fragment behind, or NOTHING."""

    z: float
    surface: int
    behind: int


def put_by_depth(fragments: list[Fragment], head: int, z: float, surface: int) -> int:
    """Put a fragment into the list that begins with ``head``; returns with which one it begins then.

    Of equal depths the earlier one stays in front.
    """
    before, after = NOTHING, head
    while after != NOTHING and fragments[after].z <= z:
        before, after = after, fragments[after].behind
    new = len(fragments)
    fragments.append(Fragment(z, surface, after))
    if before == NOTHING:
        return new
    nearer = fragments[before]
    fragments[before] = Fragment(nearer.z, nearer.surface, new)
    return head


def list_from(fragments: list[Fragment], head: int) -> list[Fragment]:
    """The fragments of a pixel, from the nearest to the farthest."""
    row = fragments[:0]
    while head != NOTHING:
        row.append(fragments[head])
        head = fragments[head].behind
    return row
