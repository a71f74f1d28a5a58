"""Which turns of the event loop hold the interface, and what ran in them.

Run it by hand: ``python tests/bench/interface_thread.py [MILLISECONDS] [--warm] [--size WxH] [--window]``.
The real window is driven through every workspace and example, both themes and the pages, in a fresh profile;
every turn in which its thread worked longer than MILLISECONDS (50) is printed with where its time went. What
counts is the thread's own processor time, so that a busy machine does not speak; the time on the clock stands
beside it. ``--warm`` has the algorithms compiled before, as on the second day of use.
"""

import os
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT))

LOOKED_S = 0.002
SETTLE_MS = 450


class Turns:
    """Watches the event loop of the main thread."""

    def __init__(self, dispatcher: Any, least_s: float) -> None:
        self.doing = "start"
        self.slow: list[tuple[float, float, str, Counter[str]]] = []
        self.longest: dict[str, float] = {}
        self._least_s = least_s
        self._began = time.thread_time(), time.perf_counter()
        self._looked = self._began[0]
        self._spent: Counter[str] = Counter()
        dispatcher.awake.connect(self._turn)
        dispatcher.aboutToBlock.connect(self._turn)
        signal.signal(signal.SIGALRM, self._look)
        signal.setitimer(signal.ITIMER_REAL, LOOKED_S, LOOKED_S)

    def _turn(self) -> None:
        """The turn before ends here, and another one begins."""
        now = time.thread_time(), time.perf_counter()
        worked, passed = now[0] - self._began[0], now[1] - self._began[1]
        self._began = now
        spent, self._spent = self._spent, Counter()
        self.longest[self.doing] = max(self.longest.get(self.doing, 0.0), worked)
        if worked >= self._least_s:
            self.slow.append((worked, passed, self.doing, spent))

    def _look(self, _number: int, frame: FrameType | None) -> None:
        """Put the time since the last look down to where the thread is now."""
        now = time.thread_time()
        self._spent[_place(frame)] += round((now - self._looked) * 1e6)
        self._looked = now

    def end(self) -> None:
        """Look no more."""
        signal.setitimer(signal.ITIMER_REAL, 0)


def _place(frame: FrameType | None) -> str:
    """The two innermost lines of the program itself, and what they called."""
    lines: list[str] = []
    inner = "" if frame is None else frame.f_code.co_qualname
    while frame is not None and len(lines) < 2:
        name = frame.f_code.co_filename
        if f"{os.sep}workbench{os.sep}" in name:
            lines.append(f"{Path(name).stem}.{frame.f_code.co_qualname}:{frame.f_lineno}")
        frame = frame.f_back
    return " < ".join(lines) + ("" if not lines or inner in lines[0] else f"  ({inner})") if lines else inner


def scenario(window: Any, examples: list[Any]) -> list[tuple[str, Callable[[], object]]]:
    """What a person does, one thing at a time."""

    def step(forward: bool) -> None:
        run = window.session.run
        (run.forward if forward else run.last)()

    def undo_theme() -> None:
        window.themes.choose("light")

    acts: list[tuple[str, Callable[[], object]]] = []
    for slug in window.workspace_slugs:
        acts.append((f"enter {slug} for the first time", lambda s=slug: window.go(s)))
    for slug in window.workspace_slugs:
        acts.append((f"enter {slug} again", lambda s=slug: window.go(s)))
    for example in examples:
        acts.append((f"example {example.slug}", lambda e=example: window.open_example(e.slug)))
        acts.append((f"example {example.slug}: a step", lambda: step(True)))
        acts.append((f"example {example.slug}: the last step", lambda: step(False)))
    acts.append(("draw for the tube", lambda: window.go("draw")))
    for slug in window.workspace_slugs:
        acts.append((f"enter {slug} for its docks", lambda s=slug: window.go(s)))
        for number in range(8):
            acts.append((f"{slug}, dock {number}", lambda s=slug, n=number: _raise(window, s, n)))
    acts.append(("dark theme", lambda: window.themes.choose("dark")))
    acts.append(("light theme", undo_theme))
    for page in ("home", "settings", "help", "keys", "about"):
        acts.append((f"page {page}", lambda p=page: window.go(p)))
    acts.append(("draw again", lambda: window.go("draw")))
    acts.append(("another size", lambda: window.resize(1000, 600)))
    acts.append(("palette", window.show_palette))
    return acts


def _raise(window: Any, slug: str, number: int) -> None:
    docks = window.arrangements.docks(slug)
    if number < len(docks):
        docks[number].show()
        docks[number].raise_()


def main() -> None:
    """Drive the window; print the slow turns, longest first, and the longest of each thing done."""
    words = sys.argv[1:]
    least_s = float(next((word for word in words if word.isdecimal()), 50)) / 1e3
    size = words[words.index("--size") + 1] if "--size" in words else "1280x680"
    if "--window" not in words:
        os.environ["QT_QPA_PLATFORM"] = "offscreen"
    profile = tempfile.TemporaryDirectory()
    os.environ["GRAPHICS_WORKBENCH_PROFILE"] = profile.name
    if "--warm" in words:
        os.environ.setdefault("GRAPHICS_WORKBENCH_CACHE", str(Path(tempfile.gettempdir()) / "bench-kernels"))

    from PySide6.QtCore import QAbstractEventDispatcher, QTimer
    from PySide6.QtWidgets import QApplication

    from workbench.shell.start import Building, make_window

    application = QApplication(["Graphics Workbench"])
    turns = Turns(QAbstractEventDispatcher.instance(), least_s)
    window = make_window()
    window.settings.set("hints", False)
    window.resize(*map(int, size.split("x")))
    building = Building(window, warms=False)
    acts: list[tuple[str, Callable[[], object]]] = []

    def begin() -> None:
        from workbench.document.samples.examples import examples

        if "--warm" in words:
            from workbench.algorithms import catalogue
            from workbench.engine.warm import Warming

            turns.doing = "compiling"
            Warming([entry.slug for entry in catalogue.entries()]).follow(lambda _progress: None)
        acts.extend(scenario(window, list(examples())))
        QTimer.singleShot(SETTLE_MS, act)

    def act() -> None:
        if not acts:
            application.quit()
            return
        turns.doing, do = acts.pop(0)
        QTimer.singleShot(0, lambda: (do(), QTimer.singleShot(SETTLE_MS, act)))

    building.built.connect(begin)
    window.first_frame.connect(building.start)
    window.show()
    application.exec()
    building.end()
    turns.end()
    window.session.undo_stack.setClean()
    window.close()
    for worked, passed, doing, spent in sorted(turns.slow, key=lambda turn: -turn[0]):
        if doing != "compiling":
            print(f"{worked * 1e3:6.0f} ms worked ({passed * 1e3:.0f} on the clock): {doing}")
            for place, microseconds in spent.most_common(5):
                print(f"        {microseconds / 1e3:6.1f} {place}")
    print(f"\n{len(turns.slow)} turns over {least_s * 1e3:.0f} ms; longest turn of each thing done, in ms:")
    print(", ".join(f"{doing} {seconds * 1e3:.0f}" for doing, seconds in turns.longest.items()))


if __name__ == "__main__":
    main()
