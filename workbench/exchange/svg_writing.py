"""SVG out: every visible figure of a sheet, in world units with y turned downwards.

Curves that are plain pieces up to degree 3 are written exactly (lines, quadratics, cubics); any other as
cubics within a stated tolerance. A figure's chain is written as its transform, a group as <g>. Each element
keeps its figure in an attribute of our own.
"""

import math
import re
from collections.abc import Iterator
from itertools import groupby
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import to_cubic_pieces
from workbench.document.curves.pieces import fault_of, pieces_of
from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    Rectangle,
    Sheet,
    WorldPoint,
)
from workbench.document.transforms.chains import is_singular
from workbench.exchange.svg_colours import written
from workbench.exchange.svg_originals import kept
from workbench.exchange.svg_transforms import number, transform_text
from workbench.exchange.svg_tree import OWN, SVG
from workbench.geometry.stretch import largest_stretch
from workbench.language import _
from workbench.rendering.mapping import device_map

_TOLERANCE_PX = 0.05
NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_COMMANDS = {1: "L", 2: "Q", 3: "C"}


class Exported(NamedTuple):
    """An SVG ``text``.

    ``approximated``: what is not exact in it, with its error in world units; ``notes``: a sentence for each
    thing that it does not show.
    """

    text: str
    approximated: tuple[tuple[str, float], ...]
    notes: tuple[str, ...]

    @property
    def error(self) -> float:
        """How far any outline is from its figure, at most, in world units."""
        return max((error for _name, error in self.approximated), default=0.0)


def write_svg(sheet: Sheet, tolerance: float | None = None) -> Exported:
    """The visible figures of ``sheet`` as SVG; what cannot be exact within ``tolerance``, world, by default a
    20th of a pixel. What SVG cannot show (a seed fill, a curve that lacks points) is kept, and noted.
    """
    scale = device_map(sheet)
    within = tolerance or _TOLERANCE_PX / max(abs(scale.sx), abs(scale.sy))
    from xml.sax.saxutils import escape  # brings the network's modules with it

    body: list[tuple[int, str]] = []
    approximated: list[tuple[str, float]] = []
    notes: list[str] = []
    for figure in sheet.figures:
        if not figure.visible:
            continue
        stretch = _stretch(figure)
        tag, attributes, error = _element(figure, within / max(stretch, 1.0))
        error *= stretch
        name = figure.name or figure.id
        if error:
            approximated.append((name, error))
        if not attributes.get("d", "shown"):
            notes.append(_("{name} cannot be shown in SVG; it is kept for this program.").format(name=name))
        if transform := transform_text(figure.transforms):
            attributes["transform"] = transform
        own = {f"workbench:{key}": value for key, value in kept(figure, tag, attributes).items()}
        paint = _paint(figure, sheet, 1.0 / (max(abs(scale.sx), abs(scale.sy)) * _growth(figure)))
        title = f"<title>{escape(NO_XML.sub(' ', figure.name))}</title>" if figure.name else ""
        said = {"id": figure.id, **attributes, **paint, **own}
        body.append((figure.group, f"  <{tag} {_joined(said)}>{title}</{tag}>"))
    view = sheet.first_view
    if len(sheet.views) > 1:
        notes.append(_("Only the first view is in the SVG; export a picture to get them all."))
    head = {
        "xmlns": SVG,
        "xmlns:workbench": OWN,
        "width": str(sheet.width_px),
        "height": str(sheet.height_px),
        "viewBox": " ".join(map(number, _frame(view.window_world))),
        "preserveAspectRatio": "none",
    }
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', f"<svg {_joined(head)}>"]
    if view.clip_world is not None:
        names = ("x", "y", "width", "height")
        inside = dict(zip(names, map(number, _frame(view.clip_world)), strict=True))
        lines.append(f'  <clipPath id="clip-window"><rect {_joined(inside)}/></clipPath>')
        lines.append('  <g clip-path="url(#clip-window)">')
    lines += _in_groups(body)
    if view.clip_world is not None:
        lines.append("  </g>")
    return Exported("\n".join([*lines, "</svg>", ""]), tuple(approximated), tuple(notes))


def _in_groups(body: list[tuple[int, str]]) -> Iterator[str]:
    """The elements, neighbours of one group in a <g>, which says that it is one, whatever else there is."""
    for group, members in groupby(body, key=itemgetter(0)):
        elements = [element for _group, element in members]
        if group and len(elements) > 1:
            elements = [f'  <g workbench:group="{group}">', *elements, "  </g>"]
        yield from elements


def path_data(figure: Curve, tolerance: float) -> tuple[str, float]:
    """Path data of a curve, y downwards, and its error; empty where the curve lacks something."""
    if fault_of(figure):
        return "", 0.0
    pieces, error = pieces_of(figure), 0.0
    if pieces.weights is not None or pieces.degree > 3:
        pieces, error = to_cubic_pieces(pieces, tolerance)
    controls = pieces.controls * [1.0, -1.0]
    letter = _COMMANDS[pieces.degree]
    words = [f"M {_pairs(controls[:1, 0])}"]
    words += [f"{letter} {_pairs(piece[1:])}" for piece in controls]
    size = float(np.abs(controls).max())
    if figure.closed and np.abs(controls[0, 0] - controls[-1, -1]).max() <= 1e-12 * size:
        words.append("Z")
    return " ".join(words), error


def _stretch(figure: AnyFigure) -> float:
    """How much longer the chain of a figure makes a length at most."""
    return 1.0 if figure.matrix is None else largest_stretch(figure.matrix[:2, :2])


def _growth(figure: AnyFigure) -> float:
    """How much wider the chain of a figure makes its line, taken over all directions."""
    if is_singular(figure.matrix) or figure.matrix is None:
        return 1.0
    return float(math.sqrt(abs(np.linalg.det(figure.matrix[:2, :2]))))


def _element(figure: AnyFigure, tolerance: float) -> tuple[str, dict[str, str], float]:
    """Tag, geometry and error of a figure."""
    first = figure.points_world[0] if figure.points_world else WorldPoint("", 0.0, 0.0)
    centre = {"cx": number(first.x), "cy": number(-first.y)}
    match figure:
        case Line():
            last = figure.points_world[-1]
            ends = {"x1": first.x, "y1": -first.y, "x2": last.x, "y2": -last.y}
            return "line", {name: number(value) for name, value in ends.items()}, 0.0
        case Polyline():
            tag = "polygon" if figure.closed else "polyline"
            return tag, {"points": _pairs(_turned(figure.points_world))}, 0.0
        case Polygon():
            rings = (f"M {_pairs(_turned(ring))} Z" for ring in figure.rings)
            return "path", {"d": " ".join(rings)}, 0.0
        case Circle():
            return "circle", {**centre, "r": number(figure.radius_world)}, 0.0
        case Ellipse():
            radii = {"rx": number(figure.radius_x_world), "ry": number(figure.radius_y_world)}
            return "ellipse", {**centre, **radii}, 0.0
        case Curve():
            data, error = path_data(figure, tolerance)
            return "path", {"d": data}, error
        case _:
            return "path", {"d": ""}, 0.0


def _paint(figure: AnyFigure, sheet: Sheet, pixel: float) -> dict[str, str]:
    colour = written(sheet.palette[figure.colour])
    if catalogue.get(figure.drawn_with).emits == "spans":
        rule = "nonzero" if isinstance(figure, Polygon) and figure.nonzero else "evenodd"
        return {"fill": colour, "fill-rule": rule, "stroke": "none"}
    return {"fill": "none", "stroke": colour, "stroke-width": number(pixel)}


def _frame(rectangle: Rectangle) -> tuple[float, float, float, float]:
    """x, y, width and height, y downwards."""
    width, height = rectangle.xmax - rectangle.xmin, rectangle.ymax - rectangle.ymin
    return rectangle.xmin, -rectangle.ymax, width, height


def _turned(points: tuple[WorldPoint, ...]) -> NDArray[np.float64]:
    return np.array([(p.x, -p.y) for p in points], np.float64)


def _pairs(points: NDArray[np.float64]) -> str:
    return " ".join(f"{number(x)},{number(y)}" for x, y in points.tolist())


def _joined(attributes: dict[str, str]) -> str:
    from xml.sax.saxutils import quoteattr

    return " ".join(f"{name}={quoteattr(value)}" for name, value in attributes.items())
