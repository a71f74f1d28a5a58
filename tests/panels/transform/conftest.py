"""A Transform panel with the paper's triangle, and its docks beside it."""

import pytest

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.samples.examples import example
from workbench.panels.transform.panel import TransformPanel
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=example("transform-pivot").document)
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def panel(qtbot, session):
    made = TransformPanel(session)
    keep_until_the_end(qtbot, made)
    qtbot.addWidget(made.chain)
    qtbot.addWidget(made.whole)
    made.resize(900, 620)
    made.chain.resize(400, 500)
    made.show()
    made.chain.show()
    made.canvas.setFocus()
    settle()
    return made
