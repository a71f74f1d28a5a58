"""Where the cursor of a run stands, what is seen there, and how it is moved.

It counts *steps* (rows of the hand table, 0 is before the first) or, in detail, lines that ran (the number of
lines is the end).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from workbench.algorithms.marks import Mark
from workbench.engine.calls import OwnCall, own_call
from workbench.engine.columns import EmittedSoFar
from workbench.engine.observation import Step
from workbench.engine.recording import Moment
from workbench.engine.sentences import Part
from workbench.session.emissions import event_on_line, event_touching, painted
from workbench.session.recorded_run import RecordedRun
from workbench.session.variables import differing, in_order

_MOST_LINES = 100_000


class Cursor(RecordedRun):
    """A recorded run and a cursor in it. ``moved``: the cursor, or what it counts.

    ``before`` gives one sentence where less is run than what was to be, empty where all is.
    """

    moved = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.detail = False
        self.before: Callable[[], str] = str
        self._position = 0
        self._wanted: int | None = None
        self._to_end = self._stays = False
        self._seen = 0
        self.changed.connect(self.moved)
        self.grown.connect(self._go_to_known_end)

    def _leaving(self, same: bool) -> None:
        if not same:
            self._wanted = None
            self._to_end = self._stays = False
            self._seen = 0
        elif self._wanted is None:
            self._wanted = self.number
            self._to_end = self._to_end or (self._is_at_last and not self._stays)
        self._position = 0

    @property
    def _is_at_last(self) -> bool:
        """Whether no step follows, in a run that is recorded as far as it will be."""
        return self.done and not self.goes_on and 0 < self._position >= self.last_position

    def _recorded(self, done: bool) -> None:
        if self._wanted is None:
            return
        wanted = self._wanted
        position = wanted - self._before_stretch
        self._move_to(position)
        if done or position <= self.last_position:
            self._wanted = None
        if self.last_position < position and self.goes_on and not self.passed:
            self.go_to_number(wanted)

    def _go_to_known_end(self) -> None:
        """Where the end was asked for and all of the run is known by now, go there."""
        if self._to_end and self._knows_end:
            self.last()

    @property
    def _knows_end(self) -> bool:
        return self.done and (self.detail or not self.goes_on or self.total_steps is not None)

    # Where the cursor is

    @property
    def position(self) -> int:
        """The step, or in detail the line event."""
        return self._position

    @property
    def target(self) -> int | None:
        """Number where the cursor is, or is going once that is recorded; None for an end not yet known."""
        if self._to_end and not self.done:
            return None
        return self.number if self._wanted is None else self._wanted

    @property
    def ended(self) -> bool:
        """Whether the cursor is at the end of a whole run."""
        return self._at_end

    @property
    def seen(self) -> int:
        """The last step that was shown, of the stretch that is recorded."""
        return self._seen

    @property
    def step_number(self) -> int:
        """The step the cursor is in."""
        if not self.detail or self.steps is None:
            return self._position
        event = self.line_event
        return self.steps.step_of(event) if event >= 0 else 0

    def go_to_step(self, number: int) -> None:
        """Move to a step; in detail, to its last line."""
        if self.detail and self.steps is not None:
            self.go(self.steps.span(min(number, len(self.steps)))[1])
        else:
            self.go(number)

    @property
    def last_position(self) -> int:
        """The last position recorded so far."""
        if self.recording is None or self.steps is None:
            return 0
        if self.detail:
            return max(len(self.recording) - (not self.recording.complete), 0)
        return len(self.steps)

    @property
    def total_text(self) -> str:
        """How many positions there are: a number, or ``46+`` while nobody knows."""
        total = self.last_position + (0 if self.detail else self.passed)
        if not self.detail and self.total_steps is not None:
            return str(self.total_steps)
        finished = self.done and self.recording is not None and self.recording.complete
        return str(total) if finished or self.recording is None else f"{total}+"

    @property
    def number(self) -> int:
        """What the position is called: the step of the whole run, or in detail the line of the stretch."""
        return self._before_stretch + self._position

    @property
    def _before_stretch(self) -> int:
        """What is counted before the first position."""
        return 0 if self.detail else self.passed

    @property
    def line_event(self) -> int:
        """The line event shown; -1 when nothing is recorded."""
        if self.recording is None or self.steps is None or not len(self.recording):
            return -1
        if self.detail:
            return min(self._position, len(self.recording) - 1)
        return max(self.steps.span(self._position)[1], 0)

    @property
    def _at_end(self) -> bool:
        recording = self.recording
        if recording is None or not recording.complete:
            return False
        return self._position >= self.last_position if self.detail else self.line_event == len(recording) - 1

    @property
    def moment(self) -> Moment | None:
        """Line, variables and what was emitted at the cursor; at the end of the run, after its last line."""
        event = self.line_event
        if event < 0 or self.recording is None:
            return None
        moment = self.recording[event]
        if not self._at_end:
            return moment
        emitted = EmittedSoFar(self.recording.emitted, len(self.recording.emitted))
        variables = self.recording.after(event)
        return Moment(moment.line, moment.function, moment.depth, variables, emitted)

    @property
    def step(self) -> Step | None:
        """The step the cursor is in."""
        if self.recording is None or self.steps is None or not len(self.recording):
            return None
        return self.steps[min(self.step_number, len(self.steps))]

    @property
    def sentence(self) -> tuple[Part, ...]:
        """What is said at the cursor."""
        if self.steps is None or self.line_event < 0:
            return ()
        if self.detail and not self._at_end:
            return self.steps.told(self.line_event)
        step = self.step
        told = step.sentence if step else ()
        if step is None or step.number or not (before := self.before()):
            return told
        return (Part(f"{before} ", None), *told)

    def own_call(self, number: int | None = None) -> OwnCall | None:
        """How far the text's own call has come, at the cursor or at the end of a step; None where that is
        not recorded.
        """
        recording, steps, event = self.recording, self.steps, self.line_event
        if recording is None or steps is None or event < 0 or (number or 0) > len(steps):
            return None
        if number is None and self.detail:
            count = len(recording.emitted) if self._at_end else recording.emitted_count(event)
            return own_call(recording, event, event, count, self._at_end)
        step = steps[self._position if number is None else number]
        last = max(step.last, 0)
        over = recording.complete and last == len(recording) - 1
        return own_call(recording, max(step.first, 0), last, step.emitted_to, over)

    def marks(self, number: int | None = None) -> tuple[Mark, ...]:
        """What the algorithm draws at the cursor or at the end of a step, in the frame of its arguments."""
        call = self.own_call(number)
        if call is None or self.entry is None or self.steps is None:
            return ()
        of_block = (
            self.steps.marks_told(self.line_event)
            if number is None and self.detail and not self._at_end
            else self.steps[self.step_number if number is None else number].marks
        )
        own = self.entry.marks(self.calls[call.number], call.variables, call.emitted, call.ended)
        return (*own, *of_block)

    @property
    def variables(self) -> dict[str, Any]:
        """The variables at the cursor: those that a loop changes, then those that are set once."""
        moment, recording = self.moment, self.recording
        if moment is None or recording is None:
            return {}
        return in_order(recording, moment)

    @property
    def changed_names(self) -> frozenset[str]:
        """Variables that became others with this step, or in detail with the line before."""
        event = self.line_event
        if event < 0 or self.recording is None or self.steps is None:
            return frozenset()
        if self.detail and not self._at_end:
            return self.recording.changed(event)
        if self._position == 0:
            return frozenset()
        before = self.recording[event if self.detail else max(self.steps.span(self._position)[0], 0)]
        return differing(before, self.moment)

    @property
    def lines_run(self) -> frozenset[tuple[str, int]]:
        """(function, line) of what ran in this step; in detail the one line that runs next."""
        moment = self.moment
        if moment is None or self.recording is None or self.steps is None:
            return frozenset()
        if self.detail:
            return frozenset(((moment.function, moment.line),))
        first, last = self.steps.span(self._position)
        return self.recording.ran_between(first, min(last, first + _MOST_LINES) + 1)

    def image(self) -> NDArray[np.bool_]:
        """(height, width) which pixels were painted up to the cursor."""
        moment = self.moment
        if moment is None or self.entry is None or self.recording is None:
            return np.zeros(self.image_size[::-1], bool)
        step = None if self.detail else self.step
        count = len(moment.emitted) if step is None else step.emitted_to
        return painted(self.recording.emitted.array(0, count), self.entry.emits, self.image_size)

    # Moving it

    def go_to_number(self, number: int) -> None:
        """Move to a step of the whole run; where it is not recorded, record the stretch around it."""
        position = number if self.detail else number - self.passed
        beyond = position > self.last_position and self.goes_on
        if self.detail or not (beyond or (self.passed > 0 and position < 1)):
            self.go(position)
        else:
            self._wanted = number  # first: who is told of the stretch asks where it leads
            self._to_end = self._stays = False
            if self.record_around(number):
                position = self._seen = max(number - self.passed, 0)
                self._move_to(position)

    def stay_at(self, number: int) -> None:
        """Move to a step of the whole run; another input leaves it there, be it the last one now."""
        self.go_to_number(number)
        self._stays = True

    def go(self, position: int) -> None:
        """Move to ``position``, or as far as there is; further as soon as that is recorded."""
        beyond = position > self.last_position and not self.done
        self._wanted = position + self._before_stretch if beyond else None
        self._to_end = self._stays = False
        self._move_to(position)

    def _move_to(self, position: int) -> None:
        position = max(0, min(position, self._furthest()))
        if position != self._position:
            self._position = position
            if not self.detail:
                self._seen = max(self._seen, position)
            self.moved.emit()

    def _furthest(self) -> int:
        """The last position that may be shown."""
        return self.last_position

    def forward(self) -> None:
        """One step, or one line."""
        self.go_to_number(self.number + 1)

    def back(self) -> None:
        """One step, or one line, back."""
        self.go_to_number(self.number - 1)

    def first(self) -> None:
        """Before the first step."""
        self.go_to_number(0)

    def last(self) -> None:
        """To the end of the run, or as far as it is recorded, and to its end when that is known."""
        known = self._knows_end
        last = self._before_stretch + self.last_position
        self.go_to_number(max(last, self.total_steps or 0) if known and not self.detail else last)
        self._to_end = not known

    def set_detail(self, detail: bool) -> None:
        """Count lines, or rows of the hand table; the cursor stays in its step."""
        if detail == self.detail:
            return
        event = self.line_event
        end = self._at_end
        self.detail = detail
        self._wanted = None
        if self.steps is None or event < 0:
            self._position = 0
        elif detail:
            self._position = self.last_position if end else event
        else:
            self._position = self.steps.step_of(event)
            self._seen = max(self._seen, self._position)  # what was seen in detail was seen
        self.moved.emit()

    def run_to_line(self, line: int, function: str = "") -> bool:
        """Go to where this line of the source file runs next; False, and no move, when it does not."""
        if self.recording is None or self.steps is None:
            return False
        event = event_on_line(self.recording, self.line_event + 1, line, function)
        if event is None:
            return False
        before = self._position
        self.go(event if self.detail else self.steps.step_of(event))
        return self._position != before

    def run_to_pixel(self, x: int, y: int) -> bool:
        """Go to the next step that emits pixel (x, y), or else the first; False when none does."""
        if self.recording is None or self.steps is None or self.entry is None:
            return False
        target = event_touching(self.recording, self.entry.emits, self.line_event, x, y)
        if target is None:
            return False
        self.go(target + 1 if self.detail else self.steps.step_of(target))
        return True
