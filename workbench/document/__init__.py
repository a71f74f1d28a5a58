"""The picture as a value: model, edits, addresses, files."""

from workbench.document.errors import DocumentError
from workbench.document.scene.model import Camera
from workbench.document.storage.files import Stored, load, read, save, write

__all__ = ["Camera", "DocumentError", "Stored", "load", "read", "save", "write"]
