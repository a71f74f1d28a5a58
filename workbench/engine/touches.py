"""Which steps touched a pixel, and which only considered it: the ground of *Why this pixel?*."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from workbench.algorithms.entry import Emits
from workbench.engine import arguments
from workbench.engine.compiled import Stop, kernel
from workbench.engine.counts import slot_blocks, step_blocks


@dataclass(frozen=True, slots=True)
class StepTouch:
    """One time that a run came to a pixel: it emitted it, or a block considered it.

    ``emission`` is the number of the emission, from 0; of the next one, where the pixel was only considered.
    ``step`` is the number of the step, 0 before the first.
    """

    emitted: bool
    emission: int
    step: int


def touches(
    function: Callable[..., Any],
    x: int,
    y: int,
    *args: Any,
    emits: Emits | None = None,
    stop: Stop | None = None,
    compiling: bool = True,
    flavour: str = "",
) -> tuple[StepTouch, ...]:
    """All that a run of ``function(*args)`` did at the pixel (x, y), in order; arrays are copied.

    Raises:
        Stopped: ``stop`` was set. DialectError, NotCompilable, TypeError, ValueError: as ``collect``.
    """
    one = kernel(function, emits, flavour, "probing")
    entry = arguments.entry_of(function)
    rows = np.zeros(len(one.lowered.titles), bool) if entry is None else step_blocks(entry, one)
    stop, room = stop or Stop(), 256
    while True:
        kept = np.zeros((room, 3), np.int64)
        found, steps, emitted = np.zeros(1, np.int64), np.zeros(1, np.int64), np.zeros(1, np.int64)
        values = arguments.bind(function, args, True)
        sink = (int(x), int(y), kept, found, rows, slot_blocks(one), steps, emitted, stop.flag)
        one.call("_probe", (*sink, *values), compiling, stop)
        if found[0] <= room:
            return tuple(StepTouch(bool(a), int(b), int(c)) for a, b, c in kept[: found[0]])
        room = int(found[0])
