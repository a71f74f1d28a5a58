"""From the world to view coordinates: x right, y up, z into the picture.

The world is right-handed and view coordinates are left-handed: each matrix here holds that flip.

forward, right, up  unit vectors of the view's z, x and y axes, in the world
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
Vector = NDArray[np.float64]
Triple = tuple[float, float, float]

_PARALLEL = 1e-12

STANDARD_VIEWS: Mapping[str, tuple[Triple, Triple]] = {
    "front": ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0)),
    "back": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "left": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "right": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "top": ((0.0, -1.0, 0.0), (0.0, 0.0, -1.0)),
    "bottom": ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
}
"""Of each of the six standard views, named by the side that is seen: where it looks, and which way is up."""

_PLACEMENTS: Mapping[int, Triple] = {1: (0.0, 0.0, 1.0), 2: (1.0, 0.0, 1.0), 3: (1.0, 1.0, 1.0)}


def view(eye: Sequence[float], look_at: Sequence[float], up: Sequence[float] = (0.0, 1.0, 0.0)) -> Matrix:
    """From the world to view coordinates with the eye at the origin, looking at ``look_at``.

    Args: points and a direction of the world; ``up`` points upwards in the picture, and need not be
    perpendicular to the line of sight. Returns: (4, 4), homogeneous, for points as columns. Raises:
    ValueError when the eye is at ``look_at``, or ``up`` runs along the line of sight.
    """
    place = _vector(eye)
    return _looking(place, _vector(look_at) - place, up, "The eye is at the point it looks at.")


def view_from_plane(
    vrp: Sequence[float],
    vpn: Sequence[float],
    vup: Sequence[float],
    prp: Sequence[float] = (0.0, 0.0, 0.0),
) -> Matrix:
    """From the world to view coordinates, given as PHIGS and Hearn and Baker do it.

    ``vrp`` is a point of the view plane, ``vpn`` its normal, towards the viewer, ``vup`` upwards, all in the
    world. ``prp``, the projection reference point, is in the right-handed (u, v, n) of the view plane, n
    towards the viewer. The origin is at ``prp``: the view plane is at z = prp[2], which is the d of
    ``perspective``; by default it is at z = 0.

    Returns: (4, 4), homogeneous, for points as columns. Raises: ValueError when ``vpn`` is zero, or ``vup``
    runs along it. Source: Hearn and Baker, Computer Graphics, C Version, section 12-2.
    """
    matrix = _looking(_vector(vrp), -_vector(vpn), vup, "The normal of the view plane has no length.")
    u, v, n = _vector(prp)
    matrix[:3, 3] += -u, -v, n
    return matrix


def standard_view(name: str) -> Matrix:
    """One of STANDARD_VIEWS, with the origin of the world at the origin of view coordinates.

    Returns: (4, 4), homogeneous, for points as columns. Raises: LookupError for any other name.
    """
    if name not in STANDARD_VIEWS:
        raise LookupError(f"There is no view {name!r}; choose one of {', '.join(STANDARD_VIEWS)}.")
    toward, up = STANDARD_VIEWS[name]
    return _looking(np.zeros(3), _vector(toward), up, "")


def perspective_placement(points: int, look_at: Sequence[float], distance: float) -> Triple:
    """Where an upright eye sees the world's axes in one-, two- or three-point perspective.

    It stands in front, at the corner, or at the corner and above, ``distance`` from ``look_at``. Returns: a
    point of the world. Raises: ValueError unless ``points`` is 1, 2 or 3 and ``distance`` above 0.
    """
    if points not in _PLACEMENTS:
        raise ValueError(f"A perspective has 1, 2 or 3 principal vanishing points, not {points}.")
    if not 0.0 < distance < math.inf:
        raise ValueError(f"The eye is {distance:g} away from what it looks at; give more than 0.")
    direction = _vector(_PLACEMENTS[points])
    x, y, z = _vector(look_at) + direction * (distance / np.linalg.norm(direction))
    return float(x), float(y), float(z)


def _looking(origin: Vector, toward: Vector, up: Sequence[float], no_length: str) -> Matrix:
    length = np.linalg.norm(toward)
    if length == 0.0:
        raise ValueError(no_length)
    forward = toward / length
    aside = np.cross(forward, _vector(up))
    if np.linalg.norm(aside) <= _PARALLEL * np.linalg.norm(up):
        raise ValueError(
            "Up runs along the line of sight, so it does not say which way is up in the picture."
        )
    right = aside / np.linalg.norm(aside)
    matrix = np.eye(4)
    matrix[:3, :3] = right, np.cross(right, forward), forward
    matrix[:3, 3] = -matrix[:3, :3] @ origin
    return matrix + 0.0  # no -0


def _vector(values: Sequence[float]) -> Vector:
    vector = np.array(values, np.float64)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{tuple(values)} is not a point or direction in space; give three finite numbers.")
    return vector
