"""Resetting a workspace undoes all that was moved in it by hand."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.shell.keys.focus import settle
from workbench.document.samples.examples import example_document
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.widgets.look.split import Split


def test_lines_between_panes_go_back(qtbot: QtBot) -> None:
    window = make_window(Settings())
    qtbot.addWidget(window)
    window.resize(1280, 680)
    window.show()
    window.attach(Session(window, example_document()))
    window.go("view")
    settle()
    area = window.arrangements.area("view")
    assert area is not None
    split = next(each for each in area.findChildren(Split) if each.isVisible() and min(each.sizes()) > 100)
    first, line = split.sizes(), split.handle(1)
    middle = line.rect().center()
    QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(line, middle - QPoint(40, 40))
    QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=middle - QPoint(40, 40))
    assert split.sizes() != first
    window.reset_workspace()
    settle()
    assert split.sizes() == first
