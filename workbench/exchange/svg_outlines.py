"""Outlines of SVG elements as Bézier segments in the element's own coordinates; arcs become cubics.

Source: SVG 1.1, chapters 8 and 9.
"""

import math
import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from workbench.exchange.path_data import LARGEST, MOST_POINTS, Run, TooManyPointsError, runs
from workbench.exchange.svg_arcs import arc_pieces
from workbench.exchange.svg_transforms import MOST_FUNCTIONS, Function, functions_in, matrix_in
from workbench.exchange.svg_tree import Element, SvgError
from workbench.geometry.curves.cubic_pieces import raised_to_cubic
from workbench.language import _

Array = NDArray[np.float64]

_LENGTH = re.compile(r"([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)(px|pt|pc|mm|cm|in|rem|em|ex|ch|Q|%)?")
_UNITS = {
    "px": 1.0,
    "pt": 96.0 / 72.0,
    "pc": 16.0,
    "mm": 96.0 / 25.4,
    "cm": 96.0 / 2.54,
    "Q": 96.0 / 101.6,
    "in": 96.0,
    "rem": 16.0,
}
_LONGEST_LENGTH = 100
# Of the size: so short a closing line is what was cut off on the way round, not one that was drawn.
_ROUNDED = 1e-4
# What makes the control points of a cubic of those of a segment of this degree.
_RAISED = {degree: raised_to_cubic(np.eye(degree + 1)[None])[0] for degree in (1, 2, 3)}
_OF_PAIRS = set("0123456789.,+-eE \t\r\n")


@dataclass(slots=True, eq=False)
class Outline:
    """One run of segments, each from the end of the one before; ``error``: how far they are off.

    ``points`` (n, 2) are the begin, and then of each segment as many points as its degree in ``degrees``.
    """

    points: Array
    degrees: list[int]
    closed: bool = False
    error: float = 0.0

    def cubics(self) -> Array:
        """The segments (m, 4, 2), those of lower degree raised."""
        degrees = np.array(self.degrees)
        starts = np.cumsum(degrees) - degrees
        cubics = np.empty((len(degrees), 4, 2))
        for degree in (1, 2, 3):
            which = degrees == degree
            if not which.any():
                continue
            inside = starts[which][:, None] + np.arange(degree + 1)
            cubics[which] = _RAISED[degree] @ self.points[inside]
        return cubics


def outline(run: Run, matrix: Array, tolerance: float) -> Outline:
    """A run of path data under ``matrix`` (2, 3), arcs then within ``tolerance``. Raises: SvgError."""
    given = np.array(run.points)
    points = matrix[:, 0] * given[:, :1] + matrix[:, 1] * given[:, 1:] + matrix[:, 2]
    placed = Outline(points, [kind for kind in run.kinds if isinstance(kind, int)])
    if len(placed.degrees) < len(run.kinds):
        placed = _with_arcs(run, points, matrix, tolerance)
    if run.closed:
        _close(placed)
    return placed


def _with_arcs(run: Run, points: Array, matrix: Array, tolerance: float) -> Outline:
    parts, degrees, error, at = [points[:1]], [], 0.0, 0  # type: list[Array], list[int], float, int
    for kind in run.kinds:
        if isinstance(kind, int):
            parts.append(points[at + 1 : at + 1 + kind])
            degrees.append(kind)
            at += kind
            continue
        cubics, off = arc_pieces(kind, np.array(run.points[at : at + 2]).T, matrix, tolerance)
        parts += [piece[1:] for piece in cubics]
        degrees += [len(piece) - 1 for piece in cubics]
        error = max(error, off)
        at += 1
        if len(degrees) > MOST_POINTS:
            raise TooManyPointsError
    return Outline(np.concatenate(parts), degrees, error=error)


def _close(placed: Outline) -> None:
    """Close a run with a line, or, where only rounding parts the ends, with the last segment."""
    placed.closed = True
    gap = float(np.abs(placed.points[-1] - placed.points[0]).max())
    if placed.degrees and gap <= _ROUNDED * float(np.ptp(placed.points, axis=0).max()):
        placed.points[-1] = placed.points[0]
    elif gap > 0:
        placed.points = np.vstack([placed.points, placed.points[:1]])
        placed.degrees.append(1)


def functions_of(element: Element) -> tuple[Function, ...]:
    """The functions of an element's ``transform``, about its ``transform-origin``. Raises: UnreadError."""
    text = element.style.get("transform", "")
    if not text:
        return ()
    functions = functions_in(text, element.viewport)
    origin = _origin_of(element) if functions else (0.0, 0.0)
    if functions and origin is not None and any(origin):
        x, y = origin
        functions = (Function("translate", (x, y)), *functions, Function("translate", (-x, -y)))
    sound = functions is not None and origin is not None
    matrix = matrix_in(functions) if functions and sound else np.eye(2, 3)
    if sound and np.isfinite(matrix).all() and np.abs(matrix).max() <= LARGEST:
        return functions or ()
    sentence = _("transform {text!r} cannot be read; correct it.")
    if sound:
        sentence = _("transform {text!r} has numbers above {largest:g} in its matrix; give smaller ones.")
    elif text.count("(") > MOST_FUNCTIONS:
        sentence = _("transform {text!r} has more than {most:,} functions; write fewer.")
    raise element.unread(sentence.format(text=text[:40], largest=LARGEST, most=MOST_FUNCTIONS))


def _origin_of(element: Element) -> tuple[float, float] | None:
    """The place about which an element is transformed; None where it cannot be read."""
    words = element.style.get("transform-origin", "").split()[:2]
    if len(words) == 1:
        words = ["50%", words[0]] if words[0] in ("top", "bottom") else [words[0], "50%"]
    elif words and (words[0] in ("top", "bottom") or words[1] in ("left", "right")):
        words = words[::-1]
    names = {"left": "0", "top": "0", "center": "50%", "right": "100%", "bottom": "100%"}
    x, y = (
        pixels(names.get(word, word), whole, element.font_px)
        for word, whole in zip(words or ["0", "0"], element.viewport, strict=True)
    )
    return (x, y) if math.isfinite(x + y) else None


def pixels(text: str, whole: float, font_px: float = 16.0) -> float:
    """A length in user units, of 100 % being ``whole``; not a number where it is none."""
    match = _LENGTH.fullmatch(text.strip()) if len(text) <= _LONGEST_LENGTH else None
    if match is None:
        return math.nan
    sizes = {**_UNITS, "%": whole / 100.0, "em": font_px, "ex": 0.5 * font_px, "ch": 0.5 * font_px}
    return float(match[1]) * sizes[match[2] or "px"]


def length_of(element: Element, name: str, default: float = 0.0) -> float:
    """A coordinate or length in user units. Raises: UnreadError."""
    text = element.attributes.get(name, "").strip()
    if not text or text == "auto":
        return default
    width, height = element.viewport
    diagonal = math.hypot(width, height) / math.sqrt(2.0)
    whole = diagonal if name == "r" else height if "y" in name or name == "height" else width
    value = pixels(text, whole, element.font_px)
    if not (math.isfinite(value) and abs(value) <= LARGEST):
        sentence = _("{name} is {text!r}, which is not a length that can be drawn; correct it.")
        raise element.unread(sentence.format(name=name, text=text[:20]))
    return value


def points_of(element: Element) -> list[tuple[float, float]]:
    """The points of a polyline or polygon. Raises: UnreadError, and SvgError for too many."""
    text = element.attributes.get("points", "").strip()
    try:
        drawn = runs("M " + text) if text else []
    except TooManyPointsError as error:
        raise element.refusal(str(error)) from None
    except SvgError:
        drawn = [Run([]), Run([])]
    if len(drawn) > 1 or not set(text) <= _OF_PAIRS:
        raise element.unread(_("its points are not pairs of numbers; correct them."))
    return drawn[0].points if drawn else []
