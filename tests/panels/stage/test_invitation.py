"""What an empty canvas says is read whole, also on a narrow or a low one."""

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.samples.examples import blank_sheet
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.stage.invitation import Invitation
from workbench.panels.transform.panel import TransformPanel
from workbench.session.session import Session

SENTENCE = "Click corners on the canvas to draw a polygon, then give it a transform."


@pytest.mark.parametrize("size", [(765, 450), (444, 325), (300, 200)])
def test_the_sentence_fits_its_canvas(qtbot: QtBot, size: tuple[int, int]) -> None:
    canvas = QWidget()
    qtbot.addWidget(canvas)
    canvas.resize(*size)
    invitation = Invitation(canvas, SENTENCE, lambda: None)
    canvas.show()
    invitation.setVisible(True)
    assert canvas.rect().contains(invitation.geometry())
    assert invitation.sentence.height() >= invitation.sentence.heightForWidth(invitation.sentence.width())
    assert invitation.sentence.width() <= size[0]


DRAWN_BY = [
    (FillPanel, "polygon", "corners of a polygon"),
    (FillPanel, "seed", "Draw a boundary, then click inside it"),
    (FillPanel, "brush", "paint freehand"),
    (FillPanel, "select", "Choose a tool on the left"),
    (TransformPanel, "polygon", "Click corners on the canvas"),
    (TransformPanel, "select", "Choose a tool on the left"),
    (DrawPanel, "circle", "centre of a circle"),
    (DrawPanel, "polyline", "Enter ends it"),
    (ClipPanel, "window", "clip window, then lines"),
    (ClipPanel, "point", "place a point"),
    (CurvesPanel, "freehand", "freehand"),
    (CurvesPanel, "probe", "Draw a curve first"),
    (AnimatePanel, "select", "Nothing moves yet"),
]


@pytest.mark.parametrize(("kind", "tool", "said"), DRAWN_BY)
def test_an_empty_sheet_says_how_to_draw_with_the_tool_that_is_taken(
    qtbot: QtBot, kind: type, tool: str, said: str
) -> None:
    session = Session(document=blank_sheet())
    panel = kind(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 620)
    panel.show()
    settle()
    panel._actions[tool].trigger()
    settle()
    assert panel.empty.isVisible()
    assert said in panel.empty.sentence.text()
    assert panel.canvas.rect().contains(panel.empty.geometry())
    session.close()


def test_the_plane_without_figures_takes_up_its_tool_when_one_comes_back_from_space(qtbot: QtBot) -> None:
    session = Session(document=blank_sheet())
    panel = TransformPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.show_page("space")
    panel.show()
    settle()
    panel.show_page("plane")
    assert panel.tool.name == "polygon"
    session.close()
