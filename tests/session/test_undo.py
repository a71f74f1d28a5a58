"""Undo: as Qt's own stack does it, but bounded by what it holds in memory."""

import gc
import sys
import tracemalloc
from types import FrameType
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtGui import QUndoCommand, QUndoStack

from workbench.document import DocumentError, edits
from workbench.document.model import Document, Polyline, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.document.weight import weight
from workbench.session import Session
from workbench.session.undo import Step, UndoStack

pytestmark = pytest.mark.usefixtures("qapp")  # a session rings for it


def named(name: str) -> Document:
    return edits.rename_sheet("s1", name)(blank_sheet())


def full_of(figures: int, points: int = 5) -> Document:
    (sheet,) = blank_sheet().sheets
    many = tuple(
        Polyline(f"f{n}", tuple(WorldPoint(f"p{n}-{k}", 0.1 + k, 0.3 * n) for k in range(points)), "dda_line")
        for n in range(figures)
    )
    return Document((replace(sheet, figures=many),))


class Told:
    """What a stack told, in order."""

    def __init__(self, stack: UndoStack | QUndoStack) -> None:
        self.all: list[Any] = []
        stack.indexChanged.connect(lambda index: self.all.append(index))
        stack.cleanChanged.connect(lambda clean: self.all.append(clean))


class Merged(QUndoCommand):
    """A command of Qt that takes up those of the same drag."""

    def __init__(self, drag: int) -> None:
        super().__init__("drag")
        self._drag = drag

    def id(self) -> int:
        return self._drag

    def mergeWith(self, _other: QUndoCommand) -> bool:
        return True


def drop_last(stack: QUndoStack, told: Told) -> None:
    """Take away a last step that leads nowhere. Qt cannot know that a document saved there is still that."""
    clean = stack.isClean()
    stack.blockSignals(clean)
    stack.command(stack.index() - 1).setObsolete(True)
    stack.undo()
    stack.blockSignals(False)
    if clean:
        stack.setClean()
        told.all[-1:] = [stack.index()]


def without_repeats(told: list[Any]) -> list[Any]:
    """Qt tells the index at every merge, even where it stays."""
    last: dict[type, Any] = {}
    kept = []
    for each in told:
        if last.get(type(each)) != each:
            kept.append(each)
        last[type(each)] = each
    return kept


words = st.sampled_from(
    ["push", "push", "drag", "drag", "back", "end", "undo", "undo", "redo", "setClean", "resetClean", "clear"]
)


@given(st.lists(words, max_size=25))
@example(["drag", "back", "setClean", "drag"])
@example(["push", "drag", "back", "setClean", "end", "push"])
def test_it_does_what_the_stack_of_qt_does(words: list[str]) -> None:
    documents = [named("0")]
    saved = [documents[0]]
    ours, theirs = UndoStack(documents.append), QUndoStack()
    told = Told(ours), Told(theirs)
    dragged: Step | None = None
    drag = 0
    for number, word in enumerate(words, 1):
        if word == "drag" or (word == "back" and dragged):
            new = named(str(number)) if word == "drag" or dragged is None else dragged.old
            if dragged is None:
                dragged, drag = ours.push("drag", documents[-1], new), number
            elif new != documents[-1]:
                if dragged.old == dragged.new and ours.isClean():
                    drop_last(theirs, told[1])
                dragged = ours.extend(dragged, new)
            else:
                continue
            theirs.push(Merged(drag))
        elif word in ("setClean", "resetClean"):
            getattr(ours, word)()
            getattr(theirs, word)()
        elif word != "back":
            if dragged is not None:
                if dragged.old == dragged.new:
                    drop_last(theirs, told[1])
                ours.end(dragged)
                dragged = None
            if word == "push":
                ours.push(str(number), documents[-1], named(str(number)))
                theirs.push(QUndoCommand(str(number)))
            elif word != "end":
                getattr(ours, word)()
                # Qt's stack, once it is empty, does not become clean by being cleared.
                getattr(theirs, "setClean" if word == "clear" and not theirs.count() else word)()
        if word in ("setClean", "clear"):
            saved = [documents[-1]]
        elif word == "resetClean":
            saved = []
        for ask in ("count", "index", "isClean", "canUndo", "canRedo", "undoText", "redoText"):
            assert getattr(ours, ask)() == getattr(theirs, ask)(), ask
        assert not ours.isClean() or saved == [documents[-1]]
        if word in ("push", "undo", "redo") and ours.undoText() != "drag":
            names = [documents[-1].sheets[0].name]
            assert names == [ours.undoText() or names[0]]
    assert without_repeats(told[0].all) == without_repeats(told[1].all)


def test_the_oldest_steps_go_where_all_together_hold_too_much() -> None:
    documents = [full_of(500)]
    step = weight(documents[0], edits.move_figures(["f7"], 1, 0)(documents[0]))
    stack = UndoStack(documents.append, limit_bytes=10 * step + step // 2)
    for _turn in range(25):
        old = documents[-1]
        stack.push("Move", old, edits.move_figures(["f7"], 1, 0)(old))
    assert stack.count() == stack.index() == 10
    assert stack.held <= 10 * step + step // 2
    assert not stack.isClean()
    pushed = documents[:]
    while stack.canUndo():
        stack.undo()
    assert documents[-1] == pushed[15]
    assert not stack.isClean()  # what was saved is among the steps that are gone
    stack.setClean()
    stack.redo()
    stack.push("Move", documents[-1], edits.move_figures(["f7"], 1, 0)(documents[-1]))
    stack.undo()
    stack.undo()
    assert stack.isClean()


def test_what_is_clean_stays_clean_when_older_steps_go() -> None:
    documents = [full_of(50)]
    step = weight(documents[0], edits.move_figures(["f7"], 1, 0)(documents[0]))
    stack = UndoStack(documents.append, limit_bytes=5 * step)
    for turn in range(8):
        stack.push("Move", documents[-1], edits.move_figures(["f7"], 1, 0)(documents[-1]))
        if turn == 5:
            stack.setClean()
            saved = documents[-1]
    assert not stack.isClean()
    stack.undo()
    stack.undo()
    assert stack.isClean()
    assert documents[-1] == saved


def test_the_last_step_always_stays() -> None:
    documents = [full_of(50)]
    stack = UndoStack(documents.append, limit_bytes=10)
    for figure in ("f3", "f4"):
        stack.push("Remove", documents[-1], edits.remove_figures([figure])(documents[-1]))
        assert stack.count() == 1
    stack.undo()
    assert [f.id for f in documents[-1].sheets[0].figures if f.id in ("f3", "f4")] == ["f4"]


@pytest.mark.parametrize(
    "edit",
    [
        edits.move_figures(["f7"], 1, 0),
        edits.remove_figures([f"f{n}" for n in range(0, 900, 3)]),
        edits.move_figures([f"f{n}" for n in range(1000)], 1, 0),
        edits.move_points({"s1/f7/p7-3/x": (1.0, 2.0)}),
    ],
)
def test_a_step_weighs_what_only_the_older_document_holds(edit: edits.Edit) -> None:
    def changed() -> tuple[Document, Document]:
        old = edits.move_figures([f"f{n}" for n in range(1000)], 0.5, 0)(full_of(1000))
        return old, edit(old)

    changed()
    gc.collect()
    tracemalloc.start()
    try:
        old, new = changed()
        told = weight(old, new)
        both = tracemalloc.get_traced_memory()[0]
        del old
        held = both - tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
    assert 0.6 * held < told < 1.5 * held, (held, told)


def test_weighing_looks_at_a_part_where_everything_differs() -> None:
    count = 0

    def look(_frame: FrameType, event: str, _what: Any) -> None:
        nonlocal count
        count += event == "call"

    old, other = full_of(3000), full_of(3000)
    sys.setprofile(look)
    try:
        told = weight(old, other)
    finally:
        sys.setprofile(None)
    assert count < 30_000
    assert told == pytest.approx(3 * weight(full_of(1000), full_of(1000)), rel=0.05)


def test_a_session_bounds_what_undo_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    session = Session(document=full_of(2000))
    one = weight(session.document, edits.move_figures(["f1"], 1, 0)(session.document))
    monkeypatch.setattr(session.undo_stack, "_limit_bytes", 20 * one)
    for x in range(60):
        session.apply(edits.move_points({"s1/f1/p1-0/x": (x, 3.5)}), "Move", merge=f"drag {x // 2}")
    session.end_merge()
    assert 15 <= session.undo_stack.count() < 30
    assert session.undo_stack.held <= 20 * one
    with pytest.raises(DocumentError):
        session.apply(edits.remove_figures(["none"]), "Remove")


def test_a_drag_weighs_what_it_has_become() -> None:
    session = Session(document=full_of(100))
    start = session.document
    session.apply(edits.rename_sheet("s1", "Other"), "Change", merge="drag")
    session.apply(edits.remove_figures([f"f{n}" for n in range(50)]), "Change", merge="drag")
    session.end_merge()
    assert session.undo_stack.held == weight(start, session.document) > 50_000
