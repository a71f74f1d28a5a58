"""What comes over the window takes the focus, wherever that is, and gives it back."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import type_name
from tests.shell.keys.focus import settle, work_in
from workbench.panels.stage.stepped import SteppedPanel
from workbench.shell.command_palette import CommandPalette
from workbench.shell.window import MainWindow

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


def canvas_of(window: MainWindow) -> QWidget:
    panel = window.panels("draw")[0]
    assert isinstance(panel, SteppedPanel)
    return panel.canvas


@pytest.fixture
def afloat(qtbot: QtBot, window: MainWindow) -> QDockWidget:
    """The hand table, afloat and with the focus."""
    work_in(window, "draw")
    dock = next(each for each in window.arrangements.docks("draw") if each.windowTitle() == "Hand table")
    window.arrangements.bring_forward(dock.objectName())
    dock.setFloating(True)
    dock.setGeometry(120, 200, 300, 160)  # on the small screen of the tests
    dock.activateWindow()
    qtbot.waitUntil(dock.isActiveWindow)
    table = dock.widget()
    table.setFocus()
    settle()
    assert QApplication.focusWidget() is not None
    assert dock.isAncestorOf(QApplication.focusWidget())
    return dock


def test_the_palette_is_typed_in_over_the_dock_that_floats(window: MainWindow, afloat: QDockWidget) -> None:
    held, step = QApplication.focusWidget(), window.session.run.number
    window.show_palette()
    settle()
    (palette,) = window.findChildren(CommandPalette)
    assert palette.isWindow()
    assert QApplication.activePopupWidget() is palette
    assert palette.geometry().intersects(afloat.frameGeometry())
    assert QApplication.focusWidget() is palette.field
    keyed = afloat.windowHandle()  # the system gives the keys to the window that is active
    for key in (Qt.Key.Key_T, Qt.Key.Key_U, Qt.Key.Key_B, Qt.Key.Key_E):
        QTest.keyClick(keyed, key)
    assert palette.field.text() == "tube"
    assert window.session.run.number == step
    QTest.keyClick(keyed, Qt.Key.Key_Escape)
    settle()
    assert window.findChildren(CommandPalette) == []
    assert QApplication.focusWidget() is held


def test_a_click_beside_the_palette_over_a_dock_closes_it(window: MainWindow, afloat: QDockWidget) -> None:
    window.show_palette()
    settle()
    (palette,) = window.findChildren(CommandPalette)
    QTest.mouseClick(palette, Qt.MouseButton.LeftButton, pos=QPoint(-20, -20))
    settle()
    assert window.findChildren(CommandPalette) == []


@pytest.mark.parametrize("end", ["escape", "cancel", "written"])
def test_after_an_export_of_the_run_the_focus_is_where_it_was(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    work_in(window, "draw")
    canvas = canvas_of(window)
    canvas.setFocus()
    settle()
    window.menus.actions["export_run"].trigger()
    settle()
    card = window.files.exports.writing.card
    assert QApplication.focusWidget() is card.kind
    if end == "escape":
        qtbot.keyClick(card.kind, Qt.Key.Key_Escape)
    elif end == "cancel":
        qtbot.mouseClick(card.cancel, Qt.MouseButton.LeftButton)
    else:
        qtbot.mouseClick(card.go, Qt.MouseButton.LeftButton)
        type_name(qtbot, window, "walk")
        qtbot.waitUntil(lambda: not window.files.exports.writing.writer.busy, timeout=20_000)
    qtbot.waitUntil(lambda: not card.isVisible())
    window.activateWindow()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is canvas)


def test_a_run_that_is_cancelled_while_it_is_written_gives_the_focus_back(
    qtbot: QtBot, window: MainWindow
) -> None:
    work_in(window, "draw")
    canvas = canvas_of(window)
    canvas.setFocus()
    card = window.files.exports.writing.card
    window.menus.actions["export_run"].trigger()
    card.progress("Writing walk")
    settle()
    assert QApplication.focusWidget() is card.cancel
    card.stop()
    card.put_away()
    settle()
    assert QApplication.focusWidget() is canvas


def test_the_card_is_typed_in_though_a_dock_floats_with_the_focus(
    window: MainWindow, afloat: QDockWidget
) -> None:
    held = QApplication.focusWidget()
    window.menus.actions["export_run"].trigger()
    settle()
    card = window.files.exports.writing.card
    assert QApplication.focusWidget() is card.kind
    card.put_away()
    settle()
    assert QApplication.focusWidget() is held


def test_an_answered_question_gives_the_focus_back(qtbot: QtBot, window: MainWindow) -> None:
    work_in(window, "draw")
    canvas = canvas_of(window)
    canvas.setFocus()
    settle()
    window.messages.ask("Save it?", [("Save", lambda: None), ("Stay", lambda: None)])
    (first, _second) = window.messages.buttons()
    assert QApplication.focusWidget() is first
    qtbot.mouseClick(first, Qt.MouseButton.LeftButton)
    settle()
    assert QApplication.focusWidget() is canvas
