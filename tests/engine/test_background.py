"""Threads end before the interpreter: one that is told to stop is waited for, and gone is gone."""

import subprocess
import sys
import threading
from pathlib import Path

import pytest

from workbench.engine import background
from workbench.engine.turns import interface

ROOT = Path(__file__).parents[2]


def test_a_thread_is_told_to_stop_and_waited_for() -> None:
    begun, stop, ended = threading.Event(), threading.Event(), threading.Event()

    def work() -> None:
        begun.set()
        stop.wait()
        ended.set()

    thread = background.Thread(work, "waits", stop.set)
    thread.start()
    begun.wait()
    assert not ended.is_set()
    assert background.end_all()
    assert ended.is_set()
    assert not thread.is_alive()


def test_those_that_are_ended_no_longer_wait_for_the_interface() -> None:
    begun = threading.Event()

    def wait_often() -> None:
        begun.set()
        for _turn in range(100):
            interface.wait()

    interface.works()
    background.Thread(wait_often, "waits").start()
    begun.wait()
    try:
        assert background.end_all(2.0)
    finally:
        interface.rests()


def test_one_that_does_not_stop_is_given_up() -> None:
    begun, late = threading.Event(), threading.Event()
    thread = background.Thread(lambda: (begun.set(), late.wait())[0], "stays")
    thread.start()
    begun.wait()
    assert not background.end_all(0.01)
    late.set()
    thread.join()
    assert background.end_all(0.01)


def test_nobody_waits_for_a_thread_that_never_comes_to_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where memory is short: https://github.com/python/cpython/issues/140746."""
    monkeypatch.setattr(threading.Thread, "_bootstrap", lambda _thread: None)
    done_on: list[threading.Thread] = []
    thread = background.Thread(lambda: done_on.append(threading.current_thread()), "never")
    thread.start()
    assert not thread.ended
    thread.join(0.01)
    thread.finish()
    thread.finish()
    assert thread.ended
    assert done_on == [threading.main_thread()]
    another = background.Thread(lambda: done_on.append(threading.current_thread()), "never")
    another.start()
    assert background.end_all(60)
    another.finish()
    assert len(done_on) == 1


def test_stacks_of_other_threads_stay_as_they_were_whoever_starts_them_at_once() -> None:
    before = threading.stack_size()
    inside, leave = threading.Event(), threading.Event()

    def hold() -> None:
        with background.large_stacks():
            inside.set()
            leave.wait()

    def follow() -> None:
        with background.large_stacks():
            pass

    first, second = background.Thread(hold, "first"), background.Thread(follow, "second")
    first.start()
    inside.wait()
    second.start()
    leave.set()
    first.join()
    second.join()
    assert threading.stack_size() == before


def test_the_interpreter_ends_after_a_recorder_that_would_go_on() -> None:
    code = (
        "import threading;"
        "from workbench.algorithms import catalogue; from workbench.engine.recorder import Recorder;"
        "one = Recorder(catalogue.get('bresenham_line').function, 0, 0, 10**9, 10**8, limit=10**9);"
        "one.start(); one.wait_for_first(60); import atexit; atexit._run_exitfuncs();"
        "print(one.done, threading.active_count())"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "True 1\n", "")
