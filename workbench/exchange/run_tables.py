"""The tables of a run: the hand table, what is emitted, every line with its variables."""

import linecache
from collections.abc import Iterator
from typing import Any

from workbench.algorithms.entry import Emits, Entry
from workbench.engine.observation import Steps
from workbench.engine.recording import Recording
from workbench.exchange.tables import Table

_EMITTED: dict[Emits, tuple[str, ...]] = {
    "pixels": ("x", "y"),
    "coverage": ("x", "y", "coverage"),
    "spans": ("y", "x_left", "x_right"),
    "fragments": ("x", "y", "z", "won"),
    "points": ("x", "y"),
    "segments": ("x0", "y0", "x1", "y1"),
}


def hand(steps: Steps, most: int | None = None) -> Table:
    """The hand table, one row for each step, or for the first ``most`` of them."""
    last = len(steps) if most is None else most
    return Table(steps.entry.columns, [steps.row(number) for number in range(1, last + 1)])


def emitted(entry: Entry, recording: Recording) -> Table:
    """Everything emitted, in order."""
    rows = [tuple(each) for each in recording.emitted]
    names = _EMITTED[entry.emits]
    width = len(rows[0]) if rows else len(names)
    headings = names if len(names) == width else tuple(f"value {n + 1}" for n in range(width))
    return Table(headings, rows, formulas=False)


def lines(recording: Recording) -> Table:
    """Every line that ran, with the variables as they were before it; empty where a name is not bound."""
    files = {text.name: text.code.co_filename for text in recording.texts}
    moments = [recording[number] for number in range(len(recording))]
    names = list(dict.fromkeys(name for moment in moments for name in moment.variables))

    def rows() -> Iterator[tuple[Any, ...]]:
        for number, moment in enumerate(moments, 1):
            values = (moment.variables.get(name) for name in names)
            yield number, moment.line, linecache.getline(files[moment.function], moment.line).strip(), *values

    return Table(("number", "line", "text", *names), list(rows()), formulas=False)
