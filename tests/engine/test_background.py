"""Threads end before the interpreter: one that is told to stop is waited for, and gone is gone."""

import subprocess
import sys
import threading
from pathlib import Path

from workbench.engine import background
from workbench.engine.turns import interface

ROOT = Path(__file__).parents[2]


def test_a_thread_is_told_to_stop_and_waited_for() -> None:
    stop, ended = threading.Event(), threading.Event()

    def work() -> None:
        stop.wait()
        ended.set()

    thread = background.thread(work, "waits", stop.set)
    thread.start()
    assert not ended.is_set()
    assert background.end_all()
    assert ended.is_set()
    assert not thread.is_alive()


def test_those_that_are_ended_no_longer_wait_for_the_interface() -> None:
    def wait_often() -> None:
        for _turn in range(100):
            interface.wait()

    interface.works()
    background.thread(wait_often, "waits").start()
    try:
        assert background.end_all(2.0)
    finally:
        interface.rests()


def test_one_that_does_not_stop_is_given_up() -> None:
    late = threading.Event()
    thread = background.thread(late.wait, "stays")
    thread.start()
    assert not background.end_all(0.01)
    late.set()
    thread.join()
    assert background.end_all(0.01)


def test_the_interpreter_ends_after_a_recorder_that_would_go_on() -> None:
    code = (
        "import threading;"
        "from workbench.algorithms import catalogue; from workbench.engine.recorder import Recorder;"
        "one = Recorder(catalogue.get('bresenham_line').function, 0, 0, 10**9, 10**8, limit=10**9);"
        "one.start(); import atexit; atexit._run_exitfuncs(); print(one.done, threading.active_count())"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "True 1\n", "")
