"""A figure under the clipper that its sheet has for it."""

from workbench.algorithms import catalogue
from workbench.document.edits import Edit, set_clipper
from workbench.document.model import Sheet
from workbench.document.sheet_edits import with_clipper
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.clipping import clipper_calls, clipper_of, clippers_of
from workbench.rendering.comparing import figure_pixels
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.figure import figure_of
from workbench.rendering.subjects.registry import Cells, Comparing, SubjectKind, register


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    figure = figure_of(sheet, subject)
    if figure is None:
        return ()
    return tuple(dict.fromkeys(slug for slug in (clipper_of(sheet, figure), *clippers_of(figure)) if slug))


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    figure = figure_of(sheet, subject)
    if figure is None or (subject.entry and subject.entry not in _choices(sheet, subject)):
        return []
    return clipper_calls(sheet, figure, subject.entry or None)


def _choose(sheet: Sheet, subject: Subject, slug: str) -> Edit:
    return set_clipper(sheet.id, slug)


def _painted(sheet: Sheet, subject: Subject) -> Cells:
    figure = figure_of(sheet, subject)
    assert figure is not None
    return figure_pixels(with_clipper(sheet, subject.entry) if subject.entry else sheet, figure)


def _alike(sheet: Sheet, subject: Subject) -> tuple[Subject, ...]:
    own = _choices(sheet, subject)[0]
    return tuple(
        Subject("clipper", (f.id,)) for f in sheet.figures if f.visible and clipper_of(sheet, f) == own
    )


register(
    "clipper",
    SubjectKind(
        title=_("The clipper at work on the figure"),
        invitation=_("Draw a figure and a window to see how the algorithm works, step by step."),
        calls=_calls,
        choices=_choices,
        choose=_choose,
        entries=tuple(entry.slug for entry in catalogue.entries() if entry.clips),
        comparing=Comparing(choices=_choices, painted=_painted, alike=_alike, of_sheet=True, example="clip"),
    ),
)
