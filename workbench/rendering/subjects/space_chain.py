"""The chain of an object in space: a vertex through the seven steps of its last rotation, or its matrices
multiplied one after another.
"""

import math

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.transforms import Matrix, matrix_product, product, rotate_about_axis
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.scene.links import AnyLink3D, Rotate3D
from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "space_chain"
TURN = rotate_about_axis.__name__
PRODUCT = matrix_product.__name__
VERTEX = "vertex"
_MOST_VERTICES = 2**31


def is_of_a_chain_in_space(subject: Subject) -> bool:
    """Whether the chain of an object of the scene is what is stepped."""
    return subject.kind == KIND


def object_of(sheet: Sheet, subject: Subject) -> Object | None:
    """The object that a subject names, else the first of the scene; None where there is none."""
    objects = sheet.scene.objects if sheet.scene else ()
    return next((each for each in objects if each.id in subject.ids), next(iter(objects), None))


def acting(thing: Object) -> list[AnyLink3D]:
    """The links of its chain that are on, the one that acts first at the head."""
    return [link for link in thing.transforms if link.on]


def upto(thing: Object, count: int) -> Matrix:
    """What the first ``count`` of the links that are on do (4, 4)."""
    return product(np.eye(4), *(link.matrix for link in reversed(acting(thing)[:count])))


def last_turn(thing: Object) -> tuple[int, Rotate3D] | None:
    """The last rotation of a chain, with its place among the links that are on; None where it has none."""
    turns = [(at, link) for at, link in enumerate(acting(thing)) if isinstance(link, Rotate3D)]
    return turns[-1] if turns else None


def vertex_of(thing: Object, subject: Subject) -> int:
    """The number of the vertex that a subject follows, from 0."""
    number = subject.arguments.get(VERTEX, 0)
    assert isinstance(number, int), "its kind is checked"
    return min(number, len(thing.mesh.vertices) - 1)


def vertex_after(thing: Object, subject: Subject, count: int) -> tuple[float, float, float]:
    """Where that vertex is after the first ``count`` links that are on."""
    x, y, z, _w = (upto(thing, count) @ [*thing.mesh.vertices[vertex_of(thing, subject)], 1.0]).tolist()
    return x, y, z


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    thing = object_of(sheet, subject)
    if thing is None:
        return ()
    turned, several = last_turn(thing) is not None, len(acting(thing)) > 1
    return (*((TURN,) if turned else ()), *((PRODUCT,) if several else ()))


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    thing, choices = object_of(sheet, subject), _choices(sheet, subject)
    slug = subject.entry or next(iter(choices), "")
    if thing is None or slug not in choices:
        return []
    entry, turn = catalogue.get(slug), last_turn(thing)
    if slug == TURN and turn is not None:
        at, link = turn
        place = vertex_after(thing, subject, at)
        return [Call(entry, (math.radians(link.angle), *place, *link.pivot, *link.second))]
    links = acting(thing)
    return [Call(entry, (link.matrix, upto(thing, at))) for at, link in enumerate(links[1:], 1)]


register(
    KIND,
    SubjectKind(
        title=_("The transforms of an object"),
        invitation=_("Give an object a rotation, to see its seven matrices step by step."),
        calls=_calls,
        choices=_choices,
        entries=(TURN, PRODUCT),
        arguments={
            VERTEX: Given(0, Number(label=_("vertex"), low=0, high=_MOST_VERTICES, whole=True, keyed=False))
        },
    ),
)
