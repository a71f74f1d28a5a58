"""Meshes as the bytes that a document keeps, equal where their content is."""

import numpy as np

from workbench.document.errors import DocumentError
from workbench.document.storage.blobs import MAX_BLOB_BYTES, Blob
from workbench.geometry.meshes import Faces, Mesh
from workbench.language import _

_HEAD = b"mesh 1\n\0"
FARTHEST = 1e9
_COUNTS, _VERTEX, _NUMBER = 24, 24, 4  # bytes


def blob_of(mesh: Mesh) -> Blob:
    """The bytes of a mesh. Raises: DocumentError where they are more than a document keeps."""
    refuse_bytes(mesh)
    return Blob(_bytes_of(mesh))


def refuse_bytes(mesh: Mesh) -> None:
    """Raises: DocumentError, a sentence, where a mesh takes more bytes than a document keeps."""
    vertices, faces = mesh
    size = len(_HEAD) + _COUNTS + bytes_of_counts(len(vertices), len(faces), len(faces.corners))
    if size > MAX_BLOB_BYTES:
        sentence = _(
            "As a part of a picture the mesh takes {size:,} bytes, but at most {most:,} can be kept; choose "
            "a simpler one."
        )
        raise DocumentError("", sentence.format(size=size, most=MAX_BLOB_BYTES))


def bytes_of_counts(vertices: int, faces: int, corners: int) -> int:
    """How many bytes the numbers of a mesh take."""
    return _VERTEX * vertices + _NUMBER * (faces + corners)


def _bytes_of(mesh: Mesh) -> bytes:
    vertices, faces = mesh
    counts = np.array([len(vertices), len(faces.corners), len(faces)], "<i8")
    numbers = (np.ascontiguousarray(each, "<i4") for each in (faces.corners, faces.ends))
    # The arrays themselves, not their bytes: a fine mesh would be there several times.
    return b"".join(
        [_HEAD, counts.data, np.ascontiguousarray(vertices, "<f8").data, *(n.data for n in numbers)]
    )


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
