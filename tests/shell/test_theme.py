"""Contrast in both themes, and switching between them."""

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QListView,
    QMainWindow,
    QPushButton,
    QStyle,
    QStyleOptionComboBox,
    QTableView,
    QTreeView,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from workbench.paths import resource
from workbench.shell.hints import Hints
from workbench.shell.style_sheet import style_sheet
from workbench.shell.window import MainWindow
from workbench.widgets.look.icons import icon, set_icon
from workbench.widgets.look.tokens import DARK, LIGHT, Tokens, theme, tokens

THEMES = pytest.mark.parametrize("chosen", [LIGHT, DARK], ids=["light", "dark"])


def luminance(value: str) -> float:
    """Relative luminance as WCAG 2 defines it."""
    parts = (int(value[i : i + 2], 16) / 255 for i in (1, 3, 5))
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_contrast_of_black_and_white_is_21() -> None:
    assert contrast("#000000", "#FFFFFF") == pytest.approx(21)


@THEMES
@pytest.mark.parametrize("words", ["text", "muted", "accent", "warn", "error"])
@pytest.mark.parametrize("ground", ["window", "surface", "raised", "canvas", "selected"])
def test_words_can_be_read(chosen: Tokens, words: str, ground: str) -> None:
    assert contrast(getattr(chosen, words), getattr(chosen, ground)) >= 4.5


@THEMES
def test_words_on_the_accent_can_be_read(chosen: Tokens) -> None:
    assert contrast(chosen.on_accent, chosen.accent) >= 4.5


@THEMES
@pytest.mark.parametrize("ground", ["window", "surface", "raised"])
def test_edges_of_fields_and_controls_are_seen(chosen: Tokens, ground: str) -> None:
    for edge in (chosen.field_edge, chosen.accent):
        assert contrast(edge, getattr(chosen, ground)) >= 3


@THEMES
def test_data_is_seen_on_canvas_and_surface(chosen: Tokens) -> None:
    for data in (*chosen.data, chosen.agreement):
        assert contrast(data, chosen.canvas) >= 3
        assert contrast(data, chosen.surface) >= 3
    assert len(set(chosen.data)) == 6


@THEMES
def test_the_style_sheet_names_only_tokens_and_files_that_exist(chosen: Tokens) -> None:
    text = style_sheet(chosen)
    assert "@" not in text
    pictures = re.findall(r"url\(([^)]*)\)", text)
    assert pictures
    for picture in pictures:
        assert resource("controls", picture.rpartition("/")[2]).is_file()


@THEMES
@pytest.mark.parametrize("kind", ["", "card", "flat", "low"])
def test_a_button_that_the_keys_came_to_is_ringed_in_the_accent_and_not_crossed(
    qtbot: QtBot, chosen: Tokens, kind: str
) -> None:
    frame = QWidget()
    qtbot.addWidget(frame)
    frame.setStyleSheet(style_sheet(chosen))
    first, second = QPushButton(frame), QPushButton(frame)
    second.setProperty(kind or "plain", True)
    for place, button in enumerate((first, second)):
        button.setGeometry(20, 20 + 60 * place, 200, 40)
    frame.resize(240, 140)
    frame.show()
    qtbot.waitUntil(frame.isActiveWindow)
    first.setFocus()
    qtbot.keyClick(first, Qt.Key.Key_Tab)
    assert second.hasFocus()
    seen = second.grab().toImage()
    assert QColor(seen.pixel(100, 0)) == QColor(seen.pixel(100, 1)) == QColor(chosen.accent)
    assert {seen.pixel(100, y) for y in range(2, 38)} == {seen.pixel(100, 2)}


def test_following_the_system_and_choosing(window: MainWindow) -> None:
    themes = window.themes
    themes.choose("system")
    themes._take_scheme(Qt.ColorScheme.Dark)
    assert tokens() is DARK
    themes._take_scheme(Qt.ColorScheme.Light)
    assert tokens() is LIGHT
    themes.choose("dark")
    assert tokens() is DARK
    assert QApplication.palette().window().color() == QColor(DARK.window)
    themes._take_scheme(Qt.ColorScheme.Light)
    assert tokens() is DARK
    themes.choose("light")
    assert QApplication.palette().window().color() == QColor(LIGHT.window)


def test_icons_follow_the_theme(window: MainWindow) -> None:
    window.themes.choose("light")
    button = QPushButton()
    set_icon(button, "play")
    before = button.icon().cacheKey()
    window.themes.choose("dark")
    assert button.icon().cacheKey() != before
    window.themes.choose("light")
    assert button.icon().cacheKey() == before


def test_an_icon_changed_again_and_again_follows_the_theme_as_the_last_one(window: MainWindow) -> None:
    window.themes.choose("light")
    button, other = QPushButton(), QPushButton()
    for name in ("play", "pause", "play", "pause"):
        set_icon(button, name)
    set_icon(other, "pause")
    window.themes.choose("dark")
    assert button.icon().cacheKey() == other.icon().cacheKey()


def test_an_unknown_icon_is_refused() -> None:
    with pytest.raises(LookupError, match="no icon named nonsense"):
        icon("nonsense")


def test_larger_type(window: MainWindow) -> None:
    window.themes.choose("light", large=True)
    large = QApplication.font().pixelSize()
    window.themes.choose("light", large=False)
    assert (large, QApplication.font().pixelSize()) == (16, 13)
    assert theme.current is LIGHT


def test_a_hint_holds_its_words_when_they_become_larger(qtbot: QtBot, window: MainWindow) -> None:
    window.show_hints_again()
    hints = window.findChild(Hints)
    assert hints is not None
    window.themes.choose("light", large=True)
    words = next(each for each in hints.findChildren(QLabel) if each.text() == hints.text)
    qtbot.waitUntil(lambda: words.height() >= words.heightForWidth(words.width()))
    window.themes.choose("light", large=False)


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)
@pytest.mark.parametrize("count", [2, 3, 7])
@pytest.mark.parametrize("focused", [False, True])
def test_a_list_to_choose_from_opens_with_all_its_rows(
    qtbot: QtBot, window: MainWindow, count: int, focused: bool
) -> None:
    dressed = QMainWindow()
    qtbot.addWidget(dressed)
    window.themes.dress(dressed)
    body, box, other = QWidget(), QComboBox(), QPushButton("other")
    column = QVBoxLayout(body)
    column.addWidget(other)
    column.addWidget(box)
    dressed.setCentralWidget(body)
    box.addItems([f"row {row}" for row in range(count)])
    dressed.resize(300, 200)
    dressed.show()
    qtbot.waitExposed(dressed)
    (box if focused else other).setFocus()
    qtbot.waitUntil((box if focused else other).hasFocus)
    box.showPopup()
    view = box.view()
    qtbot.waitUntil(view.isVisible)
    QApplication.processEvents()
    rows = sum(view.sizeHintForRow(row) for row in range(count))
    assert view.viewport().height() >= rows
    assert view.verticalScrollBar().maximum() == 0
    box.hidePopup()


@THEMES
def test_the_focus_leaves_the_words_of_a_choice_their_room(qtbot: QtBot, chosen: Tokens) -> None:
    """And the room that a box asks for is enough for them, up to the arrow."""
    page = QWidget()
    page.setStyleSheet(style_sheet(chosen))
    box, other = QComboBox(page), QLineEdit(page)
    box.addItem("Free vector display")
    box.resize(box.sizeHint())
    qtbot.addWidget(page)
    page.show()
    for focused in (other, box):
        focused.setFocus()
        qtbot.waitUntil(focused.hasFocus)
        option = QStyleOptionComboBox()
        box.initStyleOption(option)
        words, arrow = (
            box.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, part, box)
            for part in (QStyle.SubControl.SC_ComboBoxEditField, QStyle.SubControl.SC_ComboBoxArrow)
        )
        assert words.width() >= box.fontMetrics().horizontalAdvance(box.currentText())
        assert 0 < arrow.left() - words.right() <= 8


def test_an_action_that_can_be_ticked_shows_its_tick_in_a_menu_and_no_icon(qapp: QApplication) -> None:
    action, plain = QAction("Labels"), QAction("Copy")
    set_icon(action, "play")
    set_icon(plain, "play")
    assert action.isIconVisibleInMenu()
    action.setCheckable(True)
    assert not action.isIconVisibleInMenu()
    assert not action.icon().isNull()
    assert plain.isIconVisibleInMenu()


@THEMES
@pytest.mark.parametrize("kind", [QTableView, QListView, QTreeView])
def test_tables_and_lists_show_that_they_have_the_focus(
    qtbot: QtBot, chosen: Tokens, kind: type[QAbstractItemView]
) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    window.setStyleSheet(style_sheet(chosen))
    column = QVBoxLayout(window)
    view, field = kind(), QLineEdit()
    column.addWidget(view)
    column.addWidget(field)
    with qtbot.waitExposed(window):
        window.show()
    window.activateWindow()

    def edge() -> QColor:
        return view.grab().toImage().pixelColor(0, view.height() // 2)

    view.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.waitUntil(view.hasFocus)
    assert edge() == QColor(chosen.accent)
    field.setFocus(Qt.FocusReason.TabFocusReason)
    assert edge() == QColor(chosen.surface)
