"""What the exact scan-line fill shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.polygons.fill_views import edge_table_views
from workbench.algorithms.polygons.scan_line_words import (
    VERTEX_RULE,
    active_rows,
    crossings,
    edge_rows,
    listed,
    moves,
    not_among,
    reached,
    row_spans,
    span_pixels,
    spans_text,
    vertices_on,
)

_FILL = "Fill between the crossings"
_SPANS = "row_spans(scan_line_exact, vertices, ring_ends, closed, nonzero, row)"
_CHOSEN = f"span_pixels({_SPANS}, row)"
_REACHED = "reached(active, edges, vertices, row)"
_CROSSINGS = "crossings(active, edges, vertices, ring_ends)"
_XS = f"listed({_CROSSINGS})"
_FIRST, _SECOND = f"listed({_CROSSINGS}[:1])", f"listed({_CROSSINGS}[1:])"
_CROSSED = f"Row {{row}} is crossed at x = {{{_XS}}}"
_TABLES = {
    "Active edge table": (
        "active_rows(active, edges, vertices, ring_ends)",
        ("from", "to", "last y", "x", "1/m", "winding"),
    ),
    "Edge table": (
        "edge_rows(edges[waiting:], vertices)",
        ("first y", "last y", "x", "1/m", "from", "to"),
    ),
}


def _filled(when: str, sentence: str) -> View:
    return View(
        block=_FILL,
        when=when,
        candidates=_REACHED,
        chosen=_CHOSEN,
        rejected=f"not_among({_REACHED}, {_CHOSEN})",
        row=f"(row, {_XS}, spans_text({_SPANS}), len({_CHOSEN}))",
        tables=_TABLES,
        sentence=sentence,
    )


def _vertices(kind: str, condition: str, sentence: str) -> View:
    named = f"vertices_on(vertices, ring_ends, row, '{kind}')"
    return _filled(
        f"{condition}{named}",
        f"Row {{row}} has {{{named}}}: {sentence} Crossed at x = {{{_XS} or 'none'}}: fill "
        f"{{spans_text({_SPANS}) or 'nothing'}}.",
    )


VIEW_FUNCTIONS = (
    active_rows,
    crossings,
    edge_rows,
    listed,
    moves,
    not_among,
    reached,
    row_spans,
    span_pixels,
    spans_text,
    vertices_on,
)
VIEWS = (
    *edge_table_views(_TABLES),
    *(_vertices(*rule) for rule in VERTEX_RULE),
    _filled(
        f"len({_CROSSINGS}) == 0",
        f"Row {{row}} has level edges only: nothing crosses it, and closed fills {{spans_text({_SPANS})}}.",
    ),
    _filled(f"len({_SPANS}) == 0", _CROSSED + ": no pixel's centre lies between."),
    _filled(
        f"closed and len(active) == 2 and len({_SPANS}) == 1",
        _CROSSED + f": closed fills from ⌈{{{_FIRST}}}⌉ to ⌊{{{_SECOND}}}⌋, {{spans_text({_SPANS})}}.",
    ),
    _filled(
        f"len(active) == 2 and len({_SPANS}) == 1",
        _CROSSED + f": half-open fills {{{_FIRST}}} <= x < {{{_SECOND}}}, {{spans_text({_SPANS})}}.",
    ),
    _filled(
        "nonzero",
        _CROSSED + f". Inside is where the edges passed so far do not cancel: {{spans_text({_SPANS})}}.",
    ),
    _filled("True", _CROSSED + f". Inside is every second stretch: {{spans_text({_SPANS})}}."),
    View(
        block="Move each crossing by 1/m to the next row",
        when="moves(before.active)",
        sentence="To the next row x moves by 1/m: {moves(before.active)}.",
    ),
)
