"""The shapes of an SVG's tree, back to front, each with all that holds for it: matrix, style, what it uses.

What an element says is read once, however often it is used.
"""

import math
import re
from collections import Counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.storage.content import Progress, silent
from workbench.exchange.path_data import MOST_POINTS, TooManyPointsError
from workbench.exchange.svg_figures import Geometry, Shape
from workbench.exchange.svg_outlines import length_of, transform_of
from workbench.exchange.svg_styles import (
    INHERITED,
    PROPERTIES,
    REFERRING,
    StyleError,
    StyleSheet,
    declarations,
)
from workbench.exchange.svg_transforms import Function, Placing, after, functions_in
from workbench.exchange.svg_tree import GEOMETRY, MOST_DEPTH, MOST_ELEMENTS, Element, all_elements
from workbench.language import _, ngettext

Array = NDArray[np.float64]

_GROUPS = ("svg", "g", "a", "switch")
_SILENT = {"defs", "title", "desc", "metadata", "style", "script", "symbol", "clipPath", "mask", "marker", ""}
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#([^"')]++)["']?\s*\)""")
_BETWEEN_REPORTS = 100


class Drawing(NamedTuple):
    """What a tree shows, and a sentence for each kind of element that no figure can be made of."""

    shapes: list[Shape]
    notes: list[str]


class _Saying(NamedTuple):
    """What an element says of itself and of what is in it; ``references`` are the tags it refers to."""

    matrix: Array | None
    functions: tuple[Function, ...]
    inherited: dict[str, str]
    references: list[str]
    geometry: Geometry | None


def drawing_of(root: Element, viewport: tuple[float, float], progress: Progress = silent) -> Drawing:
    """The shapes in ``root``, of whose width and height ``viewport`` is 100 %. Raises: SvgError."""
    walk = _Walk(root, viewport, progress)
    walk.into(root, Placing(np.eye(2, 3)), {})
    return Drawing(walk.shapes, walk.notes())


class _Walk:
    def __init__(self, root: Element, viewport: tuple[float, float], progress: Progress) -> None:
        self.shapes: list[Shape] = []
        self._progress = progress
        self._left_out: Counter[str] = Counter()
        self._named: dict[str, Element] = {}
        self._sayings: dict[Element, _Saying] = {}
        self._using: list[Element] = []
        self._steps = self._depth = self._points = 0
        elements = all_elements(root)
        element = root
        try:
            rules = StyleSheet("\n".join("".join(each.text) for each in elements))
            for number, element in enumerate(elements):
                if number % _BETWEEN_REPORTS == 0:
                    progress(0.5 * number / len(elements))
                element.viewport = viewport
                said = {name: value for name, value in element.attributes.items() if name in PROPERTIES}
                own = declarations(element.attributes.get("style", ""))
                element.style = {**said, **rules.style_of(element.tag, element.attributes), **own}
                self._named.setdefault(element.attributes.get("id", ""), element)
        except StyleError as error:
            raise element.refusal(str(error)) from error

    def into(self, element: Element, placing: Placing, style: dict[str, str]) -> None:
        """Go through one element and those in it, under what is around it and an inherited ``style``."""
        self._steps += 1
        if self._steps % _BETWEEN_REPORTS == 0:
            self._progress(0.5 + 0.5 * self._steps / MOST_ELEMENTS)
        if self._steps > MOST_ELEMENTS:
            sentence = _("there are more than {most:,} elements; choose a smaller picture.")
            raise element.refusal(sentence.format(most=MOST_ELEMENTS))
        if element.tag not in _GROUPS and element.tag not in GEOMETRY and element.tag != "use":
            self._left_out[element.tag] += element.tag not in _SILENT
            return
        saying = self._sayings.get(element)
        if saying is None:
            saying = self._sayings[element] = self._saying(element)
        self._left_out.update(saying.references)
        if saying.inherited:
            style = {**style, **saying.inherited}
        if saying.matrix is not None:
            placing = placing.within(saying.matrix, saying.functions)
        if saying.geometry is not None:
            self._points += saying.geometry.size
            if self._points > MOST_POINTS:
                raise element.refusal(str(TooManyPointsError()))
            self.shapes.append(Shape(element, placing, style, saying.geometry))
        elif element.tag == "use":
            self._used(element, placing, style)
        else:
            if element.tag == "svg" and self._depth:
                placing = placing.within(_inner_frame(element))
            self._inside(element.children, placing, style)

    def _saying(self, element: Element) -> _Saying:
        own = element.style
        inherited = {name: own[name] for name in INHERITED if own.get(name, "inherit") != "inherit"}
        if own.get("display", "") == "none":
            inherited["hidden"] = "yes"
        links = (_REFERENCE.match(own.get(name, "")) for name in REFERRING)
        targets = [self._named.get(link[1].strip()) for link in links if link]
        return _Saying(
            transform_of(element),
            functions_in(element.attributes.get("transform", "")),
            inherited,
            [target.tag for target in targets if target is not None],
            Geometry.of(element) if element.tag in GEOMETRY else None,
        )

    def _inside(self, elements: list[Element], placing: Placing, style: dict[str, str]) -> None:
        self._depth += 1
        for element in elements:
            if self._depth > MOST_DEPTH:
                sentence = _("what it uses is nested more than {most} deep; ungroup some.")
                raise element.refusal(sentence.format(most=MOST_DEPTH))
            self.into(element, placing, style)
        self._depth -= 1

    def _used(self, element: Element, placing: Placing, style: dict[str, str]) -> None:
        name = element.attributes.get("href", "").strip()
        target = self._named.get(name.removeprefix("#")) if name.startswith("#") else None
        if target is None:
            raise element.refusal(_("it uses {name!r}, which is not there; add it.").format(name=name[:40]))
        if any(target is used for used in self._using):
            raise element.refusal(
                _("it uses {name!r}, which uses itself; break the circle.").format(name=name[:40])
            )
        x, y = length_of(element, "x"), length_of(element, "y")
        if x or y:
            moved = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
            placing = placing.within(moved)
        self._using.append(target)
        if target.tag == "symbol":
            self._left_out["symbol viewBox"] += "viewBox" in target.attributes
        self._inside(target.children if target.tag == "symbol" else [target], placing, style)
        self._using.pop()

    def notes(self) -> list[str]:
        """A sentence for each kind of element that no figure can be made of."""
        return [
            ngettext("Left out: {count} <{tag}>.", "Left out: {count} × <{tag}>.", count).format(
                count=count, tag=tag[:40]
            )
            for tag, count in self._left_out.items()
            if count
        ]


def _inner_frame(element: Element) -> Array:
    """The matrix (2, 3) from the inside of a nested svg to its outside. Raises: SvgError."""
    x, y = length_of(element, "x"), length_of(element, "y")
    moved = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
    inner = stated_frame(element) if "viewBox" in element.attributes else None
    width = length_of(element, "width", element.viewport[0])
    height = length_of(element, "height", element.viewport[1])
    if inner is None or not (width > 0 and height > 0):
        return moved
    sx, sy = width / inner[2], height / inner[3]
    if "none" not in element.attributes.get("preserveAspectRatio", ""):
        sx = sy = min(sx, sy)
    left, top = 0.5 * (width - sx * inner[2]), 0.5 * (height - sy * inner[3])
    return after(moved, np.array([[sx, 0.0, left - sx * inner[0]], [0.0, sy, top - sy * inner[1]]]))


def stated_frame(root: Element) -> tuple[float, float, float, float] | None:
    """x, y, width and height of the drawing as the file states them. Raises: SvgError."""
    words = root.attributes.get("viewBox", "").replace(",", " ").split()
    if words:
        try:
            x, y, width, height = (float(word) for word in words)
        except ValueError:
            x = y = width = height = math.nan
        if not (width > 0 and height > 0 and math.isfinite(x + y + width + height)):
            shown = root.attributes["viewBox"][:40]
            sentence = _("viewBox {text!r} is not x, y, width and height, the last two above 0; correct it.")
            raise root.refusal(sentence.format(text=shown))
        return x, y, width, height
    if all("%" not in root.attributes.get(name, "%") for name in ("width", "height")):
        width, height = (length_of(root, name) for name in ("width", "height"))
        if width > 0 and height > 0:
            return 0.0, 0.0, width, height
    return None
