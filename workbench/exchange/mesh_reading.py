"""Mesh files as polygon meshes, their faces as they are: OBJ, OFF and PLY, and by trimesh STL and GLB.

What cannot be kept is left out and counted; a file is refused only where nothing would be left of it.
"""

import codecs
import re
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.scene.meshes import refuse_bytes
from workbench.document.storage.content import Progress, silent
from workbench.exchange.mesh_limits import Refuse, refuse_counts, refuse_unkept
from workbench.geometry.meshes import Faces, Mesh, face_normals
from workbench.language import _, ngettext

Array = NDArray[np.float64]
Index = NDArray[np.int64]

MOST_BYTES = 256 * 2**20
MOST_CORNERS = 4_096  # of one face
FARTHEST = 1e9
_CONTENT = re.compile(rb"[^ \t\r\n\0]")  # searched for, as stripping would copy a file
_TEXTS = (".obj", ".off", ".ply")  # a PLY begins as one even where it goes on as bytes


class Raw(NamedTuple):
    """What a file says, before it is looked at: vertices (n, 3 or more), faces that may name none of them.

    ``unread`` counts the lines that hold no numbers where numbers belong; ``coloured`` tells whether there
    are colours.
    """

    vertices: Array
    faces: Faces
    unread: int = 0
    coloured: bool = False


class ImportedMesh(NamedTuple):
    """A mesh that was read, and a sentence for what was left out, if anything was."""

    mesh: Mesh
    notes: tuple[str, ...]


def read_mesh(
    content: bytes, suffix: str, progress: Progress = silent, to_keep: bool = False
) -> ImportedMesh:
    """The mesh in a file whose name ends in ``suffix``, not larger than a document can keep if it is
    ``to_keep``. Raises: ValueError with one sentence."""
    if suffix.lower() in _TEXTS:
        content = _unmarked(content)
    if not content:
        raise ValueError(_("The file is empty; choose one with a mesh in it."))
    if not _CONTENT.search(content):
        raise ValueError(_("The file holds nothing but blanks or zero bytes; choose one with a mesh in it."))
    read = sound(_reader(suffix.lower())(content, progress, refuse_unkept if to_keep else refuse_counts))
    if to_keep:
        refuse_bytes(read.mesh)
    return read


def _unmarked(content: bytes) -> bytes:
    """A text that begins with the mark of its encoding as UTF-8 without it; anything else as it is."""
    if content[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE):
        return content.decode("utf-16", "replace").encode()
    return content.removeprefix(codecs.BOM_UTF8)


def _reader(suffix: str) -> Callable[[bytes, Progress, Refuse], Raw]:
    if suffix == ".obj":
        from workbench.exchange.obj_reading import read_obj

        return read_obj
    if suffix == ".off":
        from workbench.exchange.off_reading import read_off

        return read_off
    if suffix == ".ply":
        from workbench.exchange.ply_reading import read_ply

        return read_ply
    if suffix in (".stl", ".glb"):
        from workbench.exchange.triangle_files import reader

        return reader(suffix)
    sentence = _("A file that ends in {suffix} is not a mesh; choose .obj, .off, .ply, .stl or .glb.")
    raise ValueError(sentence.format(suffix=repr(suffix)))


def sound(raw: Raw) -> ImportedMesh:
    """The faces that can be drawn and their vertices. Raises: ValueError where there is none."""
    vertices, faces = raw.vertices[:, :3], raw.faces
    refuse_counts(len(vertices), len(faces))
    if not len(faces) and not raw.unread:
        raise ValueError(_("The file has no face; choose one with a mesh in it."))
    count = len(vertices)
    left_out = []

    def leave_out(bad: NDArray[np.bool_], what: Callable[[int], str]) -> None:
        nonlocal faces
        if bad.any():
            left_out.append(what(int(bad.sum())))
            faces = faces.chosen(~bad)

    sizes = faces.sizes
    leave_out((sizes < 3) | (sizes > MOST_CORNERS), _of_corners)
    leave_out(_any_corner(faces, (faces.corners < 0) | (faces.corners >= count)), _of_missing)
    usable: NDArray[np.bool_] = np.all(np.abs(vertices) <= FARTHEST, axis=1)  # so is no NaN
    if not usable.all():
        leave_out(_any_corner(faces, ~usable[faces.corners]), _of_bad_numbers)
        vertices, faces = _only_used(vertices, faces)
    leave_out(~(face_normals(vertices, faces) != 0).any(axis=1), _of_no_area)
    if raw.unread:
        left_out.append(_of_lines(raw.unread))
    if not len(faces):
        sentence = _("No face of the file can be drawn ({what}); choose another file.")
        raise ValueError(sentence.format(what=_(", ").join(left_out)))
    if raw.coloured:
        left_out.append(_("the colours of the vertices"))
    notes = (_("Left out: {what}.").format(what=_(", ").join(left_out)),) if left_out else ()
    return ImportedMesh(Mesh(np.ascontiguousarray(vertices, np.float64), faces), notes)


def _any_corner(faces: Faces, which: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """The faces (m,) that one of ``which`` corners (k,) is of."""
    if not len(faces) or not which.any():
        return np.zeros(len(faces), bool)
    bad: NDArray[np.bool_] = np.logical_or.reduceat(which, faces.starts)
    return bad


def _only_used(vertices: Array, faces: Faces) -> tuple[Array, Faces]:
    used = np.zeros(len(vertices), bool)
    used[faces.corners] = True
    number = np.cumsum(used) - 1
    return vertices[used], Faces(number[faces.corners], faces.ends)


def _of_corners(count: int) -> str:
    text = ngettext(
        "{count:,} face with fewer than 3 or more than {most:,} corners",
        "{count:,} faces with fewer than 3 or more than {most:,} corners",
        count,
    )
    return text.format(count=count, most=MOST_CORNERS)


def _of_missing(count: int) -> str:
    text = ngettext(
        "{count:,} face with a vertex that does not exist",
        "{count:,} faces with vertices that do not exist",
        count,
    )
    return text.format(count=count)


def _of_bad_numbers(count: int) -> str:
    text = ngettext(
        "{count:,} face with a coordinate that is not a number or too large",
        "{count:,} faces with coordinates that are not numbers or too large",
        count,
    )
    return text.format(count=count)


def _of_no_area(count: int) -> str:
    return ngettext("{count:,} face without area", "{count:,} faces without area", count).format(count=count)


def _of_lines(count: int) -> str:
    text = ngettext("{count:,} line that cannot be read", "{count:,} lines that cannot be read", count)
    return text.format(count=count)
