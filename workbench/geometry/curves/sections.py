"""Splines whose tangent at a point is made of its neighbours: who the neighbours of the ends are."""

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse

# inner: as in the course, the first and the last point only steer, and the curve joins those between;
# through: the curve joins all points, and each end has its neighbour mirrored; closed: it goes round.
Ends = Literal["inner", "through", "closed"]
_LEAST: dict[Ends, int] = {"inner": 4, "through": 2, "closed": 3}


def with_neighbours(points: ArrayLike, ends: Ends) -> NDArray[np.float64]:
    """All points that matter: the curve goes from the second to the last but one of them.

    Raises: ValueError for too few points (4, 2 or 3), or for another word.
    """
    if ends not in _LEAST:
        raise ValueError(f"{ends!r} is not a choice for the ends; write one of {', '.join(get_args(Ends))}.")
    refuse(faults(points, least=_LEAST[ends]))
    given = np.asarray(points, float)
    if ends == "through":
        return np.vstack([2.0 * given[0] - given[1], given, 2.0 * given[-1] - given[-2]])
    if ends == "closed":
        return np.vstack([given[-1], given, given[:2]])
    return given
