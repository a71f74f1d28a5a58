"""What of a mesh in the world lasts while only the camera moves, found when it is first asked for."""

from functools import cached_property
from itertools import product
from math import pi, sqrt

import numpy as np

from workbench.geometry.meshes import Array, Index, Mesh, edges_of, face_normals
from workbench.rendering.scene.smoothing import corner_normals

_MOST_POINTS = 2_000
_DIRECTIONS = 256


class Lasting:
    """Of the faces (m,): unit normals and middles, in rows x, y and z (3, m), and the distances (m,) of their
    planes from the origin, along the normals; a box around all; the edges; and the points that are outermost.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._corner_normals: Array | None = None

    @cached_property
    def normals(self) -> Array:
        """0 where a face has no area."""
        normals = np.ascontiguousarray(face_normals(*self._mesh).T)
        length = np.sqrt((normals * normals).sum(axis=0))
        unit: Array = np.divide(normals, length, out=np.zeros_like(normals), where=length > 0)
        return unit

    @cached_property
    def distances(self) -> Array:
        """By their first corners."""
        vertices, faces = self._mesh
        firsts = faces.corners[faces.starts]
        found: Array = sum(n * x[firsts] for n, x in zip(self.normals, vertices.T, strict=True))
        return found

    @cached_property
    def middles(self) -> Array:
        """The mean of the corners."""
        vertices, faces = self._mesh
        sums = [np.add.reduceat(x[faces.corners], faces.starts) for x in vertices.T]
        middles: Array = np.stack(sums) / faces.sizes
        return middles

    @cached_property
    def squares(self) -> Array:
        """The squares (m,) of how far the middles are from the origin."""
        squares: Array = (self.middles * self.middles).sum(axis=0)
        return squares

    @cached_property
    def box(self) -> Array:
        """The corners (8, 3) of a box around all vertices, none where there are none."""
        columns = self._mesh.vertices.T
        if not columns.size:
            return np.zeros((0, 3))
        return np.array(list(product(*((x.min(), x.max()) for x in columns))))

    @cached_property
    def edges(self) -> Index:
        """(e, 2), each once."""
        return edges_of(self._mesh)

    def corner_normals(self, triangles: Index, owners: Index) -> Array:
        """(t, 3, 3) of the mesh's triangles (t, 3), each a part of the face in ``owners`` (t,)."""
        if self._corner_normals is None:
            self._corner_normals = corner_normals(self._mesh, triangles, owners)
        return self._corner_normals

    @cached_property
    def outermost(self) -> Array:
        """Points (k, 3) between which all others lie; of many, those that reach farthest in some directions,
        along the axes among them."""
        points = self._mesh.vertices
        if len(points) <= _MOST_POINTS:
            return points
        # Along a spiral from pole to pole, each a golden angle farther round.
        y = np.linspace(1.0, -1.0, _DIRECTIONS)
        round_axis = np.arange(_DIRECTIONS) * pi * (3.0 - sqrt(5.0))
        away = np.sqrt(1.0 - y * y)
        spiral = np.stack([away * np.cos(round_axis), y, away * np.sin(round_axis)], axis=1)
        directions = np.concatenate([spiral, np.eye(3), -np.eye(3)])
        columns = np.ascontiguousarray(points.T, np.float32)  # a third of the time
        rows = directions.astype(np.float32)
        farthest: Array = points[np.unique([int((row @ columns).argmax()) for row in rows])]
        return farthest
