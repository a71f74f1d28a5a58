"""A panel with figures in the box."""

import pytest

from tests.panels.by_hand import keep_until_the_end
from tests.panels.stage.boxed import settle
from workbench.document.edits import add_figures
from workbench.document.samples.examples import blank_sheet
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session


@pytest.fixture
def opened(qtbot):
    sessions = []

    def make(*figures, kind=DrawPanel):
        session = Session(document=add_figures("s1", figures)(blank_sheet(64, 48)))
        sessions.append(session)
        panel = kind(session)
        keep_until_the_end(qtbot, panel)
        panel.resize(1000, 640)
        panel.show()
        qtbot.waitExposed(panel)
        panel.choose_tool("select")
        panel.select_all()
        panel.canvas.setFocus()
        settle()
        panel.toggle_box()
        settle()
        return panel

    yield make
    for session in sessions:
        session.close()
        session.deleteLater()
