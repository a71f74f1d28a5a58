"""Polygon tables: vertices, edges, faces, and the plane of each face.

Source: Hearn and Baker, Computer Graphics, C Version, section 10-1.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.meshes import Faces, Mesh, face_planes


class PolygonTables(NamedTuple):
    """The tables of a mesh; all numbers count from 0.

    ``vertices`` (n, 3); ``edges`` (e, 2), the vertices of each, the lower one first; ``sides`` (k,), for each
    corner of ``faces`` the edge from it to the next; ``edge_faces`` (e, 2), the faces that run along an edge,
    upwards and downwards in its vertices, -1 where none or more than one does; ``planes`` (m, 4), A, B, C, D
    of the plane of each face in the world, negative inside.
    """

    vertices: NDArray[np.float64]
    edges: NDArray[np.int64]
    faces: Faces
    sides: NDArray[np.int64]
    edge_faces: NDArray[np.int64]
    planes: NDArray[np.float64]

    @property
    def closed(self) -> bool:
        """Whether each edge has two faces, which run along it in opposite directions."""
        return bool((self.edge_faces >= 0).all())


def polygon_tables(mesh: Mesh) -> PolygonTables:
    """The tables of a mesh."""
    vertices, faces = mesh
    here, after = faces.corners, faces.following
    pairs = np.stack([np.minimum(here, after), np.maximum(here, after)], axis=1)
    edges, sides = np.unique(pairs, axis=0, return_inverse=True)
    sides = sides.reshape(-1)
    owners = np.repeat(np.arange(len(faces)), faces.sizes)
    edge_faces = np.full((len(edges), 2), -1)
    for way, along in enumerate((here < after, here > after)):
        edge_faces[sides[along], way] = owners[along]
        edge_faces[np.bincount(sides[along], minlength=len(edges)) > 1, way] = -1
    return PolygonTables(vertices, edges, faces, sides, edge_faces, face_planes(vertices, faces))
