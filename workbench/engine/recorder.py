"""Runs a text line by line and writes down every state: the only place that traces.

Each line that is about to run is an *event*. What the line before it can have changed is known from the
syntax (``effects``), so only that is looked at, and only what did change is kept (``columns``,
``containers``). A value at any event is then found by bisection, nothing is run again.

A generator's frame sees a ``call`` at each resume and a ``return`` at each yield; only the code of the
entry and of the functions it can call are followed.
"""

import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from inspect import CO_GENERATOR
from types import CodeType, FrameType, TracebackType
from typing import Any

from workbench.engine import background
from workbench.engine.arguments import for_recording
from workbench.engine.columns import MISSING, Column
from workbench.engine.containers import Containers, Log, is_fixed
from workbench.engine.effects import Effects, texts_of
from workbench.engine.limited import frames
from workbench.engine.passing import YIELD, Known, Passing, Skip
from workbench.engine.recording import Failure, Recording
from workbench.engine.turns import interface, short_turns

LIMIT = 1_000_000
_SLICE = 512
_NUMBERS = frozenset((int, float, bool, type(None)))
_NO_GLOBALS: dict[str, Any] = {}


class _Ended(BaseException):
    """Raised from the trace function to leave a run; ``truncated`` when it reached the limit."""

    def __init__(self, truncated: bool) -> None:
        self.truncated = truncated


class _Call:
    """One call under way."""

    __slots__ = ("depth", "number", "trace")

    def __init__(self, number: int, depth: int) -> None:
        self.number = number
        self.depth = depth
        self.trace: Any = None


class _Tracer:
    """Holds what the trace functions of one run share. ``pause`` is called every ``_SLICE`` events."""

    def __init__(
        self,
        recording: Recording,
        limit: int,
        depth_limit: int | None,
        pause: Callable[[], None] | None,
        skip: Skip | None = None,
    ) -> None:
        self.recording = recording
        recording.steps_before = skip.steps if skip else 0
        self._texts: dict[CodeType, Known] = {
            text.code: Known(recording, number) for number, text in enumerate(recording.texts)
        }
        self._limit = limit
        self.depth_limit = depth_limit
        self._pause = pause
        self._next_check = min(limit, _SLICE) if pause else limit
        self._calls: dict[FrameType, _Call] = {}
        self._stack: list[_Call] = []
        self._containers = Containers()
        self.overflow = False
        self._passing = (
            Passing(skip, lambda frame: self._texts.get(frame.f_code), self.refuse_depth, pause, self.begin)
            if skip and skip.steps
            else None
        )

    @property
    def first(self) -> Callable[[FrameType, str, Any], Any]:
        """The global trace function to begin with."""
        return self._passing.call if self._passing else self.call

    def call(self, frame: FrameType, event: str, arg: Any) -> Any:
        """The global trace function: a call, or a generator resumed."""
        known = self._texts.get(frame.f_code)
        if known is None:
            return None
        call = self._calls.get(frame) or self._open(frame, known)
        self._stack.append(call)
        return call.trace

    def begin(self, under_way: Iterable[tuple[FrameType, int]]) -> None:
        """Record from here on; ``under_way`` are the calls there are, with the block that each is in."""
        sys.settrace(self.call)
        for frame, block in under_way:
            known = self._texts[frame.f_code]
            call = self._open(frame, known, under_way=True)
            self._stack.append(call)
            self.recording.begun_in.append(block)
            self.recording.begun_at.append(frame.f_lineno)
            frame.f_trace = call.trace

    def refuse_depth(self, depth: int, known: Known) -> None:
        """Raise RecursionError for a text that nests too deep; what it only asks ends before the next."""
        if self.depth_limit is not None and depth > self.depth_limit and known.generator:
            self.overflow = True
            raise RecursionError(f"the calls are more than {self.depth_limit} deep")

    def _open(self, frame: FrameType, known: Known, under_way: bool = False) -> _Call:
        recording = self.recording
        parent = self._stack[-1] if self._stack else None
        depth = parent.depth + 1 if parent else 0
        self.refuse_depth(depth, known)
        call = _Call(len(recording.frame_starts), depth)
        recording.frame_texts.append(known.number)
        recording.frame_depths.append(depth)
        recording.frame_parents.append(parent.number if parent else -1)
        recording.frame_ends.append(0)
        recording.frame_starts.append(2 * recording.count)
        fresh = not under_way and self._may_have_changed(frame.f_back)
        call.trace = self._local_trace(call, known, fresh, frame if under_way else None)
        self._calls[frame] = call
        return call

    def _may_have_changed(self, caller: FrameType | None) -> bool:
        """Whether the line that makes a call can have changed a container before the call."""
        known = self._texts.get(caller.f_code) if caller is not None else None
        if known is None or caller is None:
            return True
        effects = known.effects.get(caller.f_lineno, known.otherwise)
        return effects is not None and bool(effects.tails or effects.touches or effects.stores)

    def _local_trace(self, call: _Call, known: Known, fresh: bool, under_way: FrameType | None) -> Any:
        """The trace function of one call; a closure, since this runs once per line."""
        recording, number = self.recording, call.number
        add_line, add_frame = recording.line_column.append, recording.frame_column.append
        columns = recording.columns(call.depth, known.number)
        containers, look = self._containers, self._look
        effects_of, otherwise = known.effects.get, known.otherwise
        generator, bytecode = known.generator, known.bytecode
        seen: dict[str, Any] = {}
        logs: dict[str, Log] = {}
        pending: Effects | None = known.entry
        if under_way is not None:
            look(under_way.f_locals, known.everything, 0, columns, seen, logs, fresh)
            pending = effects_of(under_way.f_lineno, otherwise)

        def trace(frame: FrameType, event: str, arg: Any) -> Any:
            nonlocal pending, fresh
            if event == "line":
                count = recording.count
                if pending is not None:
                    look(frame.f_locals, pending, 2 * count, columns, seen, logs, fresh)
                    fresh = False
                line = frame.f_lineno
                if count >= self._next_check:
                    self._check(count)
                pending = effects_of(line, otherwise)
                add_line(line)
                add_frame(number)
                recording.count = count + 1
            elif event == "return":
                self._stack.pop()
                if not (generator and bytecode[frame.f_lasti] == YIELD):
                    stamp = max(2 * recording.count - 1, 0)
                    if pending is not None:
                        look(frame.f_locals, pending, stamp, columns, seen, logs, fresh)
                    recording.frame_ends[number] = stamp
                    for log in logs.values():
                        containers.release(log)
                    self._calls.pop(frame, None)
                    call.trace = None
            return call.trace

        return trace

    def _look(
        self,
        variables: dict[str, Any],
        effects: Effects,
        stamp: int,
        columns: dict[str, Column],
        seen: dict[str, Any],
        logs: dict[str, Log],
        fresh: bool,
    ) -> None:
        """Write down what a line with these effects has changed."""
        containers = self._containers
        for name, pops in effects.tails:
            if name in variables:
                containers.tail(variables[name], stamp, pops)
        for name, index in effects.stores:
            if name in variables:
                try:
                    place = eval(index, _NO_GLOBALS, variables)
                except Exception:
                    place = None
                containers.store(variables[name], stamp, place)
        for name in effects.touches:
            value = variables.get(name)
            if type(value) not in _NUMBERS:
                containers.touch(value, stamp)
        for name in effects.binds:
            value = variables.get(name, MISSING)
            old = seen.get(name, MISSING)
            if value is old:
                continue
            seen[name] = value
            kind = type(value)
            if kind in _NUMBERS or is_fixed(value):
                if kind is type(old) and value == old:
                    continue
                held = value
            else:
                held = containers.bind(value, stamp, fresh)
            columns[name].put(stamp, held)
            if logs and name in logs:
                containers.release(logs.pop(name))
            if isinstance(held, Log):
                logs[name] = held

    def let_go(self) -> None:
        """Let go of the calls that a run was left in, cycles that would keep all that is recorded."""
        for call in self._calls.values():
            call.trace = None
        self._calls.clear()
        self._stack.clear()

    def finish(self) -> None:
        """The run came to its end; where it has fewer steps than were to be passed, say how many."""
        if self._passing is not None and not self.recording.count:
            self.recording.steps_before = self._passing.steps

    def _check(self, count: int) -> None:
        if count >= self._limit:
            raise _Ended(truncated=True)
        if self._pause is not None:
            self._pause()
            self._next_check = min(self._limit, count + _SLICE)

    def failure(self, exception: BaseException) -> Failure:
        """Where ``exception`` came from: the last line of ours in its traceback."""
        recording = self.recording
        line, function, depth = 0, "", -1
        walk: TracebackType | None = exception.__traceback__
        while walk is not None:
            known = self._texts.get(walk.tb_frame.f_code)
            if known is not None:
                line, function = walk.tb_lineno, recording.texts[known.number].name
                depth += 1
            if known is None or not self.overflow or depth < (self.depth_limit or 0):
                walk = walk.tb_next
            else:
                break
        return Failure(exception, line, function, depth, isinstance(exception, RecursionError))


@contextmanager
def _tracing(trace: Any) -> Iterator[None]:
    before = sys.gettrace()
    sys.settrace(trace)
    try:
        yield
    finally:
        sys.settrace(before)


def _run(tracer: _Tracer, function: Callable[..., Any], calls: Iterable[tuple[Any, ...]]) -> None:
    recording = tracer.recording
    add = recording.emitted.add
    generator = recording.texts[0].code.co_flags & CO_GENERATOR
    try:
        with _tracing(tracer.first):
            for args in calls:
                recording.begin_call()
                running = function(*args)
                if not generator:
                    recording.result = running
                    continue
                for item in running:
                    add(item if isinstance(item, tuple) else (item,), recording.count)
        tracer.finish()
        recording.complete = True
    except _Ended as ended:
        recording.truncated = ended.truncated
    except Exception as exception:
        recording.error = tracer.failure(exception)
        exception.__traceback__ = None
    finally:
        tracer.let_go()


def record(
    function: Callable[..., Any],
    *args: Any,
    limit: int = LIMIT,
    depth_limit: int | None = None,
    skip: Skip | None = None,
) -> Recording:
    """Run ``function`` to its end, or to ``limit`` line events, and return what happened.

    What ``skip`` passes over is run, and what it emits is kept, but none of its lines is recorded.

    Nothing that the text raises leaves this function: it is in ``Recording.error``. ``depth_limit`` is the
    deepest call allowed (the entry is 0); beyond it RecursionError is raised where the call was made.
    Pictures among the arguments are written in place where the text does so. Raises TypeError when
    ``function`` is not a Python function.
    """
    recording = Recording(texts_of(function))
    given = for_recording(function, args)
    _run(_Tracer(recording, limit, depth_limit, None, skip), function, (given,))
    return recording


class Recorder:
    """Records on a thread of its own, in slices, so that an interface stays free; ``hold`` makes it wait.

    ``then`` are the arguments of further calls, which are recorded behind the first. ``skip`` is as in
    ``record``.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        *args: Any,
        limit: int = LIMIT,
        depth_limit: int | None = None,
        then: Iterable[tuple[Any, ...]] = (),
        skip: Skip | None = None,
    ) -> None:
        self.recording = Recording(texts_of(function))
        self._may_run = threading.Event()
        self._may_run.set()
        self._begun = threading.Event()
        self._stopped = False
        tracer = _Tracer(self.recording, limit, depth_limit, self._pause, skip)
        calls = [for_recording(function, call) for call in (args, *then)]
        work = partial(self._run, tracer, function, calls)
        self._thread = background.Thread(work, f"record {function.__name__}", self.stop)

    def _run(self, tracer: _Tracer, function: Callable[..., Any], calls: Iterable[tuple[Any, ...]]) -> None:
        try:
            with short_turns, frames.for_depth(tracer.depth_limit or 0):
                _run(tracer, function, calls)
        finally:
            self._begun.set()

    def _pause(self) -> None:
        self._begun.set()
        time.sleep(0.0002)
        interface.wait()
        self._may_run.wait()
        if self._stopped:
            raise _Ended(truncated=False)

    def start(self) -> bool:
        """Begin; False when the system gives no more threads now."""
        with suppress(RuntimeError), background.large_stacks():
            self._thread.start()
            return True
        return False

    def wait_for_first(self, timeout: float) -> None:
        """Wait until the first slice is recorded, or all there is; at most ``timeout`` seconds."""
        self._begun.wait(timeout)

    def hold(self) -> None:
        """Wait at the end of the slice, until ``go_on``."""
        self._may_run.clear()

    def go_on(self) -> None:
        """End the wait."""
        self._may_run.set()

    def stop(self) -> None:
        """Leave the run at the end of the slice; what is recorded stays readable."""
        self._stopped = True
        self._may_run.set()

    def join(self, timeout: float | None = None) -> bool:
        """Wait for the end; False when it did not come within ``timeout`` seconds."""
        self._thread.join(timeout)
        return self.done

    @property
    def done(self) -> bool:
        """Whether nothing more will be recorded."""
        return self._thread.ended

    @property
    def error(self) -> Failure | None:
        """What the run raised."""
        return self.recording.error
