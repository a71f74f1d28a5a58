"""What of a mesh in the world lasts while only the camera moves, found when it is first asked for."""

from functools import cached_property
from itertools import product
from math import pi, sqrt

import numpy as np

from workbench.geometry.meshes import Array, Index, Mesh, edges_of, face_normals
from workbench.rendering.scene.smoothing import CornerNormals

_MOST_POINTS = 2_000
_DIRECTIONS = 256
_AT_ONCE = 1 << 16  # faces: what is worked out on the way takes little memory


class Lasting:
    """Of the faces (m,): unit normals and middles, in rows x, y and z (3, m), and the distances (m,) of their
    planes from the origin, along the normals; a box around all; the edges; and the points that are outermost.
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._corner_normals: CornerNormals | None = None

    @property
    def count(self) -> int:
        """How many faces there are."""
        return len(self._mesh.faces)

    @cached_property
    def normals(self) -> Array:
        """0 where a face has no area."""
        normals = np.ascontiguousarray(face_normals(*self._mesh).T)
        length = np.sqrt(_squares(normals))
        normals[:, length == 0] = 0.0
        np.divide(normals, length, out=normals, where=length > 0)
        return normals

    @cached_property
    def distances(self) -> Array:
        """By their first corners."""
        vertices, faces = self._mesh
        distances, starts = np.zeros(len(faces)), faces.starts
        for first in range(0, len(faces), _AT_ONCE):
            part = slice(first, first + _AT_ONCE)
            corners = faces.corners[starts[part]]
            for n, x in zip(self.normals, vertices.T, strict=True):
                distances[part] += n[part] * x[corners]
        return distances

    @cached_property
    def middles(self) -> Array:
        """The mean of the corners."""
        vertices, faces = self._mesh
        middles, starts = np.empty((3, len(faces))), faces.starts
        for first in range(0, len(faces), _AT_ONCE):
            part = slice(first, first + _AT_ONCE)
            begins, end = starts[part], faces.ends[part][-1]
            corners = faces.corners[begins[0] : end]
            for row, x in zip(middles, vertices.T, strict=True):
                np.add.reduceat(x[corners], begins - begins[0], out=row[part])
        middles /= faces.sizes
        return middles

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

    def corner_normals(self, triangles: Index, owners: Index) -> CornerNormals:
        """Those of the mesh's triangles (t, 3), each a part of the face in ``owners`` (t,)."""
        if self._corner_normals is None:
            self._corner_normals = CornerNormals(self._mesh, triangles, owners)
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


def _squares(rows: Array) -> Array:
    """The sums (m,) of the squares of x, y and z (3, m)."""
    x, y, z = rows
    squares: Array = x * x
    squares += y * y
    squares += z * z
    return squares
