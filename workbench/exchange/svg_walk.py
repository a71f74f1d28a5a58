"""The shapes of an SVG's tree, back to front, each with all that holds for it: matrix, style, what it uses.

What an element says is read once, however often it is used.
"""

import re
from collections import Counter
from itertools import count
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.storage.content import Progress, silent
from workbench.exchange.path_data import MOST_POINTS, TooManyPointsError
from workbench.exchange.svg_figures import Geometry, Shape
from workbench.exchange.svg_frames import frame_inside, measure
from workbench.exchange.svg_outlines import functions_of, length_of
from workbench.exchange.svg_styles import cascade, share
from workbench.exchange.svg_transforms import Function, Placing, matrix_in
from workbench.exchange.svg_tree import (
    GEOMETRY,
    INHERITED,
    LAYER,
    MOST_DEPTH,
    MOST_ELEMENTS,
    REFERRING,
    Element,
    UnreadError,
    all_elements,
)
from workbench.language import _, ngettext

Array = NDArray[np.float64]

_DRAWN = {"svg", "g", "a", "switch", "use", *GEOMETRY}
_SILENT = {"defs", "title", "desc", "metadata", "style", "script", "symbol", "clipPath", "mask", "marker", ""}
_REFERENCE = re.compile(r"""\s*url\(\s*["']?#([^"')]++)["']?\s*\)""")
_BETWEEN_REPORTS = 100
_MOST_FUNCTIONS = 150_000  # of the transforms around all shapes


class Drawing(NamedTuple):
    """What a tree shows.

    ``notes``: a sentence for each kind of element that no figure can be made of; ``unread``: one for each
    element that cannot be read.
    """

    shapes: list[Shape]
    notes: list[str]
    unread: list[str]


class _Saying(NamedTuple):
    """What an element says of itself and of what is in it; ``references`` are those it refers to."""

    functions: tuple[Function, ...]
    inherited: dict[str, str]
    opacity: float
    references: list[Element]
    geometry: Geometry | None


def drawing_of(root: Element, viewport: tuple[float, float] | None, progress: Progress = silent) -> Drawing:
    """The shapes in ``root``, of whose width and height ``viewport`` is 100 %, if it is known.

    Raises: SvgError.
    """
    walk = _Walk(root, viewport, progress)
    walk.into(root, Placing(np.eye(2, 3)), {})
    return Drawing(walk.shapes, walk.notes(), list(walk.unread))


class _Walk:
    def __init__(self, root: Element, viewport: tuple[float, float] | None, progress: Progress) -> None:
        self.shapes: list[Shape] = []
        self.unread: dict[str, None] = {}
        self._progress = progress
        self._left_out: Counter[str] = Counter()
        self._passed: set[Element] = set()
        self._referred: set[Element] = set()
        self._named: dict[str, Element] = {}
        self._sayings: dict[Element, _Saying | None] = {}
        self._using: list[Element] = []
        self._steps = self._depth = self._points = self._functions = 0
        self._numbers, self._group = count(1), 0
        elements = all_elements(root)
        progress(0.1)
        self._left_out.update(f"style {selector}" for selector in cascade(root, elements))
        progress(0.4)
        for element in elements:
            self._named.setdefault(element.attributes.get("id", ""), element)
        measure(root, viewport)

    def into(self, element: Element, placing: Placing, style: dict[str, str]) -> None:
        """Go through one element and those in it, under what is around it and an inherited ``style``."""
        self._steps += 1
        if self._steps % _BETWEEN_REPORTS == 0:
            self._progress(0.5 + 0.5 * self._steps / MOST_ELEMENTS)
        if self._steps > MOST_ELEMENTS:
            sentence = _("there are more than {most:,} elements; choose a smaller picture.")
            raise element.refusal(sentence.format(most=MOST_ELEMENTS))
        if element.tag not in _DRAWN:
            if element.tag not in _SILENT:
                self._left_out[element.tag] += 1
                self._passed.add(element)
            return
        if element not in self._sayings:
            self._sayings[element] = self._readable(element)
        saying = self._sayings[element]
        if saying is None:
            return
        self._referred.update(saying.references)
        if saying.inherited or saying.opacity < 1.0:
            opacity = float(style.get("opacity", 1.0)) * saying.opacity
            style = {**style, **saying.inherited, "opacity": repr(opacity)}
        if saying.functions:
            placing = placing.within(matrix_in(saying.functions), saying.functions)
        self._functions += len(placing.functions)
        if self._functions > _MOST_FUNCTIONS:
            sentence = _("there are more than {most:,} transforms around shapes; choose a smaller picture.")
            raise element.refusal(sentence.format(most=_MOST_FUNCTIONS))
        if saying.geometry is not None:
            self._points += saying.geometry.size
            if self._points > MOST_POINTS:
                raise element.refusal(str(TooManyPointsError()))
            group = self._group or next(self._numbers)
            self.shapes.append(Shape(element, placing, style, saying.geometry, group))
            return
        try:
            if element.tag == "use":
                self._used(element, placing, style)
            elif element.tag == "svg" and self._depth:
                self._inside(element.children, placing.within(frame_inside(element, element)), style)
            else:
                self._inside(_drawn_in(element), placing, style)
        except UnreadError as error:
            self.unread[str(error)] = None

    def _readable(self, element: Element) -> _Saying | None:
        """What an element says; None, and a sentence kept, where it cannot be read."""
        try:
            return self._saying(element)
        except UnreadError as error:
            self.unread[str(error)] = None
            return None

    def _saying(self, element: Element) -> _Saying:
        own = element.style
        inherited = {name: own[name] for name in INHERITED if own.get(name, "inherit") != "inherit"}
        if own.get("display", "") == "none":
            inherited["hidden"] = "yes"
        opacity = share(own.get("opacity", "1"))
        links = (_REFERENCE.match(own.get(name, "")) for name in REFERRING)
        targets = [self._named.get(link[1].strip()) for link in links if link]
        return _Saying(
            functions_of(element),
            inherited,
            1.0 if opacity is None else opacity,
            [target for target in targets if target is not None],
            Geometry.of(element) if element.tag in GEOMETRY else None,
        )

    def _inside(self, elements: list[Element], placing: Placing, style: dict[str, str]) -> None:
        self._depth += 1
        for element in elements:
            if self._depth > MOST_DEPTH:
                sentence = _("what it uses is nested more than {most} deep; ungroup some.")
                raise element.refusal(sentence.format(most=MOST_DEPTH))
            around = self._group
            if not around and _is_group(element, elements):
                self._group = next(self._numbers)
            self.into(element, placing, style)
            self._group = around
        self._depth -= 1

    def _used(self, element: Element, placing: Placing, style: dict[str, str]) -> None:
        name = element.attributes.get("href", "").strip()
        target = self._named.get(name.removeprefix("#")) if name.startswith("#") else None
        if target is None:
            raise element.unread(_("it uses {name!r}, which does not exist; add it.").format(name=name[:40]))
        if any(target is used for used in self._using):
            raise element.unread(
                _("it uses {name!r}, which uses itself; break the circle.").format(name=name[:40])
            )
        x, y = length_of(element, "x"), length_of(element, "y")
        if x or y:
            moved = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
            placing = placing.within(moved)
        inside = [target]
        if target.tag == "symbol" or (target.tag == "svg" and "viewBox" in target.attributes):
            placing, inside = placing.within(frame_inside(target, element)), target.children
        self._using.append(target)
        self._inside(inside, placing, style)
        self._using.pop()

    def notes(self) -> list[str]:
        """A sentence for each kind of element that no figure can be made of."""
        left_out = self._left_out + Counter(each.tag for each in self._referred - self._passed)
        return [
            ngettext("Left out: {count} <{tag}>.", "Left out: {count} × <{tag}>.", count).format(
                count=count, tag=tag[:40]
            )
            for tag, count in left_out.items()
        ]


def _is_group(element: Element, siblings: list[Element]) -> bool:
    """Whether what is in it stays together: not in a layer, nor in what merely holds the whole drawing."""
    if element.tag not in ("g", "use") or element.attributes.get(LAYER) == "layer":
        return False
    if "own:group" in element.attributes:
        return True
    return any(other is not element and other.tag in _DRAWN for other in siblings)


def _drawn_in(element: Element) -> list[Element]:
    """The children that are drawn: of a switch the first one that asks for nothing special."""
    if element.tag != "switch":
        return element.children
    for child in element.children:
        languages = child.attributes.get("systemLanguage", "en").lower().split(",")
        plain = not child.attributes.get("requiredExtensions", "").strip()
        if child.tag and plain and any(word.strip().startswith("en") for word in languages):
            return [child]
    return []
