"""Documents that are there from the start: a blank sheet, and small pictures worth looking at."""

from functools import cache

from workbench.document.model import AnyFigure, Circle, Document, Ellipse
from workbench.document.samples.animate import animate_examples
from workbench.document.samples.arena import arena_examples
from workbench.document.samples.clip import clip_examples
from workbench.document.samples.colour import colour_examples
from workbench.document.samples.curves import curve_examples
from workbench.document.samples.display import display_examples
from workbench.document.samples.figures import (
    PALETTE,
    Example,
    document_of,
    line,
    points_at,
    polyline,
)
from workbench.document.samples.fill import fill_examples
from workbench.document.samples.raster import raster_examples
from workbench.document.samples.shading import shading_examples
from workbench.document.samples.space import space_examples
from workbench.document.samples.transform import transform_examples
from workbench.document.samples.viewing import viewing_examples
from workbench.document.samples.visibility import visibility_examples
from workbench.language import _

__all__ = [
    "DEFAULT_SIZE_PX",
    "PALETTE",
    "Example",
    "blank_sheet",
    "example",
    "example_document",
    "examples",
]

DEFAULT_SIZE_PX = (64, 48)


def blank_sheet(
    width_px: int = DEFAULT_SIZE_PX[0], height_px: int = DEFAULT_SIZE_PX[1], name: str = ""
) -> Document:
    """A document with one empty sheet, whose world is its pixels."""
    return document_of(name or _("Sheet 1"), width_px, height_px, ())


def example_document() -> Document:
    """The picture that Draw opens with: the line from (20, 10) to (30, 18) by Bresenham's algorithm."""
    return document_of(_("A line"), 40, 28, [line((20, 10), (30, 18))])


@cache
def examples() -> tuple[Example, ...]:
    """Every built-in document, in the order of the list that a person sees; always the same ones."""
    return (
        Example(
            "line",
            _("A line"),
            _("The textbook line from (20, 10) to (30, 18): ten steps of Bresenham's algorithm."),
            "draw",
            example_document(),
        ),
        Example(
            "octants",
            _("A star in all octants"),
            _("Sixteen lines from one centre: which slopes step in x, which in y, and where ties fall."),
            "draw",
            _star(),
        ),
        Example(
            "circles",
            _("Circle and ellipse"),
            _("The midpoint circle plots eight points at a time; the ellipse changes region on the way."),
            "draw",
            _circles(),
        ),
        Example(
            "house",
            _("A house of lines"),
            _("Polylines, a sun and an ellipse of smoke: a picture for the tubes."),
            "draw",
            _house(),
        ),
        Example(
            "slopes",
            _("The same line, three ways"),
            _("DDA, Bresenham and the midpoint algorithm on parallel lines: compare their pixels."),
            "draw",
            _three_ways(),
        ),
        *fill_examples(),
        *clip_examples(),
        *transform_examples(),
        *viewing_examples(),
        *curve_examples(),
        *space_examples(),
        *visibility_examples(),
        *shading_examples(),
        *arena_examples(),
        *animate_examples(),
        *raster_examples(),
        *display_examples(),
        *colour_examples(),
    )


def example(slug: str) -> Example:
    """The built-in document called ``slug``; raises LookupError."""
    for candidate in examples():
        if candidate.slug == slug:
            return candidate
    known = ", ".join(candidate.slug for candidate in examples())
    raise LookupError(
        _("There is no example {slug!r}; choose one of {known}.").format(slug=slug, known=known)
    )


def _star() -> Document:
    tips = [(14, 0), (14, 7), (14, 14), (7, 14)]
    lines: list[AnyFigure] = []
    for quarter in range(4):
        for index, (x, y) in enumerate(tips):
            for _turn in range(quarter):
                x, y = -y, x
            lines.append(line((20, 16), (20 + x, 16 + y), 1 + index))
    return document_of(_("A star in all octants"), 41, 33, lines)


def _circles() -> Document:
    return document_of(
        _("Circle and ellipse"),
        64,
        40,
        [
            Circle("", points_at((18, 20)), "midpoint_circle", 1, _("Circle"), radius_world=12.0),
            Circle("", points_at((18, 20)), "midpoint_circle", 5, _("Small circle"), radius_world=5.0),
            Ellipse(
                "",
                points_at((45, 20)),
                "midpoint_ellipse",
                2,
                _("Ellipse"),
                radius_x_world=14.0,
                radius_y_world=8.0,
            ),
        ],
    )


def _house() -> Document:
    return document_of(
        _("A house of lines"),
        64,
        48,
        [
            line((2, 6), (61, 6), 3, name=_("Ground")),
            polyline([(14, 6), (14, 24), (42, 24), (42, 6)], 1, _("Walls"), False),
            polyline([(10, 23), (28, 37), (46, 23)], 2, _("Roof"), False),
            polyline([(19, 6), (19, 16), (25, 16), (25, 6)], 5, _("Door"), False),
            polyline([(31, 13), (31, 19), (38, 19), (38, 13)], 6, _("Window"), True),
            polyline([(36, 31), (36, 38), (40, 38), (40, 28)], 2, _("Chimney"), False),
            Ellipse(
                "",
                points_at((44, 42)),
                "midpoint_ellipse",
                7,
                _("Smoke"),
                radius_x_world=5.0,
                radius_y_world=2.0,
            ),
            Circle("", points_at((56, 39)), "midpoint_circle", 5, _("Sun"), radius_world=5.0),
        ],
    )


def _three_ways() -> Document:
    """Six up on thirty, since 0.2 has no end in binary and a DDA drifts; it is the last, the one stepped."""
    ways = (
        ("bresenham_line", _("Bresenham"), 2),
        ("midpoint_line", _("Midpoint"), 3),
        ("dda_line", _("DDA"), 1),
    )
    lines = [
        line((4, 8 * number - 4), (34, 8 * number + 2), number, slug, name) for slug, name, number in ways
    ]
    return document_of(_("The same line, three ways"), 41, 42, lines)
