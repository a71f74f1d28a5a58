"""What threads give is told on the interface thread, once, and never to what has gone."""

import threading
from functools import partial

import pytest
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import delete, isValid

from workbench.session.answers import Answers
from workbench.session.bell import bell


def test_each_answer_arrives_once_on_the_thread_that_asked(qtbot: QtBot) -> None:
    parent = QObject()
    answers = Answers(parent)
    arrived: list[tuple[int, str]] = []
    answers.arrived.connect(lambda answer: arrived.append((answer, threading.current_thread().name)))
    for number in range(20):
        answers.ask(partial(int, number), "counting")
    qtbot.waitUntil(lambda: len(arrived) == 20)
    assert sorted(arrived) == [(number, threading.main_thread().name) for number in range(20)]
    assert not answers.are_awaited


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_no_answer_and_a_failure_leave_nothing_awaited(qtbot: QtBot) -> None:
    parent = QObject()
    answers = Answers(parent)
    arrived: list[object] = []
    answers.arrived.connect(arrived.append)
    threads = [answers.ask(lambda: None, "nothing"), answers.ask(lambda: 1 // 0, "failing")]
    qtbot.waitUntil(lambda: not answers.are_awaited)
    for thread in threads:
        thread.join()  # the failure is told by then
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


def test_one_that_waits_in_an_answer_keeps_no_other_from_arriving(qtbot: QtBot) -> None:
    """As a dialog does that is opened for an answer, and has an event loop of its own."""
    parent = QObject()
    arrived: list[int] = []
    two = Answers(parent), Answers(parent)
    for number, answers in enumerate(two):
        answers.arrived.connect(arrived.append)
        answers.arrived.connect(lambda _answer: qtbot.waitUntil(lambda: len(arrived) == 2))
        answers.ask(partial(int, number), "counting").join()
    qtbot.waitUntil(lambda: not any(answers.are_awaited for answers in two))
    assert sorted(arrived) == [0, 1]


def test_what_is_told_while_nobody_listens_arrives_in_order(qtbot: QtBot) -> None:
    """More than the bell holds rings of."""
    parent = QObject()
    answers = Answers(parent)
    arrived: list[int] = []
    answers.arrived.connect(arrived.append)
    many = 3_000

    def work() -> int:
        for number in range(many):
            answers_tell(number)
        return many

    answers_tell = answers.tell
    answers.ask(work, "telling").join()
    qtbot.waitUntil(lambda: len(arrived) == many + 1)
    assert arrived == list(range(many + 1))
    assert not answers.are_awaited


def test_nothing_looks_for_answers_while_the_work_goes_on(qtbot: QtBot) -> None:
    parent = QObject()
    answers, may_end, looks = Answers(parent), threading.Event(), []
    bell().rung.connect(lambda: looks.append(1))
    answers.ask(may_end.wait, "long", may_end.set)
    qtbot.wait(50)
    assert looks == []
    may_end.set()
    qtbot.waitUntil(lambda: not answers.are_awaited)
    assert looks
