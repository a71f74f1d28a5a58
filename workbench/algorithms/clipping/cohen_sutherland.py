"""Cohen and Sutherland's line clipping.

x0, y0, x1, y1      both ends of what is left
ax, ay, bx, by      both ends as they were given: cut from these, errors do not add up
code_0, code_1      region codes of both ends: top, bottom, right, left from the highest bit
edge                the edge that one end is cut off at, as the bit of its code
k                   number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.clipping.cohen_sutherland_marks import marks
from workbench.algorithms.clipping.cutting import (
    INTERSECTION_VIEWS,
    INTERSECTIONS,
    bits,
    crossings,
    edge_name,
    others,
    pixels,
)
from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, between, intersection, region_code
from workbench.algorithms.clipping.window import LINE, LINES, WINDOW, line_and_window
from workbench.algorithms.entry import Entry, Law, View


def cohen_sutherland(
    x0: float, y0: float, x1: float, y1: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float, float, float]]:
    """Emit the visible part of a line: accept, reject, or cut off one end at one edge and look again.

    Args: both ends and the window, in device coordinates. Emits: (x0, y0, x1, y1), ends in the order
    given, or nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Code both ends
    ax, ay, bx, by = x0, y0, x1, y1
    code_0 = region_code(x0, y0, xmin, ymin, xmax, ymax)
    code_1 = region_code(x1, y1, xmin, ymin, xmax, ymax)

    for k in range(5):  # one cut for each edge at most, then a last look
        # Accept, reject or cut off one end
        if code_0 | code_1 == 0:
            yield x0, y0, x1, y1
            return
        if code_0 & code_1 != 0:
            return
        code = code_0 if code_0 != 0 else code_1
        edge = TOP if code & TOP else BOTTOM if code & BOTTOM else RIGHT if code & RIGHT else LEFT
        x, y = intersection(ax, ay, bx, by, edge, xmin, ymin, xmax, ymax)
        x, y = between(x, x0, x1), between(y, y0, y1)
        if code_0 != 0:
            x0, y0, code_0 = x, y, region_code(x, y, xmin, ymin, xmax, ymax)
        else:
            x1, y1, code_1 = x, y, region_code(x, y, xmin, ymin, xmax, ymax)


_LOOK = "Accept, reject or cut off one end"
_WINDOW = "(xmin, ymin, xmax, ymax)"
_CODES = (
    "f'{bits(before.code_0)}, {bits(before.code_1)}', bits(before.code_0 | before.code_1), "
    "bits(before.code_0 & before.code_1)"
)
_CROSSED = f"crossings((x0, y0, code_0), (x1, y1, code_1), {_WINDOW})"
_CROSSED_BEFORE = (
    f"crossings((before.x0, before.y0, before.code_0), (before.x1, before.y1, before.code_1), {_WINDOW})"
)
_END = "((before.x0, before.y0) if before.code_0 else (before.x1, before.y1))"
_CUT = "(x, y)"
_OPTIONS = "('accept', 'reject', 'clip top', 'clip bottom', 'clip right', 'clip left')"
_BOTH = "Codes {bits(before.code_0)} and {bits(before.code_1)}"
_ENDS = {"Ends": ("(('P0', x0, y0, bits(code_0)), ('P1', x1, y1, bits(code_1)))", ("end", "x", "y", "code"))}


def _clip_view(edge: int, beyond: str) -> View:
    """The view of an end cut off at ``edge``, which it is beyond."""
    decision = f"clip {edge_name(edge)}"
    return View(
        block=_LOOK,
        when=f"edge == {edge}",
        candidates=_CROSSED,
        chosen=f"pixels(({_CUT},))",
        rejected=f"others({_CROSSED_BEFORE}, pixels(({_CUT},)))",
        row=f"(k, {_CODES}, {decision!r}, {_END}, {_CUT})",
        tables=_ENDS,
        options=_OPTIONS,
        answer=repr(decision),
        sentence=f"{_BOTH}: OR gives {{bits(before.code_0 | before.code_1)}}, AND gives 0000, so neither "
        "accept nor reject. "
        f"{{'P0' if before.code_0 else 'P1'}} {{{_END}}} is {beyond}: cut it off at {{{_CUT}}}, code "
        "{bits(code_0 if before.code_0 else code_1)}.",
    )


ENTRY = Entry(
    function=cohen_sutherland,
    topic="clipping",
    title="Cohen-Sutherland",
    summary="Codes of four bits accept or reject a line at a glance; otherwise an end is cut off at an edge.",
    parameters=(*LINE, *WINDOW),
    arguments=line_and_window,
    clips=LINES,
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-7",
    columns=("k", "codes", "OR", "AND", "decision", "end", "intersection"),
    view_functions=(bits, crossings, others, pixels),
    views=(
        View(
            block="Code both ends",
            tables=_ENDS,
            sentence="P0 {(x0, y0)} has code {bits(code_0)}, P1 {(x1, y1)} has code {bits(code_1)}.",
        ),
        View(
            block=_LOOK,
            when="before.code_0 | before.code_1 == 0",
            row=f"(k, {_CODES}, 'accept', '', '')",
            tables=_ENDS,
            options=_OPTIONS,
            answer="'accept'",
            sentence=f"{_BOTH}: OR gives 0000, so both ends are inside. Accept {{(x0, y0)}} to {{(x1, y1)}}.",
        ),
        View(
            block=_LOOK,
            when="before.code_0 & before.code_1 != 0",
            candidates=_CROSSED,
            rejected=_CROSSED_BEFORE,
            row=f"(k, {_CODES}, 'reject', '', '')",
            tables=_ENDS,
            options=_OPTIONS,
            answer="'reject'",
            sentence=f"{_BOTH}: AND gives {{bits(code_0 & code_1)}}, so both ends are beyond one edge. "
            "Reject.",
        ),
        _clip_view(TOP, "above the window"),
        _clip_view(BOTTOM, "below the window"),
        _clip_view(RIGHT, "right of the window"),
        _clip_view(LEFT, "left of the window"),
        *INTERSECTION_VIEWS,
    ),
    laws=(
        Law(
            "What is emitted lies in the window, to the last digit, and on the line, to a relative 10⁻⁹.",
            "clipping/test_lines.py::test_what_is_left_is_what_is_visible",
        ),
        Law("The ends keep their order.", "clipping/test_lines.py::test_the_ends_keep_their_order"),
        Law(
            "An end inside the window stays as it is; clipped again, so does the line.",
            "clipping/test_lines.py::test_an_end_inside_stays_as_it_is_and_clipping_again_changes_nothing",
        ),
        Law(
            "Four intersections are computed at most, and none for a line that is accepted or rejected "
            "at once.",
            "clipping/test_lines.py::test_no_more_intersections_than_are_promised",
        ),
        Law(
            "A line is found where any of it is visible, be it the touch of a corner, and no other is.",
            "clipping/test_lines.py::test_cohen_sutherland_finds_a_line_just_where_any_of_it_is_visible",
        ),
        Law(
            "Mirrored left to right or top to bottom, line and window give the mirrored line, to the "
            "last digit.",
            "clipping/test_lines.py::test_mirrored_lines_give_mirrored_lines_to_the_last_digit",
        ),
    ),
    not_laws=(
        "Only intersections on the window are computed: some lie on an edge's extension and are cut again.",
    ),
    labs=("Clipping: Cohen-Sutherland",),
    next_rung="liang_barsky",
    marks=marks,
    counted=INTERSECTIONS,
)
