"""Figures made of single SVG elements."""

import math
from dataclasses import dataclass, field

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import Pieces, chord_counts, polyline
from workbench.document.curves.conversions import path_through
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    WorldPoint,
)
from workbench.exchange.path_data import MOST_POINTS, Run, TooManyPointsError, runs
from workbench.exchange.svg_arcs import Arc
from workbench.exchange.svg_colours import BLACK, Colours, Paint, paint_of
from workbench.exchange.svg_outlines import Outline, length_of, outline, pixels, points_of
from workbench.exchange.svg_styles import share
from workbench.exchange.svg_transforms import Placing
from workbench.exchange.svg_tree import Element, SvgError
from workbench.language import _

Array = NDArray[np.float64]

MOST_PIECES = (Curve.most_points - 1) // 3
# The handles of a circle of radius 1 in quarters: no point of it is outside of them.
_WIDE_PX = 2.0  # a line that is drawn narrower by more than a pixel is told of
_HANDLE = 4.0 / 3.0 * (math.sqrt(2.0) - 1.0)
_ROUND = np.array([(s * x, t * y) for s in (1, -1) for t in (1, -1) for x, y in ((1, _HANDLE), (_HANDLE, 1))])


@dataclass(slots=True, eq=False)
class Geometry:
    """What an element draws, in its own coordinates; ``size`` is how many points its figures have."""

    element: Element
    runs: list[Run]
    size: int

    @classmethod
    def of(cls, element: Element) -> "Geometry":
        """That of any element that draws. Raises: SvgError with the place."""
        drawn = _runs(element)
        segments, points = sum(len(run.kinds) for run in drawn), sum(len(run.points) for run in drawn)
        return cls(element, drawn, 3 * segments + len(drawn) if element.tag == "path" else points)

    def outlines(self, matrix: Array, tolerance: float) -> list[Outline]:
        """Under ``matrix`` (2, 3), arcs within ``tolerance``. Raises: SvgError with the place."""
        drawn: list[Outline] = []
        points = 0
        try:
            for run in self.runs:
                drawn.append(outline(run, matrix, tolerance))
                points += len(drawn[-1].points)
                if points > MOST_POINTS:
                    raise TooManyPointsError
            return drawn
        except TooManyPointsError as error:
            raise self.element.refusal(str(error)) from error
        except (ValueError, ArithmeticError, IndexError) as error:
            raise self.element.unread(_("the path cannot be understood; correct it.")) from error


@dataclass(slots=True, eq=False)
class Shape:
    """An element that draws, the transforms it stands under, and the style that holds for it.

    What has the same ``group`` stays together, as all that is made of the element does.
    """

    element: Element
    placing: Placing
    style: dict[str, str]
    geometry: Geometry
    group: int

    @property
    def fill(self) -> Paint | None:
        """What its inside is painted with, or None; black where nothing is said."""
        return self._paint("fill", "black")

    @property
    def stroke(self) -> Paint | None:
        """What its outline is painted with, or None, also where nothing is said or it has no width."""
        width = self.style.get("stroke-width", "1")
        return self._paint("stroke", "none") if pixels(width, 100.0) != 0.0 else None

    @property
    def paint(self) -> Paint:
        """The one colour that the figure it was made of has: the line's, else the inside's, else black."""
        return self.stroke or self.fill or BLACK

    @property
    def hidden(self) -> bool:
        """Whether nothing of it is seen."""
        unseen = self.style.get("visibility", "") in ("hidden", "collapse") or "hidden" in self.style
        return unseen or (self.fill is None and self.stroke is None)

    @property
    def nonzero(self) -> bool:
        """Whether what is inside is found by counting windings."""
        return self.style.get("fill-rule", "") != "evenodd"

    def corners(self) -> Array:
        """Control points (n, 2) of its outline under its matrix."""
        if self.element.tag in ("circle", "ellipse"):
            x, y, rx, ry = _ellipse(self.element)
            around = _ROUND * [rx, ry] + [x, y] if rx > 0 and ry > 0 else np.zeros((0, 2))
            matrix = self.placing.matrix
            placed: Array = around @ matrix[:, :2].T + matrix[:, 2]
            return placed
        parts = [part.points for part in self.geometry.outlines(self.placing.matrix, 1e9)]
        return np.vstack([np.zeros((0, 2)), *parts])

    def _paint(self, name: str, default: str) -> Paint | None:
        paint = paint_of(self.style.get(name, default), self.style.get("color", "black"))
        if paint is None:
            return None
        alpha = paint.alpha * (share(self.style.get(f"{name}-opacity", "1")) or 0.0)
        alpha *= float(self.style.get("opacity", 1.0))
        return paint._replace(alpha=alpha) if alpha > 0 else None


def losses(shape: Shape, scale: float) -> list[str]:
    """What of a shape's look no figure has, in sentences; ``scale`` is the pixels of the sheet in a unit."""
    said: list[str] = []
    style = shape.style
    if any(style.get(name, "").strip().startswith("url(") for name in ("fill", "stroke")):
        said.append(_("Gradients and patterns are left out; what they fill gets a single colour."))
    if shape.stroke is None:
        return said
    width = pixels(style.get("stroke-width", "1"), 100.0)
    size = math.sqrt(abs(float(np.linalg.det(shape.placing.matrix[:, :2])))) * scale
    if style.get("stroke-dasharray", "none").strip() not in ("", "none") or width * size > _WIDE_PX:
        said.append(_("Lines are drawn one pixel wide and without dashes, along their centre."))
    return said


@dataclass(slots=True)
class Made:
    """What became of an element: its figures, without ids, and the error of the worst, world units."""

    name: str
    figures: list[AnyFigure] = field(default_factory=list)
    error: float = 0.0
    notes: list[str] = field(default_factory=list)


def figures_of(shape: Shape, matrix: Array, colours: Colours, tolerance: float) -> Made:
    """The figures, world, of an element whose coordinates ``matrix`` (2, 3) takes to the world.

    An inside and an outline are two figures, the outline in front. Curved insides are polygons within
    ``tolerance``; such a path that has an inside alone gets its outline too, to be edited as a curve.
    Raises: UnreadError with the place, SvgError for too many points.
    """
    element = shape.element
    name = element.attributes.get("id", "")[:200]
    made = Made(name or _("<{tag}> in line {line}").format(tag=element.tag, line=element.line))
    fill, stroke = shape.fill, shape.stroke
    outlines = [] if element.tag in ("circle", "ellipse") else shape.geometry.outlines(matrix, tolerance)
    made.error = max((each.error for each in outlines), default=0.0)
    if fill is not None and (area := _area(shape, matrix, outlines, colours.index_of(fill), tolerance)):
        made.figures.append(area)
    curved = any(degree != 1 for each in outlines for degree in each.degrees)
    made.error += tolerance if curved and made.figures else 0.0
    lined = stroke or fill or BLACK
    if stroke is not None or not made.figures or curved:
        made.figures += _lines(shape, matrix, outlines, colours.index_of(lined), tolerance)
    made.figures = [
        replace(figure, name=name, visible=not shape.hidden)
        for figure in made.figures
        if len(figure.points_world)
    ]
    if not made.figures:
        made.notes.append(_("{name} draws nothing.").format(name=made.name))
    return made


def _runs(element: Element) -> list[Run]:
    """The outline of any element that draws. Raises: SvgError with the place."""
    match element.tag:
        case "path":
            try:
                return runs(element.attributes.get("d", ""))
            except TooManyPointsError as error:
                raise element.refusal(str(error)) from error
            except SvgError as error:
                raise element.unread(str(error)) from error
        case "line":
            x1, y1, x2, y2 = (length_of(element, name) for name in ("x1", "y1", "x2", "y2"))
            return [Run([(x1, y1), (x2, y2)], [1])]
        case "polyline" | "polygon":
            points = points_of(element)
            return [Run(points, [1] * (len(points) - 1), element.tag == "polygon")] if points else []
        case "rect":
            return _rectangle(element)
        case _:
            x, y, rx, ry = _ellipse(element)
            half = Arc(rx, ry, 0.0, False, True)
            ends = [(x + rx, y), (x - rx, y), (x + rx, y)]
            return [Run(ends, [half, half], True)] if rx > 0 and ry > 0 else []


def _ellipse(element: Element) -> tuple[float, float, float, float]:
    """Centre and radii of a circle or ellipse."""
    x, y = length_of(element, "cx"), length_of(element, "cy")
    if element.tag == "circle":
        r = length_of(element, "r")
        return x, y, r, r
    rx, ry = length_of(element, "rx", -1.0), length_of(element, "ry", -1.0)
    return x, y, (ry if rx < 0 else rx), (rx if ry < 0 else ry)


def _rectangle(element: Element) -> list[Run]:
    x, y, width, height = (length_of(element, name) for name in ("x", "y", "width", "height"))
    if not (width > 0 and height > 0):
        return []
    rx, ry = length_of(element, "rx", -1.0), length_of(element, "ry", -1.0)
    rx, ry = (ry if rx < 0 else rx), (rx if ry < 0 else ry)
    rx, ry = min(max(rx, 0.0), 0.5 * width), min(max(ry, 0.0), 0.5 * height)
    right, top = x + width, y + height
    if not (rx > 0 and ry > 0):
        return [Run([(x, y), (right, y), (right, top), (x, top)], [1, 1, 1], True)]
    # Along each side, and then round the corner at its end.
    sides = [
        ((x + rx, y), (right - rx, y)),
        ((right, y + ry), (right, top - ry)),
        ((right - rx, top), (x + rx, top)),
        ((x, top - ry), (x, y + ry)),
    ]
    points = [*(end for side in sides for end in side), sides[0][0]]
    return [Run(points, [1, Arc(rx, ry, 0.0, False, True)] * 4, True)]


def _area(
    shape: Shape, matrix: Array, outlines: list[Outline], colour: int, tolerance: float
) -> AnyFigure | None:
    """The inside of an element, if it has any."""
    if shape.element.tag in ("circle", "ellipse"):
        plain = _round_figure(shape.element, matrix, colour, True)
        if plain is not None:
            return plain
        outlines = shape.geometry.outlines(matrix, tolerance)
    if sum(_most_corners(each, tolerance) for each in outlines) > Polygon.most_points:
        raise shape.element.refusal(str(TooManyPointsError()))
    rings = [ring for each in outlines if len(ring := _corners(each, tolerance)) >= Polygon.least_points]
    if not rings:
        return None
    ends = np.cumsum([len(ring) for ring in rings]).tolist()
    points = tuple(WorldPoint("", x, y) for ring in rings for x, y in ring.tolist())
    several = tuple(ends) if len(ends) > 1 else ()
    return Polygon("", points, Polygon.algorithms[0], colour, ring_ends=several, nonzero=shape.nonzero)


def _most_corners(drawn: Outline, tolerance: float) -> int:
    """How many corners a run comes to before those that are twice in a row are left out."""
    if not any(degree != 1 for degree in drawn.degrees):
        return len(drawn.points)
    cubics = drawn.cubics()
    return int(chord_counts(Pieces(np.arange(len(cubics) + 1.0), cubics), tolerance).sum())


def _corners(drawn: Outline, tolerance: float) -> Array:
    """The corners (n, 2) of a run, curves within ``tolerance``, none twice in a row."""
    if any(degree != 1 for degree in drawn.degrees):
        cubics = drawn.cubics()
        corners = polyline(Pieces(np.arange(len(cubics) + 1.0), cubics), tolerance)
    else:
        corners = drawn.points
    if len(corners):
        corners = corners[np.any(corners != np.roll(corners, -1, axis=0), axis=1)]
    return corners


def _lines(
    shape: Shape, matrix: Array, outlines: list[Outline], colour: int, tolerance: float
) -> list[AnyFigure]:
    """The outline of an element: the figure that is exactly it, or curves."""
    tag = shape.element.tag
    if tag in ("circle", "ellipse"):
        plain = _round_figure(shape.element, matrix, colour, False)
        if plain is not None:
            return [plain]
        outlines = shape.geometry.outlines(matrix, tolerance)
    elif tag != "path" and not any(run.curved for run in shape.geometry.runs):
        corners = outlines[0].points.tolist() if outlines else []
        closed = tag in ("polygon", "rect")
        if closed and len(corners) > 1 and corners[0] == corners[-1]:
            corners.pop()
        points = tuple(WorldPoint("", x, y) for x, y in corners)
        if len(points) < 2:
            return []
        if tag == "line":
            return [Line("", points, Line.algorithms[0], colour)]
        return [Polyline("", points, Polyline.algorithms[0], colour, closed=closed)]
    return [figure for run in outlines for figure in _curves(run, colour)]


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
    return (catalogue.filling(kind.algorithms) if filled else kind.algorithms)[0]


def _curves(run: Outline, colour: int) -> list[AnyFigure]:
    """A run as paths of Bézier pieces: one, or several where there are too many pieces for one."""
    if not run.degrees:
        return []
    cubics = run.cubics()
    whole = len(cubics) <= MOST_PIECES
    parts = [cubics[k : k + MOST_PIECES] for k in range(0, len(cubics), MOST_PIECES)]
    return [path_of(part, run.closed and whole, colour) for part in parts]


def path_of(cubics: Array, closed: bool, colour: int) -> Curve:
    """The path of cubic pieces (m, 4, 2), world; ends that meet smoothly are joined so."""
    empty = Curve("", (), Curve.algorithms[0], colour, spline="bezier_path", closed=closed)
    return path_through(empty, Pieces(np.arange(len(cubics) + 1.0), cubics))
