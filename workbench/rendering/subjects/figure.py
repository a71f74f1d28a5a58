"""A figure under the algorithm that draws it, or under another; a polygon also as an outline to be filled."""

from typing import get_args

import numpy as np

from workbench.document.edits import Edit, set_algorithm
from workbench.document.model import AnyFigure, Polygon, SeedFill, Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.guard_band import cut_before
from workbench.rendering.mapping import Call
from workbench.rendering.outline_fill import OutlineFill, outline_fill
from workbench.rendering.raster import figure_calls
from workbench.rendering.subjects.registry import Cells, Comparing, SubjectKind, painted_by_calls, register


def figure_of(sheet: Sheet, subject: Subject) -> AnyFigure | None:
    """The figure of the sheet that a subject names first; None where it has none."""
    named = subject.ids[0] if subject.ids else ""
    return next((figure for figure in sheet.figures if figure.id == named), None)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    figure, slug = figure_of(sheet, subject), subject.entry
    if figure is None:
        return []
    if filled := _filled(sheet, figure, slug):
        return [] if filled.call is None else [filled.call]
    return figure_calls(sheet, figure, slug or None) if not slug or slug in figure.algorithms else []


def _filled(sheet: Sheet, figure: AnyFigure | None, slug: str) -> OutlineFill | None:
    """What a seed fill makes of a polygon; None for whatever draws the figure itself."""
    if not isinstance(figure, Polygon) or slug not in SeedFill.algorithms:
        return None
    return outline_fill(sheet, figure, slug)


def choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    """The algorithms that can draw the figure, the one that does first."""
    figure = figure_of(sheet, subject)
    return () if figure is None else tuple(dict.fromkeys((figure.drawn_with, *figure.algorithms)))


def _choose(sheet: Sheet, subject: Subject, slug: str) -> Edit:
    return set_algorithm(subject.ids, slug)


def _compared_under(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    fills = SeedFill.algorithms if isinstance(figure_of(sheet, subject), Polygon) else ()
    return *choices(sheet, subject), *fills


def _before(sheet: Sheet, subject: Subject) -> Cells | None:
    filled = _filled(sheet, figure_of(sheet, subject), subject.entry)
    return None if filled is None else filled.outline


def _painted(sheet: Sheet, subject: Subject) -> Cells:
    before, painted = _before(sheet, subject), painted_by_calls(sheet, subject)
    return painted if before is None else np.concatenate([before, painted])


def _cut(sheet: Sheet, subject: Subject) -> str:
    figure = figure_of(sheet, subject)
    return "" if figure is None else cut_before(sheet, figure)


def _alike(sheet: Sheet, subject: Subject) -> tuple[Subject, ...]:
    kind = type(figure_of(sheet, subject))
    return tuple(Subject("figure", (f.id,)) for f in sheet.figures if f.visible and type(f) is kind)


register(
    "figure",
    SubjectKind(
        title=_("The algorithm of the figure"),
        calls=_calls,
        choices=choices,
        choose=_choose,
        before=_cut,
        entries=tuple(dict.fromkeys(slug for kind in get_args(AnyFigure) for slug in kind.algorithms)),
        comparing=Comparing(choices=_compared_under, painted=_painted, before=_before, alike=_alike),
    ),
)
