"""The two type faces, the system's own for words, its fixed-width one for numbers and code, and how large
type is: every size of it that is given in pixels goes through ``scaled``.
"""

from functools import cache

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QFont, QFontDatabase
from PySide6.QtWidgets import QAbstractScrollArea, QWidget

from workbench.widgets.look.tokens import TEXT_PX


class TypeScale(QObject):
    """How many times as large as designed type is; only the shell changes it. ``changed``: it is another, and
    the program's own font follows it already.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.factor = 1.0


type_scale = TypeScale()


def scaled(pixels: int) -> int:
    """The size of type that is designed with so many pixels, in pixels."""
    return round(pixels * type_scale.factor)


def code_font(pixels: int = TEXT_PX, weight: QFont.Weight = QFont.Weight.Normal) -> QFont:
    """The fixed-width font, of a size as it is designed."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPixelSize(scaled(pixels))
    font.setStyleHint(QFont.StyleHint.Monospace)
    font.setWeight(weight)
    return font


def cell_font(marked: bool) -> QFont:
    """The font of a table's cells, half bold where ``marked``; all share one object, not to be changed."""
    return _cell_font(marked, type_scale.factor)


@cache
def _cell_font(marked: bool, _factor: float) -> QFont:
    return code_font(12, QFont.Weight.DemiBold if marked else QFont.Weight.Normal)


class _CodeFont(QObject):
    """Keeps a widget in the fixed-width font as large as type is; it goes with the widget."""

    def __init__(self, widget: QWidget, pixels: int, weight: QFont.Weight) -> None:
        super().__init__(widget)
        self._widget, self._pixels, self._weight = widget, pixels, weight
        type_scale.changed.connect(self._put)
        self._put()

    def _put(self) -> None:
        font = code_font(self._pixels, self._weight)
        self._widget.setFont(font)
        if isinstance(self._widget, QAbstractScrollArea):
            self._widget.viewport().setFont(font)  # a heading is painted in this one's, which keeps its own


def keep_code_font(
    widget: QWidget, pixels: int = TEXT_PX, weight: QFont.Weight = QFont.Weight.Normal
) -> None:
    """Let a widget have the fixed-width font, of a size as it is designed, also when type becomes larger."""
    _CodeFont(widget, pixels, weight)
