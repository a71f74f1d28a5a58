"""Documents that are there from the start: a blank sheet, and small pictures worth looking at."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

from msgspec.structs import replace

from workbench.document.model import (
    AnyFigure,
    Circle,
    Document,
    Ellipse,
    Line,
    Polyline,
    Sheet,
    WorldPoint,
    whole_sheet,
)
from workbench.language import _

# The paper, then colours that keep a contrast of 3:1 on white and on near-black, then a grey.
PALETTE = (0x000000, 0x0072B2, 0xD55E00, 0x00805C, 0xC2417C, 0xA97400, 0x1F86BF, 0x7F7F7F)

DEFAULT_SIZE_PX = (64, 48)


@dataclass(frozen=True, slots=True)
class Example:
    """A built-in document: ``slug`` names it in links, ``workspace`` is the one it opens in."""

    slug: str
    title: str
    description: str
    workspace: str
    document: Document


def blank_sheet(
    width_px: int = DEFAULT_SIZE_PX[0], height_px: int = DEFAULT_SIZE_PX[1], name: str = ""
) -> Document:
    """A document with one empty sheet, whose world is its pixels."""
    return _document(name or _("Sheet 1"), width_px, height_px, ())


def example_document() -> Document:
    """The picture that Draw opens with: the line from (20, 10) to (30, 18) by Bresenham's algorithm."""
    return _document(_("A line"), 40, 28, [_line((20, 10), (30, 18))])


def examples() -> list[Example]:
    """Every built-in document, in the order of the list that a person sees."""
    return [
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
            _("The midpoint circle plots eight points at a time, the ellipse changes region half-way."),
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
    ]


def example(slug: str) -> Example:
    """The built-in document called ``slug``; raises LookupError."""
    for candidate in examples():
        if candidate.slug == slug:
            return candidate
    known = ", ".join(candidate.slug for candidate in examples())
    raise LookupError(
        _("There is no example {slug!r}; choose one of {known}.").format(slug=slug, known=known)
    )


def _document(name: str, width_px: int, height_px: int, figures: Sequence[AnyFigure]) -> Document:
    whole = whole_sheet(width_px, height_px)
    numbers = count(1)
    numbered = []
    for number, figure in enumerate(figures, 1):
        points = tuple(replace(point, id=f"p{next(numbers)}") for point in figure.points_world)
        numbered.append(replace(figure, id=f"f{number}", points_world=points))
    return Document((Sheet("s1", name, width_px, height_px, whole, whole, PALETTE, tuple(numbered)),))


def _points(*places: tuple[float, float]) -> tuple[WorldPoint, ...]:
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


def _line(
    start: tuple[float, float],
    end: tuple[float, float],
    colour: int = 1,
    algorithm: str = "bresenham_line",
    name: str = "",
) -> Line:
    return Line("", _points(start, end), algorithm, colour, name)


def _polyline(places: Sequence[tuple[float, float]], colour: int, name: str, closed: bool) -> Polyline:
    return Polyline("", _points(*places), "bresenham_line", colour, name, closed=closed)


def _star() -> Document:
    tips = [(14, 0), (14, 7), (14, 14), (7, 14)]
    lines: list[AnyFigure] = []
    for quarter in range(4):
        for index, (x, y) in enumerate(tips):
            for _turn in range(quarter):
                x, y = -y, x
            lines.append(_line((20, 16), (20 + x, 16 + y), 1 + index))
    return _document(_("A star in all octants"), 41, 33, lines)


def _circles() -> Document:
    return _document(
        _("Circle and ellipse"),
        64,
        40,
        [
            Circle("", _points((18, 20)), "midpoint_circle", 1, _("Circle"), radius_world=12.0),
            Circle("", _points((18, 20)), "midpoint_circle", 5, _("Small circle"), radius_world=5.0),
            Ellipse(
                "",
                _points((45, 20)),
                "midpoint_ellipse",
                2,
                _("Ellipse"),
                radius_x_world=14.0,
                radius_y_world=8.0,
            ),
        ],
    )


def _house() -> Document:
    return _document(
        _("A house of lines"),
        64,
        48,
        [
            _line((2, 6), (61, 6), 3, name=_("Ground")),
            _polyline([(14, 6), (14, 24), (42, 24), (42, 6)], 1, _("Walls"), False),
            _polyline([(10, 23), (28, 37), (46, 23)], 2, _("Roof"), False),
            _polyline([(19, 6), (19, 16), (25, 16), (25, 6)], 5, _("Door"), False),
            _polyline([(31, 13), (31, 19), (38, 19), (38, 13)], 6, _("Window"), True),
            _polyline([(36, 31), (36, 38), (40, 38), (40, 28)], 2, _("Chimney"), False),
            Ellipse(
                "",
                _points((44, 42)),
                "midpoint_ellipse",
                7,
                _("Smoke"),
                radius_x_world=5.0,
                radius_y_world=2.0,
            ),
            Circle("", _points((56, 39)), "midpoint_circle", 5, _("Sun"), radius_world=5.0),
        ],
    )


def _three_ways() -> Document:
    slugs = ("dda_line", "bresenham_line", "midpoint_line")
    lines = [
        _line((4, 4 + 8 * number), (36, 10 + 8 * number), number, slug, name)
        for number, (slug, name) in enumerate(
            zip(slugs, (_("DDA"), _("Bresenham"), _("Midpoint")), strict=True), 1
        )
    ]
    return _document(_("The same line, three ways"), 41, 42, lines)
