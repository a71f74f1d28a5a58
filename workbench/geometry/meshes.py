"""Polygon meshes: vertices, and faces of any number of corners; their normals, planes and triangles.

Faces are counter-clockwise seen from outside. Triangles are made of them here and nowhere else.
"""

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_AT_ONCE = 1 << 16  # triangles: what is worked out on the way takes little memory


class Faces:
    """Polygons as lists of vertices: ``corners`` (k,), one face after the other, each before its end in
    ``ends`` (m,). ``faces[i]`` are the corners of one, and ``for face in faces`` goes through all."""

    __slots__ = ("corners", "ends")

    def __init__(self, corners: Index, ends: Index) -> None:
        self.corners, self.ends = corners, ends

    @classmethod
    def of(cls, faces: Union["Faces", ArrayLike, Sequence[Sequence[int]]]) -> "Faces":
        """The same faces, whether an array (m, corners) or a list of lists. Raises: ValueError."""
        if isinstance(faces, Faces):
            return faces
        if isinstance(faces, np.ndarray):
            if faces.ndim != 2 or not np.issubdtype(faces.dtype, np.integer):
                raise ValueError("Faces are rows of whole numbers, the vertices of their corners.")
            ends = np.arange(1, len(faces) + 1) * faces.shape[1]
            return cls(np.ascontiguousarray(faces, np.int64).ravel(), ends)
        lists: Any = faces
        sizes = [len(face) for face in lists]
        corners = np.fromiter(chain.from_iterable(lists), np.int64, sum(sizes))
        return cls(corners, np.cumsum(sizes, dtype=np.int64))

    def __len__(self) -> int:
        return len(self.ends)

    def __getitem__(self, number: int) -> Index:
        number = range(len(self.ends))[number]
        return self.corners[self.starts[number] : self.ends[number]]

    def __iter__(self) -> Iterator[Index]:
        return iter(np.split(self.corners, self.ends[:-1]) if len(self.ends) else [])

    @property
    def starts(self) -> Index:
        """Where in ``corners`` each face begins (m,)."""
        return self.ends - self.sizes

    @property
    def sizes(self) -> Index:
        """How many corners each face has (m,)."""
        return np.diff(self.ends, prepend=0)

    @property
    def triangle_count(self) -> int:
        """How many triangles the faces are cut into."""
        return len(self.corners) - 2 * len(self)

    @property
    def following(self) -> Index:
        """For each corner (k,) the vertex of the corner after it in its face, round to the first again."""
        after = np.arange(1, len(self.corners) + 1)
        after[self.ends - 1] = self.starts
        return self.corners[after]

    def reversed(self) -> "Faces":
        """The same faces, seen from their other side."""
        numbers = np.arange(len(self.corners))
        back = np.repeat(self.starts + self.ends, self.sizes) - 1 - numbers
        return Faces(self.corners[back], self.ends)

    def chosen(self, which: NDArray[np.bool_]) -> "Faces":
        """The faces that ``which`` (m,) is true for."""
        return Faces(self.corners[np.repeat(which, self.sizes)], np.cumsum(self.sizes[which]))


class Mesh(NamedTuple):
    """Vertices (n, 3), y up, and the faces over them."""

    vertices: Array
    faces: Faces

    @property
    def arrays(self) -> tuple[Array, Index, Index]:
        """All that it is kept in."""
        return self.vertices, self.faces.corners, self.faces.ends


def edges_of(mesh: Mesh) -> Index:
    """The edges (e, 2) of a mesh, each once."""
    here, after = mesh.faces.corners, mesh.faces.following
    count = len(mesh.vertices)
    numbers = np.unique(np.minimum(here, after) * count + np.maximum(here, after))
    return np.stack([numbers // count, numbers % count], axis=1)


def face_normals(vertices: Array, faces: Faces) -> Array:
    """A normal (m, 3) of each face, outwards, as long as twice its area (Newell's): the sum over its fan."""
    triangles, owners = _fan(faces)
    normals = _crossed(vertices, triangles)
    if len(normals) == len(faces):
        return normals
    sums = [np.bincount(owners, weights=column, minlength=len(faces)) for column in normals.T]
    return np.stack(sums, axis=1)


def _crossed(vertices: Array, triangles: Index) -> Array:
    """(b - a) x (c - a) of triangles (t, 3) of vertices."""
    normals = np.empty((3, len(triangles)))  # each axis in one piece: written, and later read, in a row
    for first in range(0, len(triangles), _AT_ONCE):
        a, b, c = triangles[first : first + _AT_ONCE].T
        columns = [(column[b] - start, column[c] - start) for column in vertices.T for start in (column[a],)]
        for axis, (y, z) in enumerate(((1, 2), (2, 0), (0, 1))):
            (uy, vy), (uz, vz) = columns[y], columns[z]
            normals[axis, first : first + _AT_ONCE] = uy * vz - uz * vy
    return normals.T


def _fan(faces: Faces) -> tuple[Index, Index]:
    """Triangles (t, 3) from the first corner of each face, and for each (t,) the number of the face."""
    sizes = faces.sizes
    if (sizes == 3).all():
        return faces.corners.reshape(-1, 3), np.arange(len(faces))
    counts = np.maximum(sizes - 2, 0)
    owners = np.repeat(np.arange(len(faces)), counts)
    step = np.arange(len(owners)) - np.repeat(np.cumsum(counts) - counts, counts)
    first = faces.starts[owners]
    return faces.corners[np.stack([first, first + step + 1, first + step + 2], axis=1)], owners


def face_planes(vertices: Array, faces: Faces) -> Array:
    """A, B, C, D (m, 4) of the plane of each face, A x + B y + C z + D = 0, negative on its inner side.

    The plane passes the middle of the corners, also where these do not lie in one.
    """
    normals = face_normals(vertices, faces)
    if not len(faces):
        return np.zeros((0, 4))
    middles = np.add.reduceat(vertices[faces.corners], faces.starts, axis=0) / faces.sizes[:, None]
    return np.column_stack([normals, -(normals * middles).sum(axis=1)])


def triangulated(vertices: Array, faces: Faces) -> tuple[Index, Index]:
    """Triangles (t, 3) that turn as their faces do, and for each (t,) the number of the face it is of.

    A face is cut into a fan from its first corner, or, where that would leave it, by its ears.
    """
    triangles, owners = _fan(faces)
    several = (faces.sizes > 3)[owners]
    if several.any():
        normals = face_normals(vertices, faces)
        turns = (_crossed(vertices, triangles[several]) * normals[owners[several]]).sum(axis=1)
        for face in np.unique(owners[several][turns < 0]).tolist():
            corners = faces[face]
            triangles[owners == face] = corners[_ears(vertices[corners], normals[face])]
    return triangles, owners


def _ears(points: Array, normal: Array) -> Index:
    """The n - 2 triangles of a polygon (n, 3), numbers of its corners, cut off one after the other."""
    axis = int(np.abs(normal).argmax())
    others = [(1, 2), (2, 0), (0, 1)][axis]
    flat = points[:, others] * ((1.0, 1.0) if normal[axis] > 0 else (-1.0, 1.0))
    left = list(range(len(points)))
    triangles: list[tuple[int, int, int]] = []
    at = 0
    passed = 0
    while len(left) > 3:
        a, b, c = left[at - 1], left[at % len(left)], left[(at + 1) % len(left)]
        if passed >= len(left) or _is_ear(flat, left, a, b, c):  # none: the polygon crosses itself
            triangles.append((a, b, c))
            del left[at % len(left)]
            at, passed = max(at - 1, 0) % len(left), 0
        else:
            at, passed = (at + 1) % len(left), passed + 1
    return np.array([*triangles, tuple(left)], np.int64)


def _is_ear(flat: Array, left: list[int], a: int, b: int, c: int) -> bool:
    """Whether the triangle a, b, c turns to the left and no other corner lies in it."""
    p, q, r = flat[a], flat[b], flat[c]
    if _turn(p, q, r) <= 0:
        return False
    others = flat[[k for k in left if k not in (a, b, c)]].T
    inside = (_turn(p, q, others) >= 0) & (_turn(q, r, others) >= 0) & (_turn(r, p, others) >= 0)
    return not inside.any()


def _turn(p: Array, q: Array, r: Array) -> Any:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
