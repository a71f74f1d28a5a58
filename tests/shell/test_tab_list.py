"""Docks whose tabs have no room are reached by a list, by mouse and by keys, in every workspace."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QMenu, QTabBar, QToolButton
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.tab_list import TabList
from workbench.shell.window import MainWindow

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


@pytest.fixture(params=[(1280, 680), (960, 540)])
def window(qtbot: QtBot, request: pytest.FixtureRequest) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.resize(*request.param)
    window.show()
    window.attach(Session(window, example_document()))
    qtbot.waitExposed(window)
    yield window
    window.close()
    window.deleteLater()
    QApplication.processEvents()


def settle() -> None:
    for _turn in range(8):
        QApplication.processEvents()


def bars(window: MainWindow) -> list[QTabBar]:
    """The tab bars that are seen in the workspace that is shown."""
    area = window.arrangements.area(window.place)
    assert area is not None
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    seen = [bar for bar in area.findChildren(QTabBar, options=direct) if bar.isVisible()]
    return [bar for bar in seen if bar.geometry().intersects(area.rect())]


def list_of(bar: QTabBar) -> TabList:
    there = bar.findChild(TabList)
    assert isinstance(there, TabList)
    return there


def crowded(bar: QTabBar) -> bool:
    """Whether the tabs ask for more room than the bar has."""
    return sum(bar.tabRect(k).width() for k in range(bar.count())) > bar.width()


def chosen_from(button: TabList, qtbot: QtBot, downs: int) -> None:
    """Open the list by Enter and go down so many rows."""
    qtbot.keyClick(button, Qt.Key.Key_Return)
    settle()
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    for _row in range(downs):
        qtbot.keyClick(menu, Qt.Key.Key_Down)
    qtbot.keyClick(menu, Qt.Key.Key_Return)
    settle()


def test_in_every_workspace_the_list_is_there_where_tabs_are_not(window: MainWindow) -> None:
    lists = 0
    for slug in window.workspace_slugs:
        window.go(slug)
        settle()
        for bar in bars(window):
            button = list_of(bar)
            assert button.isVisible() == crowded(bar), slug
            if not crowded(bar):
                continue
            lists += 1
            titles = [bar.tabText(k) for k in range(bar.count())]
            assert [action.text() for action in button.list().actions()] == titles
            assert bar.rect().contains(button.geometry())
            for arrow in bar.findChildren(QToolButton):
                assert button.geometry().contains(arrow.geometry())
                assert bar.childAt(arrow.geometry().center()) is button
    assert lists >= 2


def test_every_dock_of_curves_is_reached_by_keys(qtbot: QtBot, window: MainWindow) -> None:
    window.go("curves")
    settle()
    bar = max(bars(window), key=QTabBar.count)
    button = list_of(bar)
    assert button.isVisible()
    assert button.focusPolicy() & Qt.FocusPolicy.TabFocus
    assert button.accessibleName()
    button.setFocus()
    for number in range(bar.count()):
        down = (number - bar.currentIndex()) % bar.count()
        chosen_from(button, qtbot, down)
        assert bar.currentIndex() == number
        in_front = [
            dock.windowTitle()
            for dock in window.arrangements.docks("curves")
            if dock.geometry().top() == bar.geometry().bottom() + 1
        ]
        assert in_front == [bar.tabText(number)]
        assert button.isVisible()


def test_a_click_opens_the_list_with_the_one_in_front_marked(qtbot: QtBot, window: MainWindow) -> None:
    window.go("curves")
    settle()
    bar = max(bars(window), key=QTabBar.count)
    button = list_of(bar)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    assert [action.isChecked() for action in menu.actions()].index(True) == bar.currentIndex()
    qtbot.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(menu.actions()[-1]).center())
    settle()
    assert bar.currentIndex() == bar.count() - 1


def test_with_room_for_all_tabs_there_is_no_list(window: MainWindow) -> None:
    window.go("curves")
    settle()
    bar = max(bars(window), key=QTabBar.count)
    area = window.arrangements.area("curves")
    assert area is not None
    window.resize(2600, 900)
    settle()
    area.resizeDocks(area.docks, [1400] * len(area.docks), Qt.Orientation.Horizontal)
    settle()
    for bar in bars(window):
        assert not crowded(bar)
        assert not list_of(bar).isVisible()
