"""A Draw panel over an empty sheet."""

import pytest

from tests.panels.by_hand import LEFT, at, keep_until_the_end, settle
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=blank_sheet(64, 48))
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def panel(qtbot, session):
    made = DrawPanel(session)
    keep_until_the_end(qtbot, made)
    made.resize(850, 600)
    made.show()
    made.canvas.setFocus()
    settle()
    return made


@pytest.fixture
def line(qtbot, session, panel):
    session.new(example_document())
    settle()
    panel.choose_tool("select")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 25, 14))
    settle()
    assert session.state.selection == ("f1",)
    return lambda: session.sheet.figures[0]
