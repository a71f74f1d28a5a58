"""The built-in pictures of clipping."""

from workbench.document.model import AnyFigure, Circle, Rectangle
from workbench.document.samples.figures import Example, document_of, line, points_at, polygon
from workbench.language import _

_WINDOW = Rectangle(8.0, 10.0, 38.0, 30.0)


def clip_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "clip",
            _("Lines at a window"),
            _("One line is inside, two are outside, three are cut: the region codes tell which is which."),
            "clip",
            document_of(_("Lines at a window"), 50, 42, _lines(), _WINDOW),
        ),
        Example(
            "clip-fork",
            _("A fork at a window"),
            _("The prongs of a concave polygon come apart, yet Sutherland-Hodgman keeps them in one ring."),
            "clip",
            document_of(_("A fork at a window"), 50, 42, [_fork()], Rectangle(10.0, 10.0, 40.0, 30.0)),
        ),
        Example(
            "clip-lab",
            _("The clipping lab"),
            _("Points, lines and a polygon at one window: clip each by hand, then step it."),
            "clip",
            document_of(_("The clipping lab"), 50, 42, _lab(), _WINDOW),
        ),
    ]


def _lines() -> list[AnyFigure]:
    """The front one is the course's, (10, 30) to (40, 0) at (0, 0) to (30, 20), moved by (8, 10)."""
    return [
        line((12, 16), (27, 13), 3, name=_("Inside")),
        line((41, 32), (48, 40), 4, name=_("Beyond one corner")),
        line((1, 26), (10, 36), 4, name=_("Past a corner")),
        line((3, 3), (48, 34), 2, name=_("From corner to corner")),
        line((13, 21), (13, 4), 5, name=_("Upright")),
        line((18, 40), (48, 10), 1, name=_("Across a corner")),
    ]


def _fork() -> AnyFigure:
    corners = [(48, 12), (4, 14), (16, 16), (45, 17), (45, 23), (18, 24), (22, 36), (48, 28)]
    return polygon([[(float(x), float(y)) for x, y in corners]], 1, _("Fork"), closed=True)


def _lab() -> list[AnyFigure]:
    places = ((4, 35), (8, 22), (26, 27), (45, 17))
    points: list[AnyFigure] = [
        Circle("", points_at(place), "midpoint_circle", 2, _("Point"), radius_world=0.0) for place in places
    ]
    kite = polygon([[(2.0, 32.0), (20.0, 24.0), (31.0, 37.0), (25.0, 21.0), (13.0, 16.0)]], 6, _("Kite"))
    return [
        kite,
        *points,
        line((1, 6), (32, 20), 1, name=_("From below the left")),
        line((30, 27), (48, 12), 1, name=_("To the right")),
        line((10, 5), (42, 8), 4, name=_("Below")),
    ]
