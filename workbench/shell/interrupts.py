"""Ctrl+C in the terminal that the window was started from."""

import signal

from PySide6.QtCore import QObject, Signal

from workbench.session.bell import Bell

STATUS = 130
"""Exit status of a process that was interrupted, as shells have it."""


class Interrupts(QObject):
    """Ctrl+C as a signal of the event loop, which Python's own handler would not wake."""

    interrupted = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._bell = Bell(self)
        self._bell.rung.connect(self.interrupted)
        if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as in the background
            signal.signal(signal.SIGINT, lambda _number, _frame: None)
            signal.set_wakeup_fd(self._bell.rope.fileno(), warn_on_full_buffer=False)

    def end(self) -> None:
        """Leave the rest to Python."""
        signal.set_wakeup_fd(-1)
        self._bell.rung.disconnect(self.interrupted)
