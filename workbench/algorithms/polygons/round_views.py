"""What the filled circle and the filled ellipse show of their blocks."""

from workbench.algorithms.entry import View

Pixels = tuple[tuple[int, int], ...]


def span_pixels(y: int, x_left: int, x_right: int) -> Pixels:
    """The pixels of a span."""
    return tuple((x, y) for x in range(x_left, x_right + 1))


def two_rows(xc: int, yc: int, x: int, y: int) -> Pixels:
    """The pixels of row y, seen from the centre, and of its mirror image."""
    below = span_pixels(yc - y, xc - x, xc + x) if y else ()
    return span_pixels(yc + y, xc - x, xc + x) + below


def _moves(verbs: dict[str, str], block: str, chosen: str, row: str, span: str) -> tuple[View, ...]:
    """The span of a row has its ends: how it came to them, by when that is said."""
    return tuple(
        View(block=block, when=when, chosen=chosen, row=row, sentence=f"The span {verb} pixels{span}")
        for when, verb in verbs.items()
    )


_GROWS = {"x > before.x": "grows from {before.x} to {x}"}
_SHRINKS = {"x < before.x": "shrinks from {before.x} to {x}"}
_STAYS = {"True": "still reaches {x}"}

CIRCLE_COLUMNS = ("y", "x", "test of x", "test of x + 1", "x left", "x right")
CIRCLE_VIEWS = _moves(
    _GROWS | _SHRINKS | _STAYS,
    "Move the end of the span to where the outline is",
    "span_pixels(yc + y, xc - x, xc + x)",
    "(y, x, reach(x, y), reach(x + 1, y), xc - x, xc + x)",
    " from the centre: one more would give {reach(x + 1, y)}, not less than r² = {r2}. "
    "Fill {xc - x} to {xc + x} on row {yc + y}.",
)

ELLIPSE_COLUMNS = ("y", "x", "region", "x left", "x right")
ELLIPSE_VIEWS = _moves(
    _GROWS | _STAYS,  # it goes outwards from row to row
    "Go along the row to where the outline leaves it",
    "two_rows(xc, yc, x, y)",
    "(y, x, 1 if ry2 * x < rx2 * y else 2, xc - x, xc + x)",
    " from the centre. Fill {xc - x} to {xc + x} on rows {yc + y} and {yc - y}.",
)
