"""When what a window shows has come to rest, as for a picture of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

if TYPE_CHECKING:
    from collections.abc import Callable

    from workbench.shell.window import MainWindow

_LOOK_MS = 50


def has_settled(window: MainWindow) -> bool:
    """Whether nothing of a large sheet is still worked on, every plot is made, and every tube that is seen
    shows its picture.
    """
    from workbench.widgets.plots.library import library
    from workbench.widgets.tube.live_tube import LiveTube

    if library.busy or (window.session is not None and window.session.ahead.busy):
        return False
    return all(tube.has_picture for tube in window.findChildren(LiveTube) if tube.sight.now)


def when_settled(window: MainWindow, act: Callable[[], object]) -> None:
    """Do something as soon as the window has settled."""
    if has_settled(window):
        act()
    else:
        QTimer.singleShot(_LOOK_MS, window, lambda: when_settled(window, act))
