"""Tooltips that hold what others have written, such as the name of a file."""

from html import escape

from workbench.language import legible

_LONGEST = 300


def plain_tip(text: str) -> str:
    """A tooltip that shows ``text`` as it is: Qt would take what looks like HTML for it."""
    shown = legible(text, _LONGEST)
    return f"<span>{escape(shown)}</span>" if "<" in shown else shown
