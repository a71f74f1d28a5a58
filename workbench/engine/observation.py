"""What a person sees of a run: the steps of its hand table, with pixels, tables and a sentence.

A *visit* is one passage through a titled block that has views (see ``algorithms.entry``). Visits that
bear a row are the steps. Step i >= 1 begins where the i-th of them is entered and ends before the next
one is; step 0 is everything before the first. Visits are found by NumPy over the recording's columns,
only in what has grown; expressions are evaluated when a step is asked for.
"""

from bisect import bisect_right
from collections import OrderedDict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import CodeType
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, View
from workbench.algorithms.marks import Mark
from workbench.engine.blocks import block_at
from workbench.engine.recording import Recording
from workbench.engine.sentences import Part, fill_in, joined
from workbench.engine.visits import ViewError, Visits
from workbench.language import _

_STEPS_KEPT = 4096
_STATES_KEPT = 16
_LOOKED_BACK = 8

T = TypeVar("T")
Pixels = tuple[tuple[int, int], ...]
Table = tuple[tuple[str, ...], tuple[tuple[Any, ...], ...]]


@dataclass(frozen=True, slots=True)
class Step:
    """One row of the hand table, or (number 0) what comes before the first.

    ``first`` and ``last`` are its line events, both included; ``emitted_from`` up to ``emitted_to`` is
    what it emitted. ``tables`` maps a title to column headings and rows. ``view`` is the view that held,
    ``row`` is empty in step 0. ``options`` are the choices a person has who is asked first, ``answer`` is the
    right one; none where a pixel is asked for. ``marks`` are what is drawn of its block alone.
    """

    number: int
    title: str
    first: int
    last: int
    candidates: Pixels
    chosen: Pixels
    rejected: Pixels
    row: tuple[Any, ...]
    tables: dict[str, Table]
    sentence: tuple[Part, ...]
    emitted_from: int
    emitted_to: int
    view: View | None
    options: tuple[Any, ...] = ()
    answer: Any = None
    marks: tuple[Mark, ...] = ()


class _Latest(OrderedDict[int, T]):
    """What was made of a number, for the ``most`` numbers that were asked for last."""

    def __init__(self, most: int) -> None:
        super().__init__()
        self._most = most

    def recall(self, number: int, make: Callable[[int], T]) -> T:
        """What was made of ``number``; it is made if it is not known any more."""
        if number in self:
            self.move_to_end(number)
            return self[number]
        made = self[number] = make(number)
        if len(self) > self._most:
            self.popitem(last=False)
        return made


class _Before:
    """The variables as attributes; read when first asked for, since most expressions do not ask."""

    def __init__(self, read: Callable[[], dict[str, Any]]) -> None:
        self._read = read

    def __getattr__(self, name: str) -> Any:
        variables = self._read()
        self.__dict__.update(variables)
        return variables[name]


class Steps:
    """The steps of ``recording`` as the views of ``entry`` show them. Call ``update`` when it has grown.

    ``len`` is the number of rows so far; ``steps[0]`` is what comes before the first row,
    ``steps[len(steps)]`` the last step. Raises ViewError when a view names a block that the text does not
    have.
    """

    def __init__(self, entry: Entry, recording: Recording) -> None:
        self.entry = entry
        self.recording = recording
        self._functions = {function.__name__: function for function in entry.view_functions}
        self._visits = Visits(entry, recording)
        self._tells = self._visits.blocks_where(lambda view: bool(view.sentence) and not view.row)
        self._tabulates = self._visits.blocks_where(lambda view: bool(view.tables))
        self._considers = self._visits.blocks_where(lambda view: bool(view.considers))
        self._length = 0
        self._steps: _Latest[Step] = _Latest(_STEPS_KEPT)
        self._rows: _Latest[tuple[Any, ...]] = _Latest(_STEPS_KEPT)
        self._states: _Latest[dict[str, Any]] = _Latest(_STATES_KEPT)
        self._decisions: list[int] = []
        self._judged = 0
        self._last_view: View | None = None
        self.update()

    # What there is

    def update(self) -> bool:
        """Look at what was recorded since; True when there are more steps."""
        self._visits.update()
        before = self._length
        self._length = self._visits.rows_left(before)
        self._steps.pop(before, None)  # it may go on with what was recorded since
        return self._length > before

    def __len__(self) -> int:
        return self._length

    def __iter__(self) -> Iterator[Step]:
        return (self[number] for number in range(len(self) + 1))

    def __getitem__(self, number: int) -> Step:
        self._refuse(number)
        return self._steps.recall(number, self._step)

    def row(self, number: int) -> tuple[Any, ...]:
        """The row of a step alone, which is found faster than all of it; () for step 0."""
        self._refuse(number)
        return self._rows.recall(number, self._row) if number else ()

    def _refuse(self, number: int) -> None:
        if not 0 <= number <= self._length:
            raise IndexError(f"There is no step {number}; the last so far is {self._length}.")

    def step_of(self, event: int) -> int:
        """Number of the step that a line event belongs to."""
        entered = self._visits.entered[self._visits.rows[: self._length]]
        return int(np.searchsorted(entered, event, side="right"))

    def span(self, number: int) -> tuple[int, int]:
        """First and last line event of a step, without evaluating anything."""
        rows, entered = self._visits.rows, self._visits.entered
        first = int(entered[rows[number - 1]]) if number else 0
        last = int(entered[rows[number]]) - 1 if number < len(rows) else self._visits.seen - 1
        return first, last

    def title_of(self, event: int) -> str:
        """Title of the block that a line event is in, or an empty text."""
        moment_text = self.recording.frame_texts[self.recording.frame_column[event]]
        block = block_at(self.recording.texts[moment_text].function, self.recording.line_column[event])
        return block.title if block else ""

    def told(self, event: int) -> tuple[Part, ...]:
        """The sentence of the last visit that was left before ``event``, for stepping in detail."""
        return self._teller(event)[1]

    def marks_told(self, event: int) -> tuple[Mark, ...]:
        """What is drawn of the block whose sentence ``told`` gives."""
        visit = self._teller(event)[0]
        return self._marks(visit, None if visit is None else self._view_of(visit))

    def _teller(self, event: int) -> tuple[int | None, tuple[Part, ...]]:
        """The last visit with a sentence that was left before ``event``, and that sentence."""
        visits = self._visits
        for visit in range(bisect_right(visits.entered, event) - 1, -1, -1):
            if visits.last[visit] < event and self._is_left(visit):
                sentence = self._sentence_of(visit)
                if sentence:
                    return visit, sentence
        return None, ()

    def candidates_next(self, number: int) -> Pixels:
        """The candidates of the step after this one, as they stand before its choice; none after the last."""
        visit, view = self._next(number)
        return self._candidates(visit, view) if view else ()

    def options_next(self, number: int) -> tuple[Any, ...]:
        """The options of the step after this one, as they stand before its choice; none after the last."""
        visit, view = self._next(number)
        return self._options(visit, view)

    def _next(self, number: int) -> tuple[int, View | None]:
        """The visit of the step after this one, and its view; while it is under way, the first it may be."""
        if number >= len(self._visits.rows):
            return 0, None
        visit = int(self._visits.rows[number])
        views = self._visits.block_of(visit).views
        return visit, self._view_of(visit) if number < self._length else views[0]

    @property
    def judged(self) -> int:
        """How many steps ``find_decisions`` has looked at."""
        return self._judged

    @property
    def decisions(self) -> tuple[int, ...]:
        """Steps whose view differs from that of the step before. Looks at all of them."""
        return self.find_decisions(self._length)

    def find_decisions(self, most: int) -> tuple[int, ...]:
        """Look at up to ``most`` further steps; returns the decisions found so far."""
        for number in range(self._judged + 1, min(self._judged + most, self._length) + 1):
            view = self._view_of(int(self._visits.rows[number - 1]))
            if number > 1 and view is not self._last_view:
                self._decisions.append(number)
            self._last_view = view
            self._judged = number
        return tuple(self._decisions)

    def considered(self, first: int, most: int) -> tuple[list[tuple[int, tuple[int, int]]], int, bool]:
        """The pixels that the visits from ``first`` on tested, each with the event its visit was entered at.

        Looks at up to ``most`` visits; gives back, too, where to go on, and whether there is more.
        """
        visits = self._visits
        last = min(first + most, len(visits))
        found: list[tuple[int, tuple[int, int]]] = []
        for visit in range(first, last):
            if not self._is_left(visit):
                return found, visit, False
            if self._considers[visits.block_number(visit)]:
                cell = self._considered(visit)
                if cell is not None:
                    found.append((int(visits.entered[visit]), cell))
        return found, last, last < len(visits)

    def _considered(self, visit: int) -> tuple[int, int] | None:
        """The pixel that a visit tested. Where all views name the same, only the variables in it are read."""
        block = self._visits.block_of(visit)
        expressions = {view.considers for view in block.views}
        if len(expressions) > 1:
            view = self._view_of(visit)
            if view is None or not view.considers:
                return None
            x, y = self._value(visit, view, view.considers)
            return int(x), int(y)
        code = _compiled(next(iter(expressions)))
        known = self.recording.values_after(int(self._visits.last[visit]), code.co_names)
        x, y = eval(code, {**block.function.__globals__, **self._functions, **known})
        return int(x), int(y)

    # Showing one step

    def _step(self, number: int) -> Step:
        first, last = self.span(number)
        low = int(self._visits.rows[number - 1]) if number else 0
        high = int(self._visits.rows[number]) if number < len(self._visits.rows) else len(self._visits)
        told = self._some_of(self._tells, low, high)
        told = [low, *told[:1]] if number else told[2::-1]
        shown = told[0] if told else None
        view = self._view_of(shown) if shown is not None else None
        whole = last + 1 == self._visits.seen
        return Step(
            number=number,
            title=self._visits.block_of(shown).title if shown is not None else "",
            first=first,
            last=last,
            candidates=self._candidates(shown, view) if shown is not None and view is not None else (),
            chosen=self._pixels(shown, view, "chosen"),
            rejected=self._pixels(shown, view, "rejected"),
            row=self.row(number),
            tables=self._tables(low, high),
            sentence=tuple(joined(map(self._sentence_of, told))),
            emitted_from=self.recording.emitted_count(first) if self._visits.seen else 0,
            emitted_to=len(self.recording.emitted) if whole else self.recording.emitted_count(last + 1),
            view=view,
            options=self._options(shown, view),
            answer=self._value(shown, view, view.answer)
            if shown is not None and view and view.answer
            else None,
            marks=self._marks(shown, view),
        )

    def _row(self, number: int) -> tuple[Any, ...]:
        visit = int(self._visits.rows[number - 1])
        view = self._view_of(visit)
        return tuple(map(_plain, self._value(visit, view, view.row))) if view is not None else ()

    def _some_of(self, blocks: NDArray[np.bool_], low: int, high: int) -> list[int]:
        """The last few of the visits low to high whose block is one of these and has a view; latest first."""
        found = self._visits.of_blocks(blocks, low, high)[-_LOOKED_BACK:]
        latest = map(int, found[self._visits.left(found)][::-1])
        return [visit for visit in latest if self._view_of(visit) is not None]

    def _tables(self, low: int, high: int) -> dict[str, Table]:
        """The tables of the last of these visits that shows any."""
        for visit in self._some_of(self._tabulates, low, high)[:1]:
            view = self._view_of(visit)
            assert view is not None
            return {
                title: (columns, _table_rows(self._value(visit, view, expression)))
                for title, (expression, columns) in view.tables.items()
            }
        return {}

    def _is_left(self, visit: int) -> bool:
        return bool(self._visits.left(np.array([visit]))[0])

    def _before(self, visit: int) -> dict[str, Any]:
        """Variables when the visit was entered."""
        return self.recording[int(self._visits.entered[visit])].variables

    def _left_with(self, visit: int) -> dict[str, Any]:
        """Variables when the visit was left, and ``before`` those of its entering."""
        return self._states.recall(visit, self._state)

    def _state(self, visit: int) -> dict[str, Any]:
        recording, entered = self.recording, int(self._visits.entered[visit])
        after = recording.after(int(self._visits.last[visit]))
        return {**after, "before": _Before(lambda: recording[entered].variables)}

    def _view_of(self, visit: int) -> View | None:
        """The first view of the visit's block that holds."""
        for view in self._visits.block_of(visit).views:
            if view.when == "True" or self._value(visit, view, view.when):
                return view
        return None

    def _value(self, visit: int, view: View, expression: str) -> Any:
        return self._evaluate(visit, view, expression, self._left_with(visit))

    def _candidates(self, visit: int, view: View) -> Pixels:
        return _pixels(self._evaluate(visit, view, view.candidates, self._before(visit)))

    def _options(self, visit: int | None, view: View | None) -> tuple[Any, ...]:
        if visit is None or view is None:
            return ()
        return tuple(self._evaluate(visit, view, view.options, self._before(visit)))

    def _marks(self, visit: int | None, view: View | None) -> tuple[Mark, ...]:
        return () if visit is None or view is None else tuple(self._value(visit, view, view.marks))

    def _evaluate(self, visit: int, view: View, expression: str, variables: dict[str, Any]) -> Any:
        if expression == "()":
            return ()
        function = self._visits.block_of(visit).function
        try:
            return eval(_compiled(expression), {**function.__globals__, **self._functions, **variables})
        except Exception as error:
            if self._visits.broken_off(visit):
                return ()
            raise ViewError(
                _("{title}, block “{block}”: {expression} cannot be evaluated: {error}.").format(
                    title=self.entry.title, block=view.block, expression=expression, error=error
                )
            ) from error

    def _pixels(self, visit: int | None, view: View | None, which: str) -> Pixels:
        return _pixels(self._value(visit, view, getattr(view, which))) if visit is not None and view else ()

    def _sentence_of(self, visit: int) -> tuple[Part, ...]:
        view = self._view_of(visit)
        if view is None or not view.sentence or self._visits.broken_off(visit):
            return ()
        return fill_in(_(view.sentence), lambda expression: self._value(visit, view, expression))


_codes: dict[str, CodeType] = {}


def _compiled(expression: str) -> CodeType:
    code = _codes.get(expression)
    if code is None:
        code = _codes[expression] = compile(expression.strip(), "<view>", "eval")
    return code


def _pixels(value: Any) -> Pixels:
    return tuple((int(x), int(y)) for x, y in value)


def _plain(value: Any) -> Any:
    """A NumPy number as Python's own, with no more digits than it shows."""
    if isinstance(value, np.generic):
        return float(str(value)) if isinstance(value, np.floating) else value.item()
    if isinstance(value, tuple) and any(isinstance(part, (np.generic, tuple)) for part in value):
        return tuple(map(_plain, value))
    return value


def _table_rows(value: Any) -> tuple[tuple[Any, ...], ...]:
    """The rows of a table; a long list of plain tuples, as a stack is one, passes as it is."""
    ends = (value[0], value[-1]) if isinstance(value, list) and value else ()
    if ends and all(isinstance(row, tuple) and _plain(row) is row for row in ends):
        return tuple(value)
    rows = (row if isinstance(row, (tuple, list, np.ndarray)) else (row,) for row in value)
    return tuple(tuple(map(_plain, row)) for row in rows)
