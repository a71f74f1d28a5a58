"""How long from the start of the process to the first painted frame, against a bare PySide6 main window.

Run it by hand: ``python tests/bench/first_frame.py [RUNS] [--window]``, the latter on a real screen. The two
kinds of run take turns; their medians are compared.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BARE = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QMainWindow


class Window(QMainWindow):
    def paintEvent(self, event):
        super().paintEvent(event)
        QTimer.singleShot(0, QApplication.quit)


application = QApplication([])
window = Window()
window.resize(1280, 680)
window.show()
sys.exit(application.exec())
"""
OURS = ["-m", "workbench", "--quit-after-first-frame"]


def seconds(arguments: list[str], environment: dict[str, str]) -> float:
    """From starting the process until it has left again, which it does as soon as the frame is painted."""
    begin = time.perf_counter()
    subprocess.run(
        [sys.executable, *arguments],
        check=True,
        env=environment,
        cwd=Path(__file__).parents[2],
        capture_output=True,
    )
    return time.perf_counter() - begin


def main() -> None:
    """Print both medians and their ratio."""
    runs = int(next((word for word in sys.argv[1:] if word.isdecimal()), 10))
    with tempfile.TemporaryDirectory() as profile:
        environment = {**os.environ, "GRAPHICS_WORKBENCH_PROFILE": profile, "QT_QPA_PLATFORM": "offscreen"}
        if "--window" in sys.argv:
            del environment["QT_QPA_PLATFORM"]
        bare, ours = [], []
        for run in range(runs + 1):
            pair = seconds(["-c", BARE], environment), seconds(OURS, environment)
            if run:  # the first pair only warms the disk
                bare.append(pair[0])
                ours.append(pair[1])
    medians = statistics.median(bare), statistics.median(ours)
    print(f"bare window {medians[0] * 1000:.0f} ms, workbench {medians[1] * 1000:.0f} ms")
    print(f"ratio {medians[1] / medians[0]:.2f} (median of {runs} each; at most 1.5 is wanted)")


if __name__ == "__main__":
    main()
