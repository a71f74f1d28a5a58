"""Ctrl+C in the terminal that the window was started from."""

import signal
import socket

from PySide6.QtCore import QObject, QSocketNotifier, Signal

STATUS = 130
"""Exit status of a process that was interrupted, as shells have it."""


class Interrupts(QObject):
    """Ctrl+C as a signal of the event loop, which Python's own handler would not wake."""

    interrupted = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._woken, self._waking = socket.socketpair()
        for end in (self._woken, self._waking):
            end.setblocking(False)
        self._notifier = QSocketNotifier(self._woken.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._look)
        if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as in the background
            signal.signal(signal.SIGINT, lambda _number, _frame: None)
            signal.set_wakeup_fd(self._waking.fileno(), warn_on_full_buffer=False)

    def _look(self) -> None:
        self._woken.recv(64)
        self.interrupted.emit()

    def end(self) -> None:
        """Leave the rest to Python."""
        signal.set_wakeup_fd(-1)
        self._notifier.setEnabled(False)
        self._woken.close()
        self._waking.close()
