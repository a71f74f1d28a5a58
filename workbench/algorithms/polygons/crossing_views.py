"""What the fill by crossings shows of its blocks."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import Mark
from workbench.algorithms.polygons.row_crossings import Crossing
from workbench.algorithms.polygons.scan_line_marks import row_marks
from workbench.algorithms.polygons.scan_line_words import (
    VERTEX_RULE,
    listed,
    not_among,
    row_of_box,
    row_spans,
    span_pixels,
    spans_text,
    vertices_on,
)

_FIND = "Find all crossings of the row with the edges"
_SORT = "Sort the crossings from left to right"
_FILL = "Fill between each pair of crossings"
_SPANS = "row_spans(scan_line_crossings, vertices, ring_ends, closed, nonzero, y)"
_CHOSEN = f"span_pixels({_SPANS}, y)"
_CANDIDATES = "row_of_box(vertices, y)"
_XS = "listed(crossed(crossings))"
_TABLES = {
    "Crossings of the row": ("[tuple(each) for each in crossings]", ("x", "x at its end", "winding")),
}


def crossed(crossings: Sequence[Crossing]) -> list[float]:
    """Where edges cross the row; those that lie along it do not."""
    return [crossing.x for crossing in crossings if crossing.winding != 0]


def pairs(crossings: Sequence[Crossing]) -> str:
    """The crossings two by two: (3.5, 6.5), (8, 9)."""
    xs = [listed([x]) for x in crossed(crossings)]
    return listed([f"({a}, {b})" for a, b in zip(xs[::2], xs[1::2], strict=False)])


def marks(
    _arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The scan line, its spans so far, its crossings with their x."""
    if "crossings" in now:
        yield from row_marks(now["y"], sorted(crossed(now["crossings"])), emitted)


def _crossed(when: str, sentence: str) -> View:
    return View(
        block=_FIND,
        when=when,
        candidates=_CANDIDATES,
        chosen=_CHOSEN,
        rejected=f"not_among({_CANDIDATES}, {_CHOSEN})",
        row=f"(y, listed(sorted(crossed(crossings))), spans_text({_SPANS}), len({_CHOSEN}))",
        tables=_TABLES,
        sentence=sentence,
    )


def _filled(when: str, sentence: str) -> View:
    return View(block=_FILL, when=when, sentence=sentence)


def _vertices(kind: str, condition: str, sentence: str) -> View:
    named = f"vertices_on(vertices, ring_ends, y, '{kind}')"
    return _crossed(f"{condition}{named}", f"Row {{y}} has {{{named}}}: " + sentence)


VIEW_FUNCTIONS = (
    crossed,
    listed,
    not_among,
    pairs,
    row_of_box,
    row_spans,
    span_pixels,
    spans_text,
    vertices_on,
)
VIEWS = (
    View(
        block="Find the lowest and the highest row",
        when="lowest > highest",
        sentence="No row of pixels runs through the polygon: nothing is filled.",
    ),
    View(
        block="Find the lowest and the highest row",
        sentence="The polygon reaches from row {lowest} to row {highest}.",
    ),
    *(_vertices(*rule) for rule in VERTEX_RULE),
    _crossed("len(crossings) == 0", "Row {y} meets none of the {len(vertices)} edges."),
    _crossed("len(crossed(crossings)) == 0", "Row {y} has level edges only: nothing crosses it."),
    _crossed("True", "Row {y} crosses {len(crossed(crossings))} of the {len(vertices)} edges."),
    View(block=_SORT, when="crossed(crossings)", sentence=f"From left to right: x = {{{_XS}}}."),
    _filled("len(crossings) == 0", "Nothing is filled."),
    _filled(f"len({_SPANS}) == 0", "No pixel's centre lies between them."),
    _filled(
        "closed and len(crossed(crossings)) < len(crossings)",
        f"With the level edge on the row, closed fills {{spans_text({_SPANS})}}.",
    ),
    _filled(
        "nonzero",
        f"Inside is where the edges passed so far do not cancel: fill {{spans_text({_SPANS})}}.",
    ),
    _filled("True", f"In pairs, {{pairs(crossings)}}: fill {{spans_text({_SPANS})}}."),
)
