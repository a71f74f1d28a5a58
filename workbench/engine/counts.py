"""How much work a run is: runs of each line, visits of each titled block, operations on the lines.

Runs and visits come from the compiled reading of the counting text. Operations are those written on a line
times its runs, see ``Operations``.
"""

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.engine import arguments
from workbench.engine.compiled import Kernel, Stop, kernel


@dataclass(frozen=True, slots=True)
class Counts:
    """The work of one run.

    ``writes`` are pixels: elements stored in arrays where the text writes its own picture, else emissions.
    ``line_runs`` are by (function, line of its file), ``block_visits`` by title.
    """

    tests: int
    additions: int
    multiplications: int
    divisions: int
    writes: int
    emitted: int
    line_runs: Mapping[tuple[str, int], int]
    block_visits: Mapping[str, int]


def counts(
    function: Callable[..., Any],
    *args: Any,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> Counts:
    """Count the work of ``function(*args)``; arrays are copied.

    Raises:
        Stopped: ``stop`` was set. DialectError, NotCompilable, TypeError, ValueError: as ``collect``.
    """
    one = kernel(function, None, flavour, "counting")
    runs, visits, emitted = _run(one, args, stop, compiling)
    lines: Counter[tuple[str, int]] = Counter()
    done: Counter[str] = Counter()
    for slot, times in zip(one.lowered.slots, runs, strict=True):
        for line in slot.lines:
            lines[slot.function, line] += int(times)
        for name, written in slot.written._asdict().items():
            done[name] += written * int(times)
    titles: Counter[str] = Counter()
    for title, times in zip(one.lowered.titles, visits, strict=True):
        titles[title] += int(times)
    return Counts(
        tests=done["tests"],
        additions=done["additions"],
        multiplications=done["multiplications"],
        divisions=done["divisions"],
        writes=done["stores"] if one.writes else done["yields"],
        emitted=emitted,
        line_runs=lines,
        block_visits=titles,
    )


def step_total(entry: Entry, *args: Any, stop: Stop | None = None, compiling: bool = True) -> int:
    """How many steps a run has: visits of the blocks whose views give a row of the hand table."""
    one = kernel(entry.function, None, "", "counting")
    _runs, visits, _emitted = _run(one, args, stop, compiling)
    return int(visits[step_blocks(entry, one)].sum())


def step_blocks(entry: Entry, one: Kernel) -> NDArray[np.bool_]:
    """For each block of a ticking text, whether its visits are steps."""
    rows = {view.block for view in entry.views if view.row}
    return np.array([title in rows for title in one.lowered.titles], bool)


def slot_blocks(one: Kernel) -> NDArray[np.int64]:
    """The block of each slot, as the ticks need it."""
    return np.array([slot.block for slot in one.lowered.slots], np.int64)


def _run(
    one: Kernel, args: tuple[Any, ...], stop: Stop | None, compiling: bool
) -> tuple[NDArray[np.int64], NDArray[np.int64], int]:
    runs = np.zeros(len(one.lowered.slots), np.int64)
    visits = np.zeros(len(one.lowered.titles), np.int64)
    emitted = np.zeros(1, np.int64)
    values = arguments.bind(one.function, args, True)
    stop = stop or Stop()
    one.call("_count", (runs, visits, slot_blocks(one), emitted, stop.flag, *values), compiling, stop)
    return runs, visits, int(emitted[0])
