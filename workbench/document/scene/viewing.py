"""What a camera does with points: the matrix from the world to view coordinates, and on to the view plane."""

import math
from functools import lru_cache

import numpy as np

from workbench.algorithms import projection, transforms
from workbench.algorithms.transforms import Matrix
from workbench.document.scene.model import Camera
from workbench.language import _

_FLAT = 1e-12
_KEPT = 64  # cameras whose matrices are at hand: one picture asks for them many times


def view_matrix(camera: Camera) -> Matrix:
    """From the world to view coordinates (4, 4), read-only. Raises: ValueError, a sentence."""
    return _view(camera)


@lru_cache(maxsize=_KEPT)
def _view(camera: Camera) -> Matrix:
    matrix = _seen_from(camera)
    matrix.flags.writeable = False
    return matrix


def _seen_from(camera: Camera) -> Matrix:
    if camera.projection in ("axonometric", "isometric"):
        return _turned(camera)
    return projection.view(camera.eye.xyz, camera.look_at.xyz, camera.up.xyz)


def projection_matrix(camera: Camera) -> Matrix:
    """From view coordinates to the view plane (4, 4), read-only, depths 0 at ``near`` to 1 at ``far``.

    x, y and the depth are to be divided by w. Raises: ValueError, a sentence.
    """
    return _projection(camera)


def is_central(camera: Camera) -> bool:
    """Whether its projectors meet in a point, rather than being parallel. Raises: ValueError, a sentence."""
    if camera.projection != "matrix":
        return camera.projection == "perspective"
    centre = projection.classify(projection_matrix(camera)).centre
    return centre is not None and centre[3] != 0.0


@lru_cache(maxsize=_KEPT)
def _projection(camera: Camera) -> Matrix:
    matrix = _projected_by(camera)
    matrix.flags.writeable = False
    return matrix


def _projected_by(camera: Camera) -> Matrix:
    d, near, far = camera.distance, camera.near, camera.far
    match camera.projection:
        case "perspective":
            return projection.perspective_depth(d, near, far)
        case "matrix":
            return _given(camera)
        case "oblique":
            plane = projection.oblique(math.radians(camera.oblique_alpha), math.radians(camera.oblique_phi))
        case "cavalier":
            plane = projection.cavalier(math.radians(camera.oblique_phi))
        case "cabinet":
            plane = projection.cabinet(math.radians(camera.oblique_phi))
        case _:
            plane = projection.orthographic()
    about = transforms.translation_3d(0.0, 0.0, d), transforms.translation_3d(0.0, 0.0, -d)
    return transforms.product(projection.parallel_depth(near, far), about[0], plane, about[1])


def _turned(camera: Camera) -> Matrix:
    """The axonometric turn about what is looked at, which is as far from the eye as before."""
    turn = (
        projection.isometric()
        if camera.projection == "isometric"
        else projection.axonometric(math.radians(camera.angle_y), math.radians(camera.angle_x))
    )
    away = math.dist(camera.eye.xyz, camera.look_at.xyz)
    if away == 0.0:
        raise ValueError(_("The eye is at the point it looks at; move one of them."))
    x, y, z = camera.look_at.xyz
    to_eye = transforms.translation_3d(0.0, 0.0, away)
    return transforms.product(to_eye, turn, transforms.translation_3d(-x, -y, -z))


def _given(camera: Camera) -> Matrix:
    matrix = np.array(camera.entries, np.float64).reshape(4, 4)
    lengths = np.sqrt((matrix**2).sum(axis=1))
    if not (lengths > 0).all() or abs(np.linalg.det(matrix / lengths[:, None])) < _FLAT:
        raise ValueError(
            _("The matrix of the camera is singular: it flattens space; change one of its rows.")
        )
    if not camera.near < camera.far:
        projection.parallel_depth(camera.near, camera.far)
    return matrix
