"""What the fills with edge tables show of their blocks, in floats and in whole numbers alike."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import Mark, Spot
from workbench.algorithms.polygons.fill_words import (
    active_rows,
    crossings,
    crossings_on,
    moves,
    pairs,
    table_rows,
)
from workbench.algorithms.polygons.row_drift import Drift, drifted, drifts
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

_TABLE = "Make the edge table"
_FILL = "Fill between each pair of crossings"
_ON_ROW = "crossings(active)"


def edge_table_views(tables: Mapping[str, tuple[str, tuple[str, ...]]]) -> tuple[View, ...]:
    """The views of the block that makes the edge table: it stands there whole before the first row."""
    return (
        View(
            block=_TABLE,
            when="len(edges) == len(vertices)",
            tables=tables,
            sentence="The edge table has all {len(edges)} edges, lowest first; none is active yet.",
        ),
        View(
            block=_TABLE,
            tables=tables,
            sentence="The edge table has {len(edges)} of the {len(vertices)} edges, lowest first; the others "
            "count on no row. None is active yet.",
        ),
    )


def fill_views(slug: str, corners: str, update: str, rounds: bool) -> tuple[View, ...]:
    """The views of the fill of this name.

    ``corners`` are its vertices, ``update`` is the title of the block that brings the active edge table to
    the row. Where it ``rounds``, its views tell of drift.
    """
    spans = f"row_spans({slug}, vertices, ring_ends, closed, nonzero, y)"
    tables = {
        "Active edge table": (
            f"active_rows(active, {corners})",
            ("from", "to", "last y", "x", "1/m", "winding"),
        ),
        "Edge table": (
            f"table_rows(edges[waiting:], {corners})",
            ("first y", "last y", "x", "1/m", "from", "to"),
        ),
    }

    drift = f"drifts(active, vertices, {spans}, closed, nonzero, y)"

    def updated(when: str, sentence: str) -> View:
        chosen = f"span_pixels({spans}, y)"
        return View(
            block=update,
            when=when,
            candidates="row_of_box(vertices, y)",
            chosen=chosen,
            rejected=f"not_among(row_of_box(vertices, y), {chosen})",
            row=f"(y, listed({_ON_ROW}), spans_text({spans}), len({chosen}))",
            tables=tables,
            sentence=sentence,
            marks=f"drift_marks({drift}, y)" if rounds else "()",
        )

    def vertices(kind: str, condition: str, sentence: str) -> View:
        named = f"vertices_on({corners}, ring_ends, y, '{kind}')"
        return updated(f"{condition}{named}", f"Row {{y}} has {{{named}}}: " + sentence)

    def filled(when: str, sentence: str) -> View:
        return View(block=_FILL, when=when, sentence=sentence)

    first, second = f"{_ON_ROW}[0]", f"{_ON_ROW}[1]"
    two = f"len({_ON_ROW}) == 2 and len({spans}) == 1"
    # Between whole corners an edge begins on one of them, and that is said
    beginning = updated(
        "not moves(before.active, y)",
        f"{{len({_ON_ROW})}} edges begin on row {{y}}, at x = {{listed({_ON_ROW})}}.",
    )
    drifting = filled(
        drift,
        f"1/m, rounded and added up, has drifted: {{drifted({drift})}}. The row is filled "
        f"{{spans_text({spans}) or 'nowhere'}}.",
    )
    return (
        *edge_table_views(tables),
        *(vertices(*rule) for rule in VERTEX_RULE),
        updated("len(active) == 0", "No edge is on row {y}."),
        updated(f"len({_ON_ROW}) == 0", "Row {y} has level edges only: nothing crosses it."),
        *([beginning] if rounds else []),
        updated(
            "True", f"{{len({_ON_ROW})}} edges cross row {{y}}; x grows by 1/m: {{moves(before.active, y)}}."
        ),
        *([drifting] if rounds else []),
        filled("len(active) == 0", "Nothing is filled."),
        filled(f"len({spans}) == 0", "No pixel's centre lies between the crossings."),
        filled(
            f"closed and len({_ON_ROW}) < len(active)",
            f"With the level edge on the row, closed fills {{spans_text({spans})}}.",
        ),
        filled(
            f"closed and {two}",
            f"Closed fills from ⌈{{{first}}}⌉ to ⌊{{{second}}}⌋, {{spans_text({spans})}}.",
        ),
        filled(two, f"Half-open fills {{{first}}} <= x < {{{second}}}, {{spans_text({spans})}}."),
        filled(
            "nonzero",
            f"Inside is where the edges passed so far do not cancel: fill {{spans_text({spans})}}.",
        ),
        filled("True", f"In pairs, {{pairs(active)}}: fill {{spans_text({spans})}}."),
    )


def marks(
    _arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The scan line, its spans so far, its crossings with their x."""
    if "y" in now:
        xs, words = crossings_on(now["edges"], now["y"])
        yield from row_marks(now["y"], xs, emitted, words)


def drift_marks(drifts: Sequence[Drift], y: int) -> tuple[Mark, ...]:
    """A cross on each pixel of row y that is lost or too much."""
    return tuple(Spot(float(drift.pixel), float(y), "error", "cross", "pixel") for drift in drifts)


VIEW_FUNCTIONS = (
    active_rows,
    crossings,
    drift_marks,
    drifted,
    drifts,
    listed,
    moves,
    not_among,
    pairs,
    row_of_box,
    row_spans,
    span_pixels,
    spans_text,
    table_rows,
    vertices_on,
)
