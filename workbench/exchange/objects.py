"""Objects of a scene on the clipboard: an object, its material and how it moves, as the file writes them."""

import msgspec

from workbench.document.model import Sheet
from workbench.document.motion.model import Motion
from workbench.document.motion.tracks import motion_copied
from workbench.document.scene.model import Material, Object
from workbench.language import _

MIME = "application/x-graphics-workbench-object"


class CopiedObject(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """An object with the material it has; ``motion`` has the tracks that hang on it, None where none do."""

    thing: Object
    material: Material
    motion: Motion | None = None


# Made here, by the thread that imports: as in ``document.storage.files``.
_decoder = msgspec.json.Decoder(CopiedObject)


def write_object(sheet: Sheet, thing: Object, material: Material) -> bytes:
    """An object of the scene of a sheet, and how it moves there, as text."""
    return msgspec.json.encode(CopiedObject(thing, material, motion_copied(sheet, (thing.id,))))


def read_object(data: bytes | bytearray | memoryview) -> CopiedObject:
    """The object in such a text, its numbers unchecked. Raises: ValueError with one sentence."""
    try:
        return _decoder.decode(data)
    except (ValueError, RecursionError):
        raise ValueError(_("The object on the clipboard cannot be read; copy it again.")) from None
