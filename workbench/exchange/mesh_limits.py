"""How large a mesh may be, told from the numbers that its file begins with, before it is read."""

from collections.abc import Callable

from workbench.document.scene.laws import MOST_TRIANGLES
from workbench.document.scene.meshes import bytes_of_counts
from workbench.document.storage.blobs import MAX_BLOB_BYTES
from workbench.language import _, ngettext

MOST_VERTICES = MOST_FACES = 4_000_000

Refuse = Callable[[int | None, int], None]
"""Given how many vertices and faces a file has, or None and its triangles where it lists these.
Raises ValueError, a sentence, where those are too many."""


def refuse_counts(vertices: int | None, faces: int) -> None:
    """Where a mesh has more than can be worked with."""
    if vertices is None and faces > MOST_FACES:
        sentence = _("The mesh has {triangles}; at most {most:,} can be read. Choose a simpler one.")
        raise ValueError(sentence.format(triangles=_of_triangles(faces), most=MOST_FACES))
    if vertices is not None and (vertices > MOST_VERTICES or faces > MOST_FACES):
        sentence = _(
            "The mesh has {vertices} and {faces}; at most {most:,} of each can be read. Choose a simpler one."
        )
        raise ValueError(
            sentence.format(vertices=of_vertices(vertices), faces=of_faces(faces), most=MOST_FACES)
        )


def refuse_unkept(vertices: int | None, faces: int) -> None:
    """Where it has more, or, even if each face is a triangle, more than a scene has or a document keeps."""
    if vertices is not None:
        refuse_counts(vertices, faces)
    if faces > MOST_TRIANGLES:
        sentence = _(
            "The mesh has {faces}; a scene can have at most {most:,} triangles. Choose a simpler one."
        )
        of = _of_triangles if vertices is None else of_faces
        raise ValueError(sentence.format(faces=of(faces), most=MOST_TRIANGLES))
    if vertices is None:
        return
    size = bytes_of_counts(vertices, faces, 3 * faces)
    if size > MAX_BLOB_BYTES:
        sentence = _(
            "The mesh has {vertices} and {faces}, which take at least {size:,} bytes; a picture can keep at "
            "most {most:,}. Choose a simpler one."
        )
        raise ValueError(
            sentence.format(
                vertices=of_vertices(vertices), faces=of_faces(faces), size=size, most=MAX_BLOB_BYTES
            )
        )


def of_vertices(count: int) -> str:
    """So many vertices, in words."""
    return ngettext("{count:,} vertex", "{count:,} vertices", count).format(count=count)


def of_faces(count: int) -> str:
    """So many faces, in words."""
    return ngettext("{count:,} face", "{count:,} faces", count).format(count=count)


def _of_triangles(count: int) -> str:
    return ngettext("{count:,} triangle", "{count:,} triangles", count).format(count=count)
