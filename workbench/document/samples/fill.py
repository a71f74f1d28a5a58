"""The built-in pictures of the fills."""

import math

from workbench.document.model import AnyFigure, Circle, Ellipse
from workbench.document.samples.figures import (
    Example,
    document_of,
    points_at,
    polygon,
    polyline,
    seed_fill,
)
from workbench.language import _

Rings = list[list[tuple[float, float]]]


def fill_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    first_rung = "scan_line_crossings"
    triangle = polygon([[(2, 1), (8, 1), (5, 7)]], 1, _("Triangle"), closed=True, algorithm=first_rung)
    return [
        Example(
            "triangle",
            _("The triangle of the course"),
            _("Corners (2, 1), (8, 1), (5, 7): on row 4 the crossings are 3.5 and 6.5, the pixels 4 to 6."),
            "fill",
            document_of(_("The triangle of the course"), 11, 9, [triangle]),
        ),
        Example(
            "two-interiors",
            _("A star with two interiors"),
            _(
                "The same self-crossing outline by even-odd and by winding number: see what happens "
                "to its middle."
            ),
            "fill",
            document_of(
                _("A star with two interiors"),
                36,
                32,
                [
                    polygon([_pentagram(10, 10)], 1, _("Even-odd")),
                    polygon([_pentagram(25, 21)], 2, _("Winding number"), nonzero=True),
                ],
            ),
        ),
        Example(
            "letters",
            _("Letters with holes"),
            _("The hole of an A or an O is a ring of its own, whose crossings are counted with the others."),
            "fill",
            document_of(_("Letters with holes"), 36, 31, _letters()),
        ),
        Example(
            "pond",
            _("A pond with two islands"),
            _("A boundary fill finds its way round two islands; its stack grows and shrinks."),
            "fill",
            document_of(_("A pond with two islands"), 34, 32, _pond()),
        ),
        Example(
            "leak",
            _("A boundary that leaks"),
            _("Pixels that touch only at corners stop the 4-connected fill; the 8-connected one leaks out."),
            "fill",
            document_of(_("A boundary that leaks"), 31, 27, _leak("boundary_fill_8")),
        ),
        Example(
            "missed",
            _("A region that is missed"),
            _("Two rooms that touch only at a corner: a 4-connected fill leaves the second one empty."),
            "fill",
            document_of(_("A region that is missed"), 21, 20, _missed("boundary_fill_4")),
        ),
        Example(
            "overflow",
            _("Recursion that overflows"),
            _("A square of 60 by 60 pixels nests almost 2,000 calls; the limit stops it at 1,000."),
            "fill",
            document_of(_("Recursion that overflows"), 66, 64, _overflow()),
        ),
    ]


def _pentagram(x: float, y: float, radius: float = 9.5) -> list[tuple[float, float]]:
    turns = [math.pi / 2 + k * 4 * math.pi / 5 for k in range(5)]
    return [(round(x + radius * math.cos(a), 1), round(y - 0.5 + radius * math.sin(a), 1)) for a in turns]


def _letters() -> list[AnyFigure]:
    a: Rings = [
        [(1, 3), (5, 3), (6.5, 9), (12.5, 9), (14, 3), (18, 3), (11.5, 27), (7.5, 27)],
        [(7.6, 13), (11.4, 13), (9.5, 20.5)],
    ]
    o: Rings = [_round(26.5, 15, 7.5, 12, 24), _round(26.5, 15, 3.5, 7.5, 16)]
    return [polygon(a, 1, "A"), polygon(o, 2, "O")]


def _round(x: float, y: float, rx: float, ry: float, corners: int) -> list[tuple[float, float]]:
    turns = [2 * math.pi * k / corners for k in range(corners)]
    return [(round(x + rx * math.cos(a), 2), round(y + ry * math.sin(a), 2)) for a in turns]


def _pond() -> list[AnyFigure]:
    shore = [
        (5, 3), (12, 1), (18, 4), (26, 2), (31, 8), (29, 16), (32, 23), (25, 29),
        (17, 27), (10, 30), (4, 25), (2, 14),
    ]  # fmt: skip
    return [
        polyline(shore, 1, _("Shore"), True),
        Circle("", points_at((11, 19)), "midpoint_circle", 1, _("Island"), radius_world=4.0),
        Ellipse(
            "",
            points_at((21, 11)),
            "midpoint_ellipse",
            1,
            _("Island"),
            radius_x_world=6.0,
            radius_y_world=4.0,
        ),
        seed_fill((17, 19), 6, 1, _("Water")),
    ]


def _leak(algorithm: str) -> list[AnyFigure]:
    diamond = [(15, 4), (24, 13), (15, 22), (6, 13)]
    return [
        polyline([(1, 1), (29, 1), (29, 25), (1, 25)], 1, _("Frame"), True),
        polyline(diamond, 1, _("Diagonal boundary"), True),
        seed_fill((15, 13), 2, 1, _("Fill"), algorithm),
    ]


def _missed(algorithm: str) -> list[AnyFigure]:
    walls = [(2, 2), (10, 2), (10, 9), (18, 9), (18, 17), (9, 17), (9, 10), (2, 10)]
    return [
        polyline(walls, 1, _("Two rooms"), True),
        seed_fill((6, 6), 2, 1, _("Fill"), algorithm),
    ]


def _overflow() -> list[AnyFigure]:
    return [
        polyline([(2, 1), (63, 1), (63, 62), (2, 62)], 1, _("Square"), True),
        seed_fill((32, 31), 2, 1, _("Fill"), "boundary_fill_recursive"),
    ]
