"""The built-in pictures for random scan: a list that is too long, and one picture for both displays."""

import math

from workbench.document.model import AnyFigure, Document, Polygon
from workbench.document.samples.figures import Example, document_of, line, polygon, polyline
from workbench.language import _

VECTOR, COMPARISON = "vector", "comparison"
_PEGS, _SPANS = 48, (9, 14, 18, 21, 23)


def display_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "overloaded-list",
            _("An overloaded display list"),
            _("Hundreds of long threads between pegs: the list takes longer than the eye will wait."),
            "display",
            _threads(),
            VECTOR,
            dock="random_scan_architecture",
        ),
        Example(
            "raster-or-random",
            _("One picture, two displays"),
            _("Slanted lines and filled areas: where the raster has stairs, and the strokes have no area."),
            "display",
            _ship(),
            COMPARISON,
            dock="raster_or_random",
        ),
    ]


def _threads() -> Document:
    """Threads between pegs on a circle, each tied to others as far on: what they leave free are circles."""
    pegs = [
        (80 + 56 * math.cos(2 * math.pi * k / _PEGS), 60 + 56 * math.sin(2 * math.pi * k / _PEGS))
        for k in range(_PEGS)
    ]
    threads: list[AnyFigure] = [
        line(pegs[k], pegs[(k + span) % _PEGS], 1 + turn)
        for turn, span in enumerate(_SPANS)
        for k in range(_PEGS)
    ]
    return document_of(_("An overloaded display list"), 160, 120, threads)


def _ship() -> Document:
    """A small ship: sails and hull are areas, rigging and waves are lines."""
    areas: list[Polygon] = [
        polygon([[(33, 14), (33, 42), (56, 14)]], 2, _("Mainsail")),
        polygon([[(29, 14), (29, 36), (12, 14)]], 5, _("Jib")),
        polygon([[(8, 11), (60, 11), (52, 3), (16, 3)]], 1, _("Hull")),
    ]
    lines: list[AnyFigure] = [
        line((31, 11), (31, 46), 7, name=_("Mast")),
        line((31, 46), (61, 11), 3, name=_("Backstay")),
        line((31, 46), (7, 11), 3, name=_("Forestay")),
        polyline([(1, 2), (9, 0), (17, 2), (25, 0), (33, 2), (41, 0), (49, 2), (57, 0), (63, 2)], 6,
                 _("Waves"), False),
    ]  # fmt: skip
    return document_of(_("One picture, two displays"), 64, 48, [*areas, *lines])
