"""Vanishing points: where they are, and the view that has one where it is wanted.

x, y        a vanishing point on the view plane, from the foot of the perpendicular from the eye
d           distance from the eye to the view plane
axis        0, 1 or 2 for the world's x, y or z
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.projection.view import view

Matrix = NDArray[np.float64]
Vector = NDArray[np.float64]
Place = tuple[float, float]
Triple = tuple[float, float, float]

_CRUMB = 1e-12


def vanishing_points(matrix: ArrayLike) -> tuple[Place | None, Place | None, Place | None]:
    """The principal vanishing points of a projection: where the world's x, y and z axes run together.

    Column j of the matrix is the image of the point at infinity of axis j. Where its w is not 0 that is a
    point of the picture; where it is 0 lines along the axis stay parallel.

    Args: (4, 4), homogeneous, from the world to the picture, for points as columns, finite. Returns: (x, y)
    for each axis, or None where it has none. Raises: ValueError for another shape or numbers not finite.
    """
    m = checked(matrix)
    crumb = _CRUMB * np.abs(m[3, :3]).max()
    x, y, z = [
        None if abs(w) <= crumb else (float(u / w + 0.0), float(v / w + 0.0)) for u, v, _, w in m[:, :3].T
    ]
    return x, y, z


def checked(matrix: ArrayLike) -> Matrix:
    """``matrix`` as (4, 4) floats. Raises: ValueError for another shape or numbers not finite."""
    m = np.array(matrix, np.float64)
    if m.shape != (4, 4) or not np.isfinite(m).all():
        raise ValueError("A projection is a 4 x 4 matrix of finite numbers.")
    return m


def with_vanishing_point(
    eye: Sequence[float],
    look_at: Sequence[float],
    up: Sequence[float],
    axis: int,
    at: Place,
    d: float,
) -> tuple[Triple, Triple]:
    """The eye and up that see the vanishing point of ``axis`` at ``at``, from as far, with the same d.

    Seen from the eye, the axis turns to (x, y, d) or its opposite, whichever is nearer, by the least rotation
    about ``look_at``.

    Args: the view as for ``view``; (x, y); d above 0. Returns: eye and up, in the world. Raises: ValueError
    as ``view`` does, or unless d > 0.
    """
    before = view(eye, look_at, up)
    turned = _turned(before[:3, axis], _nearer(_toward(at, d), before[:3, axis])) @ before[:3, :3]
    return _placed(turned, eye, look_at)


def distance_of(first: Place, second: Place) -> float:
    """The d that two vanishing points of perpendicular directions need: d squared = -(v1 . v2).

    Raises: ValueError where minus their product is not positive: no right angle looks like that.
    """
    squared = -(first[0] * second[0] + first[1] * second[1])
    if not 0.0 < squared < math.inf:
        raise ValueError(
            f"From nowhere do perpendicular axes run together at {_pair(first)} and {_pair(second)}: "
            f"d² = −v₁·v₂ = {squared:g} would have to be positive."
        )
    return math.sqrt(squared)


def with_vanishing_points(
    eye: Sequence[float],
    look_at: Sequence[float],
    up: Sequence[float],
    pinned: tuple[int, Place],
    moved: tuple[int, Place],
) -> tuple[Triple, Triple, float]:
    """The eye, up and d that keep the vanishing point of one axis and see that of another where it went.

    Args: the view as for ``view``; twice the number of an axis and its vanishing point, of different axes.
    Returns: eye and up, in the world, and d. Raises: ValueError as ``view`` does, or where ``distance_of``
    refuses the two points.
    """
    before = view(eye, look_at, up)[:3, :3]
    d = distance_of(pinned[1], moved[1])
    (first, kept), (second, gone_to) = pinned, moved
    third = 3 - first - second
    turned = np.empty((3, 3))
    turned[:, first] = _nearer(_toward(kept, d), before[:, first])
    turned[:, second] = _nearer(_toward(gone_to, d), before[:, second])
    aside = np.cross(turned[:, first], turned[:, second])
    aside /= np.linalg.norm(aside)
    turned[:, third] = aside
    if np.linalg.det(turned) > 0.0:  # the view holds a flip
        turned[:, third] = -aside
    return *_placed(turned, eye, look_at), d


def _toward(at: Place, d: float) -> Vector:
    if not (math.isfinite(d) and d > 0.0):
        raise ValueError(f"The view plane is {d:g} from the centre of projection; give more than 0.")
    direction = np.array((*at, d), np.float64)
    return direction / np.linalg.norm(direction)


def _nearer(direction: Vector, axis: Vector) -> Vector:
    """``direction`` or its opposite, whichever is nearer to ``axis``."""
    return direction if direction @ axis >= 0.0 else -direction


def _turned(start: Vector, end: Vector) -> Matrix:
    """The least rotation from one unit vector to another, at most a right angle away."""
    x, y, z = np.cross(start, end)
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + across + across @ across / (1.0 + start @ end))


def _placed(axes: Matrix, eye: Sequence[float], look_at: Sequence[float]) -> tuple[Triple, Triple]:
    """Eye and up of a view whose rows are ``axes``, as far from ``look_at`` as ``eye`` is."""
    distance = math.dist(eye, look_at)
    x, y, z = np.asarray(look_at, np.float64) - distance * axes[2]
    up_x, up_y, up_z = axes[1]
    return (float(x), float(y), float(z)), (float(up_x), float(up_y), float(up_z))


def _pair(place: Place) -> str:
    return f"({place[0]:g}, {place[1]:g})"
