"""The display list of a sheet, or test lines, run by the processor of a random-scan display."""

from fractions import Fraction
from functools import lru_cache

from workbench.algorithms import catalogue
from workbench.algorithms.scanning.random_scan import random_scan
from workbench.algorithms.scanning.stroke_order import nearest_end_first
from workbench.display.setup import units_per_px
from workbench.display.vector_timing import TEACHING, VectorTiming, vector_displays
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.rendering.display_program import (
    DisplayProgram,
    Strokes,
    equal_lines,
    nearest_first,
    program_of,
    strokes_of,
)
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = random_scan.__name__
SLUG, ORDERING = random_scan.__name__, nearest_end_first.__name__
MOST_LINES = 20_000
USUAL_LENGTH = 24.0
_USUAL = VectorTiming.named(TEACHING).numbers_us


def _number(subject: Subject, name: str) -> float:
    value = subject.arguments.get(name, ARGUMENTS[name].usual)
    assert isinstance(value, int | float), "its kind is checked"
    return float(value)


def runs_a_list(subject: Subject) -> bool:
    """Whether a display list is what is stepped."""
    return subject.kind == KIND


def display_of(subject: Subject) -> str:
    """The id of the vector display; the teaching one where it is not known."""
    name = subject.arguments.get("display", TEACHING)
    return name if isinstance(name, str) and name in vector_displays() else TEACHING


def timing_of(subject: Subject) -> VectorTiming:
    """The speeds of its display, those of the teaching one as they were typed."""
    if display_of(subject) != TEACHING:
        return VectorTiming.named(display_of(subject))
    return VectorTiming.own(*(_number(subject, name) for name in ("start", "pace", "jump_pace", "settle")))


def shortest_ps_of(subject: Subject) -> int:
    """The shortest time of a picture."""
    return timing_of(subject).shortest_frame_ps(Fraction(str(_number(subject, "refresh"))))


def lines_of(subject: Subject) -> int:
    """How many test lines are drawn; 0 where the sheet is."""
    return int(_number(subject, "lines"))


def length_of(sheet: Sheet, subject: Subject) -> float:
    """How long the test lines are, in pixels; no longer than the picture is wide."""
    return min(_number(subject, "length"), sheet.width_px - 1.0)


def is_ordered(subject: Subject) -> bool:
    """Whether jumps are made short by the order of the strokes."""
    return bool(subject.arguments.get("ordered", False))


def units_of(sheet: Sheet, subject: Subject) -> float:
    """Units of the deflection per pixel of the sheet."""
    return units_per_px((sheet.width_px, sheet.height_px), timing_of(subject))


def own_strokes(sheet: Sheet, subject: Subject) -> Strokes:
    """What is drawn, in the order of the sheet."""
    count = lines_of(subject)
    if not count:
        return _strokes(sheet)
    size = sheet.width_px, sheet.height_px
    return equal_lines(count, length_of(sheet, subject), size)


def program_for(sheet: Sheet, subject: Subject) -> DisplayProgram:
    """The instructions, in the order in which they are run."""
    if lines_of(subject):
        return program_of(own_strokes(sheet, subject))
    return _program(sheet, is_ordered(subject))


@lru_cache(maxsize=4)
def _strokes(sheet: Sheet) -> Strokes:
    return strokes_of(sheet)


@lru_cache(maxsize=8)
def _program(sheet: Sheet, ordered: bool) -> DisplayProgram:
    strokes = _strokes(sheet)
    return program_of(nearest_first(strokes) if ordered else strokes)


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    if subject.entry == ORDERING:
        ends = own_strokes(sheet, subject).ends.reshape(-1, 2)
        return [Call(catalogue.get(ORDERING), (ends.copy(),))] if len(ends) else []
    program = program_for(sheet, subject)
    if not len(program):
        return []
    numbers = units_of(sheet, subject), *timing_of(subject).numbers_us
    return [Call(catalogue.get(SLUG), (program.rows.copy(), *numbers, shortest_ps_of(subject) * 1e-6))]


def _given(usual: float, label: str, low: float, high: float, unit: str) -> Given:
    return Given(usual, Number(label=label, low=low, high=high, unit=unit, keyed=False))


ARGUMENTS = {
    "display": Given(TEACHING),
    "refresh": _given(60.0, _("highest refresh rate"), 1.0, 1000.0, "Hz"),
    "start": _given(_USUAL[0], "t_0", 0.0, 1e4, "µs"),
    "pace": _given(_USUAL[2], "c", 1e-4, 1e3, "µs"),
    "jump_pace": _given(round(_USUAL[4], 4), "c_j", 0.0, 1e3, "µs"),
    "settle": _given(_USUAL[5], "t_s", 0.0, 1e4, "µs"),
    "ordered": Given(False),
    "lines": Given(0, Number(label=_("lines"), low=0, high=MOST_LINES, whole=True, keyed=False)),
    "length": _given(USUAL_LENGTH, _("length"), 1.0, 4096.0, "px"),
    "storage": Given(False),
}

register(
    KIND,
    SubjectKind(
        title=_("A display list, run by the display processor"),
        invitation=_("Draw a figure, or ask for test lines, to see how the display processor draws it."),
        calls=_calls,
        choices=lambda sheet, subject: (SLUG, ORDERING),
        entries=(SLUG, ORDERING),
        arguments=ARGUMENTS,
        whole=True,
    ),
)
