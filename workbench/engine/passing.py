"""What a recorder does before the stretch that it is to write down: it runs, and counts steps."""

from collections.abc import Callable, Iterable, Mapping
from dis import opmap
from inspect import CO_GENERATOR
from types import FrameType
from typing import Any, NamedTuple

from workbench.engine.effects import Effects
from workbench.engine.recording import Recording

YIELD = opmap["YIELD_VALUE"]
_SLICE = 2048


class Skip(NamedTuple):
    """What is run but not written down: everything before step ``steps`` + 1 is entered.

    ``blocks`` gives for each recorded text the number of the viewed block that a line is in, ``rows`` tells
    of each block whether its visits are steps.
    """

    steps: int
    blocks: tuple[Mapping[int, int], ...]
    rows: tuple[bool, ...]


class Known:
    """One text, prepared for the trace function."""

    __slots__ = ("bytecode", "effects", "entry", "everything", "generator", "number", "otherwise")

    def __init__(self, recording: Recording, number: int) -> None:
        text = recording.texts[number]
        self.number = number
        self.effects = dict(text.effects)
        self.otherwise = text.otherwise
        self.entry = Effects(text.parameters, (), ())
        self.everything = Effects(text.names, (), ())
        self.generator = bool(text.code.co_flags & CO_GENERATOR)
        self.bytecode = text.code.co_code


class Passing:
    """The trace functions until recording begins: they count steps, and write nothing down."""

    def __init__(
        self,
        skip: Skip,
        known: Callable[[FrameType], Known | None],
        refuse_depth: Callable[[int, Known], None],
        pause: Callable[[], None] | None,
        begin: Callable[[Iterable[tuple[FrameType, int]]], None],
    ) -> None:
        self._skip = skip
        self._known, self._refuse_depth, self._pause, self._begin_with = known, refuse_depth, pause, begin
        self._traces: dict[FrameType, Any] = {}
        self._stack: list[FrameType] = []
        self._blocks: dict[FrameType, int] = {}
        self._lines = 0
        self.steps = 0

    def call(self, frame: FrameType, event: str, arg: Any) -> Any:
        """The global trace function: a call, or a generator resumed."""
        trace = self._traces.get(frame)
        if trace is None:
            known = self._known(frame)
            if known is None:
                return None
            self._refuse_depth(len(self._stack), known)
            trace = self._traces[frame] = self._local_trace(known)
        self._stack.append(frame)
        return trace

    def _local_trace(self, known: Known) -> Any:
        block_of, rows = self._skip.blocks[known.number].get, self._skip.rows
        generator, bytecode = known.generator, known.bytecode
        last = -1

        def trace(frame: FrameType, event: str, arg: Any) -> Any:
            nonlocal last
            if event == "line":
                self._lines += 1
                if not self._lines % _SLICE and self._pause is not None:
                    self._pause()
                block = block_of(frame.f_lineno, -1)
                if block != last:
                    last = self._blocks[frame] = block
                    if block >= 0 and rows[block]:
                        if self.steps == self._skip.steps:
                            self._blocks[frame] = -1
                            return self._begin(frame)(frame, event, arg)
                        self.steps += 1
            elif event == "return":
                self._stack.pop()
                if not (generator and bytecode[frame.f_lasti] == YIELD):
                    self._traces.pop(frame, None)
                    self._blocks.pop(frame, None)
            return trace

        return trace

    def _begin(self, frame: FrameType) -> Any:
        self._begin_with([(each, self._blocks.get(each, -1)) for each in self._stack])
        self._traces.clear()
        self._blocks.clear()
        self._stack = []
        return frame.f_trace
