"""The tables of a run: the hand table, what is emitted, every line with its variables."""

import linecache
from collections.abc import Callable, Sequence
from typing import Any, overload

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
    "cells": ("row", "column", "value"),
    "cubes": ("x", "y", "z", "size", "state"),
}


class _Rows(Sequence[tuple[Any, ...]]):
    """The rows with these ``numbers``, each computed when it is read: a run has up to a million of them."""

    def __init__(self, numbers: Sequence[int], row: Callable[[int], tuple[Any, ...]]) -> None:
        self._numbers, self._row = numbers, row

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, number: int) -> tuple[Any, ...]: ...

    @overload
    def __getitem__(self, number: slice) -> list[tuple[Any, ...]]: ...

    def __getitem__(self, number: int | slice) -> tuple[Any, ...] | list[tuple[Any, ...]]:
        if isinstance(number, slice):
            return [self._row(each) for each in self._numbers[number]]
        return self._row(self._numbers[number])


def hand(steps: Steps, rows: Sequence[int] | None = None) -> Table:
    """The hand table, one row for each step, or for those ``rows`` (from 0)."""
    return Table(
        steps.entry.columns,
        _Rows(range(len(steps)) if rows is None else rows, lambda row: steps.row(row + 1)),
    )


def emitted(entry: Entry, recording: Recording) -> Table:
    """Everything emitted, in order."""
    rows = [tuple(each) for each in recording.emitted]
    return Table(entry.emitted_columns or _EMITTED[entry.emits], rows, formulas=False)


def lines(recording: Recording) -> Table:
    """Every line that ran, with the variables as they were before it; empty where a name is not bound."""
    files = {text.name: text.code.co_filename for text in recording.texts}
    ran = [recording.texts[code] for code in dict.fromkeys(recording.codes.tolist())]
    names = list(dict.fromkeys(name for text in ran for name in text.names))

    def row(number: int) -> tuple[Any, ...]:
        moment = recording[number]
        text = linecache.getline(files[moment.function], moment.line).strip()
        return (number + 1, moment.line, text, *map(moment.variables.get, names))

    return Table(("number", "line", "text", *names), _Rows(range(len(recording)), row), formulas=False)
