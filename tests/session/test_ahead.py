"""What is made of a large sheet is made on a thread, one thing at a time; of a small one at once."""

import threading
from collections.abc import Callable
from functools import partial

import pytest
from msgspec.structs import replace
from pytestqt.qtbot import QtBot

from workbench.document.model import Sheet
from workbench.document.samples.examples import blank_sheet
from workbench.document.samples.figures import line
from workbench.session.ahead import Ahead, is_large


def sheet_of(count: int) -> Sheet:
    figures = tuple(replace(line((k % 60, 1), (k % 60, 9)), id=f"f{3 * k + 1}") for k in range(count))
    return replace(blank_sheet().sheets[0], figures=figures)


def here() -> threading.Thread:
    return threading.current_thread()


def waiting_work() -> tuple[threading.Event, list[int], Callable[[int], int]]:
    """What gives a number back once it may go on, the numbers it was given, and that work."""
    go_on, made = threading.Event(), list[int]()

    def make(number: int) -> int:
        made.append(number)
        assert go_on.wait(20)
        return number

    return go_on, made, make


def test_of_a_small_sheet_it_is_made_at_once_and_each_time(qapp: object) -> None:
    ahead, sheet = Ahead(), sheet_of(3)
    made = [ahead.of(sheet, "thread", here) for _time in range(2)]
    assert made == [threading.main_thread()] * 2


def test_of_a_large_sheet_it_is_made_once_and_elsewhere(qtbot: QtBot) -> None:
    ahead, sheet = Ahead(), sheet_of(400)
    assert is_large(sheet)
    assert ahead.of(sheet, "thread", here) is None
    assert ahead.of(sheet, "thread", here) is None
    qtbot.waitUntil(lambda: ahead.of(sheet, "thread", here) is not None)
    first = ahead.of(sheet, "thread", here)
    assert first is not threading.main_thread()
    assert ahead.of(sheet, "thread", here) is first
    same = replace(sheet)  # equal, as after a change was taken back
    assert ahead.of(same, "thread", here) is first
    assert ahead.of(sheet, "thread", here, "otherwise") is None


def test_many_of_one_name_leave_what_there_is_of_others(qtbot: QtBot) -> None:
    ahead, sheet = Ahead(), sheet_of(400)
    ahead.of(sheet, "calls", lambda: "all of them")
    for place in range(20):  # as a magnifying glass that is moved about
        ahead.of(sheet, "part", lambda place=place: place, place)
        qtbot.waitUntil(lambda: not ahead.busy)
    assert ahead.of(sheet, "calls", here) == "all of them"
    assert [ahead.of(sheet, "part", here, place) for place in (19, 18, 17)] == [19, 18, 17]
    assert len(ahead._kept) == 4


def test_one_thing_at_a_time_and_of_what_waits_only_the_last(qtbot: QtBot) -> None:
    ahead, sheet = Ahead(), sheet_of(400)
    go_on, made, make = waiting_work()

    for number in range(5):
        for _twice in range(2):
            assert ahead.of(sheet, "number", partial(make, number), number) is None
    qtbot.waitUntil(lambda: made == [0])
    go_on.set()
    qtbot.waitUntil(lambda: not ahead.busy)
    assert made == [0, 4]
    qtbot.waitUntil(lambda: ahead.of(sheet, "number", lambda: make(4), 4) == 4)
    assert made == [0, 4]
    assert ahead.of(sheet, "number", lambda: make(0), 0) == 0
    assert made == [0, 4]


def test_what_fails_is_told_and_not_made_again(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[BaseException | None] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_value))
    ahead, sheet = Ahead(), sheet_of(400)

    def fail() -> int:
        raise ValueError("no")

    with qtbot.waitSignal(ahead.arrived):
        assert ahead.of(sheet, "failing", fail) is None
    assert ahead.of(sheet, "failing", fail) is None
    qtbot.wait(20)
    assert [type(each) for each in told] == [ValueError]


def test_nothing_is_kept_of_a_document_that_was_closed(qtbot: QtBot) -> None:
    """Neither what was there, nor what waited, nor what was still worked on."""
    ahead, sheet = Ahead(), sheet_of(400)
    go_on, made, make = waiting_work()

    def ask(number: int) -> int | None:
        return ahead.of(sheet, f"number {number}", lambda: make(number))

    go_on.set()
    ask(0)
    qtbot.waitUntil(lambda: ask(0) == 0)
    go_on.clear()
    assert (ask(1), ask(2)) == (None, None)
    qtbot.waitUntil(lambda: made == [0, 1])
    ahead.forget()
    with qtbot.assertNotEmitted(ahead.arrived):
        go_on.set()
        qtbot.waitUntil(lambda: not ahead.busy)
    assert made == [0, 1]
    assert (ask(0), ask(1)) == (None, None)
    qtbot.waitUntil(lambda: (ask(0), ask(1)) == (0, 1))
    assert made == [0, 1, 0, 1]


def test_what_is_forgotten_while_it_is_worked_on_is_made_again_where_it_is_asked_for(qtbot: QtBot) -> None:
    """As where the same file is opened once more."""
    ahead, sheet = Ahead(), sheet_of(400)
    assert ahead.of(sheet, "thread", here) is None
    ahead.forget()
    assert ahead.of(sheet, "thread", here) is None
    qtbot.waitUntil(lambda: ahead.of(sheet, "thread", here) is not None)
