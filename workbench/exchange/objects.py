"""Objects of a scene on the clipboard: an object and its material as the file writes them, in JSON."""

import msgspec

from workbench.document.scene.model import Material, Object
from workbench.language import _

MIME = "application/x-graphics-workbench-object"


class CopiedObject(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An object with the material it has."""

    thing: Object
    material: Material


# Made here, by the thread that imports: as in ``document.storage.files``.
_decoder = msgspec.json.Decoder(CopiedObject)


def write_object(thing: Object, material: Material) -> bytes:
    """An object as text."""
    return msgspec.json.encode(CopiedObject(thing, material))


def read_object(data: bytes | bytearray | memoryview) -> CopiedObject:
    """The object in such a text, its numbers unchecked. Raises: ValueError with one sentence."""
    try:
        return _decoder.decode(data)
    except (ValueError, RecursionError):
        raise ValueError(_("The object on the clipboard cannot be read; copy it again.")) from None
