"""The built-in pictures of viewing: windows onto a world, and the viewports that show them."""

from collections.abc import Sequence
from itertools import count

from msgspec.structs import replace

from workbench.document.model import AnyFigure, Circle, Document, Rectangle, View
from workbench.document.samples.figures import Example, document_of, points_at, polyline
from workbench.language import _


def viewing_examples() -> list[Example]:
    """In the order of the list that a person sees."""
    return [
        Example(
            "view-house",
            _("A house in two viewports"),
            _("One house on one device twice: stretched a third too tall, and beside it the whole street."),
            "view",
            _house(),
        ),
        Example(
            "view-numbers",
            _("Window to viewport by hand"),
            _("The numbers of the course: window (1, 1) to (4, 4), viewport (3, 2) to (6, 6), stepped."),
            "view",
            _numbers(),
        ),
        Example(
            "view-circle",
            _("A circle that becomes an ellipse"),
            _("One window in three viewports, stretched, fitted and filling: only the first one distorts."),
            "view",
            _circle(),
        ),
        Example(
            "view-again",
            _("A house in a house"),
            _("A window a fifth as large, over the pane of the house, shows the very same picture."),
            "view",
            _again(),
        ),
    ]


def _document(
    name: str, size: tuple[int, int], figures: Sequence[AnyFigure], views: Sequence[View]
) -> Document:
    """One sheet with these views."""
    document = document_of(name, *size, figures)
    numbers = count(1)
    numbered = tuple(replace(view, id=f"v{next(numbers)}") for view in views)
    return replace(document, sheets=(replace(document.sheets[0], views=numbered),))


def _street() -> list[AnyFigure]:
    """A house under the sun; its walls have the corners (3, 3) (2, 3) (2, 2) (3, 2)."""
    return [
        polyline([(0.0, 1.75), (1.0, 2.0), (4.0, 2.0), (5.0, 1.5)], 3, _("Ground"), False),
        Circle("", points_at((4.0, 3.75)), "midpoint_circle", 5, _("Sun"), radius_world=0.5),
        polyline([(2.375, 2.0), (2.375, 2.5), (2.625, 2.5), (2.625, 2.0)], 5, _("Door"), False),
        polyline([(1.75, 3.0), (2.5, 3.75), (3.25, 3.0)], 2, _("Roof"), True),
        polyline([(3.0, 3.0), (2.0, 3.0), (2.0, 2.0), (3.0, 2.0)], 1, _("Walls"), True),
    ]


_WINDOW = Rectangle(1.0, 1.0, 4.0, 4.0)


def _house() -> Document:
    tall = View("", _WINDOW, Rectangle(6.0, 8.0, 42.0, 56.0), _("Taller"))
    street = View(
        "", Rectangle(0.0, 1.0, 5.0, 5.0), Rectangle(50.0, 8.0, 90.0, 56.0), _("Street"), mode="fit"
    )
    return _document(_("A house in two viewports"), (96, 64), _street(), [tall, street])


def _numbers() -> Document:
    view = View("", _WINDOW, Rectangle(3.0, 2.0, 6.0, 6.0))
    return _document(_("Window to viewport by hand"), (10, 8), _street(), [view])


def _circle() -> Document:
    square = [(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)]
    figures: list[AnyFigure] = [
        polyline(square, 3, _("Square"), True),
        Circle("", points_at((5.0, 5.0)), "midpoint_circle", 1, _("Circle"), radius_world=3.0),
    ]
    window = Rectangle(1.0, 1.0, 9.0, 9.0)
    views = [
        View("", window, Rectangle(x, 6.0, x + 30.0, 54.0), name, mode=mode)
        for x, name, mode in (
            (6.0, _("Stretched"), "stretch"),
            (45.0, _("Fitted"), "fit"),
            (84.0, _("Filling"), "fill"),
        )
    ]
    return _document(_("A circle that becomes an ellipse"), (120, 60), figures, views)


_AGAIN, _PANE, _LEFT = 0.2, (4.7, 2.05), 1.0


def _again() -> Document:
    """Four houses, each in the pane of the one before, a fifth as large."""
    figures: list[AnyFigure] = []
    scale, x, y = 1.0, _LEFT, 0.0
    for _level in range(4):

        def at(
            places: Sequence[tuple[float, float]], scale: float = scale, x: float = x, y: float = y
        ) -> list[tuple[float, float]]:
            return [(x + scale * u, y + scale * v) for u, v in places]

        figures += [
            polyline(at([(0.0, 0.0), (0.0, 6.0), (8.0, 6.0), (8.0, 0.0)]), 1, _("Walls"), True),
            polyline(at([(-0.6, 6.0), (4.0, 9.5), (8.6, 6.0)]), 2, _("Roof"), True),
            polyline(at([(1.2, 0.0), (1.2, 3.4), (3.2, 3.4), (3.2, 0.0)]), 5, _("Door"), False),
            polyline(at([(4.4, 1.9), (6.6, 1.9), (6.6, 4.1), (4.4, 4.1)]), 3, _("Pane"), True),
        ]
        x, y = x + scale * _PANE[0], y + scale * _PANE[1]
        scale *= _AGAIN
    whole = Rectangle(0.0, -0.5, 10.0, 10.0)
    corner, sides = (_LEFT, 0.0), (whole.xmin, whole.ymin, whole.xmax, whole.ymax)
    smaller = (corner[k % 2] + _PANE[k % 2] + _AGAIN * (side - corner[k % 2]) for k, side in enumerate(sides))
    inner = Rectangle(*(round(side, 9) for side in smaller))
    views = [
        View("", whole, Rectangle(2.0, 4.0, 62.0, 67.0), _("The house"), mode="fit"),
        View("", inner, Rectangle(66.0, 4.0, 126.0, 67.0), _("Its pane"), mode="fit"),
    ]
    return _document(_("A house in a house"), (128, 72), figures, views)
