"""A button looks as its action says, does what it does, and keeps nothing of its changes."""

import gc

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolButton
from pytestqt.qtbot import QtBot

from tests.soak.holdings import _ALLOCATED
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.icons import set_icon

LEFT = Qt.MouseButton.LeftButton


def shown(qtbot: QtBot, action: QAction) -> ActionButton:
    button = ActionButton(action)
    qtbot.addWidget(button)
    with qtbot.waitExposed(button):
        button.show()
    return button


def test_it_does_its_action_once(qtbot: QtBot) -> None:
    action, done = QAction("Fit && fill"), list[bool]()
    action.triggered.connect(lambda checked: done.append(checked))
    button = shown(qtbot, action)
    QTest.mouseClick(button, LEFT)
    button.setFocus()
    QTest.keyClick(button, Qt.Key.Key_Space)
    assert done == [False, False]
    assert action in button.actions()


def test_it_follows_its_action(qtbot: QtBot) -> None:
    action = QAction("Play")
    button = shown(qtbot, action)
    likewise = QToolButton()
    qtbot.addWidget(likewise)
    likewise.setDefaultAction(action)
    for change in (
        lambda: action.setText("Pause && wait"),
        lambda: action.setToolTip("Stop here (Space)"),
        lambda: action.setStatusTip("Stopped"),
        lambda: set_icon(action, "pause"),
        lambda: action.setCheckable(True),
        lambda: action.setChecked(True),
        lambda: action.setEnabled(False),
    ):
        change()
        for told in ("text", "toolTip", "statusTip", "isCheckable", "isChecked", "isEnabled"):
            assert getattr(button, told)() == getattr(likewise, told)(), told
        assert button.icon().cacheKey() == likewise.icon().cacheKey()


def test_a_screen_reader_says_what_the_action_is_called_now(qtbot: QtBot) -> None:
    action = QAction("Play")
    button, named = shown(qtbot, action), ActionButton(action, name="Play or pause")
    qtbot.addWidget(named)
    action.setText("Pause")
    assert button.accessibleName() == "Pause"
    assert named.accessibleName() == "Play or pause"


def test_one_of_several_stays_down(qtbot: QtBot) -> None:
    group = QActionGroup(None)
    one, other = (QAction(name, group, checkable=True) for name in ("Window", "Viewport"))
    first, second = shown(qtbot, one), shown(qtbot, other)
    for button, down in ((first, one), (first, one), (second, other)):
        QTest.mouseClick(button, LEFT)
        assert [first.isChecked(), second.isChecked()] == [down is one, down is other]


@pytest.mark.skipif(_ALLOCATED is None, reason="the C library does not tell what it has allocated")
def test_nothing_is_kept_of_a_change(qtbot: QtBot) -> None:
    action = QAction("Play")
    button = shown(qtbot, action)

    def bytes_after(changes: int) -> int:
        for number in range(changes):
            action.setEnabled(number % 2 == 1)
        QApplication.processEvents()
        gc.collect()
        return int(_ALLOCATED().uordblks)

    before = bytes_after(200)
    assert bytes_after(5_000) - before < 5_000 * 30
    assert button.isEnabled()
