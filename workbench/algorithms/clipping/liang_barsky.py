"""Liang and Barsky's line clipping.

dx, dy      the line is (x0 + u dx, y0 + u dy) for u from 0 to 1
p, q        it is inside an edge where u p <= q: entering there if p < 0, leaving if p > 0, parallel if 0
r           the u at which it crosses the edge
u1, u2      the part of the line that is left so far
k           number of the edge: 1 left, 2 right, 3 bottom, 4 top
"""

from collections.abc import Iterator

from workbench.algorithms.clipping.cutting import INTERSECTIONS, edge_symbol, pixels
from workbench.algorithms.clipping.edges import between
from workbench.algorithms.clipping.liang_barsky_marks import marks
from workbench.algorithms.clipping.window import LINE, LINES, NO_LINE_LAW, WINDOW, line_and_window
from workbench.algorithms.entry import Entry, Law, View


def liang_barsky(
    x0: float, y0: float, x1: float, y1: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float, float, float]]:
    """Emit the visible part of a line: each edge narrows the interval of its parameter u.

    Args: both ends and the window, in device coordinates. Emits: (x0, y0, x1, y1), ends in the order
    given, or nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Begin with the whole line
    dx = x1 - x0
    dy = y1 - y0
    u1 = 0.0
    u2 = 1.0

    for k, p, q in ((1, -dx, x0 - xmin), (2, dx, xmax - x0), (3, -dy, y0 - ymin), (4, dy, ymax - y0)):
        # Narrow u1 to u2 by this edge
        if p < 0.0:
            r = q / p
            u1 = max(u1, r)
        elif p > 0.0:
            r = q / p
            u2 = min(u2, r)
        elif q < 0.0:
            return
        if u1 > u2:
            return

    if u2 < 1.0:
        # Find the intersection on leaving
        x1 = x0 + u2 * dx
        y1 = y0 + u2 * dy

    if u1 > 0.0:
        # Find the intersection on entering
        x0 += u1 * dx
        y0 += u1 * dy

    # Emit what is left, and let no rounding carry it out of the window
    x0, y0 = between(x0, xmin, xmax), between(y0, ymin, ymax)
    x1, y1 = between(x1, xmin, xmax), between(y1, ymin, ymax)
    yield x0, y0, x1, y1


_CROSSING = "pixels(((x0 + q / p * dx, y0 + q / p * dy),) if p != 0.0 else ())"


def _edge_view(when: str, answer: str, sentence: str) -> View:
    """The view of an edge that has this effect."""
    moves = answer in ("u1 grows", "u2 shrinks")
    return View(
        block="Narrow u1 to u2 by this edge",
        when=when,
        candidates=_CROSSING,
        chosen=_CROSSING if moves else "()",
        rejected="()" if moves else _CROSSING,
        row="(k, p, q, r if p != 0.0 else '', u1, u2)",
        options="('u1 grows', 'u2 shrinks', 'nothing changes', 'reject')",
        answer=repr(answer),
        sentence=f"{{edge_symbol(1 << (k - 1))}}: {sentence}",
    )


ENTRY = Entry(
    function=liang_barsky,
    topic="clipping",
    title="Liang-Barsky",
    summary="Four divisions at most narrow the parameter from u1 to u2; only then are points computed.",
    parameters=(*LINE, *WINDOW),
    arguments=line_and_window,
    clips=LINES,
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-7",
    columns=("k", "p_k", "q_k", "r_k", "u_1", "u_2"),
    view_functions=(edge_symbol, pixels),
    views=(
        View(
            block="Begin with the whole line",
            sentence="x = {x0} + u dx with dx = {dx}, y = {y0} + u dy with dy = {dy}; u goes from 0 to 1.",
        ),
        _edge_view(
            "p == 0.0 and q < 0.0",
            "reject",
            "p = 0, the line is parallel to the edge, and q = {q} < 0, it is outside: reject it.",
        ),
        _edge_view(
            "p == 0.0",
            "nothing changes",
            "p = 0, the line is parallel to the edge, and q = {q} ≥ 0, it is inside: nothing changes.",
        ),
        _edge_view(
            "u1 > u2",
            "reject",
            "p = {p}, r = {q}/{p} = {r}: the line would leave at {u2}, before it enters at {u1}, so "
            "reject it.",
        ),
        _edge_view(
            "p < 0.0 and u1 > before.u1",
            "u1 grows",
            "p = {p} < 0, the line enters, at r = {q}/{p} = {r}, later than {before.u1}: u1 = {u1}.",
        ),
        _edge_view(
            "p < 0.0",
            "nothing changes",
            "p = {p} < 0, the line enters, at r = {q}/{p} = {r}, no later than u1 = {u1}: nothing changes.",
        ),
        _edge_view(
            "u2 < before.u2",
            "u2 shrinks",
            "p = {p} > 0, the line leaves, at r = {q}/{p} = {r}, sooner than {before.u2}: u2 = {u2}.",
        ),
        _edge_view(
            "True",
            "nothing changes",
            "p = {p} > 0, the line leaves, at r = {q}/{p} = {r}, no sooner than u2 = {u2}: nothing changes.",
        ),
        View(
            block="Emit what is left, and let no rounding carry it out of the window",
            sentence="From u1 = {u1} to u2 = {u2}: {(x0, y0)} to {(x1, y1)} is visible.",
        ),
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
            "Four divisions at most, and two intersections, both of them ends of what is visible.",
            "clipping/test_lines.py::test_no_more_intersections_than_are_promised",
        ),
        Law(
            "Mirrored left to right or top to bottom, line and window give the mirrored line, to the "
            "last digit.",
            "clipping/test_lines.py::test_mirrored_lines_give_mirrored_lines_to_the_last_digit",
        ),
        Law(
            "With x and y changed over, line and window give the same line changed over.",
            "clipping/test_lines.py::test_liang_barsky_takes_columns_for_rows",
        ),
        Law(
            "Of lines and windows of whole numbers within 2²⁴ nothing visible is lost, not even the "
            "touch of a corner.",
            "clipping/test_lines.py::test_of_whole_numbers_nothing_visible_is_lost",
        ),
        Law(
            "It finds what Cohen-Sutherland finds, to a relative 10⁻⁹, except for a line that runs "
            "along an edge a rounding away.",
            "clipping/test_lines.py::test_both_find_the_same",
        ),
    ),
    not_laws=(
        NO_LINE_LAW,
        "An end that was cut off lies on the window's edge to the last digit.",
    ),
    labs=("Clipping: Liang-Barsky",),
    next_rung="sutherland_hodgman",
    marks=marks,
    counted=INTERSECTIONS,
)
