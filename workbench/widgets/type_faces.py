"""The two type faces: the system's own for words, its fixed-width one for numbers and code."""

from PySide6.QtGui import QFont, QFontDatabase

from workbench.widgets.tokens import TEXT_PX


def code_font(pixels: int = TEXT_PX) -> QFont:
    """The fixed-width font."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPixelSize(pixels)
    font.setStyleHint(QFont.StyleHint.Monospace)
    return font
