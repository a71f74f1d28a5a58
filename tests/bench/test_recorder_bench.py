"""What recording costs: processor time and bytes per line event, any seek, how long an interface waits.

python -m pytest tests/bench/test_recorder_bench.py --benchmark-enable -s
"""

import gc
import os
import random
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.engine.snapshots import active_edges, stack_fill
from workbench.algorithms import catalogue
from workbench.algorithms.lines.bresenham import bresenham_line
from workbench.engine.recorder import Recorder, record

EVENTS = 1_000_000


def deep_stack(levels: int) -> Iterator[tuple[int, int]]:
    """Fill and empty a stack of ``levels``, again and again."""
    stack = [(0, 0)]
    while True:
        while len(stack) < levels:
            stack.append((len(stack), levels))
        while len(stack) > levels // 2:
            at, other = stack.pop()
        yield at, other


def bordered(side: int) -> NDArray[np.int64]:
    """A square picture with a boundary around it."""
    image = np.zeros((side, side), np.int64)
    image[[0, -1], :] = image[:, [0, -1]] = 2
    return image


FILL = catalogue.get("boundary_fill_4").function
CASES: list[tuple[str, Callable[..., Any], tuple[Any, ...]]] = [
    ("Bresenham", bresenham_line, (0, 0, 400_000, 123_457)),
    ("stack of 100,000", deep_stack, (100_000,)),
    ("stack of 1,000,000", deep_stack, (1_000_000,)),
    ("fill of 60 x 60, recorded", FILL, (bordered(60), 30, 30, 1, 2)),
    ("fill of 600 x 600, left out", FILL, (bordered(600), 300, 300, 1, 2)),
    ("lists changed in place", active_edges, ([(k % 6, 11, k % 5 - 2) for k in range(3000)],)),
    ("a helper called for each pixel", stack_fill, (np.zeros((600, 600), np.int64), 300, 300, 1)),
]


def resident() -> int:
    """Bytes of this process in memory."""
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize(("name", "function", "arguments"), CASES, ids=[case[0] for case in CASES])
def test_recording(benchmark: Any, name: str, function: Any, arguments: tuple[Any, ...]) -> None:
    before, spent = resident(), time.thread_time()
    recording = benchmark.pedantic(record, (function, *arguments), {"limit": EVENTS}, rounds=1)
    spent = time.thread_time() - spent
    grown = resident() - before
    count = len(recording)
    choose = random.Random(7)
    seeks = []
    for event in (choose.randrange(count) for _ in range(300)):
        start = time.thread_time()
        recording[event]
        seeks.append(time.thread_time() - start)
    seeks.sort()
    assert count > 1000
    if benchmark.enabled:
        wall = benchmark.stats.stats.min
        print(
            f"\n{name}: {count} events, {spent / count * 1e6:.2f} us ({wall / count * 1e6:.2f} by the wall)"
            f" and {grown / count:.0f} bytes an event,"
            f" seek median {seeks[150] * 1e3:.3f}, worst {seeks[-1] * 1e3:.3f} ms"
        )


def test_delay_of_another_thread(benchmark: Any) -> None:
    """A loop that wants a millisecond of sleep and a little work, as an interface does, beside a recorder."""

    def delays(recorder: Recorder | None) -> list[float]:
        late = []
        started = time.perf_counter()
        while (not recorder.done) if recorder else time.perf_counter() - started < 2.0:
            before = time.perf_counter()
            time.sleep(0.001)
            sum(range(200))
            late.append(time.perf_counter() - before - 0.001)
        return sorted(late)

    def run() -> tuple[list[float], Recorder, float]:
        recorder = Recorder(
            bresenham_line, 0, 0, 400_000, 123_457, limit=EVENTS if benchmark.enabled else 20_000
        )
        start = time.perf_counter()
        recorder.start()
        return delays(recorder), recorder, time.perf_counter() - start

    late, recorder, spent = benchmark.pedantic(run, rounds=1)
    assert recorder.recording.truncated
    if benchmark.enabled:
        alone = delays(None)
        for name, values in (("while recording", late), ("alone", alone)):
            print(
                f"\n{name}: {len(values)} turns, late by median {values[len(values) // 2] * 1e3:.2f},"
                f" 99th of 100 {values[len(values) * 99 // 100] * 1e3:.2f}, worst {values[-1] * 1e3:.2f} ms"
            )
        print(f"on its thread: {spent / len(recorder.recording) * 1e6:.2f} us an event")
