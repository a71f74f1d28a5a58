"""A run that is stopped ends at its next emission, wherever that is, and keeps nothing of what it held."""

import sys
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine import compiled
from workbench.engine.arguments import bind
from workbench.engine.counts import counts, slot_blocks
from workbench.engine.stopping import Stop, Stopped
from workbench.engine.touches import touches

ENTRIES = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries()]
ENDS = np.array([40])
TURN = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
RING = np.stack([30.0 + 20.0 * np.cos(3.0 * TURN), 30.0 + 20.0 * np.sin(2.0 * TURN)], axis=1)


def stopped() -> Stop:
    stop = Stop()
    stop.set()
    return stop


@pytest.mark.parametrize("entry", ENTRIES)
def test_at_most_one_more_is_emitted(entry: Entry) -> None:
    stop, emitted = stopped(), np.zeros(1, np.int64)
    plain = compiled.kernel(entry.function, flavour="interpreted")
    values = bind(entry.function, entry.example, True)
    with pytest.raises(Stopped):
        plain.call("_collect", (np.zeros(0), emitted, stop.flag, *values), False, stop)
    assert emitted[0] <= 1


@pytest.mark.parametrize("entry", ENTRIES)
def test_at_most_one_more_is_emitted_where_steps_are_counted(entry: Entry) -> None:
    stop, emitted = stopped(), np.zeros(1, np.int64)
    one = compiled.kernel(entry.function, None, "interpreted", "counting")
    runs, visits = np.zeros(len(one.lowered.slots), np.int64), np.zeros(len(one.lowered.titles), np.int64)
    values = bind(entry.function, entry.example, True)
    with pytest.raises(Stopped):
        one.call("_count", (runs, visits, slot_blocks(one), emitted, stop.flag, *values), False, stop)
    assert emitted[0] <= 1


@pytest.fixture
def held() -> Iterator[Callable[[], int]]:
    """How much of numba's memory is in use now: pieces, those of what it knows of included."""
    from numba.core.runtime import _nrt_python, rtsys

    _nrt_python.memsys_enable_stats()
    yield lambda: (now := rtsys.get_allocation_stats()).alloc - now.free + now.mi_alloc - now.mi_free
    _nrt_python.memsys_disable_stats()


def asked(function: Callable[..., Any], *args: Any) -> Callable[[Stop | None], Any]:
    return lambda stop: function(*args, stop=stop)


FILL, LINE = catalogue.get("scan_line_exact").function, catalogue.get("bresenham_line").function
ROWS = np.array([[0, 0, 30, 12]] * 3)


@pytest.mark.parametrize(
    ("run", "given"),
    [
        pytest.param(asked(compiled.collect, FILL, RING, ENDS, False, True), RING, id="collect"),
        pytest.param(asked(counts, FILL, RING, ENDS, False, True), RING, id="count"),
        pytest.param(asked(touches, FILL, 30, 30, RING, ENDS, False, True), RING, id="touches"),
        pytest.param(asked(compiled.hits, FILL, 30, 30, RING, ENDS, False, True), RING, id="hits"),
        pytest.param(asked(compiled.collect_many, LINE, ROWS), ROWS, id="collect_many"),
    ],
)
def test_a_stopped_run_holds_nothing(
    held: Callable[[], int], run: Callable[[Stop | None], Any], given: Any
) -> None:
    run(None)
    before, references = held(), sys.getrefcount(given)
    for _again in range(10):
        with pytest.raises(Stopped):
            run(stopped())
    assert held() == before
    assert sys.getrefcount(given) == references
