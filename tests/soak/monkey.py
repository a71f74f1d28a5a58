"""Drives the real window with random events from a seed, and ends with the first fault it brings up.

    python -m tests.soak.monkey --seed 1 --events 20000 [--without dock_tab,dock] [--log FILE]
    python -m tests.soak.monkey --seed 1 --within display  # mostly in this workspace
    python -m tests.soak.monkey --seed 1 --only 3,17,80    # these events of the seed alone
    python -m tests.soak.monkey --seed 1 --shorten LOG     # the fewest events that bring its fault up

A fault is an exception nobody caught, on any thread, a Qt warning, a warning of Python or in the log, a
crash, an event that takes the interface over 30 s of processor time or never ends, or memory that grows. The
log names each event before it is done.

Memory is what the process holds for itself at rest, pages of library files aside: an empty picture, which
every page of every workspace has been entered with, the first of them last, with its docks as at first, in a
window as large, of the theme and of the type as then; caches of functions emptied that have a bound (they
fill for hours; those without one stay, and tell), garbage collected, and what was freed given back by the
allocator (``malloc_trim``), which else keeps tens of megabytes of it, at times more and at times less. Large
blocks are mapped apart, so that they leave no holes. The median of the marks at 8,000 to 12,000 events is
compared with that of the marks at 16,000 to 20,000.
"""

import argparse
import faulthandler
import logging
import os
import sys
import tempfile
import threading
import time
import traceback
import warnings
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from random import Random
from statistics import median
from typing import Any, TextIO

from PySide6.QtCore import QEvent, QObject, QSize, QThread, QTimer, QtMsgType, qInstallMessageHandler
from PySide6.QtGui import QDrag
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QMessageBox

from tests.soak.events import KINDS, PAGED, page, workspace
from tests.soak.hand import Hand
from tests.soak.holdings import arenas, edited, holdings
from workbench.shell import files
from workbench.shell.settled import has_settled
from workbench.shell.theme import choose_theme, choose_type
from workbench.shell.workspaces import workspaces

MARK, SETTLED, LAST = 1_000, (8, 12), (16, 20)  # marks, the first is 1
MOST_GROWTH_MB = 5.0
SIZE = 1280, 720
LONGEST_S = 30.0  # of processor time
_NO_END_S = 180.0  # on a clock, beside whatever else the machine does
EXPECTED = (
    "This plugin does not support",  # said by the offscreen platform of every window
    "Mouse event at ",  # said of drags that leave the window
)
_APART = "MALLOC_MMAP_THRESHOLD_"
_REST_MS, _POPUP_MS = 400, 40
_LONGEST_REST = 25  # times _REST_MS
_DEEPEST = 5
_MUCH_MB = 20.0
_MORE = 3  # as often is a workspace gone to that events keep to


class Faults:
    """Everything that is said of something going wrong, from anywhere in the process."""

    def __init__(self) -> None:
        self.said: list[str] = []
        sys.excepthook = self._uncaught
        threading.excepthook = lambda told: self._uncaught(
            told.exc_type, told.exc_value or told.exc_type(), told.exc_traceback
        )
        sys.unraisablehook = lambda told: self._uncaught(
            told.exc_type, told.exc_value or told.exc_type(), told.exc_traceback
        )
        qInstallMessageHandler(self._from_qt)
        warnings.simplefilter("error")
        handler = logging.Handler(logging.WARNING)
        handler.emit = lambda record: self.said.append(f"log: {record.getMessage()}")  # type: ignore[method-assign]
        logging.getLogger().addHandler(handler)

    def _uncaught(self, kind: type[BaseException], error: BaseException, trace: Any) -> None:
        self.said.append("".join(traceback.format_exception(kind, error, trace)))

    def _from_qt(self, kind: QtMsgType, _where: Any, text: str) -> None:
        if kind != QtMsgType.QtDebugMsg and not text.startswith(EXPECTED):
            self.said.append(f"Qt: {text}")


class Keeper(QObject):
    """Keeps the main window open, and ends menus, questions and drags of texts that hold their event."""

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self.inside = False
        window.installEventFilter(self)
        self._seen: Any = None
        timer = QTimer(self)
        timer.timeout.connect(self._look)
        timer.start(_POPUP_MS)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Close:
            event.ignore()
            return True
        return False

    def _look(self) -> None:
        question = QApplication.activeModalWidget()
        popup = QApplication.activePopupWidget() or (question if isinstance(question, QMessageBox) else None)
        if self.inside and popup is not None and popup is self._seen:
            popup.close()
            popup = None
        self._seen = popup
        if self.inside and QApplication.platformName() != "offscreen":  # where nothing can be dragged
            QDrag.cancel()  # Qt waits for a drop that the rest of the event can no longer bring


class Monkey(QObject):
    """Does the events with these numbers, one in each turn of the event loop."""

    def __init__(
        self, window: Any, seed: int, numbers: list[int], without: set[str], within: str, log: TextIO
    ) -> None:
        super().__init__(window)
        self._window, self._seed, self._left, self._log = window, seed, numbers[::-1], log
        self._within = within
        self._keeper = Keeper(window)
        self._kinds = [kind for kind in KINDS if kind.__name__ not in without]
        more = _MORE if within else 1
        self._weights = [KINDS[kind] * (more if kind in (workspace, page) else 1) for kind in self._kinds]
        self.faults = Faults()
        self.megabytes: list[float] = []
        self._done = 0
        self._owes_mark = False
        self._arenas = arenas()
        self._began = time.thread_time()

    def start(self) -> None:
        """Begin with nothing open but the first picture."""
        self._window.enter(self._within or "draw")
        QTimer.singleShot(_REST_MS, self._next)

    def _next(self) -> None:
        if (took := time.thread_time() - self._began) > LONGEST_S:
            self.faults.said.append(f"the last event took {took:.1f} s")
        self._began = time.thread_time()
        if self.faults.said or not self._left:
            self._finish()
            return
        number = self._left.pop()
        rng = Random(f"{self._seed}/{number}")
        kind = rng.choices(self._kinds, self._weights)[0]
        print(f"{number} {kind.__name__}", end=" ", file=self._log, flush=True)
        self._keeper.inside = True
        faulthandler.dump_traceback_later(_NO_END_S, exit=True)
        try:
            said = kind(Hand(self._window, rng, self._tell, self._within))
        except Exception:
            said = ""
            self.faults.said.append(traceback.format_exc())
        self._keeper.inside = False
        if (more := arenas() - self._arenas) > _MUCH_MB:  # which may leave holes behind
            said += f" (the allocator took {more:.0f} MB)"
        self._arenas = arenas()
        print(said, file=self._log, flush=True)
        self._done += 1
        if self._owes_mark or self._done % MARK == 0:
            self._mark(_DEEPEST)
        else:
            QTimer.singleShot(rng.choice((0, 0, 0, 0, 5, 30)), self._next)

    def _mark(self, left: int) -> None:
        """Measure once no question holds a loop of its own, which would keep all that is to be deleted; where
        one does not end, the next event is done first."""
        held = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        self._owes_mark = held is not None or QThread.currentThread().loopLevel() > 1
        if held is not None:
            self._tell(f"(closing {type(held).__name__} {held.objectName()})")
            held.close()
        if self._owes_mark:
            again = partial(self._mark, left - 1) if left else self._next
            QTimer.singleShot(_REST_MS, again)
            return
        try:
            self._measure()
        except Exception:
            self.faults.said.append(traceback.format_exc())
        self._began = time.thread_time()
        QTimer.singleShot(0, self._next)

    def _tell(self, text: str) -> None:
        print(text, end=" ", file=self._log, flush=True)

    def _measure(self) -> None:
        """The memory of the process at rest."""
        faulthandler.dump_traceback_later(_NO_END_S * len(workspaces()), exit=True)
        weights = edited(self._window.session)
        self._window.session.new()
        self._window.views.together()
        for _attempt in range(10):
            self._window.showNormal()
            QTest.qWait(_REST_MS)  # until the window manager has done so, it would take back the size
            self._window.resize(*SIZE)
            QTest.qWait(_REST_MS)
            if self._window.size() == QSize(*SIZE):
                break
        choose_type(self._window, large=False)
        for theme in ("dark", "light", "system"):  # Qt keeps rules of all states that each widget was seen in
            choose_theme(self._window, theme)
            QTest.qWait(_REST_MS)
        for each in (*workspaces(), workspaces()[0]):  # each keeps what it showed until it is entered
            self._window.go(each.slug)
            self._rest()
            self._window.reset_workspace()
            self._rest()
            if each.slug in PAGED and (panels := self._window.panels(each.slug)):
                for button in reversed(panels[0].buttons.buttons()):  # as does each page
                    button.click()
                    self._rest()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        held = holdings()
        self.megabytes.append(held.resident)
        print(f"# {self._done} events, {held.resident:.1f} MB; {held}; {weights}", file=self._log, flush=True)

    def _rest(self) -> None:
        """Wait until all that is seen is of the size that it has now, also on a busy machine."""
        for _look in range(_LONGEST_REST):
            QTest.qWait(_REST_MS)
            if has_settled(self._window):
                return

    def _finish(self) -> None:
        before, after = settled(self.megabytes)
        if after - before > MOST_GROWTH_MB:
            self.faults.said.append(f"memory grew from {before:.1f} to {after:.1f} MB")
        QTimer.singleShot(_REST_MS, lambda: QApplication.exit(0))  # to quit would ask the window


def settled(megabytes: Sequence[float]) -> tuple[float, float]:
    """The medians of the settled and of the last marks; none of a run that ended before them."""
    if len(megabytes) < LAST[1]:
        return 0.0, 0.0
    before, after = (median(megabytes[first - 1 : last]) for first, last in (SETTLED, LAST))
    return before, after


def files_at_hand(folder: Path) -> None:
    """Every file dialog is answered at once, by a name in ``folder`` or not at all."""
    (folder / "points.csv").write_text("1,2\n3,9\n12,4\n")
    (folder / "broken.gwb").write_text("{")
    (folder / "wedge.obj").write_text(
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
    )
    (folder / "broken.obj").write_text("v 0 0\nf 1 2 9\n")
    numbers = Random(0)
    files.ask_for_file = lambda *_arguments: numbers.choice([*sorted(folder.iterdir()), None])
    QFileDialog.getSaveFileName = staticmethod(  # type: ignore[method-assign,assignment]
        lambda *arguments, **_named: (numbers.choice([str(folder / Path(arguments[2]).name), ""]), "")
    )


def load_all_kernels() -> None:
    """Compile in a child what is not yet, and load it here: each takes a megabyte the first time it is used,
    which would look like a leak that goes on for hours."""
    from workbench.algorithms import catalogue
    from workbench.engine.warm import Warming, compile_use, work

    entries = {entry.slug: entry for entry in catalogue.entries()}
    child = Warming(list(entries))
    child.follow(lambda _progress: None)
    child.stop()
    for slug, use in work(list(entries)):
        compile_use(entries[slug], use)


def run(seed: int, numbers: list[int], without: set[str], within: str, log: TextIO) -> list[str]:
    """Do these events; the faults they brought up."""
    from workbench.shell.start import Building, make_window

    application = QApplication(["Graphics Workbench"])
    window = make_window()
    window.resize(*SIZE)
    building = Building(window, warms=False)
    monkey = Monkey(window, seed, numbers, without, within, log)
    building.built.connect(monkey.start)
    window.first_frame.connect(building.start)
    window.show()
    if len(numbers) >= MARK:
        load_all_kernels()
    application.exec()
    building.end()
    monkey._keeper.deleteLater()
    window.session.undo_stack.setClean()
    window.removeEventFilter(monkey._keeper)
    window.close()
    application.clipboard().clear()  # offscreen it outlives the interpreter
    for megabytes in monkey.megabytes:
        print(f"{megabytes:.1f} MB", flush=True)
    return monkey.faults.said


def main() -> int:
    """The exit status: 0 when nothing went wrong."""
    if _APART not in os.environ:  # the allocator reads it as the process begins
        os.execve(sys.executable, [*sys.orig_argv], {**os.environ, _APART: str(128 * 1024)})
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--events", type=int, default=MARK * LAST[1])
    parser.add_argument("--only", default="", help="numbers of events, or @ and a file of them")
    parser.add_argument("--without", default="", help="kinds of events to leave out")
    parser.add_argument("--within", default="", help="the workspace that most events keep to")
    parser.add_argument("--log", type=Path)
    parser.add_argument("--shorten", type=Path, metavar="LOG")
    given = parser.parse_args()
    if given.shorten is not None:
        from tests.soak.shorten import shorten

        print(*shorten(given.seed, given.shorten, given.without, given.within), sep=",")
        return 0
    text = Path(given.only[1:]).read_text() if given.only.startswith("@") else given.only
    numbers = [int(each) for each in text.split(",") if each.strip()] or list(range(given.events))
    with tempfile.TemporaryDirectory() as folder:
        os.environ["GRAPHICS_WORKBENCH_PROFILE"] = str(Path(folder, "profile"))
        work = Path(folder, "work")
        work.mkdir()
        os.environ["HOME"] = str(work)  # where dialogs begin
        files_at_hand(work)
        log = given.log or Path(folder, "log")
        faulthandler.enable()
        with log.open("w") as into:
            faults = run(given.seed, numbers, {*given.without.split(",")}, given.within, into)
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
