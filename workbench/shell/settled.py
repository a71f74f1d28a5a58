"""When what a window shows has come to rest, as for a picture of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer

if TYPE_CHECKING:
    from collections.abc import Callable

    from workbench.shell.window import MainWindow

_LOOK_MS = 50


def has_settled(window: MainWindow) -> bool:
    """Whether the run is recorded, nothing of a large sheet is still worked on, every plot is made, and every
    tube that is seen shows its picture.
    """
    from workbench.widgets.plots.library import library
    from workbench.widgets.tube.live_tube import LiveTube

    session = window.session
    if library.busy or (session is not None and (session.ahead.busy or not session.run.done)):
        return False
    return all(tube.is_current for tube in window.findChildren(LiveTube) if tube.sight.now)


def when_settled(window: MainWindow, act: Callable[[], object], before: bool = False) -> None:
    """Do something as soon as the window has settled, and had so ``before``: what came last is then shown."""
    now = has_settled(window)
    if now and before:
        act()
    else:
        QTimer.singleShot(_LOOK_MS, window, lambda: when_settled(window, act, now))
