"""What the views of the clipping texts show: codes as four bits, crossings and vertices as pixels."""

import math
from collections.abc import Iterable, Sequence

from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, intersection, region_code
from workbench.algorithms.counted import Counted
from workbench.algorithms.entry import View
from workbench.geometry.conventions import round_half_up

Point = tuple[float, float]
Pixel = tuple[int, int]
End = tuple[float, float, int]

_EDGE_NAMES = {TOP: "top", BOTTOM: "bottom", RIGHT: "right", LEFT: "left"}
_EDGE_SYMBOLS = {TOP: "yₘₐₓ", BOTTOM: "yₘᵢₙ", RIGHT: "xₘₐₓ", LEFT: "xₘᵢₙ"}


def bits(code: int) -> str:
    """A region code as the course writes it: top, bottom, right, left."""
    return f"{code:04b}"


def edge_name(edge: int) -> str:
    """What the course calls an edge, given as its bit."""
    return _EDGE_NAMES[edge]


def edge_symbol(edge: int) -> str:
    """The coordinate of an edge, given as its bit, as the course writes it."""
    return _EDGE_SYMBOLS[edge]


def pixels(points: Iterable[Sequence[float]]) -> tuple[Pixel, ...]:
    """The pixel nearest to each point, each once."""
    finite = [point for point in points if all(map(math.isfinite, point))]
    return tuple(dict.fromkeys((round_half_up(x), round_half_up(y)) for x, y in finite))


def others(found: Iterable[Pixel], chosen: Iterable[Pixel]) -> tuple[Pixel, ...]:
    """What was found and not chosen."""
    taken = set(chosen)
    return tuple(pixel for pixel in found if pixel not in taken)


def crossings(end_0: End, end_1: End, window: tuple[float, float, float, float]) -> tuple[Pixel, ...]:
    """Where the line crosses each edge that just one of its ends, (x, y, code), is beyond."""
    x0, y0, code_0 = end_0
    x1, y1, code_1 = end_1
    crossed = [edge for edge in _EDGE_NAMES if (code_0 ^ code_1) & edge]
    return pixels(intersection(x0, y0, x1, y1, edge, *window) for edge in crossed)


def met(side: tuple[Point, Point], edge: int, window: tuple[float, float, float, float]) -> tuple[Pixel, ...]:
    """What a side of a polygon may hand on at an edge: its crossing, if it has one, and its end."""
    start, end = side
    crosses = (region_code(*start, *window) ^ region_code(*end, *window)) & edge
    found = [intersection(*start, *end, edge, *window)] if crosses else []
    return pixels([*found, end])


def output(points: Sequence[Point]) -> object:
    """What a side handed on, for the hand table: nothing, a point, or two."""
    return points[0] if len(points) == 1 else tuple(points) or ""


INTERSECTIONS = {"Intersections": Counted("Intersection", ("Find the intersection",))}


def _intersection_view(when: str, given: str, found: str) -> View:
    """The arithmetic of ``intersection``: ``found`` where ``given`` is that of the edge."""
    return View(
        block="Find the intersection",
        when=when,
        sentence=f"{given} = {{{given}}}, {found} = {{{found}0}} + ({{{found}1}} − {{{found}0}})"
        f"({{{given}}} − {{{given}0}})/({{{given}1}} − {{{given}0}}) = {{{found}}}.",
    )


INTERSECTION_VIEWS = (
    _intersection_view("edge >= 4", "y", "x"),
    _intersection_view("True", "x", "y"),
)
