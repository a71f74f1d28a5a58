"""Workspaces, docks, pages and keys of the window."""

from collections.abc import Callable
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QByteArray, Qt
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.shell import dock_area
from workbench.shell.command_palette import offers
from workbench.shell.dock_area import VERSION, DockArea
from workbench.shell.failures import Failures
from workbench.shell.hints import Hints
from workbench.shell.home import HomePage
from workbench.shell.questions import algorithms_for, questions
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspace_bar import WorkspaceBar
from workbench.shell.workspaces import titles as titles_of_workspaces
from workbench.shell.workspaces import workspaces
from workbench.widgets.look.comfort import comfort


def docks(window: MainWindow) -> dict[str, bool]:
    return {dock.objectName(): not dock.isHidden() for dock in window.arrangements.docks("draw")}


def area(window: MainWindow) -> DockArea:
    there = window.arrangements.area("draw")
    assert there is not None
    return there


def test_the_bar_changes_the_workspace(qtbot: QtBot, window: MainWindow) -> None:
    assert window.place == "home"
    for slug in ("draw", "display", "home", "draw"):
        qtbot.mouseClick(window.bar._tabs[slug], Qt.MouseButton.LeftButton)
        assert window.place == slug
        assert [each for each, tab in window.bar._tabs.items() if tab.isChecked()] == [slug]
        assert area(window).isVisible() == (slug == "draw")
        assert all(docks(window).values())


def test_the_bar_folds_when_it_is_narrow(qtbot: QtBot) -> None:
    names = ("Draw", "Fill", "Clip", "Transform", "View", "Curves", "Space", "Animate", "Display", "Labs")
    bar = WorkspaceBar([(name.lower(), name, name) for name in ("Home", *names)])
    qtbot.addWidget(bar)
    bar.show()
    bar.resize(1280, 36)
    assert not bar.folded
    bar.resize(480, 36)
    assert bar.folded
    bar.show_current("space")
    assert bar._folded is not None
    assert bar._folded.text().startswith("Space")
    with qtbot.waitSignal(bar.chosen) as chosen:
        bar._folded.menu().actions()[2].trigger()
    assert chosen.args == ["fill"]
    bar.resize(1280, 36)
    assert not bar.folded


def test_a_closed_dock_stays_closed_and_reset_brings_it_back(
    window: MainWindow, open_window: Callable[[], MainWindow]
) -> None:
    window.go("draw")
    assert all(docks(window).values())
    tube = window.arrangements.docks("draw")[-1]
    tube.close()
    window.go("display")
    window.go("draw")
    assert not docks(window)["tube"]
    window.close()
    again = open_window()
    again.go("draw")
    assert not docks(again)["tube"]
    again.menus.actions["reset"].trigger()
    assert all(docks(again).values())


def test_the_first_window_fits_the_screen(qtbot: QtBot) -> None:
    window = make_window(Settings())
    qtbot.addWidget(window)
    room = window.screen().availableSize()
    assert window.width() < room.width()
    assert window.height() < room.height()


def test_a_dock_is_brought_back_by_its_name(window: MainWindow) -> None:
    window.go("draw")
    dock = window.arrangements.docks("draw")[0]
    dock.close()
    next(each for each in offers(window) if each.text == "Show Source").act()
    assert not dock.isHidden()


def test_a_dock_is_brought_back_by_the_menu(window: MainWindow) -> None:
    window.go("draw")
    dock = window.arrangements.docks("draw")[0]
    dock.close()
    window.menus._fill_docks()
    entry = next(a for a in window.menus._docks.actions() if a.text() == "Source")
    assert not entry.isChecked()
    entry.trigger()
    assert not dock.isHidden()


@pytest.mark.parametrize("bad", ["nonsense", "nothing", "another version", "a wrong byte", "cut short"])
def test_a_bad_arrangement_is_dropped(
    window: MainWindow, open_window: Callable[[], MainWindow], monkeypatch: pytest.MonkeyPatch, bad: str
) -> None:
    window.go("draw")
    kept = area(window).arrangement.data()
    monkeypatch.setattr(dock_area, "VERSION", VERSION + 1)
    other_version = area(window).arrangement.data()
    monkeypatch.undo()
    window.close()
    damaged = {
        "nonsense": b"nonsense",
        "nothing": b"",
        "another version": other_version,
        "a wrong byte": kept[:-9] + bytes([kept[-9] ^ 1]) + kept[-8:],
        "cut short": kept[:-9],
    }[bad]
    window.settings.keep_arrangement("draw", QByteArray(damaged))
    window.settings.write()
    again = open_window()
    again.go("draw")
    assert all(docks(again).values())
    assert ("could not be used" in again.messages.text) == (bad != "nothing")


def test_damaged_settings_cost_choices_only(
    window: MainWindow, open_window: Callable[[], MainWindow]
) -> None:
    window.close()
    window.settings.path.write_bytes(b"theme=\x00\xff[[[\ncalm=perhaps\nrecent_files=@Variant(\x01)\n")
    again = open_window()
    assert again.settings.get("calm") is True
    assert again.settings.get("theme") in ("system", "theme") or isinstance(again.settings.get("theme"), str)
    assert again.settings.recent() == []


@pytest.mark.qt_log_ignore("does not support raise", extend=True)
def test_tabbed_docks_are_named_once_and_float_and_close_by_menu(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    source, values, tube = window.arrangements.docks("draw")
    qtbot.waitUntil(lambda: source.titleBarWidget() is not None)
    assert tube.titleBarWidget() is None
    tabs = area(window).tabs
    tabs.menu(values).actions()[0].trigger()
    assert values.isFloating()
    qtbot.waitUntil(lambda: source.titleBarWidget() is None)
    assert values.titleBarWidget() is None
    tabs.menu(source).actions()[1].trigger()
    assert source.isHidden()
    window.menus.actions["reset"].trigger()
    source, values, tube = window.arrangements.docks("draw")
    assert not values.isFloating()
    assert not source.isHidden()
    qtbot.waitUntil(lambda: source.titleBarWidget() is not None)


def test_swap_takes_the_tube_to_the_middle_and_back(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    panel = window.panels("draw")[0]
    tube = window.arrangements.docks("draw")[-1]
    qtbot.keyClick(window, "T")
    assert tube.widget() is panel.center
    assert tube.windowTitle() == "Canvas"
    assert panel.tube.isVisibleTo(area(window).host)
    qtbot.keyClick(window, "T")
    assert tube.widget() is panel.tube
    assert tube.windowTitle() == "Tube"
    assert panel.center.isVisibleTo(area(window).host)


def test_letters_typed_in_a_field_are_no_commands(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    panel = window.panels("draw")[0]
    window.arrangements.docks("draw")[1].raise_()
    panel.field.setFocus()
    qtbot.keyClicks(panel.field, "t,.a?")
    assert panel.field.text() == "t,.a?"
    assert window.place == "draw"


@pytest.mark.parametrize("where", ["center", "source"])
def test_the_focused_view_alone(qtbot: QtBot, window: MainWindow, where: str) -> None:
    window.go("draw")
    panel = window.panels("draw")[0]
    before = docks(window)
    getattr(panel, where).setFocus()
    window.menus.actions["alone"].trigger()
    assert window.views.alone
    assert window.top.isHidden()
    assert getattr(panel, where).isVisibleTo(window)
    assert sum(docks(window).values()) == (where == "source")
    window.menus.actions["alone"].trigger()
    assert not window.views.alone
    assert docks(window) == before
    assert not window.top.isHidden()


@pytest.mark.parametrize(
    ("keys", "place"),
    [
        ((Qt.Key.Key_F1, Qt.KeyboardModifier.NoModifier), "help"),
        ((Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier), "settings"),
    ],
)
def test_keys_to_pages(
    qtbot: QtBot, window: MainWindow, keys: tuple[Qt.Key, Qt.KeyboardModifier], place: str
) -> None:
    qtbot.keyClick(window, *keys)
    assert window.place == place


def test_settings_take_effect_and_stay(window: MainWindow, open_window: Callable[[], MainWindow]) -> None:
    window.go("settings")
    page = window.stack.currentWidget()
    page.calm.click()
    assert comfort.calm is True
    assert "seizure" in page.warning.words.text()
    page.warning.show_it.click()
    page.ask.setChecked(True)
    page.theme.setCurrentIndex(page.theme.findData("dark"))
    assert comfort.calm is False
    assert window.session.state.ask_first
    window.close()
    again = open_window()
    assert again.settings.get("theme") == "dark"
    assert again.themes.choice == "dark"
    assert comfort.calm is False
    again.go("settings")
    again.stack.currentWidget().calm.click()
    again.themes.choose("light")
    assert comfort.calm is True


def test_hints_come_once_and_return_from_help(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    window.show_hints()
    hints = window.findChild(Hints)
    assert hints is not None
    seen = []
    for _hint in range(3):
        seen.append(hints.text)
        qtbot.mouseClick(hints._next, Qt.MouseButton.LeftButton)
    assert len(set(seen)) == 3
    assert window.settings.get("hints") is False
    assert "The marked lines ran in this step." in seen[2]  # several, those of the sentence
    qtbot.wait(10)
    window.show_hints()
    assert window.findChild(Hints) is None
    window.menus.actions["hints"].trigger()
    assert window.findChild(Hints) is not None
    window.go("home")
    qtbot.wait(10)
    assert window.findChild(Hints) is None


def test_a_failure_is_said_and_the_picture_kept(
    qtbot: QtBot, window: MainWindow, capsys: pytest.CaptureFixture[str]
) -> None:
    before = window.session.document
    failures = Failures(window)
    try:
        raise ValueError("seven is no colour")
    except ValueError as error:
        failures.report(type(error), error, error.__traceback__)
    qtbot.waitUntil(lambda: "seven is no colour" in window.messages.text)
    assert window.session.document is before
    window.messages.buttons()[-1].click()
    from PySide6.QtGui import QGuiApplication

    assert "Traceback" in QGuiApplication.clipboard().text()
    assert "seven is no colour" in capsys.readouterr().err


def test_a_question_is_not_displaced_by_a_remark(window: MainWindow) -> None:
    window.messages.ask("Save it?", [("Save", lambda: None)])
    window.messages.say("A remark.")
    assert window.messages.text == "Save it?"
    window.messages.buttons()[0].click()
    assert window.messages.text == "A remark."


def test_a_remark_waits_for_the_end_of_work_and_does_not_end_it(window: MainWindow) -> None:
    ended: list[str] = []
    messages = window.messages
    messages.work("Reading 1 %", ("Cancel", lambda: ended.append("cancel")))
    messages.say("A warning.", "warn", buttons=[("Yes", lambda: ended.append("yes"))])
    messages.say("Another.")
    messages.work("Reading 2 %", ("Cancel", lambda: ended.append("cancel")))
    assert messages.text == "Reading 2 %"
    messages.end_work()
    assert messages.text == "A warning."
    messages.buttons()[0].click()
    assert messages.text == "Another."
    messages.dismiss()
    assert messages.text == ""
    assert ended == ["yes"]


def test_a_message_in_the_place_of_another_is_closed_without_answering_that(window: MainWindow) -> None:
    ended: list[str] = []
    window.messages.ask("Save it?", [("Save", lambda: None)], refuse=lambda: ended.append("refused"))
    window.messages.ask("Really?", [("Yes", lambda: None)])
    window.messages.dismiss()
    assert (window.messages.text, ended) == ("", [])


def test_home_lists_twelve_questions_each_with_a_workspace(window: MainWindow) -> None:
    assert [question.number for question in questions()] == list(range(1, 13))
    slugs = {each.slug for each in workspaces()}
    assert {question.workspace for question in questions()} <= slugs
    here = [question for question in questions() if question.workspace in window.workspace_slugs]
    assert here
    for question in here:
        window.open_question(question._replace(dock="", page=""))  # the panels here are stand-ins
        assert window.place == question.workspace
        assert window.session.sheet.figures or window.session.sheet.scene


def test_home_names_the_algorithms_of_each_question(qtbot: QtBot) -> None:
    home = HomePage([])
    qtbot.addWidget(home)
    home.show_questions()
    cards = {button.accessibleName(): button for button in home.findChildren(QPushButton)}
    for question in questions():
        titles = [entry.title for entry in catalogue.entries() if question.number in entry.questions]
        assert algorithms_for(question.number) == titles
        assert titles
        card = cards[f"{question.number} {question.text}"]
        assert all(title in card.toolTip() for title in titles)
        said = [label.text() for label in card.findChildren(QLabel)]
        assert said == [str(question.number), question.text, titles_of_workspaces()[question.workspace]]


def test_commands_wait_for_the_session(qtbot: QtBot, panels: None) -> None:
    from workbench.document.samples.examples import example_document
    from workbench.session.session import Session

    from .conftest import OFFERED, leave

    window = make_window(offered=OFFERED)
    window.show()
    window.go("draw")
    assert window.place == "home"
    window.attach(Session(window, example_document()))
    assert window.place == "draw"
    leave(window)


def test_everything_pressed_has_words(window: MainWindow) -> None:
    for place in ("home", "draw", "settings", "help", "about", "keys"):
        window.go(place)
    for button in window.findChildren(QPushButton):
        assert button.text() or button.accessibleName()
        assert button.toolTip() or button.property("card") or button.parent() is window.messages
    for box in window.findChildren(QCheckBox):
        assert box.toolTip()
    for label in window.findChildren(QLabel):
        assert "!" not in label.text()


def test_home_does_not_step_a_run_that_is_not_seen(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    moved: list[str] = []
    monkeypatch.setattr(window.session, "run", SimpleNamespace(forward=lambda: moved.append("forward")))
    window.go("home")
    window.run_do("forward")
    assert not moved
    window.go("draw")
    window.run_do("forward")
    assert moved == ["forward"]
