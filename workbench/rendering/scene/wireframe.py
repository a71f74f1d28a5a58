"""The edges of meshes as segments of the view plane: for the vector tube, and for line drawings."""

import numpy as np

from workbench.algorithms.transforms import Matrix
from workbench.document.scene.model import Camera, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array, Mesh, edges_of
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.volume import DEPTH_PLANES, LEAST_W, clip_segments


def wireframe(scene: Scene) -> Array:
    """Every edge (n, 4) of the visible objects as (x0, y0, x1, y1), in view-plane coordinates, which are the
    world of the sheet; each edge once, cut at the near and the far plane. Raises: ValueError, a sentence."""
    matrix = projection_matrix(scene.camera) @ view_matrix(scene.camera)
    parts = [_segments(mesh, matrix) for mesh, *_rest in placed(scene)]
    return np.concatenate(parts or [np.zeros((0, 4))])


def wireframe_of_mesh(mesh: Mesh, camera: Camera) -> Array:
    """The same of one mesh in the world."""
    return _segments(mesh, projection_matrix(camera) @ view_matrix(camera))


def _segments(mesh: Mesh, matrix: Matrix) -> Array:
    points = mesh.vertices @ matrix[:, :3].T + matrix[:, 3]
    begin, end, _owners = clip_segments(points, edges_of(mesh), DEPTH_PLANES)
    good = (begin[:, 3] > LEAST_W) & (end[:, 3] > LEAST_W)
    begin, end = begin[good], end[good]
    return np.concatenate([begin[:, :2] / begin[:, 3:], end[:, :2] / end[:, 3:]], axis=1)
