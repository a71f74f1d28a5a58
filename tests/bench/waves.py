"""A mesh of as many triangles as are wanted: a sphere with waves on it, and a scene of it."""

import numpy as np
from msgspec.structs import replace

from workbench.document.samples.examples import blank_sheet
from workbench.document.scene.meshes import blob_of
from workbench.document.scene.model import Material, Object, Scene
from workbench.document.scene.solids import MeshSolid
from workbench.geometry.meshes import Faces, Mesh
from workbench.rendering.scene.around import camera_around


def wavy_sphere(count):
    """About ``count`` triangles, radius 0.9 to 1.1."""
    rows = round((count / 4) ** 0.5)
    columns = 2 * rows
    across, down = np.meshgrid(np.linspace(0, 2 * np.pi, columns + 1), np.linspace(0.01, 3.13, rows + 1))
    radius = 1 + 0.1 * np.sin(9 * across) * np.sin(7 * down)
    level = np.sin(down)
    points = radius[..., None] * np.stack([level * np.cos(across), np.cos(down), level * np.sin(across)], -1)
    a = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    b, c, d = a + 1, a + columns + 2, a + columns + 1
    faces = np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)
    return Mesh(points.reshape(-1, 3), Faces.of(faces))


def wavy_document(count):
    """A sheet with such a sphere as its scene."""
    mesh = wavy_sphere(count)
    scene = Scene(
        (Object("o1", MeshSolid(blob_of(mesh)), "m1", "sphere"),),
        (Material("m1", "blue", 0x9CC8E6, 0.45, 0.6),),
        camera=camera_around(mesh.vertices),
    )
    document = blank_sheet(320, 240)
    return replace(document, sheets=(replace(document.sheets[0], scene=scene),))
