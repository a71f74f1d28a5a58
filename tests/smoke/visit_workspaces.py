"""Opens the window, goes to every place in it, prints each with the number of colours seen, and closes it.

Run as a program of its own, on a real screen.
"""

import sys
from typing import Any

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from workbench.shell.start import Building, make_window
from workbench.shell.workspaces import workspaces

SETTLE_MS = 400
LIMIT_MS = 60_000


def main() -> int:
    """The exit status of the program; 1 when a place did not come in time."""
    application = QApplication(["Graphics Workbench"])
    window = make_window()
    building = Building(window)
    places = ["home", *(workspace.slug for workspace in workspaces())]

    def seen() -> int:
        picture = window.screen().grabWindow(window.winId()).toImage().scaled(320, 200)
        return len({picture.pixel(x, y) for x in range(320) for y in range(200)})

    def leave(place: str) -> None:
        print(place, window.place, window.windowHandle().isExposed(), seen(), flush=True)
        visit()

    def visit() -> None:
        if not places:
            window.close()
            return
        place = places.pop(0)
        window.go(place)
        arrive(place)

    def arrive(place: str) -> None:
        there = window.place == place
        QTimer.singleShot(SETTLE_MS, lambda: leave(place) if there else arrive(place))

    def fail(*error: Any) -> None:
        sys.__excepthook__(*error)
        application.exit(1)

    def give_up() -> None:
        print("not done in time", file=sys.stderr)
        application.exit(1)

    sys.excepthook = fail
    building.built.connect(visit)
    window.first_frame.connect(building.start)
    QTimer.singleShot(LIMIT_MS, give_up)
    window.show()
    status = application.exec()
    building.end()
    return status


if __name__ == "__main__":
    sys.exit(main())
