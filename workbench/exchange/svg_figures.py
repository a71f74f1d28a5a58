"""Figures made of single SVG elements."""

from dataclasses import dataclass, field

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import Pieces
from workbench.algorithms.curves.cubic_pieces import raised_to_cubic
from workbench.document.curve_conversions import path_through
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    Sheet,
    WorldPoint,
)
from workbench.exchange.svg_colours import colour_of, nearest_colour
from workbench.exchange.svg_originals import fault_in
from workbench.exchange.svg_outlines import Outline, length_of, outlines, points_of
from workbench.exchange.svg_tree import Element, SvgError
from workbench.language import _

Array = NDArray[np.float64]

_MOST_PIECES = (Curve.most_points - 1) // 3


@dataclass(slots=True)
class Shape:
    """An element that draws, the matrix (2, 3) it stands under, and the style that holds for it."""

    element: Element
    matrix: Array
    style: dict[str, str]

    @property
    def fill(self) -> int | None:
        """0xRRGGBB, or None; black where nothing is said."""
        return colour_of(self._paint("fill", "black"))

    @property
    def stroke(self) -> int | None:
        """0xRRGGBB, or None, also where nothing is said."""
        return colour_of(self._paint("stroke", "none"))

    @property
    def paint(self) -> int:
        """The one colour that a figure gets: the line's, else the inside's, else black."""
        stroke = self.stroke
        return stroke if stroke is not None else self.fill or 0

    @property
    def hidden(self) -> bool:
        """Whether nothing of it is seen."""
        unseen = self.style.get("visibility", "") in ("hidden", "collapse") or "hidden" in self.style
        return unseen or (self.fill is None and self.stroke is None)

    def corners(self) -> Array:
        """Control points (n, 2) of its outline under its matrix."""
        runs = [[run.begin[None], *run.segments] for run in _outlines(self.element, self.matrix, 1e9)]
        return np.vstack([np.zeros((0, 2)), *(part for run in runs for part in run)])

    def _paint(self, name: str, default: str) -> str:
        text = self.style.get(name, default)
        return self.style.get("color", "black") if text == "currentColor" else text


@dataclass(slots=True)
class Made:
    """What became of an element: its figures, without ids, and the error of the worst, world units."""

    name: str
    figures: list[AnyFigure] = field(default_factory=list)
    error: float = 0.0
    notes: list[str] = field(default_factory=list)


def figures_of(shape: Shape, matrix: Array, sheet: Sheet, tolerance: float) -> Made:
    """The figures, world, of an element whose coordinates ``matrix`` (2, 3) takes to the world.

    Raises: SvgError with the place.
    """
    element = shape.element
    name = element.attributes.get("id", "")[:200]
    made = Made(name or _("<{tag}> in line {line}").format(tag=element.tag, line=element.line))
    colour = nearest_colour(shape.paint, sheet)
    plain = _plain_figure(shape, matrix, colour)
    if plain is not None:
        made.figures.append(plain)
    else:
        for run in _outlines(element, matrix, tolerance):
            made.error = max(made.error, run.error)
            made.figures += _curves(run, colour)
        if shape.fill is not None and made.figures:
            made.notes.append(_("The insides of curves are not filled here."))
    made.figures = [
        _named(figure, name, not shape.hidden) for figure in made.figures if len(figure.points_world)
    ]
    for figure in made.figures:
        fault = fault_in(figure, sheet)
        if fault:
            raise element.refusal(fault)
    if not made.figures:
        made.notes.append(_("{name} draws nothing.").format(name=made.name))
    return made


def outline_data(element: Element) -> str:
    """The path data of any element that draws. Raises: SvgError."""
    match element.tag:
        case "path":
            return element.attributes.get("d", "")
        case "line":
            x1, y1, x2, y2 = (length_of(element, name) for name in ("x1", "y1", "x2", "y2"))
            return f"M {x1!r} {y1!r} L {x2!r} {y2!r}"
        case "polyline" | "polygon":
            points = points_of(element)
            joined = " ".join(f"{x!r} {y!r}" for x, y in points.tolist())
            return f"M {joined} {'Z' * (element.tag == 'polygon')}" if len(points) else ""
        case "rect":
            return _rectangle_data(element)
        case _:
            x, y, rx, ry = _ellipse(element)
            if not (rx > 0 and ry > 0):
                return ""
            half = f"A {rx!r} {ry!r} 0 0 1"
            return f"M {x + rx!r} {y!r} {half} {x - rx!r} {y!r} {half} {x + rx!r} {y!r} Z"


def _outlines(element: Element, matrix: Array, tolerance: float) -> list[Outline]:
    try:
        return outlines(outline_data(element), matrix, tolerance)
    except SvgError as error:
        if element.tag == "path":
            raise element.refusal(str(error)) from error
        raise
    except (ValueError, ArithmeticError, IndexError) as error:
        raise element.refusal(_("the path cannot be understood; correct it.")) from error


def _ellipse(element: Element) -> tuple[float, float, float, float]:
    """Centre and radii of a circle or ellipse."""
    x, y = length_of(element, "cx"), length_of(element, "cy")
    if element.tag == "circle":
        r = length_of(element, "r")
        return x, y, r, r
    return x, y, length_of(element, "rx"), length_of(element, "ry")


def _rectangle_data(element: Element) -> str:
    x, y, width, height = (length_of(element, name) for name in ("x", "y", "width", "height"))
    if not (width > 0 and height > 0):
        return ""
    rx, ry = length_of(element, "rx", -1.0), length_of(element, "ry", -1.0)
    rx, ry = (ry if rx < 0 else rx), (rx if ry < 0 else ry)
    rx, ry = min(max(rx, 0.0), 0.5 * width), min(max(ry, 0.0), 0.5 * height)
    right, top = x + width, y + height
    if not (rx > 0 and ry > 0):
        return f"M {x!r} {y!r} L {right!r} {y!r} {right!r} {top!r} {x!r} {top!r} Z"
    arc = f"A {rx!r} {ry!r} 0 0 1"
    return (
        f"M {x + rx!r} {y!r} H {right - rx!r} {arc} {right!r} {y + ry!r} V {top - ry!r} "
        f"{arc} {right - rx!r} {top!r} H {x + rx!r} {arc} {x!r} {top - ry!r} V {y + ry!r} "
        f"{arc} {x + rx!r} {y!r} Z"
    )


def _plain_figure(shape: Shape, matrix: Array, colour: int) -> AnyFigure | None:
    """The figure that is exactly this element, if it is no path and there is one."""
    element, filled = shape.element, shape.fill is not None
    tag = element.tag
    if tag in ("circle", "ellipse"):
        return _round_figure(element, matrix, colour, filled)
    rounded = tag == "rect" and "A" in outline_data(element)
    if tag == "path" or rounded:
        return None
    runs = _outlines(element, matrix, 1.0)
    corners = [run.begin for run in runs] + [segment[-1] for run in runs for segment in run.segments]
    closed = tag in ("polygon", "rect")
    if closed and len(corners) > 1 and np.array_equal(corners[0], corners[-1]):
        corners.pop()
    points = tuple(WorldPoint("", float(x), float(y)) for x, y in corners)
    if tag == "line":
        return Line("", points, Line.algorithms[0], colour) if len(points) == 2 else None
    if len(points) < 2:
        return None
    if closed and filled and len(points) >= Polygon.least_points:
        return Polygon("", points, Polygon.algorithms[0], colour, nonzero=True)
    return Polyline("", points, Polyline.algorithms[0], colour, closed=closed)


def _round_figure(element: Element, matrix: Array, colour: int, filled: bool) -> AnyFigure | None:
    """A circle or ellipse whose axes lie along x and y."""
    x, y, rx, ry = _ellipse(element)
    (a, c), (b, d) = matrix[:, :2].tolist()
    if not (rx > 0 and ry > 0 and b == 0.0 and c == 0.0 and a and d):
        return None
    centre = matrix[:, :2] @ np.array([x, y]) + matrix[:, 2]
    at = (WorldPoint("", float(centre[0]), float(centre[1])),)
    across, up = abs(a) * rx, abs(d) * ry
    if across == up:
        return Circle("", at, _slug(Circle, filled), colour, radius_world=across)
    return Ellipse("", at, _slug(Ellipse, filled), colour, radius_x_world=across, radius_y_world=up)


def _slug(kind: type[Circle | Ellipse], filled: bool) -> str:
    """What new figures of this kind are drawn by, or the first text that fills them."""
    areas = (slug for slug in kind.algorithms if catalogue.get(slug).emits == "spans")
    return next(areas) if filled else kind.algorithms[0]


def _curves(run: Outline, colour: int) -> list[AnyFigure]:
    """A run as paths of Bézier pieces: one, or several where there are too many pieces for one."""
    if not run.segments:
        return []
    cubics = np.concatenate([raised_to_cubic(segment[None]) for segment in run.segments])
    whole = len(cubics) <= _MOST_PIECES
    parts = [cubics[k : k + _MOST_PIECES] for k in range(0, len(cubics), _MOST_PIECES)]
    return [path_of(part, run.closed and whole, colour) for part in parts]


def path_of(cubics: Array, closed: bool, colour: int) -> Curve:
    """The path of cubic pieces (m, 4, 2), world; ends that meet smoothly are joined so."""
    empty = Curve("", (), Curve.algorithms[0], colour, spline="bezier_path", closed=closed)
    return path_through(empty, Pieces(np.arange(len(cubics) + 1.0), cubics))


def _named(figure: AnyFigure, name: str, visible: bool) -> AnyFigure:
    return replace(figure, name=name, visible=visible)
