"""The steps of undo, as documents before and after; the oldest are dropped where they hold too much memory.

Qt's own stack can be bounded in steps only, and only while it is empty. This one has its signals and names.
"""

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from workbench.document.model import Document
from workbench.document.weight import weight

LIMIT_BYTES = 200 * 2**20


@dataclass(slots=True, eq=False, weakref_slot=True)
class Step:
    """One step: the documents before and after it, and what the one before alone holds, in bytes."""

    name: str
    old: Document
    new: Document
    held: int = 0


class UndoStack(QObject):
    """Steps that can be undone, and those undone that can be done again.

    ``show(document)`` is called with what is to be open now; ``undone(Step)`` and ``redone(Step)`` tell where
    that was one step further back or on. The steps that can be undone keep at most ``limit_bytes`` beyond
    the document itself; the last one always stays.
    """

    indexChanged = Signal(int)  # noqa: N815 - the names of QUndoStack
    cleanChanged = Signal(bool)  # noqa: N815
    undone = Signal(object)
    redone = Signal(object)

    def __init__(
        self, show: Callable[[Document], None], parent: QObject | None = None, limit_bytes: int = LIMIT_BYTES
    ) -> None:
        super().__init__(parent)
        self._show = show
        self._limit_bytes = limit_bytes
        self._steps: list[Step] = []
        self._index = 0
        self._clean: int | None = 0

    def count(self) -> int:
        """How many steps there are, undone ones among them."""
        return len(self._steps)

    def index(self) -> int:
        """How many of them can be undone."""
        return self._index

    @property
    def held(self) -> int:
        """What the steps that can be undone hold beyond the document, in bytes."""
        return sum(step.held for step in self._steps[: self._index])

    def canUndo(self) -> bool:
        """Whether there is a step to undo."""
        return self._index > 0

    def canRedo(self) -> bool:
        """Whether there is an undone step to do again."""
        return self._index < len(self._steps)

    @property
    def last(self) -> Step | None:
        """The step that ``undo`` takes back, if there is one."""
        return self._steps[self._index - 1] if self.canUndo() else None

    def undoText(self) -> str:
        """The name of the step that ``undo`` takes back, or nothing."""
        return "" if self.last is None else self.last.name

    def redoText(self) -> str:
        """The name of the step that ``redo`` does again, or nothing."""
        return self._steps[self._index].name if self.canRedo() else ""

    def isClean(self) -> bool:
        """Whether the document is the one that was opened or saved last."""
        return self._index == self._clean

    def push(self, name: str, old: Document, new: Document) -> Step:
        """Show ``new`` as a step of its own; those that were undone are gone."""
        step = Step(name, old, new)
        self._show(new)
        was_clean = self.isClean()
        del self._steps[self._index :]
        if self._clean is not None and self._clean > self._index:
            self._clean = None
        self._steps.append(step)
        self._index += 1
        self._weigh(step)
        self._tell(was_clean)
        return step

    def extend(self, step: Step, new: Document) -> Step:
        """Let ``step``, the last one, lead to ``new``; where it leads to what was saved, one more does."""
        if self.isClean():
            self.end(step)
            return self.push(step.name, step.new, new)
        step.new = new
        self._show(new)
        return step

    def end(self, step: Step) -> None:
        """``step``, the last one, will not be extended any more; where it leads nowhere it goes."""
        if step.old == step.new:
            was_clean = self.isClean()
            self._show(step.old)
            self._steps.remove(step)
            if was_clean:
                self._clean = self._index - 1
            self._index -= 1
            self._tell(was_clean)
        else:
            self._weigh(step)

    def undo(self) -> None:
        """Take the last step back, if there is one."""
        step = self.last
        if step is not None:
            self._go(self._index - 1, step.old)
            self.undone.emit(step)

    def redo(self) -> None:
        """Do the step again that was taken back last, if there is one."""
        if self.canRedo():
            step = self._steps[self._index]
            self._go(self._index + 1, step.new)
            self.redone.emit(step)

    def clear(self) -> None:
        """Forget every step; the document is clean."""
        if self._steps:
            was_clean = self.isClean()
            self._steps.clear()
            self._index = self._clean = 0
            self._tell(was_clean)
        self.setClean()

    def setClean(self) -> None:
        """The document is saved as it is now."""
        self._mark(self._index)

    def resetClean(self) -> None:
        """No step leads to what was saved."""
        self._mark(None)

    def _mark(self, clean: int | None) -> None:
        was_clean = self.isClean()
        self._clean = clean
        if self.isClean() != was_clean:
            self.cleanChanged.emit(self.isClean())

    def _go(self, index: int, document: Document) -> None:
        was_clean = self.isClean()
        self._show(document)
        self._index = index
        self._tell(was_clean)

    def _weigh(self, step: Step) -> None:
        """Weigh a step anew, and drop the oldest ones when all together hold too much."""
        step.held = weight(step.old, step.new)
        held, gone = self.held, 0
        while held > self._limit_bytes and gone < self._index - 1:
            held -= self._steps[gone].held
            gone += 1
        del self._steps[:gone]
        self._index -= gone
        if self._clean is not None:
            self._clean = self._clean - gone if self._clean >= gone else None

    def _tell(self, was_clean: bool) -> None:
        self.indexChanged.emit(self._index)
        if self.isClean() != was_clean:
            self.cleanChanged.emit(self.isClean())
