"""What 100 % and 1 em are in each place of an SVG, and how the frames of its drawings lie in each other.

Source: SVG 1.1, chapter 7.
"""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.exchange.path_data import LARGEST
from workbench.exchange.svg_outlines import length_of, pixels
from workbench.exchange.svg_transforms import after
from workbench.exchange.svg_tree import Element, UnreadError
from workbench.language import _

Array = NDArray[np.float64]
Box = tuple[float, float, float, float]
"""x, y, width and height."""

_SIDES = ("width", "height")


def measure(root: Element, viewport: tuple[float, float] | None) -> None:
    """Tell each element what 100 % and 1 em are where it stands."""
    if viewport is not None:
        root.viewport = viewport
    waiting = [root]
    while waiting:
        element = waiting.pop()
        size = pixels(element.style.get("font-size", "1em"), element.font_px, element.font_px)
        if math.isfinite(size) and 0.0 < size <= LARGEST:
            element.font_px = size
        inside = element.viewport
        if element.tag in ("svg", "symbol"):
            try:
                inside = _inner_size(element, element is root)
            except UnreadError:  # said when the element is drawn
                inside = element.viewport
        for child in element.children:
            child.viewport, child.font_px = inside, element.font_px
            waiting.append(child)


def _inner_size(element: Element, outermost: bool) -> tuple[float, float]:
    """Width and height of the coordinates inside an svg or symbol. Raises: UnreadError."""
    inner = view_box(element)
    if inner is not None:
        return inner[2:]
    if outermost or element.tag == "symbol":
        return element.viewport
    width, height = (length_of(element, name, element.viewport[k]) for k, name in enumerate(_SIDES))
    return (width, height) if width > 0 and height > 0 else element.viewport


def frame_inside(element: Element, sized_by: Element) -> Array:
    """The matrix (2, 3) from the inside of a nested svg, or of a symbol that is used, to what is around it.

    ``sized_by`` is the use, if there is one. Raises: UnreadError.
    """
    x, y = (length_of(element, name) for name in ("x", "y")) if element.tag == "svg" else (0.0, 0.0)
    moved = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
    inner = view_box(element)
    sides = [
        length_of(sized_by, name, length_of(element, name, sized_by.viewport[k]))
        for k, name in enumerate(_SIDES)
    ]
    if inner is None or not (sides[0] > 0 and sides[1] > 0):
        return moved
    return after(
        moved, fitted(inner, (sides[0], sides[1]), element.attributes.get("preserveAspectRatio", ""))
    )


def fitted(inner: Box, sides: tuple[float, float], how: str) -> Array:
    """The matrix (2, 3) that puts the box ``inner`` (x, y, width, height) into 0, 0 to ``sides``.

    ``how`` is as preserveAspectRatio has it. Source: SVG 1.1, section 7.8.
    """
    x, y, width, height = inner
    sx, sy = sides[0] / width, sides[1] / height
    word = how.removeprefix("defer").strip()
    if not word.startswith("none"):
        sx = sy = max(sx, sy) if "slice" in word else min(sx, sy)
    across = 0.0 if "xMin" in word else 1.0 if "xMax" in word else 0.5
    down = 0.0 if "YMin" in word else 1.0 if "YMax" in word else 0.5
    left, top = across * (sides[0] - sx * width), down * (sides[1] - sy * height)
    return np.array([[sx, 0.0, left - sx * x], [0.0, sy, top - sy * y]])


def view_box(element: Element) -> Box | None:
    """x, y, width and height of ``viewBox``, if there is one. Raises: UnreadError."""
    words = element.attributes.get("viewBox", "").replace(",", " ").split()
    if not words:
        return None
    try:
        x, y, width, height = (float(word) for word in words)
    except ValueError:
        x = y = width = height = math.nan
    if not (width > 0 and height > 0 and math.isfinite(x + y + width + height)):
        text = element.attributes["viewBox"][:40]
        sentence = _("viewBox {text!r} is not x, y, width and height with both sizes above 0; correct it.")
        raise element.unread(sentence.format(text=text))
    return x, y, width, height


def stated_frame(root: Element) -> Box | None:
    """x, y, width and height of the drawing as the file states them. Raises: UnreadError."""
    inner = view_box(root)
    if inner is not None:
        return inner
    if all("%" not in root.attributes.get(name, "%") for name in _SIDES):
        width, height = (length_of(root, name) for name in _SIDES)
        if width > 0 and height > 0:
            return 0.0, 0.0, width, height
    return None
