"""Normals at the corners of a mesh, which shadings spread over faces: smooth but where there is an edge."""

from collections.abc import Iterator
from math import cos, radians
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.meshes import Array, Faces, Index, Mesh, face_normals

CREASE_DEGREES = 60.0
"""Faces whose normals differ by more meet in an edge that is seen as one."""

MOST_AROUND = 4_096
"""Where more corners meet each has the normal of its own face: there each would be held against each."""

_PLACES = 9
_UNIT = 10**_PLACES  # what a component of 1 is kept as: two thirds of the memory of a fine mesh were normals
_UNKNOWN = np.iinfo(np.int32).min
_AT_ONCE = 1 << 14  # triangles: what is worked out on the way takes little memory
_PAIRS = 1 << 16  # of a corner and a face around it

Index32 = NDArray[np.int32]


class CornerNormals:
    """Unit normals at the corners of triangles (t, 3) of a mesh, each a part of the face in ``owners`` (t,).

    Each is the mean, by area, of the normals of the faces around that vertex, without those that meet the
    triangle's own face in an edge; vertices in one place count as one. Corners in one place nearly always
    have one normal, which is kept once for them.
    """

    def __init__(self, mesh: Mesh, triangles: Index, owners: Index) -> None:
        around = _Around.of(mesh)
        places = len(around.begins) - 1
        self._of_place = np.full((places, 3), _UNKNOWN, np.int32)
        self._numbers = np.empty((len(triangles), 3), np.int32)
        others = np.empty((triangles.size, 3), np.int32)  # of which only what is written takes memory
        count = 0
        for first, end in around.shares(triangles):
            unit = around.normals(triangles[first:end], owners[first:end])
            normals = np.rint(unit * _UNIT).astype(np.int32)  # without noise, and without -0
            here = around.place[triangles[first:end]].ravel()
            new = self._of_place[here, 0] == _UNKNOWN
            self._of_place[here[new]] = normals[new]
            other = (self._of_place[here] != normals).any(axis=1)
            after = count + int(other.sum())
            here[other] = places + np.arange(count, after)
            others[count:after] = normals[other]
            self._numbers[first:end] = here.reshape(-1, 3)
            count = after
        self._others = others[:count]

    def of(self, first: int, end: int) -> Array:
        """Those (end - first, 3, 3) of some triangles."""
        numbers, places = self._numbers[first:end], len(self._of_place)
        is_other = numbers >= places
        normals = self._of_place[np.where(is_other, 0, numbers)]
        normals[is_other] = self._others[numbers[is_other] - places]
        unit: Array = normals / _UNIT
        return unit


class _Around(NamedTuple):
    """The place of each vertex (n,); the faces around each place, one place after the other, and where in
    that list each begins (p + 1,); the normals of the faces (m, 3), as long as twice their areas."""

    place: Index32
    faces: Index32
    begins: Index
    face_normals: Array

    @classmethod
    def of(cls, mesh: Mesh) -> "_Around":
        place = _places(mesh.vertices)
        return cls(place, *_faces_around(place, mesh.faces), face_normals(*mesh))

    def shares(self, triangles: Index) -> Iterator[tuple[int, int]]:
        """The first and the end of shares of triangles (t, 3), each with few faces around its corners."""
        for low in range(0, len(triangles), _AT_ONCE):
            pairs = np.cumsum(self._counts(triangles[low : low + _AT_ONCE]).sum(axis=1))
            first = before = 0
            while first < len(pairs):
                end = max(int(np.searchsorted(pairs, before + _PAIRS)), first + 1)
                yield low + first, low + end
                first, before = end, int(pairs[end - 1])

    def _counts(self, triangles: Index) -> Index:
        """How many faces around the corners of triangles (t, 3) are asked: (t, 3)."""
        corners = self.place[triangles]
        counts = self.begins[corners + 1] - self.begins[corners]
        return np.where(counts > MOST_AROUND, 0, counts)

    def normals(self, triangles: Index, owners: Index) -> Array:
        """The normals (3 t, 3) at the corners of triangles (t, 3) of the faces in ``owners`` (t,)."""
        corners, own = self.place[triangles].ravel(), _unit(self.face_normals[np.repeat(owners, 3)])
        counts = self._counts(triangles).ravel()
        of = np.repeat(np.arange(len(corners)), counts)
        within = np.arange(len(of)) - np.repeat(np.cumsum(counts) - counts, counts)
        weighted = self.face_normals[self.faces[self.begins[corners[of]] + within]]
        smooth = (_unit(weighted) * own[of]).sum(axis=1) >= cos(radians(CREASE_DEGREES))
        of, weighted = of[smooth], weighted[smooth]
        sums = [np.bincount(of, weights=column, minlength=len(corners)) for column in weighted.T]
        total = np.stack(sums, axis=1)
        sizes = np.sqrt((total * total).sum(axis=1, keepdims=True))
        spread: Array = np.where(sizes > 0, total / np.where(sizes > 0, sizes, 1.0), own)
        return spread


def _unit(normals: Array) -> Array:
    """0 where a face has no area."""
    lengths = np.sqrt((normals * normals).sum(axis=1))[:, None]
    unit: Array = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    return unit


def _places(vertices: Array) -> Index32:
    """For each vertex (n,) the number of its place."""
    columns = vertices.round(_PLACES).T
    order = np.lexsort(columns)
    new = np.zeros(len(order), bool)
    for column in columns:
        new[1:] |= np.diff(column[order]) != 0
    numbers = np.empty(len(order), np.int32)
    numbers[order] = np.cumsum(new)
    return numbers


def _faces_around(place: Index32, faces: Faces) -> tuple[Index32, Index]:
    """The faces around each place, one place after the other, and where in that list each begins (p + 1,)."""
    corners = place[faces.corners]
    count = int(place.max(initial=-1)) + 1
    begins = np.concatenate([[0], np.cumsum(np.bincount(corners, minlength=count))])
    order = np.argsort(corners, kind="stable")
    return np.repeat(np.arange(len(faces), dtype=np.int32), faces.sizes)[order], begins
