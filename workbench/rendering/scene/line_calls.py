"""The removal of hidden lines on a coarse picture of a scene, so that it can be stepped."""

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.visibility import hidden_lines
from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.rendering.mapping import Call
from workbench.rendering.scene.line_drawing import before_camera
from workbench.rendering.scene.render import placed
from workbench.rendering.scene.viewpoint import Size, Viewpoint

HIDDEN_LINES = hidden_lines.__name__


def line_call(scene: Scene, size: Size, window: Rectangle | None) -> Call:
    """Each edge that lies before the camera is clipped by all triangles, in pixels. Raises: ValueError."""
    vertices, triangles, edges, _owners = before_camera(scene)
    meshes = [np.zeros((0, 3)), *(mesh.vertices for mesh, *_rest in placed(scene))]
    device = Viewpoint.of(scene.camera, size, window, np.concatenate(meshes)).device
    placed_vertices = vertices.copy()
    placed_vertices[:, :2] = vertices[:, :2] * device.diagonal()[:2] + device[:2, 2]
    return Call(catalogue.get(HIDDEN_LINES), (placed_vertices, triangles, edges))
