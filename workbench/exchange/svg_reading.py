"""SVG in: paths and basic shapes become figures of a sheet, exact but for arcs, whose error is stated.

The rule of the frame: the drawing's ``viewBox`` (or its width and height, or else the box around what is
drawn) is put into the middle of the sheet's window as large as fits, in its own proportions, y upwards. So a
picture that this program wrote comes back to where it was.

A path becomes one Curve of Bézier pieces for each of its runs, quadratic and straight ones raised to cubics;
line, polyline, polygon and rect become lines, polylines or, when filled, polygons; circle and ellipse stay
themselves where their axes lie along x and y.
"""

import math
import re
from collections import Counter
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.building import without_ids
from workbench.document.check import MAX_FIGURES
from workbench.document.model import AnyFigure, Rectangle, Sheet
from workbench.exchange.svg_colours import nearest_colour
from workbench.exchange.svg_figures import Shape, figures_of
from workbench.exchange.svg_originals import GEOMETRY, fault_in, moved, original
from workbench.exchange.svg_outlines import length_of, transform_of
from workbench.exchange.svg_styles import StyleSheet
from workbench.exchange.svg_tree import MOST_DEPTH, Element, read_tree
from workbench.language import _, ngettext
from workbench.rendering.mapping import device_map

Array = NDArray[np.float64]

_GROUPS = ("svg", "g", "a", "switch")
_SILENT = {"defs", "title", "desc", "metadata", "style", "script", "symbol", "clipPath", "mask", "marker", ""}
# What an element may refer to by these changes how it looks, and no figure has it.
_REFERRING = (
    "fill",
    "stroke",
    "clip-path",
    "mask",
    "filter",
    "marker",
    "marker-start",
    "marker-mid",
    "marker-end",
)
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#([^"')]+?)\s*["']?\s*\)""")
_INHERITED = ("fill", "stroke", "visibility", "color")
_TOLERANCE_PX = 0.05
_ROUNDING = 1e-12


class Imported(NamedTuple):
    """What an SVG holds.

    ``figures`` without ids, from back to front; ``approximated``: what is not exact, with its error in world
    units; ``notes``: a sentence for each thing that did not come along.
    """

    figures: tuple[AnyFigure, ...]
    approximated: tuple[tuple[str, float], ...]
    notes: tuple[str, ...]

    @property
    def error(self) -> float:
        """How far any figure is from what the SVG describes, at most, in world units."""
        return max((error for _name, error in self.approximated), default=0.0)


def read_svg(drawing: str | bytes | Element, sheet: Sheet, tolerance: float | None = None) -> Imported:
    """The figures of an SVG, its text or its tree, for ``sheet``.

    Arcs are within ``tolerance``, world, by default a 20th of a pixel.
    Raises: SvgError, one sentence with line, column and number of the path's command; nothing is half read.
    """
    root = drawing if isinstance(drawing, Element) else read_tree(drawing)
    stated = _frame(root)
    walk = _Walk(root, stated[2:] if stated else (0.0, 0.0))
    walk.into(root, np.eye(2, 3), {})
    window = sheet.window_world
    box = stated or _drawn(walk.found)
    scale = min((window.xmax - window.xmin) / box[2], (window.ymax - window.ymin) / box[3])
    scale = 1.0 if abs(scale - 1.0) <= _ROUNDING else scale
    dx = _shift(window.xmin, window.xmax, scale * box[0], scale * box[2])
    dy = _shift(window.ymin, window.ymax, -scale * (box[1] + box[3]), scale * box[3])
    frame = np.array([[scale, 0.0, dx], [0.0, -scale, dy]])
    pixel = max(abs(v) for v in device_map(sheet)[:2])
    within = tolerance or _TOLERANCE_PX / pixel
    figures: list[AnyFigure] = []
    approximated: list[tuple[str, float]] = []
    notes = walk.notes()
    for shape in walk.found:
        restored = _restored(shape, sheet, scale, dx, dy)
        if restored is not None:
            figures.append(restored)
            continue
        made = figures_of(shape, _after(frame, shape.matrix), sheet, within)
        figures += made.figures
        approximated += [(made.name, made.error)] if made.error else []
        notes += made.notes
    return Imported(tuple(figures), tuple(approximated), tuple(dict.fromkeys(notes)))


def frame_of(root: Element) -> Rectangle:
    """The window, world, in which the drawing keeps its own coordinates, but for y, which goes upwards.

    Raises: SvgError.
    """
    stated = _frame(root)
    if stated is None:
        walk = _Walk(root, (0.0, 0.0))
        walk.into(root, np.eye(2, 3), {})
        stated = _drawn(walk.found)
    x, y, width, height = stated
    return Rectangle(x, -(y + height), x + width, -y)


def size_of(root: Element) -> tuple[float, float] | None:
    """Width and height that the drawing wants to be shown in, pixels of 1/96 inch, if it states both."""
    if any("%" in root.attributes.get(name, "%") for name in ("width", "height")):
        return None
    width, height = length_of(root, "width"), length_of(root, "height")
    return (width, height) if width > 0 and height > 0 else None


def _shift(low: float, high: float, begin: float, length: float) -> float:
    """What brings the middle of a length to the middle of low and high; 0 where only rounding parts them."""
    found = 0.5 * (low + high) - (begin + 0.5 * length)
    return 0.0 if abs(found) <= _ROUNDING * max(abs(low), abs(high)) else found


class _Walk:
    """Collects the shapes of a tree, with what they inherit."""

    def __init__(self, root: Element, viewport: tuple[float, float]) -> None:
        self.found: list[Shape] = []
        self._left_out: Counter[str] = Counter()
        self._named: dict[str, Element] = {}
        elements = _all(root)
        rules = StyleSheet("\n".join(element.text for element in elements))
        for element in elements:
            element.viewport = viewport
            element.sheet = rules.style_of(element.tag, element.attributes)
            self._named.setdefault(element.attributes.get("id", ""), element)
        self._using: list[Element] = []
        self._steps = self._depth = 0

    def into(self, element: Element, matrix: Array, style: dict[str, str]) -> None:
        """Go through one element and those in it, under ``matrix`` and an inherited ``style``."""
        self._steps += 1
        if self._steps > MAX_FIGURES:
            sentence = _("there are more than {most:,} elements; choose a smaller picture.")
            raise element.refusal(sentence.format(most=MAX_FIGURES))
        own = element.style
        merged = {
            **style,
            **{name: own[name] for name in _INHERITED if own.get(name, "inherit") != "inherit"},
        }
        if own.get("display", "") == "none":
            merged["hidden"] = "yes"
        if element.tag not in _GROUPS and element.tag not in GEOMETRY and element.tag != "use":
            self._left_out[element.tag] += element.tag not in _SILENT
            return
        self._leave_out_references(own)
        matrix = _after(matrix, transform_of(element))
        if element.tag in GEOMETRY:
            self.found.append(Shape(element, matrix, merged))
        elif element.tag == "use":
            self._used(element, matrix, merged)
        else:
            if element.tag == "svg" and self._depth:
                matrix = _after(matrix, _inner_frame(element))
            self._inside(element.children, matrix, merged)

    def _leave_out_references(self, style: dict[str, str]) -> None:
        for name in _REFERRING:
            found = _REFERENCE.match(style.get(name, ""))
            if found and found[1] in self._named:
                self._left_out[self._named[found[1]].tag] += 1

    def _inside(self, elements: list[Element], matrix: Array, style: dict[str, str]) -> None:
        self._depth += 1
        for element in elements:
            if self._depth > MOST_DEPTH:
                sentence = _("what it uses is nested more than {most} deep; ungroup some.")
                raise element.refusal(sentence.format(most=MOST_DEPTH))
            self.into(element, matrix, style)
        self._depth -= 1

    def _used(self, element: Element, matrix: Array, style: dict[str, str]) -> None:
        name = element.attributes.get("href", "").strip()
        target = self._named.get(name.removeprefix("#")) if name.startswith("#") else None
        if target is None:
            raise element.refusal(_("it uses {name!r}, which is not there; add it.").format(name=name[:40]))
        if any(target is used for used in self._using):
            raise element.refusal(
                _("it uses {name!r}, which uses itself; break the circle.").format(name=name[:40])
            )
        x, y = length_of(element, "x"), length_of(element, "y")
        matrix = _after(matrix, np.array([[1.0, 0.0, x], [0.0, 1.0, y]]))
        self._using.append(target)
        if target.tag == "symbol":
            self._left_out["symbol viewBox"] += "viewBox" in target.attributes
        self._inside(target.children if target.tag == "symbol" else [target], matrix, style)
        self._using.pop()

    def notes(self) -> list[str]:
        """A sentence for each kind of element that no figure can be made of."""
        return [
            ngettext("Left out: {count} <{tag}>.", "Left out: {count} × <{tag}>.", count).format(
                count=count, tag=tag
            )
            for tag, count in self._left_out.items()
            if count
        ]


def _inner_frame(element: Element) -> Array:
    """The matrix (2, 3) from the inside of a nested svg to its outside. Raises: SvgError."""
    x, y = length_of(element, "x"), length_of(element, "y")
    found = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
    inner = _frame(element) if "viewBox" in element.attributes else None
    width = length_of(element, "width", element.viewport[0])
    height = length_of(element, "height", element.viewport[1])
    if inner is None or not (width > 0 and height > 0):
        return found
    sx, sy = width / inner[2], height / inner[3]
    if "none" not in element.attributes.get("preserveAspectRatio", ""):
        sx = sy = min(sx, sy)
    left, top = 0.5 * (width - sx * inner[2]), 0.5 * (height - sy * inner[3])
    return _after(found, np.array([[sx, 0.0, left - sx * inner[0]], [0.0, sy, top - sy * inner[1]]]))


def _all(root: Element) -> list[Element]:
    found = [root]
    for element in found:
        found += element.children
    return found


def _after(outer: Array, inner: Array) -> Array:
    """The matrix (2, 3) of ``inner`` followed by ``outer``."""
    return np.column_stack([outer[:, :2] @ inner[:, :2], outer[:, :2] @ inner[:, 2] + outer[:, 2]])


def _frame(root: Element) -> tuple[float, float, float, float] | None:
    """x, y, width and height of the drawing as the file states them. Raises: SvgError."""
    words = root.attributes.get("viewBox", "").replace(",", " ").split()
    if words:
        try:
            x, y, width, height = (float(word) for word in words)
        except ValueError:
            x = y = width = height = math.nan
        if not (width > 0 and height > 0 and math.isfinite(x + y + width + height)):
            shown = root.attributes["viewBox"][:40]
            sentence = _("viewBox {text!r} is no x, y, width and height above 0; correct it.")
            raise root.refusal(sentence.format(text=shown))
        return x, y, width, height
    if all("%" not in root.attributes.get(name, "%") for name in ("width", "height")):
        width, height = (length_of(root, name) for name in ("width", "height"))
        if width > 0 and height > 0:
            return 0.0, 0.0, width, height
    return None


def _drawn(shapes: list[Shape]) -> tuple[float, float, float, float]:
    """The box around the control points of all shapes; a little wider where it would have no size."""
    points = np.vstack([np.zeros((0, 2)), *(shape.corners() for shape in shapes)])
    if not len(points):
        return 0.0, 0.0, 1.0, 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    wide = max(float(size.max()), 1e-9 * float(np.abs(points).max()), 1e-9)
    size = np.maximum(size, 1e-3 * wide)
    low = 0.5 * (low + high - size)
    return float(low[0]), float(low[1]), float(size[0]), float(size[1])


def _restored(shape: Shape, sheet: Sheet, scale: float, dx: float, dy: float) -> AnyFigure | None:
    """The figure that a shape was made of, if it was only scaled and moved since."""
    figure = original(shape.element.tag, shape.element.attributes)
    (a, c, e), (b, d, f) = shape.matrix.tolist()
    if figure is None or (b, c) != (0.0, 0.0) or a != d or a <= 0:
        return None
    figure = moved(without_ids(figure), scale * a, scale * e + dx, dy - scale * f)
    colour = figure.colour
    wanted = nearest_colour(shape.paint, sheet)
    if not (colour < len(sheet.palette) and sheet.palette[colour] == sheet.palette[wanted]):
        figure = replace(figure, colour=wanted)
    figure = replace(figure, visible=not shape.hidden)
    return None if fault_in(figure, sheet) else figure
