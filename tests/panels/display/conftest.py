"""The page Gun over a session of its own, as it is first seen."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.panels.display.gun.page import GunPage
from workbench.session.session import Session


@pytest.fixture
def session() -> Iterator[Session]:
    made = Session()
    made.flush()
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def gun_page(qtbot: QtBot, session: Session) -> GunPage:
    made = GunPage(session)
    keep_until_the_end(qtbot, made)
    made.resize(900, 460)
    with qtbot.waitExposed(made):
        made.show()
    session.visit("gun", made.usual)
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)
    made.refresh()
    return made
