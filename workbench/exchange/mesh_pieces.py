"""A mesh as pieces of bytes, each quickly handed on, and again as a whole."""

from collections.abc import Iterable, Iterator
from typing import Literal

import msgspec
import numpy as np

from workbench.geometry.meshes import Faces, Mesh

_BYTES = 2**20


class Piece(msgspec.Struct, tag=True):
    """Some bytes of one of the arrays of a mesh."""

    name: Literal["vertices", "corners", "ends"]
    content: bytes


def pieces_of(mesh: Mesh) -> Iterator[Piece]:
    """The arrays of a mesh, one after the other."""
    vertices, faces = mesh
    yield from _pieces("vertices", vertices.tobytes())
    yield from _pieces("corners", faces.corners.tobytes())
    yield from _pieces("ends", faces.ends.tobytes())


def _pieces(name: Literal["vertices", "corners", "ends"], content: bytes) -> Iterator[Piece]:
    for at in range(0, len(content), _BYTES):
        yield Piece(name, content[at : at + _BYTES])


def whole(pieces: Iterable[Piece]) -> Mesh:
    """The mesh that these are the pieces of."""
    contents: dict[str, list[bytes]] = {"vertices": [], "corners": [], "ends": []}
    for piece in pieces:
        contents[piece.name].append(piece.content)
    vertices = np.frombuffer(b"".join(contents["vertices"]), np.float64).reshape(-1, 3)
    corners, ends = (np.frombuffer(b"".join(contents[name]), np.int64) for name in ("corners", "ends"))
    return Mesh(vertices, Faces(corners, ends))
