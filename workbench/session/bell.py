"""A bell that any thread may ring, and the interface hears at once, also while it sleeps.

Threads know only a socket: one that emitted a signal of an object which is being destroyed would end the
process.
"""

import socket
import weakref
from contextlib import suppress
from functools import partial

from PySide6.QtCore import QCoreApplication, QObject, QSocketNotifier, Qt, Signal


class Bell(QObject):
    """``rung`` is sent on the thread this lives on, once or more often after ``ring`` was last called.

    ``ring`` is for any thread, and holds nothing of Qt; a byte written to ``rope`` rings as well.
    """

    rung = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._heard, self.rope = socket.socketpair()
        for end in (self._heard, self.rope):
            end.setblocking(False)
        self.ring = partial(_ring, self.rope)
        self._notifier = QSocketNotifier(self._heard.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._hear)
        for end in (self._heard, self.rope):
            weakref.finalize(self, end.close)  # at the latest when Python ends

    def _hear(self) -> None:
        with suppress(OSError):
            self._heard.recv(4096)
        self.rung.emit()


def _ring(rope: socket.socket) -> None:
    with suppress(OSError):  # full: it rings already; closed: the program has ended
        rope.send(b"\0")


def bell() -> Bell:
    """The one of the running application."""
    application = QCoreApplication.instance()
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    one = None if application is None else application.findChild(Bell, options=direct)
    return Bell(application) if one is None else one
