"""Figures on the clipboard, and how they move: as the file writes them, in JSON."""

from collections.abc import Iterable

import msgspec

from workbench.document.model import AnyFigure, Sheet
from workbench.document.motion.model import Motion
from workbench.document.motion.tracks import motion_copied
from workbench.language import _

MIME = "application/x-graphics-workbench-figures"


class CopiedFigures(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Figures with the ids that they have where they were copied; ``motion`` has the tracks that hang on
    them, None where none do.
    """

    figures: tuple[AnyFigure, ...]
    motion: Motion | None = None


# Made here, by the thread that imports: as in ``document.storage.files``.
_decoder = msgspec.json.Decoder(CopiedFigures)


def write_figures(sheet: Sheet, figures: Iterable[AnyFigure]) -> bytes:
    """Figures of a sheet, and how they move on it, as text."""
    copied = tuple(figures)
    motion = motion_copied(sheet, {figure.id for figure in copied})
    return msgspec.json.encode(CopiedFigures(copied, motion))


def read_figures(data: bytes | bytearray | memoryview) -> CopiedFigures:
    """What such a text holds, their numbers unchecked. Raises: ValueError with one sentence."""
    try:
        return _decoder.decode(data)
    except (ValueError, RecursionError):
        raise ValueError(_("The figures on the clipboard cannot be read; copy them again.")) from None
