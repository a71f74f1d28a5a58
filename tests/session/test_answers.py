"""What threads give is told on the interface thread, once, and never to what has gone."""

import threading
from functools import partial

import pytest
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import delete, isValid

from workbench.session.answers import Answers


def test_each_answer_arrives_once_on_the_thread_that_asked(qtbot: QtBot) -> None:
    parent = QObject()
    answers = Answers(parent)
    arrived: list[tuple[int, str]] = []
    answers.arrived.connect(lambda answer: arrived.append((answer, threading.current_thread().name)))
    for number in range(20):
        answers.ask(partial(int, number), "counting")
    qtbot.waitUntil(lambda: len(arrived) == 20)
    assert sorted(arrived) == [(number, threading.main_thread().name) for number in range(20)]
    assert not answers._timer.isActive()


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_no_answer_and_a_failure_leave_nothing_awaited(qtbot: QtBot) -> None:
    parent = QObject()
    answers = Answers(parent)
    arrived: list[object] = []
    answers.arrived.connect(arrived.append)
    answers.ask(lambda: None, "nothing")
    answers.ask(lambda: 1 // 0, "failing")
    qtbot.waitUntil(lambda: not answers._timer.isActive())
    assert arrived == []


def test_who_asked_may_go_while_the_work_goes_on(qtbot: QtBot) -> None:
    """A thread holds nothing but its work, and the end of it meets nobody."""
    parent = QObject()
    answers = Answers(parent)
    arrived: list[object] = []
    answers.arrived.connect(arrived.append)
    may_end, ended = threading.Event(), threading.Event()

    def work() -> int:
        may_end.wait()
        ended.set()
        return 1

    answers.ask(work, "long", may_end.set)
    delete(parent)
    assert not isValid(answers)
    may_end.set()
    assert ended.wait(5)
    QApplication.processEvents()
    assert arrived == []
