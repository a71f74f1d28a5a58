"""Keys pressed without Ctrl, Alt or Meta: with one of them held, the same key means another thing."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

_CONTROL_ALT = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
_HELD = _CONTROL_ALT | Qt.KeyboardModifier.MetaModifier


def is_plain(event: QKeyEvent) -> bool:
    """Whether neither Ctrl nor Alt nor Meta is held; Shift may be, as some keyboards need it for + or ?."""
    held = event.modifiers() & _HELD
    typed = event.text()
    # Windows sends both for AltGr, with which a German keyboard types a bracket
    return not held or (held == _CONTROL_ALT and typed != "" and typed.isprintable())
