"""A figure's chain of transforms: its matrices multiplied one after another, or a point taken through."""

import numpy as np
from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document.fields import Number
from workbench.document.model import AnyFigure, Sheet
from workbench.document.subjects import Subject
from workbench.document.transforms.stages import products, stages
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.figure import figure_of
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "chain"
PRODUCT = "matrix_product"
POINT = "transform_point"
VERTEX = "vertex"
_MOST_VERTICES = 1_000_000


def vertex_of(figure: AnyFigure, subject: Subject) -> int:
    """The number of the control point that a subject takes through the chain, from 0."""
    number = subject.arguments.get(VERTEX, 0)
    assert isinstance(number, int)
    return min(number, len(figure.points_world) - 1)


def at_vertex(subject: Subject, number: int) -> Subject:
    """The chain of a subject at another vertex of its figure; what is no chain stays as it is."""
    if subject.kind != KIND:
        return subject
    return replace(subject, arguments={**subject.arguments, VERTEX: number})


def _figure(sheet: Sheet, subject: Subject) -> AnyFigure | None:
    """The figure, where there is a chain that acts on it."""
    figure = figure_of(sheet, subject)
    return figure if figure is not None and figure.matrix is not None else None


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    figure = _figure(sheet, subject)
    if figure is None:
        return ()
    return (PRODUCT, POINT) if len(stages(figure.transforms)) > 1 else (POINT,)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    figure, choices = _figure(sheet, subject), _choices(sheet, subject)
    if figure is None or (subject.entry and subject.entry not in choices):
        return []
    chain = stages(figure.transforms)
    made, slug = products(chain), subject.entry or choices[0]
    entry = catalogue.get(slug)
    if slug == POINT:
        point = figure.points_world[vertex_of(figure, subject)]
        return [Call(entry, (made[-1], np.array([point.x, point.y], np.float64)))]
    return [
        Call(entry, (stage.elementary.matrix, before)) for stage, before in zip(chain[1:], made, strict=False)
    ]


register(
    KIND,
    SubjectKind(
        title=_("The chain of transforms"),
        invitation=_("Draw a figure and give it a transform, to see its matrices worked out step by step."),
        calls=_calls,
        choices=_choices,
        entries=(PRODUCT, POINT),
        arguments={
            VERTEX: Given(0, Number(label=_("vertex"), low=0, high=_MOST_VERTICES, whole=True, keyed=False))
        },
    ),
)
