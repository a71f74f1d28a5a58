"""The page Visibility with two triangles that overlap, and its run recorded."""

import pytest

from tests.panels.by_hand import keep_until_the_end, recorded
from workbench.document.samples.examples import example
from workbench.panels.space.visibility.page import VisibilityPage
from workbench.session.session import Session


@pytest.fixture
def session(qtbot):
    made = Session(document=example("overlapping-triangles").document)
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def page(qtbot, session):
    made = VisibilityPage(session)
    keep_until_the_end(qtbot, made)
    made.resize(900, 620)
    made.show()
    session.visit("visibility", made.usual)
    recorded(qtbot, session)
    return made
