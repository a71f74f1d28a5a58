"""A session with the picture that a module of tests names, and the page Gun as it is first seen."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.subjects import Subject
from workbench.panels.display.gun.page import GunPage
from workbench.panels.display.vector.page import PAGE, VectorPage
from workbench.session.session import Session


@pytest.fixture
def session(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[Session]:
    """With the example that the module calls ``EXAMPLE``, or the house of lines."""
    made = Session()
    made.open_example(getattr(request.module, "EXAMPLE", "house"))
    made.flush()
    yield made
    made.close()
    made.deleteLater()


def put_on_screen(qtbot: QtBot, page: QWidget, width: int, height: int) -> None:
    """Show a widget that is kept until the test has ended."""
    keep_until_the_end(qtbot, page)
    page.resize(width, height)
    with qtbot.waitExposed(page):
        page.show()


def run_whole(qtbot: QtBot, session: Session, page: str, usual: Subject) -> None:
    """Visit a page, and wait until what it steps is recorded."""
    session.visit(page, usual)
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.run.entry is not None)


@pytest.fixture
def gun_page(qtbot: QtBot, session: Session) -> GunPage:
    made = GunPage(session)
    put_on_screen(qtbot, made, 900, 460)
    run_whole(qtbot, session, "gun", made.usual)
    made.refresh()
    return made


@pytest.fixture
def vector_page(qtbot: QtBot, session: Session) -> VectorPage:
    """The page Random scan, with its run done."""
    made = VectorPage(session)
    put_on_screen(qtbot, made, 900, 560)
    run_whole(qtbot, session, PAGE, VectorPage.usual)
    made.refresh()
    return made
