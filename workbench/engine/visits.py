"""Finds the visits of a recording to the blocks that an entry has views for.

A *visit* is one passage through such a block: the consecutive line events of one call that belong to it.
They are found by NumPy over the recording's columns, and each time only in the events that are new.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, View
from workbench.engine.blocks import blocks
from workbench.engine.effects import texts_of
from workbench.engine.passing import Skip
from workbench.engine.recording import Recording
from workbench.language import _

_NONE = -1
_GROWTH = 16
_ENTERED, _LAST, _BLOCK, _CALL = range(4)


class ViewError(ValueError):
    """A view names a block that is not there, or an expression that cannot be evaluated."""


@dataclass(frozen=True, slots=True)
class Viewed:
    """A titled block that has views, in one function."""

    title: str
    function: Callable[..., Any]
    views: tuple[View, ...]


class Visits:
    """The visits to the blocks with views, in the order of their entering. Raises ViewError on a wrong view.

    ``seen`` is how many line events have been looked at.
    """

    def __init__(self, entry: Entry, recording: Recording) -> None:
        self.recording = recording
        self.seen = 0
        self._viewed = _viewed_blocks(entry, recording)
        self._lookup = _block_of_line(self._viewed, recording)
        self._bears_row = self.blocks_where(lambda view: bool(view.row))
        self._count = 0
        self._table = np.zeros((4, 64), np.int32)
        self._bearing = np.zeros(64, np.int32)
        self._rows = 0
        self._block_in: NDArray[np.int64] = np.zeros(0, np.int64)
        self._visit_in: NDArray[np.int64] = np.zeros(0, np.int64)
        self._begun = False

    def __len__(self) -> int:
        return self._count

    @property
    def rows(self) -> NDArray[np.int32]:
        """The visits that bear a row, in the order of their entering."""
        return self._bearing[: self._rows]

    @property
    def entered(self) -> NDArray[np.int32]:
        """Event at which each visit was entered, ascending."""
        return self._table[_ENTERED, : self._count]

    @property
    def last(self) -> NDArray[np.int32]:
        """Last event of each visit, so far as is recorded."""
        return self._table[_LAST, : self._count]

    def block_number(self, visit: int) -> int:
        """The number of the block that was visited, among those with views."""
        return int(self._table[_BLOCK, visit])

    def block_of(self, visit: int) -> Viewed:
        """The block that was visited."""
        return self._viewed[self.block_number(visit)]

    def blocks_where(self, holds: Callable[[View], bool]) -> NDArray[np.bool_]:
        """For each block with views, whether ``holds`` is true of any of them."""
        return np.array([any(map(holds, block.views)) for block in self._viewed], bool)

    def of_blocks(self, blocks: NDArray[np.bool_], low: int, high: int) -> NDArray[np.int64]:
        """Those of the visits low to high (not included) whose block is marked."""
        return low + np.flatnonzero(blocks[self._table[_BLOCK, low : min(high, self._count)]])

    def left(self, visits: NDArray[np.integer[Any]]) -> NDArray[np.bool_]:
        """Which of these visits are over, as far as has been looked at."""
        recording = self.recording
        if recording.complete and self.seen == recording.count:
            return np.ones(len(visits), bool)
        calls = self._table[_CALL, visits]
        ends = np.array(recording.frame_ends[:], np.int64)[calls]
        gone = (ends != 0) & (ends <= 2 * self.seen)
        if recording.error is None and not recording.truncated:
            # A call that ends with the last line may end by an error, which is told once all calls have ended
            gone &= ends < 2 * self.seen - 1
        left: NDArray[np.bool_] = np.logical_or(gone, self._visit_in[calls] != visits)
        return left

    def broken_off(self, visit: int) -> bool:
        """Whether an error ended the run in the middle of this visit: it ends all calls with its line."""
        recording = self.recording
        if recording.error is None:
            return False
        call = self._table[_CALL, visit]
        ended = recording.frame_ends[call] >= 2 * recording.count - 1
        return bool(ended and self._visit_in[call] == visit)

    def rows_left(self, sure: int) -> int:
        """How many rows come before the first whose visit is under way; ``sure`` of them are known to."""
        rows = self.rows[sure:]
        under_way = np.flatnonzero(~self.left(rows))
        return sure + (int(under_way[0]) if len(under_way) else len(rows))

    def update(self) -> None:
        """Find the visits in the events that were recorded since."""
        recording, seen, count = self.recording, self.seen, self.recording.count
        if count == seen:
            return
        lines = np.array(recording.line_column[seen:count], np.int64)
        calls = np.array(recording.frame_column[seen:count], np.int64)
        texts = np.array(recording.frame_texts[:], np.int64)
        self._make_room(len(texts))
        if not self._begun:
            # A call that was under way when recording began goes on with its block; that is no new visit.
            self._begun = True
            self._block_in[: len(recording.begun_in)] = recording.begun_in[:]
        order = np.argsort(calls, kind="stable")
        call, block = calls[order], self._lookup[texts[calls], lines][order]
        other_call = np.append(True, call[1:] != call[:-1])
        begins = other_call | np.append(True, block[1:] != block[:-1])
        starts = np.flatnonzero(begins)
        stops = np.append(starts[1:], len(order)) - 1
        in_block, in_call = block[starts], call[starts]
        goes_on = other_call[starts] & (self._block_in[in_call] == in_block) & (in_block != _NONE)
        new = ~goes_on & (in_block != _NONE)
        found = np.array([seen + order[starts], seen + order[stops], in_block, in_call], np.int64)
        earlier = self._visit_in[in_call[goes_on]]
        self._table[_LAST, earlier[earlier != _NONE]] = found[_LAST, goes_on][earlier != _NONE]
        by_entering = np.flatnonzero(new)[np.argsort(found[_ENTERED, new], kind="stable")]
        numbers = np.full(len(starts), _NONE, np.int64)
        numbers[by_entering] = self._count + np.arange(len(by_entering))
        numbers[goes_on] = self._visit_in[in_call[goes_on]]
        final = np.append(in_call[1:] != in_call[:-1], True)
        self._block_in[in_call[final]] = in_block[final]
        self._visit_in[in_call[final]] = numbers[final]
        self._add(found[:, by_entering])
        self.seen = count

    def _make_room(self, calls: int) -> None:
        missing = calls - len(self._block_in)
        if missing > 0:
            room = np.full(max(missing, len(self._block_in)), _NONE, np.int64)
            self._block_in = np.append(self._block_in, room)
            self._visit_in = np.append(self._visit_in, room)

    def _add(self, found: NDArray[np.int64]) -> None:
        first = self._count
        bearing = first + np.flatnonzero(self._bears_row[found[_BLOCK]])
        self._count, rows = first + found.shape[1], self._rows + len(bearing)
        self._table = _with_room(self._table, self._count)
        self._table[:, first : self._count] = found
        self._bearing = _with_room(self._bearing, rows)
        self._bearing[self._rows : rows] = bearing
        self._rows = rows


def _with_room(kept: NDArray[np.int32], needed: int) -> NDArray[np.int32]:
    """``kept`` with room for ``needed`` along its last axis.

    Much room costs nothing: a system gives memory for zeros only where they are written over.
    """
    if needed <= kept.shape[-1]:
        return kept
    grown = np.zeros((*kept.shape[:-1], max(needed, _GROWTH * kept.shape[-1])), np.int32)
    grown[..., : kept.shape[-1]] = kept
    return grown


def read(entry: Entry) -> None:
    """Read the texts of an entry and their blocks, so that its first run need not. Raises ViewError."""
    _viewed_blocks(entry, Recording(texts_of(entry.function)))


def skip(entry: Entry, steps: int) -> Skip:
    """What a recorder of ``entry`` passes over for its first event to be that of step ``steps`` + 1."""
    recording = Recording(texts_of(entry.function))
    viewed = _viewed_blocks(entry, recording)
    blocks = tuple(
        {line: block for line, block in enumerate(row.tolist()) if block != _NONE}
        for row in _block_of_line(viewed, recording)
    )
    return Skip(steps, blocks, tuple(any(bool(view.row) for view in block.views) for block in viewed))


def _viewed_blocks(entry: Entry, recording: Recording) -> list[Viewed]:
    """The blocks of the recorded functions that the entry has views for."""
    views: dict[str, list[View]] = {}
    for view in entry.views:
        views.setdefault(view.block, []).append(view)
    viewed = [
        Viewed(block.title, text.function, tuple(views[block.title]))
        for text in recording.texts
        for block in blocks(text.function)
        if block.title in views
    ]
    for title in views.keys() - {block.title for block in viewed}:
        raise ViewError(
            _("{slug}: a view is for a block “{title}”, which the text does not have.").format(
                slug=entry.slug, title=title
            )
        )
    for block in viewed:
        if len({bool(view.row) for view in block.views}) > 1:
            raise ViewError(
                _("{slug}: of the views of block “{title}” either all must give a row, or none.").format(
                    slug=entry.slug, title=block.title
                )
            )
    return viewed


def _block_of_line(viewed: list[Viewed], recording: Recording) -> NDArray[np.int64]:
    """(texts, lines) -> number of the viewed block, or -1."""
    ends = [line for text in recording.texts for *_, line in text.code.co_lines() if line]
    lookup = np.full((len(recording.texts), max(ends) + 1), _NONE, np.int64)
    numbers = {(block.function, block.title): number for number, block in enumerate(viewed)}
    for row, text in enumerate(recording.texts):
        for block in blocks(text.function):
            own = [line for line in block.lines if line < lookup.shape[1]]
            lookup[row, own] = numbers.get((text.function, block.title), _NONE)
    return lookup
