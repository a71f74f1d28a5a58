"""Tooltips that hold what others have written, such as the name of a file."""

from html import escape

from PySide6.QtWidgets import QComboBox

from workbench.language import legible

_LONGEST = 300


def tell_choice(box: QComboBox) -> None:
    """Let the tooltip of ``box`` begin with what is chosen, all of it, wherever there is little room."""
    meaning = box.toolTip()

    def tell(text: str) -> None:
        box.setToolTip("\n".join(filter(None, (plain_tip(text), meaning))))

    box.currentTextChanged.connect(tell)
    tell(box.currentText())


def plain_tip(text: str) -> str:
    """A tooltip that shows ``text`` as it is: Qt would take what looks like HTML for it."""
    shown = legible(text, _LONGEST)
    return f"<span>{escape(shown)}</span>" if "<" in shown else shown
