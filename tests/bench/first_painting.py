"""How long the interface is held while a sheet of 10,000 curves comes into view, and by an edit after it.

Run it by hand: ``python tests/bench/first_painting.py [CURVES]``. Times are milliseconds of this thread's own
processor time; at most 100 for each turn of the event loop are wanted.
"""

import os
import sys
import tempfile
import time
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ["GRAPHICS_WORKBENCH_PROFILE"] = tempfile.mkdtemp()
sys.path.insert(0, str(Path(__file__).parents[2]))

from PySide6.QtWidgets import QApplication, QMainWindow

from tests.bench.large_document import CURVES, large
from workbench.document import edits
from workbench.document.model import Document
from workbench.engine.warm import load
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.session import Session

LIMIT_S = 120.0
REST_TURNS = 50


def measure(kind: type[DrawPanel | ClipPanel | CurvesPanel], document: Document) -> None:
    """Open the document under a panel, and print the turns."""
    session = Session()
    panel = kind(session)
    window = QMainWindow()
    window.setCentralWidget(panel.center)
    window.resize(1280, 680)
    window.show()
    QApplication.processEvents()
    shown = getattr(Session, "shown", Session.sheet).fget
    turns: list[float] = []
    begin, end = time.thread_time(), time.perf_counter() + LIMIT_S
    session.new(document)
    rest = REST_TURNS
    while rest and time.perf_counter() < end:
        start = time.thread_time()
        QApplication.processEvents()
        turns.append(time.thread_time() - start)
        rest = rest - 1 if shown(session) is session.sheet else REST_TURNS
    total = time.thread_time() - begin
    middle = document.sheets[0].figures[len(document.sheets[0].figures) // 2]
    after: list[float] = []
    for _turn in range(5):
        session.apply(edits.move_figures([middle.id], 1.0, 0.0), "Move")
        start = time.thread_time()
        QApplication.processEvents()
        after.append(time.thread_time() - start)
    told = f"{kind.__name__:12} longest turn {max(turns) * 1e3:6.0f}, all {total * 1e3:6.0f}; "
    print(told + f"longest turn after an edit {max(after[1:]) * 1e3:4.0f}", flush=True)
    session.undo_stack.setClean()
    window.close()


def main() -> None:
    """Each panel in turn; what the one before has remembered helps the next."""
    application = QApplication([])
    load("bresenham_line", lambda: False)
    for kind in (DrawPanel, ClipPanel, CurvesPanel):
        measure(kind, large(int(sys.argv[1]) if len(sys.argv) > 1 else CURVES))
    application.processEvents()


if __name__ == "__main__":
    main()
