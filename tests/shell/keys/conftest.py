"""The program's own window with something to undo and to redo."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    """The program's own window with a picture that has something to undo and something to redo."""
    window = make_window(Settings())
    window.resize(1280, 900)
    window.show()
    window.attach(Session(window))
    qtbot.waitExposed(window)
    yield window
    leave(window)
