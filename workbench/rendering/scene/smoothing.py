"""Normals at the corners of a mesh, which shadings spread over faces: smooth but where there is an edge."""

from math import cos, radians

import numpy as np

from workbench.geometry.meshes import Array, Faces, Index, Mesh, face_normals

CREASE_DEGREES = 60.0
"""Faces whose normals differ by more meet in an edge that is seen as one."""

_PLACES = 9


def corner_normals(mesh: Mesh, triangles: Index, owners: Index) -> Array:
    """Unit normals (t, 3, 3) at the corners of triangles (t, 3), each a part of the face in ``owners`` (t,).

    Each is the mean, by area, of the normals of the faces around that vertex, without those that meet the
    triangle's own face in an edge; vertices in one place count as one.
    """
    normals = face_normals(*mesh)
    lengths = np.sqrt((normals * normals).sum(axis=1))
    unit = np.divide(normals, lengths[:, None], out=np.zeros_like(normals), where=lengths[:, None] > 0)
    place = _places(mesh.vertices)
    begins, around = _faces_around(place, mesh.faces)
    corners, own = place[triangles].ravel(), np.repeat(owners, 3)
    counts = begins[corners + 1] - begins[corners]
    of = np.repeat(np.arange(len(corners)), counts)
    within = np.arange(len(of)) - np.repeat(np.cumsum(counts) - counts, counts)
    other = around[begins[corners[of]] + within]
    smooth = (unit[other] * unit[own[of]]).sum(axis=1) >= cos(radians(CREASE_DEGREES))
    of, other = of[smooth], other[smooth]
    sums = [np.bincount(of, weights=column[other], minlength=len(corners)) for column in normals.T]
    found = np.stack(sums, axis=1)
    sizes = np.sqrt((found * found).sum(axis=1, keepdims=True))
    spread: Array = np.where(sizes > 0, found / np.where(sizes > 0, sizes, 1.0), unit[own])
    return spread.round(_PLACES).reshape(-1, 3, 3) + 0.0  # without noise, and without -0


def _places(vertices: Array) -> Index:
    """For each vertex (n,) the number of its place."""
    _unique, numbers = np.unique(vertices.round(_PLACES), axis=0, return_inverse=True)
    return numbers.reshape(-1).astype(np.int64)


def _faces_around(place: Index, faces: Faces) -> tuple[Index, Index]:
    """The faces around each place, one place after the other, and where in that list each begins (p + 1,)."""
    corners, owners = place[faces.corners], np.repeat(np.arange(len(faces)), faces.sizes)
    order = np.argsort(corners, kind="stable")
    count = int(corners.max()) + 1 if len(corners) else 0
    return np.searchsorted(corners[order], np.arange(count + 1)), owners[order]
