"""Nothing but the window itself ever appears as a window of its own, however panels are made and changed."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.workspaces import workspaces


class Windows(QObject):
    """Notes every window that is shown."""

    def __init__(self) -> None:
        super().__init__()
        self.shown: list[str] = []

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show and isinstance(watched, QWidget) and watched.isWindow():
            self.shown.append(type(watched).__name__)
        return False


@pytest.fixture
def windows(qtbot: QtBot) -> Iterator[Windows]:
    application = QApplication.instance()
    assert application is not None
    made = Windows()
    application.installEventFilter(made)
    yield made
    application.removeEventFilter(made)


def test_one_window(qtbot: QtBot, windows: Windows) -> None:
    window = make_window(Settings())
    window.show()
    session = Session(window, example_document())
    window.attach(session)
    for workspace in workspaces():
        window.go(workspace.slug)
        for figure in (*session.sheet.figures, None):
            session.update_state(selection=(figure.id,) if figure else ())
            qtbot.wait(20)
    window.go("home")
    assert windows.shown == ["MainWindow"]
    window.close()
    window.deleteLater()
