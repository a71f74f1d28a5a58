"""Triangles as mesh files: OBJ and PLY as text, STL as bytes.

Vertices are (n, 3), y up; faces (m, 3) count them from 0, counter-clockwise seen from outside.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.language import _


def obj(vertices: ArrayLike, faces: ArrayLike) -> bytes:
    """A Wavefront OBJ text, every digit kept."""
    points, triangles = _checked(vertices, faces)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()]
    return _text(lines)


def ply(vertices: ArrayLike, faces: ArrayLike) -> bytes:
    """A PLY text (Stanford), every digit kept."""
    points, triangles = _checked(vertices, faces)
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property double {axis}" for axis in "xyz"]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles.tolist()]
    return _text(lines)


def stl(vertices: ArrayLike, faces: ArrayLike) -> bytes:
    """A binary STL; its numbers have seven digits, and its triangles share no vertices."""
    points, triangles = _checked(vertices, faces)
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.sqrt((normals * normals).sum(axis=-1, keepdims=True))
    normals = np.divide(normals, size, out=np.zeros_like(normals), where=size > 0)
    table = np.zeros(
        len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    )
    table["normal"], table["corners"] = normals, corners
    return b"triangles in binary".ljust(80) + len(triangles).to_bytes(4, "little") + table.tobytes()


def _checked(vertices: ArrayLike, faces: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    points, triangles = np.asarray(vertices, float), np.asarray(faces, np.int64)
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise ValueError(_("The vertices are not rows of x, y and z; give each three finite numbers."))
    if triangles.size and (triangles.min() < 0 or triangles.max() >= len(points)):
        raise ValueError(_("A triangle names a vertex that is not there; count them from 0."))
    return points, triangles.reshape(-1, 3)


def _text(lines: list[str]) -> bytes:
    return ("\n".join(lines) + "\n").encode("ascii")
