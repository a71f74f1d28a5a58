"""The two type faces: the system's own for words, its fixed-width one for numbers and code."""

from functools import cache

from PySide6.QtGui import QFont, QFontDatabase

from workbench.widgets.look.tokens import TEXT_PX


def code_font(pixels: int = TEXT_PX) -> QFont:
    """The fixed-width font."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPixelSize(pixels)
    font.setStyleHint(QFont.StyleHint.Monospace)
    return font


@cache
def cell_font(marked: bool) -> QFont:
    """The font of a table's cells, half bold where ``marked``; all share one object, not to be changed."""
    font = code_font(12)
    font.setWeight(QFont.Weight.DemiBold if marked else QFont.Weight.Normal)
    return font
