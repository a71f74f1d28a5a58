"""Scenes and meshes as pictures: through the camera and the window, without a window of the program."""

from workbench.rendering.scene.render import METHODS, SHADINGS, render_mesh, render_scene
from workbench.rendering.scene.wireframe import wireframe, wireframe_of_mesh

__all__ = ["METHODS", "SHADINGS", "render_mesh", "render_scene", "wireframe", "wireframe_of_mesh"]
