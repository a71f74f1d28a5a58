"""The blobs that are values in a document: their digests stand in its text, their contents beside it."""

from collections.abc import Mapping
from typing import Any

from msgspec.structs import replace

from workbench.document.errors import DocumentError
from workbench.document.model import Document, Sheet
from workbench.document.scene.solids import MeshSolid
from workbench.document.storage.blobs import Blob, Named
from workbench.language import _

_DIGEST_DIGITS = 64


def as_text(value: Any) -> str:
    """What the text of a document has for a value that JSON does not know; for encoders."""
    if isinstance(value, Blob):
        return value.digest
    raise TypeError(type(value).__name__)


def from_text(kind: type, text: Any) -> Any:
    """The value that such a text stands for; for decoders. Raises: ValueError."""
    if kind is Blob and isinstance(text, str) and len(text) == _DIGEST_DIGITS:
        return Named(text)
    raise ValueError(_("a digest of {count} digits belongs here").format(count=_DIGEST_DIGITS))


def blobs_of(document: Document) -> dict[str, bytes]:
    """The contents of all blobs in a document whose content is there, by their digests."""
    blobs = (blob for sheet in document.sheets for blob in _blobs_on(sheet) if not isinstance(blob, Named))
    return {blob.digest: blob for blob in blobs}


def with_contents(document: Document, blobs: Mapping[str, bytes], later: frozenset[str]) -> Document:
    """``document`` with contents for its digests; those of ``later`` may be missing.

    Raises: DocumentError where another one is missing.
    """
    if not any(isinstance(blob, Named) for sheet in document.sheets for blob in _blobs_on(sheet)):
        return document
    sheets = []
    for number, sheet in enumerate(document.sheets):
        scene = sheet.scene
        if scene is not None:
            objects = []
            for index, thing in enumerate(scene.objects):
                solid = thing.solid
                if isinstance(solid, MeshSolid) and isinstance(solid.content, Named):
                    digest = solid.content.digest
                    if digest in blobs:
                        thing = replace(thing, solid=MeshSolid(_blob(blobs[digest])))
                    elif digest not in later:
                        field = f"sheets[{number}].scene.objects[{index}].solid.content"
                        sentence = _("{field} is not in the file; open another copy of it.")
                        raise DocumentError(field, sentence.format(field=field))
                objects.append(thing)
            scene = replace(scene, objects=tuple(objects))
        sheets.append(replace(sheet, scene=scene))
    return replace(document, sheets=tuple(sheets))


def _blob(content: bytes) -> Blob:
    return content if isinstance(content, Blob) else Blob(content)


def _blobs_on(sheet: Sheet) -> list[Blob]:
    objects = sheet.scene.objects if sheet.scene is not None else ()
    return [thing.solid.content for thing in objects if isinstance(thing.solid, MeshSolid)]
