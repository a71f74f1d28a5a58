"""From the start of the process to a whole window."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.session.recovery import recoverable
from workbench.shell.files import Files
from workbench.shell.questions import questions
from workbench.shell.start import Building, has_display, make_window, start
from workbench.shell.workspaces import workspaces

pytestmark = pytest.mark.xdist_group("processes")

ROOT = Path(__file__).resolve().parents[2]
UNUSED = ("numba", "llvmlite", "pyqtgraph", "PIL", "tinycss2", "cssselect2", "scipy", "ssl", "PySide6.QtSvg")
SLOW = (*UNUSED, "numpy", "qtawesome", "msgspec", "pygments")
OURS = (
    "workbench.session",
    "workbench.panels",
    "workbench.engine",
    "workbench.algorithms",
    "workbench.rendering",
)

LISTING = """
import json, sys
from PySide6.QtWidgets import QApplication
from workbench.shell.start import make_window
application = QApplication([])
window = make_window()
def painted():
    print(json.dumps(sorted(sys.modules)))
    application.quit()
window.first_frame.connect(painted)
window.show()
sys.exit(application.exec())
"""


ENTERED = """
import json, sys
from PySide6.QtWidgets import QApplication
from workbench.shell.start import Building, make_window
application = QApplication([])
window = make_window()
building = Building(window, warms=False)
def entered(slug):
    print(json.dumps([window.place, *sorted(sys.modules)]))
    window.session.close()
    application.quit()
window.entered.connect(entered)
window.first_frame.connect(building.start)
building.built.connect(lambda: window.go(sys.argv[1]))
window.show()
status = application.exec()
building.end()
sys.exit(status)
"""


ELSEWHERE = """
import sys, threading
OF_QT = ("PySide6", "shiboken6", "qtpy", "qtawesome", "pyqtgraph")
OURS = ("workbench.session", "workbench.widgets", "workbench.panels", "workbench.shell")
class Watch:
    def find_spec(self, name, path=None, target=None):
        if name.startswith((*OF_QT, *OURS)) and threading.current_thread() is not threading.main_thread():
            print(name, "on", threading.current_thread().name)
sys.meta_path.insert(0, Watch())
from PySide6.QtWidgets import QApplication
from workbench.shell.start import Building, make_window
from workbench.shell.workspaces import workspaces
from workbench.widgets.plots.library import library
application = QApplication([])
window = make_window()
building = Building(window)
left = [workspace.slug for workspace in workspaces()]
def go_on(*_entered):
    if left:
        window.go(left.pop())
    else:
        library.loaded.connect(leave)
        library.ask()
def leave():
    print("pyqtgraph" in sys.modules, left)
    window.session.close()
    application.quit()
window.entered.connect(go_on)
window.first_frame.connect(building.start)
building.built.connect(go_on)
window.show()
status = application.exec()
building.end()
sys.exit(status)
"""


def run(*words: str, **environment: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-W", "error", *words],
        env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
        capture_output=True,
        text=True,
        timeout=120,
        # What is started in the background of a shell would not hear Ctrl+C
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def test_the_first_frame_loads_nothing_slow() -> None:
    done = run("-c", LISTING)
    assert done.returncode == 0, done.stderr
    loaded = set(json.loads(done.stdout))
    assert "workbench.shell.home" in loaded
    assert loaded.isdisjoint(SLOW)
    assert not [name for name in loaded if name.startswith(OURS)]


@pytest.mark.parametrize("slug", ["draw", "clip"])
def test_only_the_modules_of_the_workspaces_entered_are_loaded(slug: str) -> None:
    done = run("-c", ENTERED, slug)
    assert done.returncode == 0, done.stderr
    place, *loaded = json.loads(done.stdout)
    assert place == slug
    own = {workspace.slug: set(workspace.modules) for workspace in workspaces()}
    first = own["draw"]  # is made ready for whoever goes anywhere
    assert own[slug] | first <= set(loaded)
    for other in own.keys() - {slug, "draw"}:
        assert not [name for name in loaded if name.startswith(f"workbench.panels.{other}")]
    assert set(loaded).isdisjoint(UNUSED)


def test_nothing_of_qt_is_imported_on_another_thread() -> None:
    """There it would make classes, which PySide looks up here without a lock: now and then that ends all."""
    done = run("-c", ELSEWHERE)
    assert done.returncode == 0, done.stderr
    assert done.stdout == "True []\n"


def test_a_workspace_arrives_once_its_panels_are_made(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    done: list[str] = []
    window.enter("fill", lambda: done.append("fill"))
    window.enter("curves", lambda: done.append("curves"))
    assert window.place == "home"
    qtbot.waitUntil(lambda: bool(window.panels("fill") and window.panels("curves")), timeout=30_000)
    qtbot.waitUntil(lambda: window.place == "curves")
    assert done == ["curves"]
    window.enter("clip", lambda: done.append("clip"))
    window.go("draw")
    qtbot.waitUntil(lambda: bool(window.panels("clip")), timeout=30_000)
    QApplication.processEvents()
    assert (window.place, done) == ("draw", ["curves"])
    window.enter("fill", lambda: done.append("fill"))  # its panels are there, so at once
    assert (window.place, done) == ("fill", ["curves", "fill"])
    fourth = questions()[3]
    window.open_question(fourth)  # its step waits for the workspace too
    assert window.place == "fill"
    qtbot.waitUntil(lambda: window.place == fourth.workspace, timeout=30_000)
    assert (window.session.state.workspace, window.session.state.step) == ("view", fourth.step)
    window.session.close()
    building.end()
    window.deleteLater()
    QApplication.processEvents()


def test_quit_after_first_frame() -> None:
    done = run("-m", "workbench", "--quit-after-first-frame")
    assert (done.returncode, done.stdout) == (0, "")


def test_words_that_are_no_picture_are_refused() -> None:
    assert start(["nowhere.gwb"]) == 2
    assert start(["--sideways"]) == 2


def test_a_name_without_its_folder_is_opened_as_that_of_this_folder(tmp_path: Path) -> None:
    (tmp_path / "a.gwb").touch()
    code = (
        "import sys; from workbench.shell import start;"
        "start.Building = lambda window, path: (print(path), sys.exit(0)); start.start(['a.gwb'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.stdout == f"{tmp_path / 'a.gwb'}\n", done.stderr


COPYING = """
import sys
from PySide6.QtWidgets import QApplication
from workbench.document.samples.examples import example_document
from workbench.panels.stage.clipboard import copy_figures
from workbench.shell import start
class Copying:
    def __init__(self, window, path):
        pass
    def start(self):
        sheet = example_document().sheets[0]
        copy_figures(sheet, list(sheet.figures))
        QApplication.quit()
    def end(self):
        pass
start.Building = Copying
sys.exit(start.start([]))
"""


def test_what_was_copied_does_not_end_the_process_otherwise_than_well() -> None:
    done = run("-c", COPYING)
    assert (done.returncode, done.stderr) == (0, "")


def test_the_rest_is_built_behind_the_first_frame(qtbot: QtBot) -> None:
    window = make_window()
    building = Building(window)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    building.end()
    (line,) = window.session.sheet.figures
    assert window.session.state.selection == (line.id,)
    home = window._pages["home"]
    assert len(home.example_buttons()) >= 3
    home.example_buttons()[1].click()
    assert window.place == "draw"
    window.close()
    window.deleteLater()
    QApplication.processEvents()


@pytest.mark.filterwarnings("ignore")
def test_the_rest_is_built_whatever_the_offer_of_recovery_does(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_files: Files) -> None:
        raise MemoryError

    monkeypatch.setattr(Files, "offer_recovery", fail)
    window = make_window()
    qtbot.addWidget(window)
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.captureExceptions() as raised, qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    assert [kind for kind, *_rest in raised] == [MemoryError]
    assert window.panels("draw")
    window.session.close()
    building.end()


INTERRUPTED = """
import os, signal, sys
from workbench.document.edits import rename_sheet
from workbench.shell import start
def change(building):
    session = building._window.session
    session.apply(rename_sheet(session.sheet.id, "nearly lost"), "Rename")
    os.kill(os.getpid(), signal.SIGINT)
class Building(start.Building):
    def __init__(self, *words):
        super().__init__(*words, warms=False)
        self.built.connect(lambda: change(self))
start.Building = Building
sys.exit(start.start([]))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="sends itself a signal")
def test_an_interrupt_in_the_terminal_ends_it_and_loses_nothing(profile: Path) -> None:
    done = run("-c", INTERRUPTED)
    assert (done.returncode, done.stderr) == (130, "")
    (work,) = recoverable(profile / "recovery")
    assert work.read().document.sheets[0].name == "nearly lost"


def test_tour_refuses_in_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from workbench.shell.tour import main

    for words in (["--theme", "green"], ["--scale", "0"], ["--size", "big"], ["--nothing"]):
        assert main([str(tmp_path), *words]) == 2
        assert capsys.readouterr().err.count("\n") == 1
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert main([str(blocked)]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_tour_without_a_temporary_folder_says_so_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbench.shell import tour

    def none(*_given: object, **_named: object) -> None:
        raise FileNotFoundError(2, "No usable temporary directory found", "/tmp")

    monkeypatch.setattr(tour.tempfile, "mkdtemp", none)
    assert tour.main([str(tmp_path)]) == 1
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize(
    ("environment", "system", "shown"),
    [
        ({}, "linux", False),
        ({"DISPLAY": ""}, "linux", False),
        ({"DISPLAY": ":0"}, "linux", True),
        ({"WAYLAND_DISPLAY": "wayland-0"}, "linux", True),
        ({"QT_QPA_PLATFORM": "offscreen"}, "linux", True),
        ({}, "darwin", True),
        ({}, "win32", True),
    ],
)
def test_a_missing_display_is_known_before_qt_ends_the_process(
    environment: dict[str, str], system: str, shown: bool
) -> None:
    assert has_display(environment, system) == shown
