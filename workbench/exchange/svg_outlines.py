"""Outlines of SVG elements as Bézier segments in the element's own coordinates; arcs become cubics.

Lengths and transforms are understood by svgelements, after they were looked at strictly.
Source: SVG 1.1, chapters 8 and 9.
"""

import math
import re
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import svgelements
from numpy.typing import NDArray

from workbench.exchange.path_data import LARGEST, MOST_POINTS, Run, TooManyPointsError, runs
from workbench.exchange.svg_arcs import arc_pieces
from workbench.exchange.svg_transforms import FUNCTION
from workbench.exchange.svg_tree import Element, SvgError
from workbench.geometry.curves.cubic_pieces import raised_to_cubic
from workbench.language import _

Array = NDArray[np.float64]

_LENGTH = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?(px|pt|pc|mm|cm|in|em|ex|Q|%)?")
_LONGEST_LENGTH = 100
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
    if placed.degrees and gap <= 1e-12 * float(np.abs(placed.points).max()):
        placed.points[-1] = placed.points[0]
    elif gap > 0:
        placed.points = np.vstack([placed.points, placed.points[:1]])
        placed.degrees.append(1)


def transform_of(element: Element) -> Array | None:
    """The matrix (2, 3) of an element's ``transform``, None where it has none. Raises: SvgError."""
    text = element.attributes.get("transform", "").strip()
    if not text:
        return None
    placed: Array = np.full((2, 3), math.nan)
    words, at = [], 0
    while match := FUNCTION.match(text, at):
        numbers = match[2].replace(",", " ").split()
        if len(numbers) > 6 or any(len(number) > _LONGEST_LENGTH for number in numbers):
            break
        words.append(f"{match[1]}({' '.join(numbers)})")
        at = match.end()
    if at == len(text):
        with suppress(ValueError, TypeError, IndexError, ZeroDivisionError, OverflowError, AttributeError):
            m = svgelements.Matrix(" ".join(words))
            placed = np.array([[m.a, m.c, m.e], [m.b, m.d, m.f]], float)
    if not (np.isfinite(placed).all() and np.abs(placed).max() <= LARGEST):
        raise element.refusal(_("transform {text!r} cannot be read; correct it.").format(text=text[:40]))
    return placed


def length_of(element: Element, name: str, default: float = 0.0) -> float:
    """A coordinate or length in user units. Raises: SvgError."""
    text = element.attributes.get(name, "").strip()
    if not text or text == "auto":
        return default
    match = _LENGTH.fullmatch(text) if len(text) <= _LONGEST_LENGTH else None
    value = math.nan
    if match and not match[1]:
        value = float(text)
    elif match:
        width, height = element.viewport
        whole = (
            math.hypot(width, height) / math.sqrt(2.0) if name == "r" else height if "y" in name else width
        )
        whole = height if name == "height" else whole
        with suppress(ValueError, TypeError, AttributeError):
            length = svgelements.Length(text)
            value = float(length.value(ppi=96.0, relative_length=whole or math.nan, font_size=16.0))
    if not (math.isfinite(value) and abs(value) <= LARGEST):
        sentence = _("{name} is {text!r}, which is not a length that can be drawn; correct it.")
        raise element.refusal(sentence.format(name=name, text=text[:20]))
    return value


def points_of(element: Element) -> list[tuple[float, float]]:
    """The points of a polyline or polygon. Raises: SvgError."""
    text = element.attributes.get("points", "").strip()
    try:
        drawn = runs("M " + text) if text else []
    except TooManyPointsError as error:
        raise element.refusal(str(error)) from None
    except SvgError:
        drawn = [Run([]), Run([])]
    if len(drawn) > 1 or not set(text) <= _OF_PAIRS:
        raise element.refusal(_("its points are no pairs of numbers; correct them."))
    return drawn[0].points if drawn else []
