"""What an SVG element keeps of the figure that it was made of, and whether that still holds.

The figure is JSON in an attribute of our own namespace; beside it a digest of the geometry as it was written.
A program that changes the geometry leaves the attribute behind, and the digest tells.
"""

import hashlib
import itertools
import json
import re
from collections.abc import Sequence

import msgspec
from msgspec.structs import replace

from workbench.document.addresses import highest
from workbench.document.building import with_ids
from workbench.document.check import check
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Curve, Document, Sheet
from workbench.exchange.svg_transforms import framed
from workbench.exchange.svg_tree import GEOMETRY

FIGURE, DIGEST = "figure", "geometry"
_decoder = msgspec.json.Decoder(AnyFigure)


def kept(figure: AnyFigure, tag: str, attributes: dict[str, str]) -> dict[str, str]:
    """The two attributes, names without namespace, for ``figure`` written as ``tag`` with ``attributes``."""
    text = json.dumps(msgspec.to_builtins(figure), separators=(",", ":"))  # ASCII: fit for any XML
    return {FIGURE: text, DIGEST: digest(tag, attributes)}


def digest(tag: str, attributes: dict[str, str]) -> str:
    """A digest of the geometry of an element as its text says it."""
    text = "\n".join(attributes.get(name, "") for name in GEOMETRY.get(tag, ()))
    return hashlib.sha256(f"{tag}\n{text}".encode()).hexdigest()[:32]


def original(tag: str, attributes: dict[str, str]) -> AnyFigure | None:
    """The figure that the element was made of, if it keeps one and its geometry is as it was."""
    text = attributes.get(f"own:{FIGURE}", "")
    if not text or attributes.get(f"own:{DIGEST}") != digest(tag, attributes):
        return None
    try:
        found: AnyFigure = _decoder.decode(text)
        return found
    except (msgspec.MsgspecError, RecursionError):
        return None


def moved(figure: AnyFigure, scale: float, dx: float, dy: float) -> AnyFigure:
    """``figure`` scaled about the origin and then moved by (dx, dy), world."""
    if (scale, dx, dy) == (1.0, 0.0, 0.0):
        return figure
    points = tuple(replace(p, x=scale * p.x + dx, y=scale * p.y + dy) for p in figure.points_world)
    chain = framed(figure.transforms, scale, dx, dy)
    across, up = figure.radii_world
    figure = replace(figure, points_world=points, transforms=chain).with_radii(scale * across, scale * up)
    if isinstance(figure, Curve):
        steered = tuple(
            replace(p, tangent_x=scale * p.tangent_x, tangent_y=scale * p.tangent_y)
            for p in figure.points_world
        )
        return replace(figure, points_world=steered)
    return figure


def fault_in(figure: AnyFigure, sheet: Sheet) -> str:
    """The sentence that says why ``figure`` cannot be put on ``sheet``; empty if it can."""
    wrong = first_fault([figure], sheet)
    return wrong[1] if wrong else ""


def first_fault(figures: Sequence[AnyFigure], sheet: Sheet) -> tuple[int, str] | None:
    """Which of ``figures`` cannot be put on an empty ``sheet``, and the sentence that says why."""
    empty = Document((replace(sheet, figures=()),))
    fresh = itertools.count(highest(empty) + 1)
    added = tuple(with_ids(figure, fresh, fresh) for figure in figures)
    try:
        check(Document((replace(sheet, figures=added),)), empty)
    except DocumentError as error:
        place = re.search(r"\.figures\[(\d+)\]", error.field)
        return int(place[1]) if place else len(figures) - 1, error.short
    return None
