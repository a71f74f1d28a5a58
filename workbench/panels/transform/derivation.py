"""The chain of a figure as a page: a labelled drawing, its matrices with symbols and with numbers."""

import itertools

import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.marks import Region, Spot, Stroke, Word
from workbench.document.model import AnyFigure, Polygon, Sheet
from workbench.document.transforms.chains import transformed
from workbench.document.transforms.stages import Stage, products, stages
from workbench.exchange.diagrams import (
    Arrow,
    Axes,
    Block,
    Derivation,
    Drawing,
    Formulas,
    Heading,
    Item,
    Sentence,
)
from workbench.exchange.formulas.terms import Phrase, Sign, matrix
from workbench.language import _
from workbench.panels.transform.rows import MOST_WITH_SYMBOLS, rows
from workbench.panels.transform.scene import curves_of, ghosts_of, ink_of_stage
from workbench.panels.transform.told import caption, in_numbers, place_text, title
from workbench.rendering.mapping import device_map
from workbench.widgets.formulas.paper import paper_inks

_MARGIN = 0.08


def derivation(sheet: Sheet, figure: AnyFigure, name: str, vertex: int) -> Derivation | None:
    """The page of a figure called ``name``, with its point ``vertex``; None where no chain acts on it."""
    chain = stages(figure.transforms)
    if not chain:
        return None
    made = [np.eye(3), *products(chain)]
    drawing = _drawing(sheet, figure, chain, made, vertex)
    if drawing is None:
        return None
    links = list(dict.fromkeys(stage.link for stage in chain))
    heading = title(links[0]) if len(links) == 1 else _("A chain of transforms")
    point = figure.points_world[vertex]
    blocks: list[Block] = [
        Heading(f"{heading}: {name}"),
        drawing,
        *(Sentence(f"${stage.number}$: {caption(stage)}, ${in_numbers(stage)}$.") for stage in chain),
    ]
    for row in rows(chain, point=(point.x, point.y), notes=False):
        blocks.append(Formulas(row.terms, row.shows))
    if 1 < len(chain) <= MOST_WITH_SYMBOLS:
        blocks += _multiplied_out(chain)
    return Derivation(heading, blocks, paper_inks())


def _multiplied_out(chain: list[Stage]) -> list[Sentence | Formulas]:
    """The products of the symbols, one after another."""
    written = [stage.symbols for stage in reversed(chain)]
    blocks: list[Sentence | Formulas] = [Sentence(_("With symbols, multiplied out from the right:"))]
    for product in transforms.multiplied_out(written):
        terms = Phrase(product.name), Sign("="), matrix(product.matrix, product.texts)
        blocks.append(Formulas(terms, "symbols"))
    return blocks


def _drawing(
    sheet: Sheet, figure: AnyFigure, chain: list[Stage], made: list[np.ndarray], vertex: int
) -> Drawing | None:
    scale, count = device_map(sheet), len(chain)
    own = [scale.world(curve) for curve in curves_of(sheet, figure)]
    items: list[Item] = [Axes()]
    corners = [np.zeros((1, 2))]
    for number in ghosts_of(count):
        ink, pattern = ink_of_stage(number, count)
        curves = [transformed(made[number], curve) for curve in own]
        if not curves or not all(np.isfinite(curve).all() for curve in curves):
            continue
        corners += curves
        for curve in curves:
            if isinstance(figure, Polygon):
                items.append(Region(curve, ink))
            items.append(Stroke(curve, ink, "medium" if number == count else "thin", pattern))
        x, y = np.concatenate(curves).mean(axis=0).tolist()
        items.append(Word(str(number), x, y, ink, 0, 0, False, True))
    point = figure.points_world[vertex]
    way = [transformed(matrix, np.array([(point.x, point.y)])) for matrix in made]
    if not np.isfinite(np.concatenate(way)).all():
        return None
    for before, after in itertools.pairwise(way):
        if not np.allclose(before, after):
            items.append(Arrow(np.concatenate([before, after]), "muted"))
    for place, ink in ((way[0], "muted"), (way[-1], "data1")):
        x, y = place[0].tolist()
        items += [Spot(x, y, ink), Word(place_text(x, y), x, y, "text", 1, 1)]
    every = np.concatenate(corners)
    low, high = every.min(axis=0), every.max(axis=0)
    room = _MARGIN * np.maximum(high - low, 1e-6).max()
    (xmin, ymin), (xmax, ymax) = (low - room).tolist(), (high + room).tolist()
    return Drawing((xmin, ymin, xmax, ymax), items)
