"""The page Raster after its first run."""

import pytest
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen, run_whole
from workbench.panels.display.raster.page import RasterPage
from workbench.session.session import Session


@pytest.fixture
def page(qtbot: QtBot, session: Session) -> RasterPage:
    made = RasterPage(session)
    put_on_screen(qtbot, made, 1000, 640)
    run_whole(qtbot, session, "raster", made.usual)
    assert session.run.total_text == "48"
    made.refresh()
    return made


def show_dock(qtbot: QtBot, dock) -> None:
    """A dock of the page, in a window of its own."""
    dock.resize(360, 700)
    with qtbot.waitExposed(dock):
        dock.show()
