"""Meshes as the bytes that a document keeps, equal where their content is."""

from functools import lru_cache

import numpy as np

from workbench.document.storage.blobs import Blob
from workbench.geometry.meshes import Faces, Mesh
from workbench.language import _

_HEAD = b"mesh 1\n\0"
FARTHEST = 1e9


def blob_of(mesh: Mesh) -> Blob:
    """The bytes of a mesh. Raises: DocumentError where they are more than a document keeps."""
    vertices, faces = mesh
    counts = np.array([len(vertices), len(faces.corners), len(faces)], "<i8")
    arrays = (counts, vertices.astype("<f8"), faces.corners.astype("<i4"), faces.ends.astype("<i4"))
    return Blob(_HEAD + b"".join(array.tobytes() for array in arrays))


@lru_cache(maxsize=64)
def mesh_of(blob: Blob) -> Mesh:
    """The mesh of some bytes, read-only. Raises: ValueError, a sentence, where they are none."""
    refusal = ValueError(_("The content is not a mesh, or it is damaged; open another copy."))
    if blob[: len(_HEAD)] != _HEAD or len(blob) < len(_HEAD) + 24:
        raise refusal
    n, k, m = np.frombuffer(blob, "<i8", 3, len(_HEAD)).tolist()
    if min(n, k, m) < 0 or len(blob) != len(_HEAD) + 24 + 24 * n + 4 * k + 4 * m:
        raise refusal
    vertices = np.frombuffer(blob, "<f8", 3 * n, len(_HEAD) + 24).reshape(-1, 3)
    corners = np.frombuffer(blob, "<i4", k, len(_HEAD) + 24 + 24 * n).astype(np.int64)
    ends = np.frombuffer(blob, "<i4", m, len(_HEAD) + 24 + 24 * n + 4 * k).astype(np.int64)
    whole = (ends[-1] == k if m else k == 0) and (np.diff(ends, prepend=0) >= 3).all()
    named = k == 0 or 0 <= corners.min() <= corners.max() < n
    if not (whole and named and (np.abs(vertices) <= FARTHEST).all()):
        raise refusal
    return Mesh(vertices.astype(np.float64), Faces(corners, ends))
