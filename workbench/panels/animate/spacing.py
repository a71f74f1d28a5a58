"""A spacing chart: where a value is in each frame between two keys, by its keys, by an equation, evenly."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from workbench.algorithms.marks import Ink, Mark, Points, Spot, Stroke, Word, along
from workbench.document.motion.evaluation import wished
from workbench.document.motion.model import Key, Track
from workbench.language import _
from workbench.panels.animate.physics import Equation

_WIDE, _ROW, _TALL = 10.0, 1.9, 0.28
_MOST_TICKS = 120


class Row(NamedTuple):
    """One row of the chart: its words, and a number for each frame."""

    title: str
    values: Points
    ink: Ink


class Chart(NamedTuple):
    """The frames of a chart, and its rows: by the keys, by the equation where there is one, evenly."""

    frames: range
    rows: tuple[Row, ...]

    @property
    def apart(self) -> Points:
        """How far keys and equation are apart in each frame; 0 where there is none."""
        keys, equation = self.rows[0].values, self.rows[-2].values
        return np.abs(keys - equation)


def chart_of(track: Track, keys: tuple[Key, Key], equation: Equation | None) -> Chart:
    """That between two keys; of several numbers how far they have come, all together."""
    first, second = keys
    step = max((second.frame - first.frame) // _MOST_TICKS, 1)
    frames = range(first.frame, second.frame + 1, step)
    by_keys = _gone(track, frames)
    rows = [Row(_("by its keys"), by_keys, "data1")]
    if equation is not None:
        rows.append(Row(_("by its equation"), _gone(equation.track, frames), "data4"))
    even = np.linspace(by_keys[0], by_keys[-1], len(frames))
    return Chart(frames, (*rows, Row(_("evenly"), even, "muted")))


def _gone(track: Track, frames: Sequence[int]) -> Points:
    values = np.array([wished(track, frame) for frame in frames])
    if values.shape[1] == 1:
        return values[:, 0]
    steps = np.sqrt((np.diff(values, axis=0) ** 2).sum(axis=1))
    return np.concatenate([[0.0], np.cumsum(steps)])


def drawn(chart: Chart, frame: int) -> Iterator[Mark]:
    """A line for each row with a tick for each frame; that of the frame is ringed."""
    every = np.concatenate([row.values for row in chart.rows])
    low, size = float(every.min()), float(np.ptp(every)) or 1.0
    for number, row in enumerate(chart.rows):
        y = -_ROW * number
        yield Stroke(along((0.0, y), (_WIDE, y)), "muted", "hair")
        for x in ((row.values - low) / size * _WIDE).tolist():
            yield Stroke(along((x, y - _TALL), (x, y + _TALL)), row.ink, "hair")
        yield Word(row.title, 0.0, y + _TALL, "text", 1, 1)
        if chart.frames.start <= frame < chart.frames.stop:
            at = float(np.interp(frame, chart.frames, row.values))
            yield Spot((at - low) / size * _WIDE, y, row.ink, "ring", "medium")


def box(chart: Chart) -> Points:
    """The corners of what holds the chart."""
    return np.array([(-0.3, 1.35), (_WIDE + 0.3, -_ROW * (len(chart.rows) - 1) - 2.0 * _TALL)])
