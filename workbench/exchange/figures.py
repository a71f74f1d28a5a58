"""Figures on the clipboard: the list of them as the file writes figures, in JSON."""

import msgspec

from workbench.document.model import AnyFigure
from workbench.language import _

# Made here, by the thread that imports: as in ``document.storage.files``.
_decoder = msgspec.json.Decoder(list[AnyFigure])
MIME = "application/x-graphics-workbench-figures"


def write_figures(figures: list[AnyFigure]) -> bytes:
    """Figures as text."""
    return msgspec.json.encode(figures)


def read_figures(data: bytes | bytearray | memoryview) -> list[AnyFigure]:
    """The figures in such a text, their numbers unchecked. Raises: ValueError with one sentence."""
    try:
        return _decoder.decode(data)
    except (ValueError, RecursionError):
        raise ValueError(_("The figures on the clipboard cannot be read; copy them again.")) from None
