"""How long a display list takes, as a student writes it down: the formula with its numbers put in."""

import html
import re
from typing import NamedTuple

from workbench.display.list_time import ListTime
from workbench.display.refresh_limit import LineTime
from workbench.display.storage_tube import BAUD, BITS_PER_BYTE, BYTES_PER_VECTOR, ERASE_S, transfer_s
from workbench.display.vector_timing import VectorTiming
from workbench.language import _

_US, _MS = 1e-6, 1e-9
_INDEX = re.compile(r"T_(\w+)")


class Budget(NamedTuple):
    """The time of a list of ``lines`` lines on a display. ``line`` is that of one of them: in a ``test`` of
    equal lines of each, else of the mean one. ``fusion_hz`` is the rate from which the eye sees it steady,
    1 / T_eye (0: any rate), ``most`` how many lines keep it (None: any). ``unordered_ps`` is the time of the
    same list in the order of the sheet.
    """

    timing: VectorTiming
    units: float
    shortest_ps: int
    time: ListTime
    lines: int
    line: LineTime
    length_units: float
    test: bool
    fusion_hz: float
    most: int | None
    unordered_ps: int

    @property
    def flickers(self) -> bool:
        """Whether the picture is refreshed too seldom for the eye."""
        return self.time.refresh_hz < self.fusion_hz


def rich(line: str) -> str:
    """A line of the sum as rich text, with real subscripts."""
    return _INDEX.sub(r"T<sub>\1</sub>", html.escape(line))


def on_paper(line: str) -> str:
    """A line of the sum as a sentence of a page, its times as formulas."""
    return _INDEX.sub(r"$T_{\1}$", line)


def stroke_formula(timing: VectorTiming) -> str:
    """The time of a stroke N units long, as a formula of the course's notation."""
    start, knee, pace, *_rest = timing.numbers_us
    length = f"(N - {knee:g})" if knee else "N"
    whole = f"{start:g} + {pace:.4g} {length}" if start else f"{pace:.4g} {length}"
    return f"t = {whole}"


def sum_lines(budget: Budget) -> list[str]:
    """The lines of the sum: what a picture takes, its rate, and how many lines there may be."""
    time, line = budget.time, budget.line
    lines = [_("One stroke of N units: {formula} µs").format(formula=stroke_formula(budget.timing))]
    if budget.test:
        lines.append(
            _("One line, N = {n:.4g}: {stroke:.4g} + {jump:.4g} + {settle:.4g} = {all:.5g} µs").format(
                n=budget.length_units,
                stroke=line.stroke_ps * _US,
                jump=line.jump_ps * _US,
                settle=line.settle_ps * _US,
                all=line.total_ps * _US,
            )
        )
        lines.append(
            _("T_list = n · t = {n:,} · {t:.5g} µs = {ms:.4g} ms").format(
                n=budget.lines, t=line.total_ps * _US, ms=time.list_ps * _MS
            )
        )
    else:
        lines.append(
            _(
                "T_list = strokes {strokes:.4g} + jumps {jumps:.4g} + settling {settles:.4g} = {all:.4g} ms"
            ).format(
                strokes=time.strokes_ps * _MS,
                jumps=time.jumps_ps * _MS,
                settles=time.settles_ps * _MS,
                all=time.list_ps * _MS,
            )
        )
    lines.append(
        _("refresh = 1 / max(T_list, T_min) = 1 / max({list:.4g}, {least:.4g}) ms = {rate:.4g} Hz").format(
            list=time.list_ps * _MS, least=budget.shortest_ps * _MS, rate=time.refresh_hz
        )
    )
    lines.append(_limit(budget))
    return lines


def storage_lines(strokes: int) -> list[str]:
    """The lines of the sum where the list is written once and kept."""
    return [
        _("No refresh: the list is written once, over a line of {baud:,} baud (Tektronix 4010).").format(
            baud=BAUD
        ),
        _(
            "t = n · {bytes} bytes · {bits} bits / {baud} = {n:,} · {each} / {baud} = {s:.3g} s "
            "({bytes} bytes: uncertain)"
        ).format(
            bytes=BYTES_PER_VECTOR,
            bits=BITS_PER_BYTE,
            each=BYTES_PER_VECTOR * BITS_PER_BYTE,
            baud=BAUD,
            n=strokes,
            s=transfer_s(strokes),
        ),
        _("To change one stroke: erase all, {erase} s (Tektronix 613), and write again, {all:.3g} s.").format(
            erase=ERASE_S, all=ERASE_S + transfer_s(strokes)
        ),
    ]


def working(budget: Budget, stores: bool) -> tuple[list[str], list[str]]:
    """The lines of the sum, and what the eye sees of it: nothing where a storage tube keeps the list."""
    if stores:
        return storage_lines(budget.lines), []
    return sum_lines(budget), [line for line in (verdict(budget), saving(budget)) if line]


def _limit(budget: Budget) -> str:
    if budget.most is None:
        return _("This phosphor glows so long that no list is seen to flicker.")
    if not budget.most:
        return _("Even an empty list is refreshed too seldom for this phosphor: it always flickers.")
    what = _("lines like this") if budget.test else _("lines of its mean length")
    return _("Steady up to n = ⌊T_eye / t⌋ = ⌊{eye:,.1f} / {t:.5g}⌋ = {most:,} {what}").format(
        eye=1e6 / budget.fusion_hz, t=budget.line.total_ps * _US, most=budget.most, what=what
    )


def verdict(budget: Budget) -> str:
    """What the eye sees of it, in one sentence."""
    rate, fusion = budget.time.refresh_hz, budget.fusion_hz
    if budget.flickers:
        said = _(
            "The list takes {ms:.3g} ms: {rate:.3g} Hz, and the eye asks for {fusion:.3g} Hz. It flickers."
        )
    else:
        said = _(
            "The list takes {ms:.3g} ms: {rate:.3g} Hz, enough for the eye, which asks for {fusion:.3g} Hz."
        )
    return said.format(ms=budget.time.list_ps * _MS, rate=rate, fusion=fusion)


def saving(budget: Budget) -> str:
    """What the order of the strokes saves; empty where it is that of the sheet."""
    saved = budget.unordered_ps - budget.time.list_ps
    if not budget.unordered_ps or not saved:
        return ""
    share = saved / budget.unordered_ps
    if saved < 0:
        said = _("Nearest end first takes {ms:.3g} ms more here: a greedy tour need not be the shortest.")
        return said.format(ms=-saved * _MS)
    said = _("Nearest end first saves {ms:.3g} ms of {all:.3g} ms, {share:.0%}.")
    return said.format(ms=saved * _MS, all=budget.unordered_ps * _MS, share=share)
