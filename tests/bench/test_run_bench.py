"""How long the interface thread is held while a long run is recorded, shown and stepped through.

The first of the runs loads the compiler beside.

python -m pytest tests/bench/test_run_bench.py --benchmark-enable -s
"""

import time
from contextlib import suppress
from pathlib import Path
from typing import Any

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from workbench.algorithms import catalogue
from workbench.document.subjects import Subject
from workbench.rendering.mapping import Call
from workbench.session.run import Run
from workbench.widgets.stepping.source_view import SourceView
from workbench.widgets.stepping.step_bar import Steps
from workbench.widgets.tables.hand_table import HandTable
from workbench.widgets.tables.variable_table import VariableTable

_RUNS = 5
_SETTLE_MS = 100


def said(name: str, values: list[float]) -> None:
    """Print the figures of one list of delays in seconds."""
    ordered = sorted(values)
    print(
        f"\n{name}: {len(ordered)} times, median {ordered[len(ordered) // 2] * 1e3:.2f},"
        f" 99th of 100 {ordered[len(ordered) * 99 // 100] * 1e3:.2f}, worst {ordered[-1] * 1e3:.2f} ms"
    )


def waited() -> float:
    """Seconds that this thread was ready to run while others had the processors, where Linux tells."""
    with suppress(OSError):
        return int(Path("/proc/thread-self/schedstat").read_text().split()[1]) / 1e9
    return 0.0


def test_delays_of_a_timer(benchmark: Any, qapp: QApplication) -> None:
    """A timer of 1 ms measures its own lateness while 1,000,000 line events are recorded and shown."""
    run, window = Run(), QWidget()
    column = QVBoxLayout(window)
    for view in (SourceView(run), VariableTable(run), HandTable(run), Steps(run)):
        column.addWidget(view)
    window.resize(900, 900)
    window.show()
    entry = catalogue.get("bresenham_line")
    run.follow(Subject(ids=("figure",)), [Call(entry, (0, 0, 20, 12))], (1000, 1000))
    while not run.done:
        qapp.processEvents()
    late: list[float] = []
    by_us: list[float] = []
    last = [time.perf_counter(), waited()]

    def tick() -> None:
        now = [time.perf_counter(), waited()]
        late.append(now[0] - last[0] - 0.001)
        by_us.append(late[-1] - (now[1] - last[1]))
        last[:] = now

    timer = QTimer()
    timer.setTimerType(Qt.TimerType.PreciseTimer)
    timer.timeout.connect(tick)

    loop = QEventLoop()
    run.grown.connect(lambda: QTimer.singleShot(_SETTLE_MS, loop.quit) if run.done else None)

    def record() -> None:
        late.clear()
        by_us.clear()
        last[:] = time.perf_counter(), waited()
        end = run.arguments[2] + 1
        run.follow(Subject(ids=("figure",)), [Call(entry, (0, 0, max(end, length), 700))], (1000, 1000))
        loop.exec()
        assert run.recording is not None
        if benchmark.enabled:
            said(f"late while {len(run.recording)} line events were recorded", late)
            said("without waiting for a processor that others had", by_us)

    length = 400_000 if benchmark.enabled else 2_000
    timer.start(1)
    benchmark.pedantic(record, rounds=_RUNS if benchmark.enabled else 1)
    timer.stop()
    if benchmark.enabled:
        moves = []
        for number in range(200):
            start = time.perf_counter()
            run.go((number * 7919) % run.last_position)
            moves.append(time.perf_counter() - start)
        said("moving the cursor", moves)
    run.clear()
    window.deleteLater()
