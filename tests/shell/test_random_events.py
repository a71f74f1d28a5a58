"""A short run of random events over the real window; ``tests/soak`` has the long ones."""

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from random import Random

import pytest
import shiboken6
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDockWidget,
    QLabel,
    QMenu,
    QScrollArea,
    QTextEdit,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.shell.keys.conftest import window as window
from tests.smoke.test_real_window import MISSING
from tests.smoke.test_real_window import environment as environment
from tests.smoke.test_real_window import screen as screen
from tests.soak.events import PAGED, in_front, keys_pressed
from tests.soak.hand import OFTEN_HIT, Hand
from tests.soak.monkey import settled
from tests.soak.shorten import fewest
from workbench.panels.stage.paged_panel import PagedPanel
from workbench.shell.window import MainWindow

ROOT = Path(__file__).resolve().parents[2]


def test_a_few_hundred_random_events_bring_up_no_fault(tmp_path: Path) -> None:
    log = tmp_path / "log"
    command = [sys.executable, "-m", "tests.soak.monkey", "--seed", "7", "--events", "120"]
    command += ["--log", str(log), "--without", "dock,dock_tab"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, ""), log.read_text()[-600:]
    assert len([line for line in log.read_text().splitlines() if line[0].isdigit()]) == 120


@pytest.mark.parametrize("needed", [{0}, {99}, {3, 50}, {10, 11, 12}, {0, 33, 66, 99}])
def test_the_fewest_events_that_fail_are_those_that_are_needed(needed: set[int]) -> None:
    tried = []

    def fails(numbers: Sequence[int]) -> bool:
        tried.append(numbers)
        return needed <= set(numbers)

    assert fewest(range(100), fails) == sorted(needed)
    assert len(tried) < 100


def test_what_a_hand_looked_at_outlives_the_window_it_was_seen_in(qtbot: QtBot) -> None:
    card, rest = QWidget(), QWidget()
    qtbot.addWidget(rest)
    column = QVBoxLayout(card)
    column.addWidget(QTextEdit())
    action = QMenu(card).addAction("Kept by the card")
    dock = QDockWidget()
    dock.setWidget(card)
    dock.show()
    qtbot.waitExposed(dock)
    hand = Hand(rest, Random(1), lambda _text: None)
    assert card in hand.parts(dock)
    assert card.isAncestorOf(hand.under(dock, dock.rect().center()))
    for _turn in range(20):
        hand.target(dock)
    QVBoxLayout(rest).addWidget(card)
    dock.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not shiboken6.isValid(dock)
    assert shiboken6.isValid(action)


def test_no_event_acts_on_the_window_behind_a_dialog(qtbot: QtBot) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    window.show()
    dialog = QDialog(window)
    dialog.setModal(True)
    dialog.show()
    qtbot.waitExposed(dialog)
    assert QApplication.activeModalWidget() is dialog
    hand, done = Hand(window, Random(1), lambda _text: None), []
    event = in_front(lambda _hand: done.append("done") or "")
    event(hand)
    assert done == []
    assert not dialog.isVisible()
    event(hand)
    assert done == ["done"]


def test_the_pictures_of_every_workspace_and_page_are_hit_often(qtbot: QtBot, window: MainWindow) -> None:
    hand = Hand(window, Random(1), lambda _text: None)

    def hit_often() -> None:
        seen = hand.parts(window)
        hit = [hand.among(seen) for _turn in range(40)]
        pictures = [part for part in hit if middle.isAncestorOf(part) and type(part).__name__ in OFTEN_HIT]
        assert len(pictures) > 4, (slug, getattr(panel, "page", ""))

    for slug in window.workspace_slugs:
        window.go(slug)
        panel = window.panels(slug)[0]
        middle = panel.center
        assert isinstance(panel, PagedPanel) == (slug in PAGED)
        if not isinstance(panel, PagedPanel):
            hit_often()
            continue
        panel.show_example()
        for switch in panel.buttons.buttons():
            switch.click()
            qtbot.waitUntil(hit_often)  # some pictures take a while


def test_a_hand_reaches_only_what_is_seen_in_the_window(qtbot: QtBot) -> None:
    window, page = QWidget(), QLabel("Tall")
    qtbot.addWidget(window)
    page.setFixedSize(300, 4000)
    scrolled = QScrollArea()
    scrolled.setWidget(page)
    QVBoxLayout(window).addWidget(scrolled)
    hidden = QLabel("Behind a tab", window)
    hidden.setGeometry(-700, -500, 100, 50)
    window.resize(320, 200)
    window.show()
    qtbot.waitExposed(window)
    hand = Hand(window, Random(1), lambda _text: None)
    assert page in hand.parts(window)
    assert hidden not in hand.parts(window)
    places = [hand.place(window, page) for _turn in range(200)]
    assert all(window.rect().contains(place) for place in places)
    assert max(place.y() for place in places) - min(place.y() for place in places) > 100


def test_every_key_of_the_hand_is_one_key_of_the_keyboard(qapp: QApplication) -> None:
    for text in keys_pressed():
        keys = QKeySequence(text)
        assert (keys.count(), text) == (1, text)
        assert (keys[0].key() != Qt.Key.Key_unknown, text) == (True, text)


def test_memory_is_compared_by_the_medians_of_the_settled_and_the_last_marks() -> None:
    marks = [400.0] * 7 + [500.0, 525.0, 501.0, 502.0, 480.0] + [900.0] * 3
    assert settled([*marks, 503.0, 530.0, 504.0, 505.0, 490.0]) == (501.0, 504.0)
    assert settled([*marks, 503.0, 530.0, 504.0, 505.0]) == (0.0, 0.0)


DRAG = """
import faulthandler
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPlainTextEdit
from tests.soak.monkey import Keeper

application = QApplication([])
window = QPlainTextEdit("Some words " * 40)
window.resize(400, 300)
window.show()
assert QTest.qWaitForWindowExposed(window)
window.selectAll()
keeper, top = Keeper(window), window.windowHandle()
keeper.inside = True
faulthandler.dump_traceback_later(10, exit=True)
QTest.mousePress(top, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(60, 20))
for x in (70, 120, 180):
    QTest.mouseMove(top, QPoint(x, 40))
window.removeEventFilter(keeper)
"""


@pytest.mark.skipif(bool(MISSING), reason=f"no real window here: {', '.join(MISSING)} not installed")
def test_a_text_that_is_dragged_and_never_dropped_holds_no_event(environment: dict[str, str]) -> None:
    command = [sys.executable, "-c", DRAG]
    done = subprocess.run(command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
