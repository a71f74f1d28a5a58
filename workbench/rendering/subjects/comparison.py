"""One picture on a raster and on a random-scan display: its display list is run, areas hatched or not."""

from functools import lru_cache

import numpy as np

from workbench.algorithms import catalogue
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.display_program import DisplayProgram, Strokes, program_of, strokes_of
from workbench.rendering.hatching import hatched
from workbench.rendering.mapping import Call
from workbench.rendering.subjects.random_scan import ARGUMENTS as OF_RANDOM_SCAN
from workbench.rendering.subjects.random_scan import SLUG, shortest_ps_of, timing_of, units_of
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "comparison"
USUAL_HATCH, USUAL_POWER = 3, 6.0


def _given(usual: float, label: str, low: float, high: float, unit: str, whole: bool = False) -> Given:
    return Given(usual, Number(label=label, low=low, high=high, unit=unit, whole=whole, keyed=False))


ARGUMENTS = {
    **{name: OF_RANDOM_SCAN[name] for name in ("display", "refresh", "start", "pace", "jump_pace", "settle")},
    "hatch": _given(USUAL_HATCH, _("rows from one hatch to the next"), 0, 64, "px", whole=True),
    "x": _given(-1.0, "x", -1.0, 4096.0, "px"),
    "y": _given(-1.0, "y", -1.0, 4096.0, "px"),
    "power": _given(USUAL_POWER, _("magnification"), 2.0, 40.0, "×"),
}


LENS = frozenset(("x", "y", "power"))
"""Where the magnifying glass is and how strong: no number that is compared depends on them."""


def compared(subject: Subject) -> dict[str, Argument]:
    """The arguments that the comparison depends on."""
    return {name: value for name, value in subject.arguments.items() if name not in LENS}


def compares_displays(subject: Subject) -> bool:
    """Whether a picture on both kinds of display is what is stepped."""
    return subject.kind == KIND


def number_of(subject: Subject, name: str) -> float:
    """One of its numbers."""
    value = subject.arguments.get(name, ARGUMENTS[name].usual)
    assert isinstance(value, int | float), "its kind is checked"
    return float(value)


def lens_of(sheet: Sheet, subject: Subject) -> tuple[float, float]:
    """The place (device, pixels) under the magnifying glass: at first a corner of the middle stroke."""
    x, y = number_of(subject, "x"), number_of(subject, "y")
    if x < 0.0 or y < 0.0:
        ends = comparison_strokes(sheet, 0).ends
        if not len(ends):
            return (sheet.width_px - 1) / 2, (sheet.height_px - 1) / 2
        ways = np.abs(ends[:, 1] - ends[:, 0])
        slanted = int(ways.min(axis=1).argmax())
        x, y = ends[slanted].mean(axis=0).tolist()
    return min(x, sheet.width_px - 1.0), min(y, sheet.height_px - 1.0)


@lru_cache(maxsize=8)
def comparison_strokes(sheet: Sheet, hatch: int) -> Strokes:
    """The strokes of a sheet, then those that hatch its areas; none of these where ``hatch`` is 0."""
    lines = strokes_of(sheet)
    if not hatch:
        return lines
    across = hatched(sheet, hatch)
    return Strokes(
        np.concatenate([lines.ends, across.ends]),
        np.concatenate([lines.colours, across.colours]),
        np.concatenate([lines.figures, across.figures]),
    )


@lru_cache(maxsize=8)
def comparison_program(sheet: Sheet, hatch: int) -> DisplayProgram:
    """The instructions that draw them."""
    return program_of(comparison_strokes(sheet, hatch))


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    program = comparison_program(sheet, int(number_of(subject, "hatch")))
    if not len(program):
        return []
    numbers = units_of(sheet, subject), *timing_of(subject).numbers_us
    return [Call(catalogue.get(SLUG), (program.rows.copy(), *numbers, shortest_ps_of(subject) * 1e-6))]


register(
    KIND,
    SubjectKind(
        title=_("One picture, drawn row by row and stroke by stroke"),
        invitation=_("Draw a figure, to see it on a raster and on a random-scan display."),
        calls=_calls,
        choices=lambda sheet, subject: (SLUG,),
        entries=(SLUG,),
        arguments=ARGUMENTS,
        whole=True,
        as_seen=True,
    ),
)
