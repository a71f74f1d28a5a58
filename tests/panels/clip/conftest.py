"""A Clip panel with its first example."""

import pytest

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.samples.examples import example
from workbench.panels.clip.panel import ClipPanel
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=example("clip").document)
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def panel(qtbot, session):
    made = ClipPanel(session)
    keep_until_the_end(qtbot, made)
    made.resize(900, 620)
    made.show()
    made.canvas.setFocus()
    settle()
    return made
