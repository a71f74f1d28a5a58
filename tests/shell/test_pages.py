"""Pages beside the work lead back to it, and what they say is about the place that one comes from."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QCheckBox, QLabel
from pytestqt.qtbot import QtBot

from workbench.shell.about import AboutPage
from workbench.shell.help import HelpPage
from workbench.shell.pages import SIDE_PAGES, SidePage
from workbench.shell.settings_page import SettingsPage
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import workspaces


def shown(window: MainWindow) -> SidePage:
    page = window.stack.currentWidget()
    assert isinstance(page, SidePage)
    return page


@pytest.mark.parametrize("page", SIDE_PAGES)
def test_escape_and_back_return_to_where_one_was(qtbot: QtBot, window: MainWindow, page: str) -> None:
    window.enter("draw")
    window.go(page)
    qtbot.keyClick(shown(window), Qt.Key.Key_Escape)
    assert window.place == "draw"
    window.go("home")
    window.go(page)
    qtbot.mouseClick(shown(window).back, Qt.MouseButton.LeftButton)
    assert window.place == "home"


def test_from_one_page_to_the_next_the_way_back_stays(qtbot: QtBot, window: MainWindow) -> None:
    window.enter("display")
    window.go("help")
    window.go("keys")
    window.go("help")
    qtbot.keyClick(shown(window), Qt.Key.Key_Escape)
    assert window.place == "display"


def test_escape_in_a_field_of_the_page_leads_back(qtbot: QtBot, window: MainWindow) -> None:
    window.enter("draw")
    window.go("settings")
    box = shown(window).findChild(QCheckBox)
    assert isinstance(box, QCheckBox)
    qtbot.keyClick(box, Qt.Key.Key_Escape)
    assert window.place == "draw"


def test_f1_begins_with_the_help_of_this_place(qtbot: QtBot, window: MainWindow) -> None:
    window.enter("display")
    qtbot.keyClick(window, Qt.Key.Key_F1)
    page = shown(window)
    assert isinstance(page, HelpPage)
    assert set(page.about) == {each.slug for each in workspaces()}
    qtbot.waitUntil(lambda: page.about["display"].property("here") is True)
    assert not page.about["draw"].property("here")
    heading = page.about["display"]
    assert isinstance(heading, QLabel)
    assert not heading.visibleRegion().isEmpty()


def test_type_and_theme_of_the_menu_are_those_of_the_settings(window: MainWindow) -> None:
    window.enter("draw")
    pixels = window.font().pixelSize()
    window.menus.actions["larger_type"].trigger()
    window.menus.actions["dark_theme"].trigger()
    window.go("settings")
    page = shown(window)
    assert isinstance(page, SettingsPage)
    assert page.large.isChecked()
    assert page.theme.currentData() == "dark"
    window.menus.actions["larger_type"].trigger()
    assert window.settings.get("large_text") is False
    assert pixels == window.font().pixelSize()


def test_the_menu_says_where_there_is_nothing_to_zoom(window: MainWindow) -> None:
    window.enter("display")
    window.menus.actions["zoom_in"].trigger()
    assert "nothing here to zoom" in window.status.hover.text()


def test_a_new_picture_stays_in_the_workspace(window: MainWindow) -> None:
    window.enter("display")
    window.menus.actions["new"].trigger()
    assert window.place == "display"
    window.go("home")
    window.menus.actions["new"].trigger()
    assert window.place == "draw"


def test_about_has_a_diagnosis_to_copy(qtbot: QtBot, window: MainWindow) -> None:
    window.go("about")
    page = window.stack.currentWidget()
    assert isinstance(page, AboutPage)
    qtbot.mouseClick(page.copy, Qt.MouseButton.LeftButton)
    copied = QGuiApplication.clipboard().text()
    assert copied.startswith("Graphics Workbench 0.")
    window.go("home")
    window.resize(1000, 600)
    window.go("about")
    assert "window 1000 x 600" in page.text.text()
    assert "numba" in copied
