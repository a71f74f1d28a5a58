"""A figure under the clipper that its sheet has for it."""

from msgspec.structs import replace

from workbench.document.edits import Edit, set_clippers
from workbench.document.model import LINE_CLIPPERS, POLYGON_CLIPPERS, Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.clipping import clipper_calls, clipper_of
from workbench.rendering.comparing import figure_pixels
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.figure import figure_of
from workbench.rendering.subjects.registry import Cells, Comparing, SubjectKind, register


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    figure = figure_of(sheet, subject)
    own = "" if figure is None else clipper_of(sheet, figure)
    among = LINE_CLIPPERS if own in LINE_CLIPPERS else ()
    return tuple(dict.fromkeys(slug for slug in (own, *among) if slug))


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    figure = figure_of(sheet, subject)
    if figure is None or (subject.entry and subject.entry not in _choices(sheet, subject)):
        return []
    return clipper_calls(sheet, figure, subject.entry or None)


def _choose(sheet: Sheet, subject: Subject, slug: str) -> Edit:
    return set_clippers(sheet.id, line=slug)


def _painted(sheet: Sheet, subject: Subject) -> Cells:
    figure = figure_of(sheet, subject)
    assert figure is not None
    clipped = replace(sheet, line_clipper=subject.entry) if subject.entry in LINE_CLIPPERS else sheet
    return figure_pixels(clipped, figure)


def _alike(sheet: Sheet, subject: Subject) -> tuple[Subject, ...]:
    own = _choices(sheet, subject)[0]
    return tuple(
        Subject("clipper", (f.id,)) for f in sheet.figures if f.visible and clipper_of(sheet, f) == own
    )


register(
    "clipper",
    SubjectKind(
        title=_("The clipper at work on the figure"),
        calls=_calls,
        choices=_choices,
        choose=_choose,
        entries=(*LINE_CLIPPERS, *POLYGON_CLIPPERS),
        comparing=Comparing(choices=_choices, painted=_painted, alike=_alike, of_sheet=True, example="clip"),
    ),
)
