"""A curve's construction at a share of the range of u, or another text of curves; of other figures theirs."""

from msgspec.structs import replace

from workbench.algorithms import catalogue
from workbench.document.building import Edit
from workbench.document.fields import Number
from workbench.document.model import Curve, Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.curve_runs import construction_of, constructions_of, curve_calls
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.figure import figure_of
from workbench.rendering.subjects.registry import Given, SubjectKind, calls_of, kind_of, register

KIND = "curve"
DRAWN_AS = "figure"
USUAL_SHARE = 0.5


def share_of(subject: Subject) -> float:
    """Where in the range of u a curve is stepped, 0 to 1."""
    share = subject.arguments.get("u", USUAL_SHARE)
    assert isinstance(share, int | float)
    return float(share)


def at_share(subject: Subject, share: float) -> Subject:
    """The construction of the curve of a subject at another share of the range of u."""
    return replace(subject, kind=KIND, arguments={**subject.arguments, "u": share})


def _curve(sheet: Sheet, subject: Subject) -> Curve | None:
    figure = figure_of(sheet, subject)
    return figure if isinstance(figure, Curve) else None


def _drawn(subject: Subject) -> Subject:
    """The drawing of a figure: what is stepped of one that is no curve."""
    return Subject(DRAWN_AS, subject.ids)


def _choices(sheet: Sheet, subject: Subject) -> tuple[str, ...]:
    curve, drawn = _curve(sheet, subject), _drawn(subject)
    return kind_of(drawn).choices(sheet, drawn) if curve is None else tuple(constructions_of(curve))


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    curve = _curve(sheet, subject)
    if curve is None:
        return calls_of(sheet, _drawn(subject))
    return curve_calls(sheet, curve, construction_of(curve, subject.entry), share_of(subject))


def _choose(sheet: Sheet, subject: Subject, slug: str) -> Edit | None:
    drawn = _drawn(subject)
    return kind_of(drawn).choose(sheet, drawn, slug) if _curve(sheet, subject) is None else None


register(
    KIND,
    SubjectKind(
        title=_("The construction of the curve"),
        calls=_calls,
        choices=_choices,
        choose=_choose,
        entries=tuple(entry.slug for entry in catalogue.entries() if entry.constructs),
        arguments={"u": Given(USUAL_SHARE, Number(label="u", low=0.0, high=1.0, keyed=True))},
        compared_as=DRAWN_AS,
    ),
)
