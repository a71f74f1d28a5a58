"""A camera by the names of Hearn and Baker: VRP, VPN, PRP, and view coordinates whose z is towards the eye.

The origin of these is at the point that is looked at, the view reference point; x and y are ours.
"""

from typing import NamedTuple

import numpy as np

from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array

_AT_INFINITY = 1e-12


class ViewReference(NamedTuple):
    """``vrp`` the view reference point and ``vpn`` the unit normal of the view plane, towards the eye, world.

    In its own view coordinates: ``prp`` (x, y, z, 1), the projection reference point, or with 0 last the
    direction of parallel projectors; ``plane`` the depth of the view plane, None where it has none of its
    own. ``view`` and ``projection`` (4, 4) lead there and on; their product is that of ours.
    """

    vrp: Array
    vpn: Array
    prp: Array
    plane: float | None
    view: Array
    projection: Array


def view_reference(camera: Camera) -> ViewReference:
    """The same camera by the book's names. Raises: ValueError, a sentence, where it sees nothing."""
    view, plane = view_matrix(camera), projection_matrix(camera)
    vrp = np.array(camera.look_at.xyz)
    origin = (view @ (*vrp, 1.0))[:3]
    turned = np.diag([1.0, 1.0, -1.0, 1.0])  # z towards the eye
    turned[:3, 3] = -origin * (1.0, 1.0, -1.0)
    projection = plane @ np.linalg.inv(turned)
    flat = projection[[0, 1, 3]]
    centre = np.array([(-1) ** k * np.linalg.det(np.delete(flat, k, axis=1)) for k in range(4)])
    if abs(centre[3]) > _AT_INFINITY * np.abs(centre).max():
        centre = centre / centre[3]
    else:
        centre = np.array([*(centre[:3] / centre[np.abs(centre[:3]).argmax()]), 0.0])
        centre *= np.copysign(1.0, centre[2])  # from the view plane towards the eye
    own = camera.projection not in ("matrix", "orthographic", "isometric", "axonometric")
    depth = float(origin[2] - camera.distance) if own else None
    return ViewReference(vrp, -view[2, :3], centre, depth, turned @ view, projection)
