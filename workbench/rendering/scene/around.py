"""Where a camera stands so that the whole of something is before it."""

import math
from functools import lru_cache

import numpy as np

from workbench.document.model import Rectangle
from workbench.document.scene.model import Camera, Point3D, Scene
from workbench.geometry.meshes import Array
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint

_TOWARDS_EYE = np.array([0.55, 0.45, 1.0])
_AWAY = 4.0  # the eye, in radii of what is seen from its middle


def camera_around(points_world: Array, eye: Point3D | None = None, look_at: Point3D | None = None) -> Camera:
    """A camera that sees all points (n, 3), from the right and above where no ``eye`` is given."""
    low, high = points_world.min(axis=0), points_world.max(axis=0)
    middle, radius = (low + high) / 2, max(math.dist(low, high) / 2, 1e-6)
    away = _TOWARDS_EYE * (_AWAY * radius / math.sqrt(float(_TOWARDS_EYE @ _TOWARDS_EYE)))
    eye, look_at = eye or Point3D(*(middle + away).tolist()), look_at or Point3D(*middle.tolist())
    depth = math.dist(eye.xyz, middle)
    near = max(depth - 2 * radius, radius / 100)
    far = max(depth, near) + 2 * radius
    return Camera(eye=eye, look_at=look_at, near=near, far=far, distance=depth or 1.0)


def window_of(camera: Camera, size: Size, points_world: Array) -> Rectangle:
    """The window, in the proportions of ``size``, in which ``camera`` sees all points, and a margin."""
    return Viewpoint.of(camera, size, None, points_world).window


@lru_cache(maxsize=8)
def whole_window(scene: Scene, size: Size) -> Rectangle:
    """The window in which the camera of a scene sees all of it, and a margin; found once."""
    outermost = [lasting.outermost for *_rest, lasting in placed(scene)]
    return window_of(scene.camera, size, np.concatenate([np.zeros((0, 3)), *outermost]))
