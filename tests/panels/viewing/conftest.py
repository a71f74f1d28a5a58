"""A session with the numbers of the course, and the panel over it as large as in a window."""

import pytest

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.samples.examples import example
from workbench.panels.viewing.panel import ViewingPanel
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=example("view-numbers").document)
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def panel(qtbot, session):
    made = ViewingPanel(session)
    keep_until_the_end(qtbot, made)
    qtbot.addWidget(made.card)
    qtbot.addWidget(made.point)
    made.resize(1000, 640)
    made.show()
    made.card.resize(420, 600)
    made.card.show()
    made.point.resize(420, 400)
    made.point.show()
    settle()
    return made
