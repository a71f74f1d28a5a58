"""Figures on the clipboard: the list of them as the file writes figures, in JSON."""

import msgspec

from workbench.document.model import AnyFigure

MIME = "application/x-graphics-workbench-figures"


def write_figures(figures: list[AnyFigure]) -> bytes:
    """Figures as text."""
    return msgspec.json.encode(figures)


def read_figures(data: bytes | bytearray | memoryview) -> list[AnyFigure]:
    """The figures in such a text, their numbers unchecked. Raises: ValueError."""
    return msgspec.json.decode(data, type=list[AnyFigure])
