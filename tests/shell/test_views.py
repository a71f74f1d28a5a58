"""Views that take each other's place leave something to be seen."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from tests.shell.keys.focus import settle
from workbench.shell.window import MainWindow


def test_a_view_alone_that_is_closed_leaves_no_empty_window(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    panel = window.panels("draw")[0]
    panel.source.setFocus()
    window.menus.actions["alone"].trigger()
    (dock,) = (dock for dock in window.arrangements.docks("draw") if dock.isAncestorOf(panel.source))
    dock.close()
    qtbot.waitUntil(lambda: not window.views.alone)
    assert panel.isVisibleTo(window)
    assert not window.top.isHidden()
    assert dock.isHidden()


@pytest.mark.parametrize("swapped", [False, True])
def test_a_dock_alone_has_the_whole_width_of_the_window(window: MainWindow, swapped: bool) -> None:
    window.go("draw")
    area = window.arrangements.area("draw")
    assert area is not None
    if swapped:
        window.views.swap()
        window.panels("draw")[0].center.setFocus()
    else:
        area.bring_forward("source")
        area.dock("source").widget().setFocus()
    settle()
    window.views.toggle_alone()
    settle()
    (dock,) = (dock for dock in area.docks if dock.isVisible())
    assert dock.width() == area.width() == window.width()
    before = area.halves
    window.views.toggle_alone()
    settle()
    assert before.isVisible()


@pytest.mark.parametrize("command", ["swap", "read"])
def test_a_view_alone_makes_room_for_why_a_key_does_nothing(window: MainWindow, command: str) -> None:
    window.go("home")
    window.views.toggle_alone()
    assert window.statusBar().isHidden()
    getattr(window.views, command)()
    assert not window.views.alone
    assert not window.statusBar().isHidden()
    assert window.status.hover.text()


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
def test_docks_come_back_while_one_of_them_is_dragged(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Under a window manager Qt warns of room that is given to it then."""
    window.resize(1280, 680)
    window.go("draw")
    settle()
    area = window.arrangements.area("draw")
    assert area is not None
    rooms = area.in_front()
    tube = area.dock("tube")
    assert tube in rooms
    title = QPoint(30, 8)
    QTest.mousePress(tube, Qt.MouseButton.LeftButton, pos=title)
    other = next(dock for dock in rooms if dock is not tube)
    place = other.mapToGlobal(other.rect().center())
    for _move in range(6):
        QTest.mouseMove(tube, title - QPoint(20, 20))
        QTest.mouseMove(tube, tube.mapFromGlobal(place))
        settle()
    assert tube.isFloating()
    given: list[QDockWidget] = []
    monkeypatch.setattr(area, "resizeDocks", lambda docks, _sizes, _along: given.extend(docks))
    area.bring_to_front(rooms)
    assert given
    assert tube not in given
    QTest.mouseRelease(tube, Qt.MouseButton.LeftButton, pos=title - QPoint(120, 120))
    settle()
    assert tube.isVisible()
