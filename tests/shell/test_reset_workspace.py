"""Resetting a workspace undoes all that was moved in it by hand."""

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.shell.keys.focus import settle
from workbench.document.samples.examples import example_document
from workbench.panels.space.objects_dock import ObjectsDock
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.widgets.look.split import Split


@pytest.fixture
def window(qtbot: QtBot) -> MainWindow:
    window = make_window(Settings())
    qtbot.addWidget(window)
    window.resize(1280, 680)
    window.show()
    window.attach(Session(window, example_document()))
    return window


def test_lines_between_panes_go_back(window: MainWindow) -> None:
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


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
def test_menus_of_docks_live_on_when_the_area_they_were_in_is_gone(window: MainWindow) -> None:
    window.go("space")
    settle()
    for _again in range(2):
        window.reset_workspace()
        settle()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        # Not searched for below the window: that alone would keep them alive, or end them.
        docks = (each for each in QApplication.allWidgets() if isinstance(each, ObjectsDock))
        (dock,) = (each for each in docks if each.window() is window)
        dock.add.menu().aboutToShow.emit()
        assert all(isValid(menu) for menu in dock._swept.values())
