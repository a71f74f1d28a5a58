"""What a fill still has to do at an event, how deep it is, and how often it has tested each pixel.

``Entry.stack`` names the list that a text keeps; one that calls itself has the calls under way for a stack.
"""

import ast
import inspect
from collections.abc import Callable, Sequence
from textwrap import dedent
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import CALLS, Entry
from workbench.engine.calls import Variables, variables_at
from workbench.engine.observation import Steps
from workbench.engine.recording import Recording

Cell = tuple[int, int]


def stack_at(entry: Entry, recording: Recording, event: int) -> Sequence[Any]:
    """What is on the stack of a text at an event, its foot first; for one that calls itself, its calls."""
    if not entry.stack:
        return ()
    found: Sequence[Any] = variables_at(recording, event).get(entry.stack, ())
    return found


def largest(entry: Entry, recording: Recording) -> int:
    """The most entries that the stack ever had, or how many calls nested at most; of what is recorded.

    A text that keeps a stack changes it on lines of their own, so that their runs tell its size at any time.
    """
    if entry.stack == CALLS:
        own = np.array(recording.frame_texts[:]) == 0
        return int(np.array(recording.frame_depths[:], np.int64)[own].max(initial=-1)) + 1
    stack = entry.stack
    source, first = inspect.getsourcelines(entry.function)
    change = np.zeros(first + len(source), np.int64)
    for number, line in enumerate(source, first):
        pushes = line.strip().startswith((f"{stack}.append(", f"{stack} = [("))
        change[number] = int(pushes) - int(f"{stack}.pop()" in line)
    lines = recording.lines[recording.codes == 0]
    return int(np.cumsum(change[lines]).max(initial=0))


class Depths:
    """How many entries the stack has, or how many calls nest, at the end of each step; found in slices."""

    def __init__(self, steps: Steps) -> None:
        self._steps = steps
        self._room = np.zeros(256, np.int64)
        self._known = 0

    @property
    def values(self) -> NDArray[np.int64]:
        """(n,) depth after steps 0 to n - 1."""
        return self._room[: self._known]

    def advance(self, most: int) -> bool:
        """Look at up to ``most`` further steps; True while there are more."""
        steps, recording = self._steps, self._steps.recording
        last = min(len(steps) + 1, self._known + most)
        if last > len(self._room):
            self._room = np.append(self._room, np.zeros(max(last, len(self._room)), np.int64))
        for number in range(self._known, last):
            event = max(steps.span(number)[1], 0)
            if event >= len(recording):
                return False
            self._room[number] = len(stack_at(steps.entry, recording, event))
            self._known = number + 1
        return self._known <= len(steps)


def _loop_line(function: Callable[..., Any]) -> int:
    """The line of the first loop of a function."""
    lines, first = inspect.getsourcelines(function)
    loops = [node for node in ast.walk(ast.parse(dedent("".join(lines)))) if isinstance(node, ast.While)]
    return first - 1 + min(loop.lineno for loop in loops)


class PixelTests:
    """Which pixel each step tested, found in slices.

    A text that fills by spans tests in the functions of ``Entry.tests_in``: every pass through the header of
    their loop is one test.
    """

    def __init__(self, steps: Steps) -> None:
        self._steps = steps
        self._looked = 0
        self._headers = {function: _loop_line(function) for function in steps.entry.tests_in}
        self._step: list[int] = []
        self._cells: list[Cell] = []

    def __len__(self) -> int:
        """How many tests were found so far."""
        return len(self._cells)

    def advance(self, most: int) -> bool:
        """Look at up to ``most`` further visits; True while there are more."""
        recording = self._steps.recording
        if self._headers:
            return self._advance_runs(recording, 4 * most)
        found, self._looked, more = self._steps.considered(self._looked, most)
        for event, cell in found:
            self._step.append(self._steps.step_of(event))
            self._cells.append(cell)
        return more

    def _advance_runs(self, recording: Recording, most: int) -> bool:
        headers = [self._headers.get(text.function) for text in recording.texts]
        last = min(self._looked + most, len(recording))
        for event in range(self._looked, last):
            frame = recording.frame_column[event]
            if recording.line_column[event] == headers[recording.frame_texts[frame]]:
                x = Variables(recording, frame, 2 * event)["x"]
                y = Variables(recording, recording.frame_parents[frame], 2 * event)["y"]
                self._step.append(self._steps.step_of(event))
                self._cells.append((int(x), int(y)))
        self._looked = last
        return last < len(recording)

    def counts(self, number: int, size: tuple[int, int]) -> NDArray[np.int64]:
        """(height, width) how often each pixel was tested up to step ``number``."""
        counted = np.zeros((size[1], size[0]), np.int64)
        if not self._cells:
            return counted
        upto = int(np.searchsorted(np.array(self._step), number, side="right"))
        x, y = np.array(self._cells[:upto], np.int64).reshape(-1, 2).T
        inside = (x >= 0) & (x < size[0]) & (y >= 0) & (y < size[1])
        np.add.at(counted, (y[inside], x[inside]), 1)
        return counted

    def steps_at(self, cell: Cell) -> list[int]:
        """The steps that tested this pixel, so far as has been looked."""
        return [step for step, tested in zip(self._step, self._cells, strict=True) if tested == cell]
