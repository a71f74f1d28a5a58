"""What the inside-outside test shows of its blocks."""

from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.geometry.conventions import round_half_up


def end_points(vertices: NDArray[Any], low: int, high: int) -> tuple[float, ...]:
    """Both ends of an edge, the lower one first."""
    return tuple(float(value) for vertex in (low, high) for value in vertices[vertex, :2])


def nearest_pixel(x: float, y: float) -> tuple[tuple[int, int], ...]:
    """The pixel that shows a point."""
    return ((round_half_up(x), round_half_up(y)),)


COLUMNS = ("edge", "x_1", "y_1", "x_2", "y_2", "x where crossed", "crossings", "winding")

_EDGE = "(k, *end_points(vertices, low, high)"
_X = "x_low + (y - y_low) / (y_high - y_low) * (x_high - x_low)"
_TEST = "Does the ray cross it?"
_DECIDE = "Decide"
_OPTIONS = "('crosses', 'misses')"


def _missed(when: str, sentence: str) -> View:
    """An edge that the ray does not cross."""
    return View(
        block=_TEST,
        when=when,
        row=f"{_EDGE}, '', crossings, winding)",
        sentence=sentence,
        options=_OPTIONS,
        answer="'misses'",
    )


def _verdict(when: str, sentence: str) -> View:
    return View(block=_DECIDE, when=when, sentence=sentence)


VIEWS = (
    View(
        block=_TEST,
        when="crosses",
        chosen=f"nearest_pixel({_X}, y)",
        row=f"{_EDGE}, {_X}, crossings, winding)",
        sentence=f"Edge {{k}} crosses the ray at x = {{{_X}}}, right of {{x}}, as y_low = {{y_low}} <= {{y}} "
        "< {y_high} = y_high: crossings {crossings}, winding number {winding}.",
        options=_OPTIONS,
        answer="'crosses'",
    ),
    _missed(
        "y_low == y_high",
        "Edge {k} runs along the row y = {y_low}: it is left to its neighbours, and not counted.",
    ),
    _missed(
        "y == y_high",
        "Edge {k} has its upper end on the ray's row: the vertex is counted with the edge that goes on "
        "upwards, if one does.",
    ),
    _missed(
        "y < y_low or y > y_high", "Edge {k}, from y = {y_low} to {y_high}, does not reach the row y = {y}."
    ),
    _missed("side == 0.0", "Edge {k} goes through the point itself: it is not right of it, and not counted."),
    _missed("True", f"Edge {{k}} crosses the row at x = {{{_X}}}, left of the point: the ray misses it."),
    _verdict(
        "on_boundary",
        "The point is on the boundary, which closed takes in. With {crossings} "
        "{'crossing' if crossings == 1 else 'crossings'} and winding number {winding}, half-open decides "
        "by the count alone.",
    ),
    _verdict(
        "crossings % 2 == 1 and winding != 0",
        "{crossings} {'crossing' if crossings == 1 else 'crossings'}, an odd number: inside by even-odd. "
        "Winding number {winding}, not zero: inside by nonzero.",
    ),
    _verdict(
        "winding != 0",
        "{crossings} crossings, an even number: outside by even-odd. Winding number {winding}, not zero: "
        "inside by nonzero.",
    ),
    _verdict(
        "True",
        "{crossings} crossings, an even number: outside by even-odd. Winding number 0: outside by nonzero.",
    ),
)
