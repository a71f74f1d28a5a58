"""When the program itself fails, the window says so, the picture is kept, and the details can be copied."""

import sys
import threading
import traceback
from types import TracebackType
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal

from workbench.language import _

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


class Failures(QObject):
    """Takes exceptions that nobody caught, from any thread, to message bar and standard error."""

    _failed = Signal(str, str)

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._failed.connect(self._say, Qt.ConnectionType.QueuedConnection)

    def install(self) -> None:
        """Catch from now on."""
        sys.excepthook = self.report
        threading.excepthook = lambda args: self.report(
            args.exc_type, args.exc_value or args.exc_type(), args.exc_traceback
        )

    def report(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        """One exception."""
        if issubclass(kind, KeyboardInterrupt):
            sys.__excepthook__(kind, error, trace)
            return
        details = "".join(traceback.format_exception(kind, error, trace))
        sys.stderr.write(details)
        self._failed.emit(f"{kind.__name__}: {error}", details)

    def _say(self, what: str, details: str) -> None:
        from workbench.shell.about import diagnosis

        self._window.messages.say(
            _("Something in the program failed ({what}). The picture is kept; save it to be safe.").format(
                what=what
            ),
            "error",
            f"{details}\n{diagnosis(self._window)}",
        )
