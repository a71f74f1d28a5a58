"""The recording of one subject's run, made in the background and watched from the event loop."""

import weakref
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from workbench.algorithms.entry import Entry
from workbench.document.subjects import Subject
from workbench.engine import compiled, counts
from workbench.engine.containers import same
from workbench.engine.observation import Steps
from workbench.engine.recorder import LIMIT, Recorder
from workbench.engine.recording import Recording
from workbench.engine.visits import skip
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import kind_of
from workbench.session.answers import Answers
from workbench.session.going_first import go_first

DEPTH_LIMIT = 1000
_LOOK_MS = 16
_LONG_LOOK_MS = 60
_FIRST_WAIT_S = 0.003
_FIRST_LOOK_MS = 2
_LONG = 50_000
# A stretch begins this part of a stretch before the step that is asked for, and never more steps before it.
_LEAD = 10
_MOST_LEAD = 1_000


class RecordedRun(QObject):
    """Records ``entry`` on ``calls``, those of ``subject``, and says how far that is.

    ``changed``: another run, another stretch of it, or none. ``grown``: more was recorded, or the total
    became known. A run too long to be recorded whole is recorded in a stretch: ``passed`` steps ran
    before it.
    """

    changed = Signal()
    grown = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.entry: Entry | None = None
        self.calls: tuple[tuple[Any, ...], ...] = ()
        self.subject: Subject | None = None
        self.invitation = kind_of(Subject()).invitation
        self.image_size = (0, 0)
        self.recording: Recording | None = None
        self.steps: Steps | None = None
        self.total_steps: int | None = None
        self.limit = LIMIT
        self.depth_limit = DEPTH_LIMIT
        self._held = False
        self._deferred: Callable[[], None] | None = None
        self._recorder: Recorder | None = None
        self._begun = False
        self._abandoned: weakref.finalize[..., Any] | None = None
        self._counting: compiled.Stop | None = None
        self._look = QTimer(self)
        self._look.timeout.connect(self._look_again)
        self._totals = Answers(self)
        self._totals.arrived.connect(self._take_total)

    # Which run

    def follow(self, subject: Subject, calls: Sequence[Call], image_size: tuple[int, int]) -> None:
        """Run the ``calls`` of a subject, those of the first one's entry; none without calls.

        The same run goes on as it is. The cursor stays where it was when subject and entry are the same, be
        it under other arguments; array arguments are copied. While the run is held, as under a drag, this
        waits and only the last of such calls is followed.
        """
        if not calls:
            self.clear(kind_of(subject).invitation)
            return
        if self._held:
            self._deferred = partial(self.follow, subject, calls, image_size)
            return
        entry, depth_limit = calls[0].entry, calls[0].recursion_limit or DEPTH_LIMIT
        same = subject.is_of(self.subject) and self.entry is entry
        limits = self.image_size == image_size and self.depth_limit == depth_limit
        if same and limits and self.runs(calls):
            self.subject = subject
            return
        self._leaving(same)
        self._forget()
        self.entry, self.calls, self.subject, self.image_size = entry, _first_run(calls), subject, image_size
        self.depth_limit = depth_limit
        self._record(entry, 0)

    def runs(self, calls: Sequence[Call]) -> bool:
        """Whether these are what it runs; while it is held, or not told of a change yet, it runs what was."""
        return bool(calls) and calls[0].entry is self.entry and _equal(_first_run(calls), self.calls)

    def follow_unheld(
        self, subject: Subject, calls: Callable[[], Sequence[Call]], image_size: tuple[int, int]
    ) -> None:
        """As ``follow``; while the run is held, what the ``calls`` would be is not even worked out."""

        def follow() -> None:
            self.follow(subject, calls(), image_size)

        if self._held:
            self._deferred = follow
        else:
            follow()

    def _record(self, entry: Entry, passed: int) -> None:
        copies = [tuple(a.copy() if isinstance(a, np.ndarray) else a for a in call) for call in self.calls]
        self._recorder = Recorder(
            entry.function,
            *copies[0],
            limit=self.limit,
            depth_limit=self.depth_limit,
            then=copies[1:],
            skip=skip(entry, passed),
        )
        self.recording = self._recorder.recording
        self.steps = Steps(entry, self.recording)
        self._abandoned = weakref.finalize(self, self._recorder.stop)
        go_first()
        self._begun = self._recorder.start()
        # What can be had at once is shown at once: views are laid out and painted one time instead of two.
        self._recorder.wait_for_first(_FIRST_WAIT_S)
        self.steps.update()
        self._look.start(_FIRST_LOOK_MS)
        self.changed.emit()

    def clear(self, invitation: str = "") -> None:
        """No run; ``invitation`` is what to do to have one."""
        self._deferred = None
        if self.entry is None and invitation == self.invitation:
            return
        self.invitation = invitation
        if self.entry is not None:
            self._leaving(False)
            self._forget()
            self.entry, self.calls, self.subject = None, (), None
        self.changed.emit()

    # A stretch of it

    @property
    def passed(self) -> int:
        """How many steps ran before the stretch that is recorded; 0 when it is recorded from its start."""
        return self.recording.steps_before if self.recording is not None else 0

    @property
    def in_stretches(self) -> bool:
        """Whether the run is longer than what is recorded of it at once."""
        return self.passed > 0 or (self.recording is not None and self.recording.truncated)

    @property
    def goes_on(self) -> bool:
        """Whether there are steps behind the stretch that is recorded."""
        return self.done and self.recording is not None and self.recording.truncated

    def record_around(self, number: int) -> bool:
        """Record another stretch, with step ``number`` and some of those before it; False while held."""
        if self.entry is None or self.steps is None or self._held:
            return False
        number = max(1, min(number, self.total_steps or number))
        lead = min(len(self.steps) // _LEAD, _MOST_LEAD)
        total, entry = self.total_steps, self.entry
        self._leaving(True)
        self._forget()
        self.total_steps = total
        self._record(entry, max(number - 1 - lead, 0))
        return True

    def _leaving(self, same: bool) -> None:
        """Another run follows, of the ``same`` subject and entry or not."""

    def _recorded(self, done: bool) -> None:
        """More was recorded, or it is done."""

    def _forget(self) -> None:
        if self._abandoned is not None:
            self._abandoned()
        if self._counting is not None:
            self._counting.set()
        self._recorder = self._abandoned = self._counting = None
        self._look.stop()
        self.recording = self.steps = self.total_steps = None

    @property
    def arguments(self) -> tuple[Any, ...]:
        """Device arguments of the first call; () without a run."""
        return self.calls[0] if self.calls else ()

    # Recording

    def hold(self) -> None:
        """Let the recording wait, as while the mouse is pressed."""
        self._held = True
        if self._recorder is not None:
            self._recorder.hold()

    def go_on(self) -> None:
        """End the wait."""
        self._held = False
        if self._recorder is not None:
            self._recorder.go_on()
        if self._deferred is not None:
            deferred, self._deferred = self._deferred, None
            deferred()

    def stop(self) -> None:
        """Record no further; what is recorded stays."""
        if self._recorder is not None:
            self._recorder.stop()

    @property
    def done(self) -> bool:
        """Whether all there will be is recorded and looked at."""
        return not self._look.isActive()

    def _look_again(self) -> None:
        recorder = self._recorder
        if recorder is None or self.steps is None:
            self._look.stop()
            return
        if not self._begun:  # the system gave no thread
            self._begun = recorder.start()
            return
        done = recorder.done
        if not done and self.passed and not recorder.recording.count:
            self._look.setInterval(_LONG_LOOK_MS)  # what comes before the stretch: nothing to be shown yet
            return
        go_first()
        long = recorder.recording.count > _LONG
        self._look.setInterval(_LONG_LOOK_MS if long else _LOOK_MS)
        self.steps.update()
        if done:
            self._look.stop()
            if recorder.recording.complete:
                self.total_steps = self.passed + len(self.steps)
            if not recorder.recording.complete:
                self._find_total()
            elif self.passed and not len(recorder.recording):
                self.record_around(self.passed)
                return
        elif long:
            self._find_total()
        self.grown.emit()
        self._recorded(done)

    def _find_total(self) -> None:
        """Ask the compiled reading for the number of steps, on another thread, if it needs no compilation."""
        entry, calls = self.entry, self.calls
        if entry is None or entry.compiles or self.total_steps is not None or self._counting is not None:
            return
        stop = self._counting = compiled.Stop()
        self._totals.ask(partial(_total, entry, calls, stop), "count steps", stop.set)

    def _take_total(self, answer: tuple[compiled.Stop, int]) -> None:
        counting, total = answer
        if counting is self._counting:
            self.total_steps = total
            self.grown.emit()

    @property
    def message(self) -> str:
        """One sentence when the run did not come to its end, else ""."""
        recording = self.recording
        if recording is None:
            return ""
        if recording.truncated:
            return _(
                "The run is longer than {limit:,} lines; steps {first:,} to {last:,} are recorded. Type "
                "another step, and the run is recorded from there."
            ).format(
                limit=self.limit,
                first=self.passed + bool(self.passed),
                last=self.passed + (len(self.steps) if self.steps else 0),
            )
        if recording.error is not None:
            if recording.error.overflow:
                return _("The recursion overflowed {depth} calls deep, in line {line}.").format(
                    depth=recording.error.depth, line=recording.error.line
                )
            return _("The run stopped: {error}.").format(error=recording.error)
        return ""


def _total(
    entry: Entry, calls: tuple[tuple[Any, ...], ...], stop: compiled.Stop
) -> tuple[compiled.Stop, int] | None:
    if not compiled.available() or not _counting_is_ready(entry):
        return None
    with suppress(compiled.Stopped):
        return stop, sum(counts.step_total(entry, *call, stop=stop, compiling=False) for call in calls)
    return None


def _counting_is_ready(entry: Entry) -> bool:
    try:
        kernel = compiled.kernel(entry.function, None, "", "counting")
    except ValueError:
        return False
    return any(use.startswith("count") for use in kernel.known())


def _first_run(calls: Sequence[Call]) -> tuple[tuple[Any, ...], ...]:
    """The arguments of those calls that are of the first one's entry."""
    return tuple(call.arguments for call in calls if call.entry is calls[0].entry)


def _equal(a: Sequence[tuple[Any, ...]], b: Sequence[tuple[Any, ...]]) -> bool:
    return len(a) == len(b) and all(
        len(x) == len(y) and all(map(same, x, y)) for x, y in zip(a, b, strict=True)
    )
