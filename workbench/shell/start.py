"""Starts the program: first a window with Home, then, once that is painted, everything else."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication

from workbench.language import _
from workbench.shell.importing import OF_QT, import_beside, import_each
from workbench.shell.settings import Settings
from workbench.shell.slices import Slices
from workbench.shell.theme import ThemeSwitch
from workbench.shell.window import PROGRAM, MainWindow

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from workbench.engine.background import Thread
    from workbench.shell.warming import Warming
    from workbench.shell.workspaces import Workspace

# NumPy reads this when it is loaded, later. The tubes multiply small matrices many times a second: waiting
# for a second thread costs three times what it saves, and keeps a core busy.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

FIRST = "draw"
QUIT_AFTER_FIRST_FRAME = "--quit-after-first-frame"


class Building(QObject):
    """Builds the rest of the window after the first frame, a slice in each turn of the event loop."""

    built = Signal()

    def __init__(self, window: MainWindow, path: Path | None = None, warms: bool = True) -> None:
        super().__init__(window)
        self._window = window
        self._path = path
        self._warms = warms
        self._slices = Slices(self)
        self._warming: Warming | None = None
        self._importing: Thread | None = None

    def start(self) -> None:
        """Complete the window, and begin importing."""
        from workbench.engine.large_arrays import give_back_large_arrays

        give_back_large_arrays()
        self._window.complete()
        self._importing = import_beside(self, lambda: self._slices.add(self._build()))

    def end(self) -> None:
        """Prepare nothing further."""
        if self._importing is not None:
            self._importing.end()
        if self._warming is not None:
            self._warming.stop()

    def _build(self) -> Iterator[None]:
        yield from import_each((*OF_QT, *self._window.workspace(FIRST).modules))
        from workbench.session.session import Session
        from workbench.shell.arriving import Arriving

        window = self._window
        session = Session(window)
        session.open_example("line")
        if window.settings.get("ask_first"):
            session.update_state(ask_first=True)
        yield
        window.arriving = Arriving(window, self._slices)
        window.attach(session)
        yield
        if self._path is not None:
            window.files.take(self._path)
            yield
        problems = [window.settings.problem]
        beginning = session.autosave_failed.connect(problems.append)
        session.start_autosave()
        session.autosave_failed.disconnect(beginning)
        session.autosave_failed.connect(window.files.warn)
        session.autosave_mended.connect(window.files.reassure)
        if any(problems):
            window.files.warn(" ".join(filter(None, problems)))
        QTimer.singleShot(0, window.files.offer_recovery)  # whatever fails there, this goes on
        window.status.preparing("")
        if self._warms:
            from workbench.shell.warming import Warming

            self._warming = Warming(window)
            self._warming.prepare(FIRST)
            window.entered.connect(self._warming.prepare)
        window.entered.connect(window.show_hints)
        if window.place == FIRST:
            window.show_hints()
        yield from window.prepare(FIRST)
        yield from window.build()
        self.built.emit()


def make_window(settings: Settings | None = None, offered: Sequence[Workspace] | None = None) -> MainWindow:
    """The window in its theme, over the running QApplication."""
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    application.setApplicationName(PROGRAM)
    application.setDesktopFileName("graphics-workbench")
    kept = settings or Settings()
    themes = application.findChild(ThemeSwitch)
    if themes is None:
        themes = ThemeSwitch(application, kept.get("theme"), kept.get("large_text"))
    else:
        themes.choose(kept.get("theme"), kept.get("large_text"))
    from workbench.widgets.look.comfort import comfort

    comfort.set_calm(kept.get("calm"))
    return MainWindow(kept, themes, offered)


def has_display(environment: Mapping[str, str], system: str) -> bool:
    """Whether Qt will have something to draw on; without it, it ends the process."""
    names = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    return system != "linux" or any(environment.get(name) for name in names)


def start(argv: Sequence[str]) -> int:
    """Open the window, with the file named on the command line if there is one; the exit status."""
    words = [word for word in argv if word != QUIT_AFTER_FIRST_FRAME]
    if len(words) > 1 or (words and words[0].startswith("-")):
        sys.stderr.write(_("Give one picture to open, or none: {words}").format(words=" ".join(words)) + "\n")
        return 2
    path = Path(words[0]).absolute() if words else None
    if path is not None:
        from workbench.document.errors import DocumentError
        from workbench.document.storage.content import check_file

        try:
            check_file(words[0], sys.maxsize)
        except DocumentError as problem:
            sys.stderr.write(f"{problem.short}\n")
            return 2
    if not has_display(os.environ, sys.platform):
        sentence = _("There is no display to open a window on; log in to a desktop, or set DISPLAY.")
        sys.stderr.write(sentence + "\n")
        return 1
    application = QApplication([PROGRAM])
    window = make_window()
    if QUIT_AFTER_FIRST_FRAME in argv:
        window.first_frame.connect(application.quit)
        window.show()
        return application.exec()
    from workbench.shell.failures import Failures
    from workbench.shell.interrupts import STATUS, Interrupts

    Failures(window).install()
    building = Building(window, path)
    window.first_frame.connect(building.start)
    interrupts = Interrupts(application)
    interrupts.interrupted.connect(lambda: application.exit(STATUS))
    window.show()
    status = application.exec()
    interrupts.end()
    if status == STATUS and window.session is not None:
        window.session.abandon()
    building.end()
    if application.platformName() == "offscreen":  # its clipboard is the process's own
        application.clipboard().clear()  # and outlives the interpreter, which what Python made there does not
    return status
