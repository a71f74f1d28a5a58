"""The library of the plots comes piece by piece, on the thread of the interface."""

import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QAbstractEventDispatcher, QObject, Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot
from shiboken6 import delete

from workbench.widgets.plots.library import library
from workbench.widgets.plots.stepwise import import_stepwise

ROOT = Path(__file__).resolve().parents[3]

LOADING = """
import sys, threading
from PySide6.QtCore import QAbstractEventDispatcher
from PySide6.QtWidgets import QApplication
from workbench.widgets.plots.library import library

turn, turns, threads = [0], {}, set()
class Watch:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "pyqtgraph":
            turns[name] = turn[0]
            threads.add(threading.current_thread() is threading.main_thread())
sys.meta_path.insert(0, Watch())
application = QApplication([])
QAbstractEventDispatcher.instance().awake.connect(lambda: turn.__setitem__(0, turn[0] + 1))
library.loaded.connect(application.quit)
library.ask()
application.exec()
import pyqtgraph
counts = [list(turns.values()).count(each) for each in set(turns.values())]
print(len(turns), len(counts), max(counts), threads, hasattr(pyqtgraph, "PlotWidget"), pyqtgraph.__version__)
"""


@pytest.mark.xdist_group("processes")
def test_no_turn_of_the_loop_imports_much_of_it() -> None:
    ended = subprocess.run(
        [sys.executable, "-c", LOADING], cwd=ROOT, capture_output=True, text=True, timeout=120,
        env={"QT_QPA_PLATFORM": "offscreen", "PATH": "/usr/bin", "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    modules, turns, most, rest = ended.stdout.split(maxsplit=3)
    assert rest.startswith("{True} True ")
    assert int(modules) > 100
    assert int(turns) > 30
    assert int(most) < int(modules) / 4


def test_a_package_is_all_there_after_the_last_step(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "stepped_package"
    package.mkdir()
    (package / "__init__.py").write_text('"""Told."""\nfrom .part import number\ntwice = 2 * number\n')
    (package / "part.py").write_text("number = 21\n")
    monkeypatch.syspath_prepend(tmp_path)
    steps = import_stepwise("stepped_package")
    seen = []
    for _step in steps:
        seen.append(hasattr(sys.modules["stepped_package"], "twice"))
    assert seen == [False, False, True]
    import stepped_package  # type: ignore[import-not-found]

    assert (stepped_package.twice, stepped_package.part.number) == (42, 21)
    assert list(import_stepwise("stepped_package")) == []
    del sys.modules["stepped_package"], sys.modules["stepped_package.part"]


def test_a_package_that_fails_is_not_left_half_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "failing_package").mkdir()
    (tmp_path / "failing_package" / "__init__.py").write_text("one = 1\nimport no_such_module_at_all\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ImportError):
        list(import_stepwise("failing_package"))
    assert "failing_package" not in sys.modules
    with pytest.raises(ImportError):
        list(import_stepwise("no_such_package_at_all"))


def test_of_several_plots_each_is_made_in_a_turn_of_its_own_unless_it_is_gone(qtbot: QtBot) -> None:
    turn, made = [0], []
    dispatcher = QAbstractEventDispatcher.instance()
    parent = QWidget()
    qtbot.addWidget(parent)
    plots = [QObject(parent) for _each in range(4)]

    def count() -> None:
        turn[0] += 1

    def make(number: int) -> None:
        made.append((number, turn[0]))
        widget = QWidget(parent, Qt.WindowType.Window)
        widget.show()  # which makes Qt send posted events at once

    dispatcher.awake.connect(count)
    for number, plot in enumerate(plots):
        library.queue(plot, lambda n=number: make(n))
    delete(plots[1])
    qtbot.waitUntil(lambda: len(made) == 3)
    qtbot.wait(20)
    dispatcher.awake.disconnect(count)
    assert [number for number, _turn in made] == [0, 2, 3]
    assert len({each for _number, each in made}) == 3
