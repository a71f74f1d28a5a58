"""The chain of an object in space as a page: a labelled drawing, and every matrix of its last rotation."""

import numpy as np

from workbench.algorithms.marks import Spot, Stroke, Word
from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Block, Derivation, Drawing, Formulas, Heading, Item, Sentence
from workbench.exchange.formulas.terms import Phrase, Sign, matrix
from workbench.language import _
from workbench.panels.transform.space_rows import space_rows
from workbench.panels.transform.space_scene import SpaceScene, scene_of, seen_from
from workbench.panels.transform.told import space_text
from workbench.rendering.subjects.space_chain import acting, last_turn
from workbench.widgets.formulas.paper import paper_inks

_FROM = -32.0, 22.0
_MARGIN = 0.12


def space_derivation(thing: Object, subject: Subject) -> Derivation | None:
    """The page of an object; None where no link of its chain is on."""
    if not acting(thing):
        return None
    turn = last_turn(thing)
    heading = _("Rotation about an axis") if turn is not None else _("Transforms in space")
    blocks: list[Block] = [Heading(heading), _drawing(scene_of(thing, subject, 0))]
    if turn is not None:
        blocks.append(Sentence(_("The axis is brought onto z, the turn is made about z, and all is undone:")))
        for number, part in enumerate(turn[1].unfolded(), 1):
            blocks.append(Formulas((Phrase(f"{number}."), Phrase(part.name), Sign("="), matrix(part.matrix))))
    blocks += [Formulas(row.terms, row.shows) for row in space_rows(thing, 0)]
    return Derivation(heading, blocks, paper_inks())


def _drawing(scene: SpaceScene) -> Drawing:
    flat = seen_from(*_FROM)[:2, :3].T
    reach = 1.2 * max(float(np.abs(part).max()) for part in (scene.made, scene.image)) or 1.0
    items: list[Item] = []
    for way, name in zip(np.eye(3), "xyz", strict=True):
        ends = np.array([np.zeros(3), reach * way]) @ flat
        items += [
            Stroke(ends, "muted", "hair"),
            Word(name, float(ends[1, 0]), float(ends[1, 1]), "muted", 1, 1),
        ]
    for places, ink in ((scene.made, "muted"), (scene.image, "data1")):
        at = places @ flat
        items += [Stroke(at[edge], ink, "thin") for edge in scene.edges]  # type: ignore[arg-type]
    if scene.axis is not None:
        first, second = scene.axis
        ends = np.array([2 * first - second, 2 * second - first]) @ flat
        items.append(Stroke(ends, "data2", "medium", "dash"))
    vertex, image = scene.way[0], scene.image[_nearest(scene.made, scene.way[0])]
    for place, name, ink in ((vertex, "P", "muted"), (image, "P'", "data1")):
        x, y = (place @ flat).tolist()
        items += [Spot(x, y, ink), Word(f"{name} {space_text(*place.tolist())}", x, y, "text", 1, 1)]  # type: ignore[arg-type]
    every = np.concatenate([item.points for item in items if isinstance(item, Stroke)])
    low, high = every.min(axis=0), every.max(axis=0)
    room = _MARGIN * float((high - low).max())
    (xmin, ymin), (xmax, ymax) = (low - room).tolist(), (high + room).tolist()
    return Drawing((xmin, ymin, xmax, ymax), items)


def _nearest(places: np.ndarray, place: np.ndarray) -> int:
    return int(np.abs(places - place).sum(axis=1).argmin())
