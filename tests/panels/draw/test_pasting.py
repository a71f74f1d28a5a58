"""What cannot be pasted on a canvas of figures is told apart, with what to do."""

import pytest
from PySide6.QtGui import QGuiApplication


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("M 10 10 L 20 40", "The text on the clipboard is not an SVG; "),
        ("3 4\n20 30", "The text on the clipboard is not an SVG; "),
        (" \n", "There are no figures on the clipboard; copy some first."),
        ("", "There are no figures on the clipboard; copy some first."),
    ],
)
def test_text_that_is_no_figure_leads_to_where_it_can_be_pasted(qtbot, session, panel, text, said):
    told, before = [], session.document
    panel.hover_text.connect(told.append)
    QGuiApplication.clipboard().clear()
    if text:
        QGuiApplication.clipboard().setText(text)
    panel.canvas.setFocus()
    panel.paste()
    assert told[-1].startswith(said)
    assert session.document == before
