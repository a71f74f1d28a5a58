"""What is said of a step of undo is true no longer once that is undone."""

from collections.abc import Callable
from weakref import ref

from PySide6.QtCore import QObject

from workbench.session.undo import Step, UndoStack
from workbench.shell.message_bar import MessageBar


class StepMessages(QObject):
    """Says in ``messages`` what became of the last step of ``stack``, and takes it away with the step."""

    def __init__(self, messages: MessageBar, stack: UndoStack) -> None:
        super().__init__(stack)
        self._messages, self._stack = messages, stack
        self._said: tuple[Callable[[], Step | None], str] = (_nothing, "")
        stack.undone.connect(self._withdraw)

    def say(self, text: str, kind: str = "info") -> None:
        """Say one sentence about the step that was done last."""
        last = self._stack.last
        self._said = (_nothing if last is None else ref(last), text)  # its documents are large
        self._messages.say(text, kind)

    def _withdraw(self, undone: Step) -> None:
        step, text = self._said
        if step() is undone:
            self._messages.withdraw(text)
            self._said = (_nothing, "")


def _nothing() -> None:
    """The step where nothing has been said of one."""
