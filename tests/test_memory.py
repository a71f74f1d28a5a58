"""What is remembered: made once, let go of when it was not asked for the longest, and never too large."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example_document
from workbench.memory import Memory, forget
from workbench.rendering.emissions import _memory
from workbench.rendering.raster import emitted, figure_calls
from workbench.session.session import Session

MOST = 40_000


def test_it_is_made_once_and_read_only() -> None:
    memory: Memory[np.ndarray] = Memory(MOST)
    first = memory.get("a", lambda: np.zeros(3))
    assert memory.get("a", lambda: np.ones(3)) is first
    assert not first.flags.writeable
    memory.clear()
    assert memory.get("a", lambda: np.ones(3)).tolist() == [1, 1, 1]


@given(st.lists(st.tuples(st.integers(0, 12), st.integers(0, 2000)), max_size=80))
def test_it_stays_small_and_keeps_what_was_asked_for_last(asked: list[tuple[int, int]]) -> None:
    memory: Memory[tuple[np.ndarray, ...]] = Memory(MOST)
    order: list[tuple[int, int]] = []
    for key in asked:
        made = []
        memory.get(key, lambda size=key[1], made=made: made.append(1) or (np.zeros(size), np.zeros(2)))
        # What was asked for since it was asked for last, each once, decides whether it is still there.
        if key in order:
            later = set(order[len(order) - order[::-1].index(key) :]) | {key}
            kept = sum(8 * size + 16 + 2 * 600 for _k, size in later) <= MOST
            assert bool(made) != kept
        order.append(key)
    held = sum(sum(array.nbytes for array in arrays) for arrays in memory._kept.values())
    assert held <= MOST


def test_every_memory_forgets_when_another_document_is_opened(qtbot: QtBot) -> None:
    forget()
    session = Session(document=example_document())
    emitted(figure_calls(session.sheet, session.sheet.figures[0])[0])
    assert len(_memory._kept) > 0
    session.new()
    assert len(_memory._kept) == _memory._bytes == 0
    session.close()
