"""Larger type is larger everywhere, at once and at the next start, and nothing is cut by it."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontInfo, QFontMetrics
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example
from workbench.session.session import Session
from workbench.shell.about import AboutPage
from workbench.shell.home_questions import QuestionList
from workbench.shell.settings import Settings
from workbench.shell.settings_page import SettingsPage
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.widgets.fields.number_field import NumberField
from workbench.widgets.formulas.matrix_row import MatrixRow
from workbench.widgets.look.type_faces import scaled, type_scale
from workbench.widgets.stepping.sentence_view import SentenceView
from workbench.widgets.stepping.source_text import SourceText
from workbench.widgets.stepping.step_bar import StepBar
from workbench.widgets.tables.hand_table import HandTable

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


@pytest.fixture
def open_it(qtbot: QtBot) -> Iterator[Callable[[bool], MainWindow]]:
    """Opens the program in Transform, with larger type from the start or not."""
    opened: list[MainWindow] = []

    def make(large: bool) -> MainWindow:
        settings = Settings()
        settings.set("large_text", large)
        window = make_window(settings)
        opened.append(window)
        window.resize(1280, 720)
        window.show()
        window.attach(Session(window, example("transform-pivot").document))
        for _slice in window.build():
            pass
        qtbot.waitExposed(window)
        return window

    yield make
    for window in opened:
        window.themes.choose("light", large=False)
        window.session.undo_stack.setClean()
        window.close()
        window.deleteLater()
    Settings().set("large_text", False)
    QApplication.processEvents()


def settle() -> None:
    for _turn in range(8):
        QApplication.processEvents()


def pixels(widget: QWidget) -> int:
    return QFontInfo(widget.font()).pixelSize()


def sizes(window: MainWindow) -> dict[str, int]:
    """How large type is in parts that have sizes of their own."""
    sentence = window.findChildren(SentenceView)[0]
    hand = window.findChildren(HandTable)[0]
    return {
        "sentence": pixels(sentence),
        "sentence as written": int(sentence.text().partition("font-size:")[2].partition("px")[0]),
        "two lines of it": sentence.height(),
        "field": pixels(window.findChildren(NumberField)[0].field),
        "room of a field": window.findChildren(NumberField)[0].field.width(),
        "step": pixels(window.findChildren(StepBar)[0].jump),
        "table": hand.model.data(hand.model.index(0, 0), Qt.ItemDataRole.FontRole).pixelSize(),
        "heading of the table": pixels(hand.view.horizontalHeader().viewport()),
        "source": pixels(window.findChildren(SourceText)[0]),
        "matrix": max(pixels(row) for row in window.findChildren(MatrixRow)),
        "menu bar": window.menu_bar.height(),
    }


def test_all_type_is_larger_at_once_as_at_the_next_start(
    open_it: Callable[[bool], MainWindow],
) -> None:
    window = open_it(False)
    window.go("transform")
    settle()
    small = sizes(window)
    window.menus.actions["larger_type"].trigger()
    settle()
    large = sizes(window)
    assert {name for name in small if large[name] <= small[name]} == set()
    window.menus.actions["larger_type"].trigger()
    settle()
    assert sizes(window) == small
    again = open_it(True)
    again.go("transform")
    settle()
    assert sizes(again) == large


def test_a_size_that_is_given_in_pixels_follows() -> None:
    before = type_scale.factor
    type_scale.factor = 1.25
    try:
        assert (scaled(11), scaled(12), scaled(13), scaled(15)) == (14, 15, 16, 19)
    finally:
        type_scale.factor = before


@pytest.mark.parametrize("seen", [True, False])
def test_the_questions_of_home_are_whole_after_the_switch(
    open_it: Callable[[bool], MainWindow], seen: bool
) -> None:
    window = open_it(False)
    window.go("home" if seen else "settings")
    settle()
    window.menus.actions["larger_type"].trigger()
    settle()
    window.go("home")
    settle()
    questions = window.findChild(QuestionList)
    assert questions is not None
    for row in questions.rows:
        words = row._words
        assert row.height() >= words.heightForWidth(words.width())


@pytest.mark.parametrize("large", [True, False])
@pytest.mark.parametrize(
    ("place", "kind", "words"),
    [("settings", SettingsPage, "Forget recent pictures"), ("about", AboutPage, "Copy the diagnosis")],
)
def test_a_button_of_a_page_has_room_for_its_words(
    open_it: Callable[[bool], MainWindow], large: bool, place: str, kind: type[QWidget], words: str
) -> None:
    window = open_it(large)
    window.go(place)
    settle()
    for _switch in range(2):
        page = window.findChild(kind)
        assert page is not None
        button = next(each for each in page.findChildren(QPushButton) if each.text() == words)
        assert button.width() >= button.sizeHint().width()
        assert button.width() < page.width() / 2
        window.menus.actions["larger_type"].trigger()
        settle()


def test_labels_and_fields_are_not_cut_by_the_switch(open_it: Callable[[bool], MainWindow]) -> None:
    window = open_it(False)
    window.go("transform")
    window.menus.actions["larger_type"].trigger()
    settle()
    for field in window.findChildren(QLineEdit):
        if field.isVisible() and field.text() and isinstance(field.parentWidget(), NumberField):
            assert QFontMetrics(field.font()).height() <= field.height()
    for label in window.findChildren(QLabel):
        if label.isVisible() and label.text() and not label.wordWrap():
            assert label.height() >= QFontMetrics(label.font()).height() - 1, label.text()
