"""A view as a page: window and viewport as drawings, its matrices, and the way of a point."""

import re

import numpy as np

from workbench.algorithms.marks import Region, Spot, Stroke, Word, closed
from workbench.document.model import Rectangle, Sheet, View
from workbench.exchange.diagrams import (
    Axes,
    Block,
    Derivation,
    Drawing,
    Formulas,
    Heading,
    Item,
    Sentence,
)
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.viewing.card import distortion, factors_of, view_name
from workbench.panels.viewing.formulas import terms_of
from workbench.panels.viewing.point import arithmetic
from workbench.panels.viewing.stages import Geometry, device_box, world_box
from workbench.rendering.mapping import box, view_map
from workbench.rendering.subjects.window import Point
from workbench.widgets.formulas.paper import paper_inks
from workbench.widgets.look.tokens import LIGHT

_HEIGHT_PT = 190.0
_LOWERED = re.compile(r"<sub>(\w+)</sub>")


def derivation(sheet: Sheet, view: View, point: Point | None) -> Derivation:
    """The page of a view of a sheet, with the way of ``point`` (world) where one is given."""
    geometry = Geometry(sheet, view, world_box(sheet, view), LIGHT)
    name = view_name(sheet, view)
    sx, sy = factors_of(view)
    blocks: list[Block] = [
        Heading(_("Window to viewport: {name}").format(name=name)),
        Sentence(_("The window in the world:")),
        _world(geometry, point),
        Sentence(_("The viewport on the device:")),
        _device(geometry, point),
        Sentence(_("$s_x = {sx}$, $s_y = {sy}$.").format(sx=displayed(sx), sy=displayed(sy))),
    ]
    if words := distortion(sx, sy):
        blocks.append(Sentence(_plain(words)))
    terms = terms_of(view)
    blocks += [Formulas(terms, "symbols"), Formulas(terms, "numbers")]
    for title, lines in () if point is None else arithmetic(view, point):
        blocks.append(Sentence(f"{title}: " + ", ".join(f"${_formula(line)}$" for line in lines)))
    return Derivation(_("Window to viewport"), blocks, paper_inks())


def _world(geometry: Geometry, point: Point | None) -> Drawing:
    """The figures, those parts that are seen stronger, and the window."""
    items: list[Item] = [Axes("x_w", "y_w")]
    items += [Stroke(curve.points, "muted", "hair", "dot") for curve in geometry.whole]
    items += [Stroke(curve.points, "text", "thin") for curve in geometry.left("world")]
    items += _framed(geometry.view.window_world, "data1")
    if point is not None:
        items += [Spot(*point, "data1", "ring"), _word("P", point)]
    return Drawing(geometry.shown, items, _HEIGHT_PT)


def _device(geometry: Geometry, point: Point | None) -> Drawing:
    """What is left of the figures in every view, and the viewport of this one."""
    sheet, view = geometry.sheet, geometry.view
    items: list[Item] = [Axes("x_v", "y_v")]
    for other in sheet.views:
        items += [Stroke(curve.points, "text", "thin") for curve in geometry.seen(other)]
    items += _framed(view.viewport_device, "data2")
    if point is not None:
        there = view_map(view).point(*point)
        items += [Spot(*there, "data2"), _word("P'", there)]
    return Drawing(device_box(sheet, view), items, _HEIGHT_PT)


def _framed(rectangle: Rectangle, ink: str) -> list[Item]:
    """A rectangle with two of its corners."""
    xmin, ymin, xmax, ymax = box(rectangle)
    ring = np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)], np.float64)
    pattern = "solid" if ink == "data1" else "dash"
    return [
        Region(ring, ink),  # type: ignore[arg-type]
        Stroke(closed(ring), ink, "medium", pattern),  # type: ignore[arg-type]
        Word(_place((xmin, ymin)), xmin, ymin, "text", -1, -1),
        Word(_place((xmax, ymax)), xmax, ymax, "text", 1, 1),
    ]


def _word(name: str, place: Point) -> Word:
    return Word(f"{name} {_place(place)}", *place, "text", 1, -1)


def _place(place: Point) -> str:
    return f"({displayed(place[0])}, {displayed(place[1])})"


def _formula(text: str) -> str:
    """Rich text as a formula."""
    return _LOWERED.sub(r"_\1", text)


def _plain(text: str) -> str:
    """A sentence of rich text, its symbols as formulas."""
    return re.sub(r"\w<sub>\w+</sub>", lambda found: f"${_formula(found[0])}$", text)
