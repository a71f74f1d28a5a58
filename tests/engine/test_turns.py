"""Threads beside an interface wait while it works, and never for good."""

import sys
import threading
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path

import pytest

from workbench.algorithms.lines.bresenham import bresenham_line
from workbench.engine import turns
from workbench.engine.recorder import Recorder
from workbench.engine.turns import imports_in_turn, interface


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Nobody goes on out of impatience, and the interface rests afterwards."""
    monkeypatch.setattr(turns, "_PATIENCE_S", 600.0)
    yield
    interface.rests()


def started(work: Callable[[], None]) -> threading.Thread:
    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    return thread


def test_others_wait_while_the_interface_works() -> None:
    thread = started(interface.wait)
    thread.join(60)
    assert not thread.is_alive()
    interface.works()
    thread = started(interface.wait)
    thread.join(0.05)
    assert thread.is_alive()
    interface.rests()
    thread.join(60)
    assert not thread.is_alive()


def test_an_interface_that_was_left_working_is_not_waited_for_for_ever(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(turns, "_PATIENCE_S", 0.01)
    interface.works()
    thread = started(interface.wait)
    thread.join(60)
    assert not thread.is_alive()
    monkeypatch.setattr(turns, "_PATIENCE_S", 600.0)
    thread = started(interface.wait)
    thread.join(60)
    assert not thread.is_alive()


def test_the_interface_does_not_wait_for_itself() -> None:
    interface.works()
    interface.wait()


def test_a_recorder_goes_on_only_while_the_interface_rests() -> None:
    interface.works()
    recorder = Recorder(bresenham_line, 0, 0, 4000, 1234)
    recorder.start()
    recorder.wait_for_first(60)
    first = len(recorder.recording)
    assert 0 < first <= 512
    assert not recorder.join(0.05)
    assert len(recorder.recording) == first
    interface.rests()
    assert recorder.join(60)
    assert recorder.recording.complete


def test_the_first_slice_of_a_short_run_is_all_of_it() -> None:
    interface.works()
    recorder = Recorder(bresenham_line, 0, 0, 20, 12)
    recorder.start()
    recorder.wait_for_first(60)
    assert recorder.recording.complete


def test_modules_are_imported_one_by_one_while_the_interface_rests(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "outer_module.py").write_text("import inner_module\n")
    (tmp_path / "inner_module.py").write_text("import workbench.engine.turns as t; t.interface.works()\n")
    monkeypatch.syspath_prepend(tmp_path)

    def load() -> None:
        with imports_in_turn:
            import_module("outer_module")
            import_module("unknown_after_inner")

    failed = []

    def work() -> None:
        try:
            load()
        except ModuleNotFoundError as error:
            failed.append(error.name)

    before = list(sys.meta_path)
    interface.works()
    thread = started(work)
    thread.join(0.05)
    assert "outer_module" not in sys.modules
    interface.rests()
    while "outer_module" not in sys.modules or "inner_module" not in sys.modules:
        thread.join(0.01)
    thread.join(0.05)
    assert thread.is_alive()
    assert not failed
    interface.rests()
    thread.join(60)
    assert failed == ["unknown_after_inner"]
    assert sys.meta_path == before
    del sys.modules["outer_module"], sys.modules["inner_module"]
