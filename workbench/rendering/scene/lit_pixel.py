"""Where the light of a pixel comes from: the triangle that it shows, and the points at which that is lit."""

from typing import NamedTuple

import numpy as np

from workbench.algorithms.shading import flat_shading, gouraud
from workbench.algorithms.visibility.surfaces import covers, depth_at, surface_of
from workbench.geometry.meshes import Array
from workbench.rendering.scene.lit_triangles import LitTriangles


class LitPoint(NamedTuple):
    """A place (3,) of the world with a normal (3,), and the share that its light has in the pixel's."""

    place: Array
    normal: Array
    share: float


class LitPixel(NamedTuple):
    """The number of a triangle, its points that are lit, and its material (4,): k_a, k_d, k_s, n."""

    face: int
    points: tuple[LitPoint, ...]
    material: Array


def lit_pixel(lit: LitTriangles, shading: str, x: int, y: int) -> LitPixel | None:
    """What a shading lights for a pixel; None where that shows no triangle.

    Flat shading lights the middle of the triangle, Gouraud its corners, Phong the place of the pixel.
    """
    vertices, faces = lit.corners, lit.triangles
    surfaces = [surface_of(vertices, faces, face) for face in range(len(faces))]
    met = [
        (depth_at(surface, x, y), face)
        for face, surface in enumerate(surfaces)
        if surface.C != 0.0 and covers(surface, x, y)
    ]
    if not met:
        return None
    _z, face = min(met)
    corners = faces[face]
    flat = np.column_stack([vertices[corners, :2], np.ones(3)])
    shares = np.linalg.solve(flat.T, [x, y, 1.0])
    places, normals = lit.places[corners], lit.normals[corners]
    if shading == flat_shading.__name__:
        normal = np.cross(places[1] - places[0], places[2] - places[0])
        normal = normal if normal @ normals[0] >= 0.0 else -normal
        points = [LitPoint(places.mean(axis=0), normal, 1.0)]
    elif shading == gouraud.__name__:
        points = [LitPoint(*each) for each in zip(places, normals, shares.tolist(), strict=True)]
    else:
        points = [LitPoint(shares @ places, shares @ normals, 1.0)]
    return LitPixel(face, tuple(points), lit.materials[face])
