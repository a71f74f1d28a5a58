"""The frame buffer of a sheet under a raster mode, at a depth, through a colour table."""

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from msgspec.structs import replace as with_fields

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Frame, Mark
from workbench.algorithms.scanning.raster_scan import raster_scan
from workbench.display.colour_table import DEPTHS, DIRECT, Table, stored, usual_table
from workbench.display.scan import Scan, resampled
from workbench.display.setup import area_mm, too_many_pixels
from workbench.display.timings import COUNTS, RasterTiming
from workbench.document.fields import Number
from workbench.document.model import Sheet
from workbench.document.subjects import Argument, Subject
from workbench.language import _
from workbench.rendering.mapping import Call
from workbench.rendering.scene.backdrop import can_be_lit, whole_picture
from workbench.rendering.subjects.registry import Given, SubjectKind, register

KIND = "raster"
SLUG = raster_scan.__name__
SHEET, TYPED = "", "typed"
"""Modes that no table has: the proportions of VGA at a rate that is given, and counts that are given."""

USUAL_HZ = 60.0
_MOST_COUNT = 8192
_VGA = RasterTiming.named("vga-640x480-60")


def _number(label: str, low: float, high: float, unit: str = "", whole: bool = False) -> Number:
    return Number(label=label, low=low, high=high, unit=unit, whole=whole, keyed=False)


def _count(name: str) -> Number:
    titles = {
        "active": _("Active"),
        "front_porch": _("Front porch"),
        "sync": _("Sync"),
        "back_porch": _("Back porch"),
    }
    unit = _("clocks") if name.startswith("h_") else _("lines")
    return _number(titles[name[2:]], 0, _MOST_COUNT, unit, whole=True)


NUMBERS: dict[str, Number] = {
    "refresh_hz": _number(_("Refresh"), 0.1, 1000.0, "Hz"),
    "clock_mhz": _number(_("Pixel clock"), 0.0, 1000.0, "MHz"),
    **{name: _count(name) for name in COUNTS},
    "depth": _number(_("Bits per pixel"), 1, DIRECT, "bits", whole=True),
    "sum_width": _number(_("Width"), 0, 65536, "px", whole=True),
    "sum_height": _number(_("Height"), 0, 65536, "px", whole=True),
    "sum_bits": _number(_("Bits per pixel"), 0, 64, "bits", whole=True),
    "sum_hz": _number(_("Refresh"), 0.0, 1000.0, "Hz"),
    "sum_h_us": _number(_("Horizontal retrace"), 0.0, 1e6, "\N{MICRO SIGN}s"),
    "sum_v_us": _number(_("Vertical retrace"), 0.0, 1e6, "\N{MICRO SIGN}s"),
    "sum_kbits": _number(_("Line"), 0.001, 1e9, "kbit/s"),
}

ARGUMENTS: dict[str, Given] = {
    "mode": Given(SHEET),
    "at_mode": Given(False),
    "interlaced": Given(False),
    "own_table": Given(False),
    "table": Given(()),
    "refresh_hz": Given(USUAL_HZ, NUMBERS["refresh_hz"]),
    "clock_mhz": Given(float(_VGA.pixel_clock_hz) / 1e6, NUMBERS["clock_mhz"]),
    **{name: Given(getattr(_VGA, name), NUMBERS[name]) for name in COUNTS},
    "depth": Given(DIRECT, NUMBERS["depth"]),
    "sums_typed": Given(False),
    "sum_mode": Given(SHEET),
    "sum_width": Given(_VGA.h_active, NUMBERS["sum_width"]),
    "sum_height": Given(_VGA.v_active, NUMBERS["sum_height"]),
    "sum_bits": Given(DIRECT, NUMBERS["sum_bits"]),
    "sum_hz": Given(USUAL_HZ, NUMBERS["sum_hz"]),
    "sum_h_us": Given(5.0, NUMBERS["sum_h_us"]),
    "sum_v_us": Given(500.0, NUMBERS["sum_v_us"]),
    "sum_kbits": Given(100.0, NUMBERS["sum_kbits"]),
}


def given(subject: Subject, name: str) -> Any:
    """An argument of a subject, as it usually is where it is left out."""
    return subject.arguments.get(name, ARGUMENTS[name].usual)


def with_given(subject: Subject, **changes: Argument) -> Subject:
    """The same with other arguments."""
    return with_fields(subject, arguments={**subject.arguments, **changes})


def depth_of(subject: Subject) -> int:
    """Bits of a pixel: the least depth that there is and that holds what is asked for."""
    return next(depth for depth in DEPTHS if depth >= int(given(subject, "depth")))


def paper_of(sheet: Sheet) -> int:
    """The colour, 0xRRGGBB, of the pixels of a sheet on which nothing is drawn."""
    return sheet.palette[sheet.background % len(sheet.palette)]


def table_of(sheet: Sheet, subject: Subject) -> Table:
    """The colours of the table, 0xRRGGBB: the subject's own, or those that the depth usually has."""
    if not given(subject, "own_table"):
        return usual_table(depth_of(subject), paper_of(sheet))
    return tuple(min(max(int(colour), 0), 0xFFFFFF) for colour in given(subject, "table"))


def mode_of(sheet: Sheet, subject: Subject) -> RasterTiming:
    """The mode as it is named or typed; its ``fault`` tells where no tube can be driven so."""
    mode = given(subject, "mode")
    if mode == TYPED:
        clock = Fraction(str(given(subject, "clock_mhz"))) * 10**6
        counts = {name: int(given(subject, name)) for name in COUNTS}
        fields: dict[str, Any] = {
            "pixel_clock_hz": clock,
            "interlaced": bool(given(subject, "interlaced")),
            **counts,
        }
        return replace(_VGA, name=_("Typed"), note="", **fields)
    try:
        return RasterTiming.named(mode)
    except LookupError:
        rate = Fraction(str(given(subject, "refresh_hz")))
        return RasterTiming.synthesised(sheet.width_px, sheet.height_px, rate)


def typed(timing: RasterTiming) -> dict[str, Argument]:
    """The arguments that give a mode number by number, to change one of them."""
    counts: dict[str, Argument] = {name: getattr(timing, name) for name in COUNTS}
    clock = float(timing.pixel_clock_hz) / 1e6
    return {"mode": TYPED, "clock_mhz": clock, "interlaced": timing.interlaced, **counts}


def timing_of(sheet: Sheet, subject: Subject) -> RasterTiming:
    """What the beam follows: the mode, or its proportions around the pixels of the sheet."""
    mode = mode_of(sheet, subject)
    if given(subject, "at_mode") or mode.fault:
        return mode
    return mode.scaled(sheet.width_px, sheet.height_px)


def fault_of(sheet: Sheet, subject: Subject) -> str:
    """Why nothing can be scanned, "" where it can."""
    mode = mode_of(sheet, subject)
    if mode.fault:
        return mode.fault
    timing = timing_of(sheet, subject)
    return too_many_pixels((sheet.width_px, sheet.height_px)) or too_many_pixels(
        (timing.h_active, timing.v_active)
    )


_latest: list[tuple[Sheet, Any, Scan]] = []
_KEPT = 4


def scan_of(sheet: Sheet, subject: Subject) -> Scan | None:
    """The picture of a sheet as it is stored and scanned; None where ``fault_of`` says why not."""
    if fault_of(sheet, subject):
        return None
    key = timing_of(sheet, subject), depth_of(subject), table_of(sheet, subject), can_be_lit(sheet)
    for known, wanted, scan in _latest:
        if known is sheet and wanted == key:
            return scan
    timing, depth, table, _lit = key
    left, bottom, right, top = area_mm((sheet.width_px, sheet.height_px))
    buffer = stored(resampled(whole_picture(sheet), timing), depth, table, paper_of(sheet))
    scan = Scan(timing, buffer, (right - left, top - bottom))
    _latest.insert(0, (sheet, key, scan))
    del _latest[_KEPT:]
    return scan


def _calls(sheet: Sheet, subject: Subject) -> list[Call]:
    scan = scan_of(sheet, subject)
    if scan is None:
        return []
    timing = scan.timing
    blanks = timing.h_blank, timing.v_blank, timing.fields
    return [Call(catalogue.get(SLUG), (scan.buffer.bits, scan.table, *blanks, *scan.size_mm))]


def _as_they_are(_sheet: Sheet, _subject: Subject, _frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """Marks are in the pixels that are scanned, which may be others than those of the sheet."""
    return tuple(marks)


register(
    KIND,
    SubjectKind(
        title=_("The frame buffer on its way to the beam"),
        invitation=_("The mode cannot be scanned; its numbers say why."),
        calls=_calls,
        choices=lambda sheet, subject: (SLUG,),
        entries=(SLUG,),
        arguments=ARGUMENTS,
        on_device=_as_they_are,
        whole=True,
        as_seen=True,
    ),
)
