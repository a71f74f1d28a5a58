"""Edits under one token, as those of a drag, are one step of undo."""

from PySide6.QtCore import QObject

from workbench.document.model import Document
from workbench.session.undo import Step, UndoStack


class Merging(QObject):
    """Puts edits onto ``stack``. Undo, redo, and an edit under another token or none, end what was merged."""

    def __init__(self, stack: UndoStack) -> None:
        super().__init__(stack)
        self._stack = stack
        self._last: tuple[str, Step] | None = None
        self._pushing = False
        stack.indexChanged.connect(self._moved)

    def push(self, name: str, old: Document, new: Document, merge: str = "") -> None:
        """Show ``new`` as a step of its own, or as what the step under the same token now leads to."""
        if self._last and self._last[0] != merge:
            self.end()
        self._pushing = True
        try:
            step = self._stack.extend(self._last[1], new) if self._last else self._stack.push(name, old, new)
        finally:
            self._pushing = False
        self._last = (merge, step) if merge else None

    def end(self, merge: str = "") -> None:
        """The next edit is a step of its own; where those under the token lead nowhere, no step is left.

        With ``merge`` only edits under this token are ended.
        """
        if self._last is None or (merge and self._last[0] != merge):
            return
        step = self._last[1]
        self._last = None
        self._stack.end(step)

    def _moved(self) -> None:
        if not self._pushing:
            self._last = None
