"""Meshes as files: OBJ and PLY as text, with the faces as they are, STL as bytes, in triangles.

Vertices are (n, 3), y up; faces count them from 0, counter-clockwise seen from outside, as ``Faces.of`` takes
them: an array (m, corners), or lists.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from workbench.geometry.meshes import Array, Faces, face_normals, triangulated
from workbench.language import _

AnyFaces = ArrayLike | Sequence[Sequence[int]] | Faces


def obj(vertices: ArrayLike, faces: AnyFaces) -> bytes:
    """A Wavefront OBJ text, every digit kept."""
    points, polygons = _checked(vertices, faces)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {' '.join(map(str, face))}" for face in _lists(polygons, 1)]
    return _text(lines)


def ply(vertices: ArrayLike, faces: AnyFaces) -> bytes:
    """A PLY text (Stanford), every digit kept."""
    points, polygons = _checked(vertices, faces)
    size = "uchar" if len(polygons) == 0 or polygons.sizes.max() < 256 else "int"
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property double {axis}" for axis in "xyz"]
    lines += [f"element face {len(polygons)}", f"property list {size} int vertex_indices", "end_header"]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"{len(face)} {' '.join(map(str, face))}" for face in _lists(polygons, 0)]
    return _text(lines)


def stl(vertices: ArrayLike, faces: AnyFaces) -> bytes:
    """A binary STL; its numbers have seven digits, and its triangles share no vertices."""
    points, polygons = _checked(vertices, faces)
    triangles, _owners = triangulated(points, polygons)
    normals = face_normals(points, Faces.of(triangles))
    size = np.sqrt((normals * normals).sum(axis=-1, keepdims=True))
    normals = np.divide(normals, size, out=np.zeros_like(normals), where=size > 0)
    table = np.zeros(
        len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    )
    table["normal"], table["corners"] = normals, points[triangles]
    return b"triangles in binary".ljust(80) + len(triangles).to_bytes(4, "little") + table.tobytes()


def _checked(vertices: ArrayLike, faces: AnyFaces) -> tuple[Array, Faces]:
    points, polygons = np.asarray(vertices, float), Faces.of(faces)
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise ValueError(_("The vertices are not rows of x, y and z; give each three finite numbers."))
    corners = polygons.corners
    if corners.size and (corners.min() < 0 or corners.max() >= len(points)):
        raise ValueError(_("A face names a vertex that does not exist; count them from 0."))
    return points, polygons


def _lists(faces: Faces, first: int) -> list[list[int]]:
    """The corners of each face, counted from ``first``."""
    corners = (faces.corners + first).tolist()
    return [corners[a:b] for a, b in zip(faces.starts.tolist(), faces.ends.tolist(), strict=True)]


def _text(lines: list[str]) -> bytes:
    return ("\n".join(lines) + "\n").encode("ascii")
