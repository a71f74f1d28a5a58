"""Outlines of SVG elements as Bézier segments in the element's own coordinates; arcs become cubics.

Path data is understood by svgelements, after it was looked at strictly.
Source: SVG 1.1, chapters 8 and 9.
"""

import math
import re
from dataclasses import dataclass, field

import numpy as np
import svgelements
from numpy.typing import NDArray

from workbench.exchange.path_data import LARGEST, checked
from workbench.exchange.svg_arcs import arc_pieces
from workbench.exchange.svg_tree import Element, SvgError
from workbench.language import _

Array = NDArray[np.float64]

_LENGTH = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?:px|pt|pc|mm|cm|in|em|ex|Q|%)?")


@dataclass(slots=True)
class Outline:
    """One run of segments (k+1, 2), each from the end of the one before; ``error``: how far they are off."""

    begin: Array
    segments: list[Array] = field(default_factory=list)
    closed: bool = False
    error: float = 0.0


def outlines(data: str, matrix: Array, tolerance: float) -> list[Outline]:
    """The runs of path data under ``matrix`` (2, 3), arcs then within ``tolerance``. Raises: SvgError."""
    found: list[Outline] = []
    looked_at = checked(data)
    for number, part in enumerate(svgelements.Path(looked_at.text)):
        if number in looked_at.put_in:
            continue
        end = _point(part.end, matrix)
        if isinstance(part, svgelements.Move):
            found.append(Outline(end))
            continue
        if found[-1].closed:
            found.append(Outline(found[-1].begin))
        run = found[-1]
        begin = run.segments[-1][-1] if run.segments else run.begin
        if isinstance(part, svgelements.Close):
            _close(run, begin)
        elif number in looked_at.arcs:
            ends = np.array([[part.start.x, part.end.x], [part.start.y, part.end.y]], float)
            cubics, error = arc_pieces(looked_at.arcs[number], ends, matrix, tolerance)
            run.segments += cubics
            run.error = max(run.error, error)
        else:
            inner = [getattr(part, name, None) for name in ("control", "control1", "control2")]
            controls = [begin, *(_point(p, matrix) for p in inner if p is not None), end]
            run.segments.append(np.array(controls))
    return found


def _close(run: Outline, begin: Array) -> None:
    """Close a run with a line, or, where only rounding parts the ends, with the last segment."""
    run.closed = True
    gap = float(np.abs(begin - run.begin).max())
    size = max((float(np.abs(s).max()) for s in run.segments), default=0.0)
    if run.segments and gap <= 1e-12 * size:
        run.segments[-1][-1] = run.begin
    elif gap > 0:
        run.segments.append(np.array([begin, run.begin]))


def _point(point: svgelements.Point, matrix: Array) -> Array:
    found: Array = matrix[:, :2] @ np.array([float(point.x), float(point.y)]) + matrix[:, 2]
    return found


def transform_of(element: Element) -> Array:
    """The matrix (2, 3) of an element's ``transform``. Raises: SvgError."""
    text = element.attributes.get("transform", "").strip()
    if not text:
        return np.eye(2, 3)
    try:
        m = svgelements.Matrix(text)
        found = np.array([[m.a, m.c, m.e], [m.b, m.d, m.f]], float)
    except (ValueError, TypeError, IndexError, ZeroDivisionError, OverflowError, AttributeError):
        found = np.full((2, 3), math.nan)
    names = text.lower().replace("matrix", "").replace("translate", "").replace("scale", "")
    names = names.replace("rotate", "").replace("skewx", "").replace("skewy", "")
    if set(names) - set("()+-.,e0123456789 \t\r\n") or names.count("(") != names.count(")"):
        found[:] = math.nan
    if not (np.isfinite(found).all() and np.abs(found).max() <= LARGEST):
        raise element.refusal(_("transform {text!r} cannot be read; correct it.").format(text=text[:40]))
    return found


def length_of(element: Element, name: str, default: float = 0.0) -> float:
    """A coordinate or length in user units. Raises: SvgError."""
    text = element.attributes.get(name, "").strip()
    if not text or text == "auto":
        return default
    width, height = element.viewport
    whole = math.hypot(width, height) / math.sqrt(2.0) if name == "r" else height if "y" in name else width
    whole = height if name == "height" else whole
    try:
        value = float(
            svgelements.Length(text).value(ppi=96.0, relative_length=whole or math.nan, font_size=16.0)
        )
    except (ValueError, TypeError, AttributeError):
        value = math.nan
    if not (_LENGTH.fullmatch(text) and math.isfinite(value) and abs(value) <= LARGEST):
        sentence = _("{name} is {text!r}, which is no length that can be drawn; correct it.")
        raise element.refusal(sentence.format(name=name, text=text[:20]))
    return value


def points_of(element: Element) -> Array:
    """The points (n, 2) of a polyline or polygon. Raises: SvgError."""
    text = element.attributes.get("points", "").strip()
    try:
        words = checked("M " + text).text.split()[1:] if text else []
    except SvgError:
        raise element.refusal(_("its points are no pairs of numbers; correct them.")) from None
    return np.array(words, float).reshape(-1, 2)
