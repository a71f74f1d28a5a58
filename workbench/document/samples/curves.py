"""The built-in pictures of curves."""

from collections.abc import Sequence
from typing import Any

from workbench.algorithms import curves
from workbench.document.curves.conversions import path_through
from workbench.document.curves.pieces import pieces_of
from workbench.document.model import Curve, CurvePoint, Document, Knot
from workbench.document.samples.figures import Example, document_of
from workbench.language import _

Places = Sequence[tuple[float, float]]

# Small enough that a whole sheet is seen beside the card.
SIZE_PX = (240, 150)

# The points of the course, P_0 to P_5, spread over the sheet.
COURSE = ((27, 15), (50, 105), (117, 128), (162, 38), (212, 20), (225, 112))


def curve_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        _example(
            "interpolation",
            _("Through the points, or near them"),
            _(
                "Six points by natural cubic, Catmull-Rom, Bézier and B-spline: which pass through, "
                "which only approach."
            ),
            [
                _curve(
                    COURSE,
                    "natural_cubic",
                    1,
                    _("Six points"),
                    beside=("catmull_rom", "bezier", "b_spline"),
                )
            ],
        ),
        _example(
            "bezier",
            _("A cubic Bézier curve"),
            _("Four points and de Casteljau's construction: drag u, and watch the legs divide."),
            [_curve(((30, 22), (52, 128), (172, 131), (214, 34)), "bezier", 1, _("Bézier curve"))],
        ),
        _example(
            "local-control",
            _("What one point of a B-spline moves"),
            _("Drag a point in the middle: four spans of the B-spline move, but all of the Bézier curve."),
            [_curve(_wave(), "b_spline", 1, _("B-spline"), beside=("bezier",))],
        ),
        _example(
            "circle",
            _("An exact circle"),
            _("Nine weighted points make a NURBS circle; with all weights 1 it is no longer a circle."),
            [_circle()],
        ),
        _example(
            "alphas",
            _("Catmull-Rom three ways"),
            _("Uniform, centripetal and chordal over the same uneven points: loops, none, and wide bends."),
            _alphas(),
        ),
        _example(
            "letter",
            _("A leaf and a letter"),
            _("Paths of cubic pieces with corners and smooth points: drag a point, a handle, the curve."),
            [*_leaf(), _letter()],
        ),
    ]


def _example(slug: str, title: str, description: str, figures: Sequence[Curve]) -> Example:
    document: Document = document_of(title, *SIZE_PX, figures)
    return Example(f"curve-{slug}", title, description, "curves", document)


def _curve(places: Places, spline: str, colour: int, name: str, **how: Any) -> Curve:
    points = tuple(CurvePoint("", float(x), float(y)) for x, y in places)
    return Curve("", points, "bresenham_line", colour, name, spline=spline, **how)


def _wave() -> Places:
    places = [(21.0 + 22.0 * k, 75.0 + (44.0 if k % 2 else -44.0)) for k in range(10)]
    return [(21.0, 45.0), *places[1:-1], (219.0, 105.0)]


def _circle() -> Curve:
    points, weights, knots, degree = curves.circle(120.0, 75.0, 58.0)
    return Curve(
        "",
        tuple(CurvePoint("", x, y, w) for (x, y), w in zip(points.tolist(), weights.tolist(), strict=True)),
        "bresenham_line",
        1,
        _("Circle"),
        spline="nurbs",
        degree=degree,
        knot_rule="free",
        knots=tuple(Knot("", u) for u in knots.tolist()),
    )


def _alphas() -> list[Curve]:
    places = ((5, 22), (117, 112), (123, 112), (235, 22))
    kinds = ((0.0, 2, _("Uniform")), (0.5, 1, _("Centripetal")), (1.0, 3, _("Chordal")))
    return [_curve(places, "catmull_rom", colour, name, alpha=alpha) for alpha, colour, name in kinds]


def _leaf() -> list[Curve]:
    blade = [
        *((72, 10), (26, 26), (10, 78)),
        *((45, 110), (55.5, 119.6), (64, 129)),
        *((72, 142), (80, 129), (88.5, 119.6)),
        *((99, 110), (134, 78), (118, 26)),
    ]
    kinds = {0: "corner", 3: "smooth", 6: "corner", 9: "smooth"}
    points = [(float(x), float(y)) for x, y in blade]
    outline = Curve(
        "",
        tuple(CurvePoint("", x, y, joint=kinds.get(k, "corner")) for k, (x, y) in enumerate(points)),
        "bresenham_line",
        3,
        _("Leaf"),
        spline="bezier_path",
        closed=True,
    )
    midrib = _curve(((72, 3), (70.5, 37), (73.5, 82), (72, 133)), "bezier_path", 3, _("Midrib"))
    veins = [
        _curve(((72, 30 + 25 * k), (72 + s * 12, 39 + 25 * k), (72 + s * 24, 46 + 25 * k)), "bezier", 3, name)
        for k in range(3)
        for s, name in ((-1, _("Left vein")), (1, _("Right vein")))
    ]
    return [outline, midrib, *veins]


def _letter() -> Curve:
    """An S, drawn through its turning points and turned into a path."""
    places = ((214, 110), (192, 129), (170, 108), (190, 78), (218, 50), (192, 21), (165, 42))
    through = _curve(places, "natural_cubic", 2, _("Letter S"))
    return path_through(through, pieces_of(through))
