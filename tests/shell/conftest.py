"""A window with small panels of its own, so that these tests are about the window."""

import sys
from collections.abc import Callable, Iterator
from types import ModuleType

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from workbench.document.addresses import new_ids
from workbench.document.edits import add_figure
from workbench.document.model import Line, WorldPoint
from workbench.document.samples.examples import example_document
from workbench.panels.panel import PlainPanel
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import Workspace

MODULE = "tests_shell_panels"


class Drawing(PlainPanel, QWidget):
    """A canvas on which a press adds a line, beside a text field."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self.title = "Drawing"
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.field = QLineEdit()
        self.source = QLabel("source")
        self.source.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.tube = QLabel("tube")

    @property
    def center(self) -> QWidget:
        return self

    def docks(self) -> list[tuple[str, str, QWidget, str]]:
        return [
            ("source", "Source", self.source, "right"),
            ("values", "Values", self.field, "right"),
            ("tube", "Tube", self.tube, "right"),
        ]

    def mousePressEvent(self, event: object) -> None:
        figure, start, end = new_ids(self.session.document, "n", 3)
        line = Line(figure, (WorldPoint(start, 1, 1), WorldPoint(end, 9, 5)), "bresenham_line")
        self.session.apply(add_figure(self.session.sheet.id, line), "Draw a line")


class Showing(PlainPanel, QWidget):
    """A panel without docks."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.title = "Showing"

    @property
    def center(self) -> QWidget:
        return self


OFFERED = (
    Workspace("draw", "Draw", "Lines", "pencil-line", (f"{MODULE}:Drawing",), lower=("tube",)),
    Workspace("display", "Display", "Tubes", "monitor", (f"{MODULE}:Showing",)),
)


@pytest.fixture(autouse=True)
def nothing_is_left_in_front(qapp: QApplication) -> Iterator[None]:
    """A dialog or menu that a test leaves open would hold up the tests that follow it."""
    yield
    qapp.processEvents()
    assert qapp.activePopupWidget() is None
    assert qapp.activeModalWidget() is None


@pytest.fixture
def panels() -> Iterator[None]:
    module = ModuleType(MODULE)
    module.Drawing, module.Showing = Drawing, Showing  # type: ignore[attr-defined]
    sys.modules[MODULE] = module
    yield
    del sys.modules[MODULE]


@pytest.fixture
def open_window(qtbot: QtBot, panels: None) -> Iterator[Callable[[], MainWindow]]:
    """Opens another window, as another start of the program in the same profile would."""
    opened: list[MainWindow] = []

    def make() -> MainWindow:
        window = make_window(Settings(), OFFERED)
        opened.append(window)
        window.show()
        window.resize(1280, 680)
        window.attach(Session(window, example_document()))
        qtbot.waitExposed(window)
        return window

    yield make
    for window in opened:
        leave(window)


def leave(window: MainWindow) -> None:
    """Close without a question."""
    window.session.undo_stack.setClean()
    window.close()
    window.deleteLater()
    QApplication.processEvents()


@pytest.fixture
def window(open_window: Callable[[], MainWindow]) -> MainWindow:
    return open_window()


def press(qtbot: QtBot, widget: QWidget, at: tuple[int, int] = (40, 40)) -> None:
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=QPoint(*at))
