"""What is drawn of a seed fill: what is still to be done, and where it goes on."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import CALLS
from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke, along


def stack_marks(
    _arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The pixels on the stack, the one that is taken next ringed."""
    waiting = now.get("stack", ())
    for x, y in waiting[-MOST_SPOTS:]:
        yield Spot(float(x), float(y), "text", "dot", "pixel")
    yield from _next(waiting)


def call_marks(
    _arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The way from the seed along the calls under way, the present one ringed."""
    path = [(float(call["x"]), float(call["y"])) for call in now.get(CALLS, ())]
    if len(path) > 1:
        yield Stroke(along(*path), "text", "pixel")
    yield from _next(path)


def span_marks(
    _arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The spans on the stack, each on the row that is to be looked at from it."""
    for y, left, right, _step in now.get("stack", ())[-MOST_SPOTS:]:
        yield Stroke(along((left, y), (right, y)), "data5", "medium", "dot")


def _next(waiting: Sequence[Sequence[float]]) -> Iterator[Mark]:
    if waiting:
        x, y = waiting[-1]
        yield Spot(float(x), float(y), "text", "ring", "large")
