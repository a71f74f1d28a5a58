"""Opens the window on Draw, prints the tool each time another is taken up, and closes at the polyline tool.

Run as a program of its own, on a real screen; whoever runs it presses keys and the mouse.
"""

import sys
from typing import Any

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from workbench.shell.start import Building, make_window

LIMIT_MS = 60_000
POLL_MS = 20


def main() -> int:
    """The exit status of the program; 1 when it was not done in time."""
    application = QApplication(["Graphics Workbench"])
    window = make_window()
    building = Building(window)
    seen = ""

    def watch() -> None:
        nonlocal seen
        panel: Any = window.panels("draw")[0]
        if panel.tool.name != seen:
            seen = panel.tool.name
            print(seen, flush=True)
        if seen == "polyline":
            window.session.undo_stack.setClean()
            window.close()

    def begin() -> None:
        window.go("draw")
        window.activateWindow()
        poll.start(POLL_MS)

    def give_up() -> None:
        print("not done in time", file=sys.stderr)
        application.exit(1)

    poll = QTimer()
    poll.timeout.connect(watch)
    building.built.connect(begin)
    window.first_frame.connect(building.start)
    QTimer.singleShot(LIMIT_MS, give_up)
    window.show()
    status = application.exec()
    building.end()
    return status


if __name__ == "__main__":
    sys.exit(main())
