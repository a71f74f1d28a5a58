"""The sums of an exam about a raster display: each with its formula, the numbers put in, and the result."""

from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from workbench.display import raster_sums as of
from workbench.display.timings import RasterTiming
from workbench.exchange.tables import Table, plain
from workbench.language import _
from workbench.widgets.look.spans import time_text

Pixel = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Numbers:
    """What the sums are of; times in seconds, the line in bits a second. ``pixel`` is the one addressed:
    where the picture has none there, that is its nearest.
    """

    width: int
    height: int
    bits: int
    refresh_hz: Fraction
    h_retrace_s: Fraction
    v_retrace_s: Fraction
    bits_per_second: Fraction
    pixel: Pixel = (0, 0)


class Sum(NamedTuple):
    """One row; ``formula`` and ``numbers`` have their levels as the headings of tables have: x_{max}.

    ``fault`` says why there is no result.
    """

    title: str
    formula: str
    numbers: str
    result: str
    fault: str = ""


def numbers_of(timing: RasterTiming, bits: int, bits_per_second: Fraction, pixel: Pixel) -> Numbers:
    """The numbers of a mode; its blanking is what the retraces take."""
    return Numbers(
        timing.h_active,
        timing.v_active,
        bits,
        timing.refresh_hz,
        timing.h_blank * timing.pixel_s,
        timing.v_blank * timing.line_s,
        bits_per_second,
        pixel,
    )


def fault_of(numbers: Numbers) -> str:
    """Why nothing can be worked out, "" where it can."""
    if min(numbers.width, numbers.height) < 1:
        return _("A picture has at least one pixel each way; give its width and height.")
    if numbers.bits < 1:
        return _("A pixel has at least 1 bit; give the bits per pixel.")
    if numbers.refresh_hz <= 0:
        return _("At 0 Hz no picture is ever shown; give a refresh above 0.")
    return ""


def worked_out(numbers: Numbers, timing: RasterTiming | None) -> list[Sum]:
    """Every sum of these numbers, and with a mode those of its totals."""
    if fault_of(numbers):
        return []
    return [
        *_memory(numbers),
        *_plain(numbers),
        *_with_retraces(numbers),
        *(_totals(timing, numbers.bits) if timing else ()),
    ]


def table_of(sums: list[Sum]) -> Table:
    """The sums as a table."""
    columns = _("quantity"), _("formula"), _("numbers put in"), _("result")
    rows = [
        (each.title, plain(each.formula), plain(each.numbers), each.result or each.fault) for each in sums
    ]
    return Table(columns, rows, formulas=False)


def text_of(sums: list[Sum]) -> str:
    """The sums as lines of text, as they are written in an exam."""
    return "".join(
        f"{each.title}: {plain(each.formula)} = {plain(each.numbers)} = {each.result}\n"
        if each.result
        else f"{each.title}: {plain(each.formula)} = {plain(each.numbers)}: {each.fault}\n"
        for each in sums
    )


def _memory(n: Numbers) -> list[Sum]:
    size = of.frame_buffer_bytes(n.width, n.height, n.bits)
    bits = of.frame_buffer_bits(n.width, n.height, n.bits)
    x, y = min(n.pixel[0], n.width - 1), min(n.pixel[1], n.height - 1)
    address = of.address_of(x, y, n.width)
    byte, bit = of.byte_and_bit(address, n.bits)
    loading = of.loading_s(bits, n.bits_per_second)
    columns, rows = of.aspect(n.width, n.height)
    return [
        Sum(
            _("Frame buffer"),
            "W \u00b7 H \u00b7 b / 8",
            f"{n.width} \u00b7 {n.height} \u00b7 {n.bits} / 8",
            f"{_number(size)} B {_kibibytes(size)}",
        ),
        Sum(_("Colours"), "2^b", f"2^{{{n.bits}}}", f"{of.colour_count(n.bits):,}"),
        Sum(
            _("Address of ({x}, {y})").format(x=x, y=y),
            "y (x_{max} + 1) + x",
            f"{y} \u00b7 {n.width} + {x}",
            f"{address:,}",
        ),
        Sum(
            _("Where its bits begin"),
            "address \u00b7 b / 8",
            f"{address} \u00b7 {n.bits} / 8",
            _("byte {byte:,}, bit {bit}").format(byte=byte, bit=bit),
        ),
        Sum(
            _("Loading over the line"),
            "W \u00b7 H \u00b7 b / R",
            f"{n.width} \u00b7 {n.height} \u00b7 {n.bits} / {_number(n.bits_per_second)}",
            time_text(loading),
        ),
        Sum(_("Aspect of the picture"), "W : H", f"{n.width} : {n.height}", f"{columns} : {rows}"),
        Sum(
            _("Aspect of a pixel, face 4 : 3"),
            "(4 / 3) / (W / H)",
            f"(4 / 3) \u00b7 {n.height} / {n.width}",
            _short(of.pixel_aspect(n.width, n.height)),
        ),
    ]


def _plain(n: Numbers) -> list[Sum]:
    hz = _short(n.refresh_hz)
    rate = of.scan_out_rate(n.width, n.height, n.bits, n.refresh_hz)
    return [
        Sum(
            _("Line time, no retrace"),
            "1 / (H f)",
            f"1 / ({n.height} \u00b7 {hz} Hz)",
            time_text(of.plain_line_s(n.height, n.refresh_hz)),
        ),
        Sum(
            _("Pixel time, no retrace"),
            "1 / (W H f)",
            f"1 / ({n.width} \u00b7 {n.height} \u00b7 {hz} Hz)",
            time_text(of.plain_pixel_s(n.width, n.height, n.refresh_hz)),
        ),
        Sum(
            _("Read from the frame buffer, on average"),
            "W \u00b7 H \u00b7 b / 8 \u00b7 f",
            f"{n.width} \u00b7 {n.height} \u00b7 {n.bits} / 8 \u00b7 {hz} Hz",
            f"{_short(rate / 10**6)} MB/s",
        ),
    ]


def _with_retraces(n: Numbers) -> list[Sum]:
    frame, h, v = (time_text(each) for each in (1 / n.refresh_hz, n.h_retrace_s, n.v_retrace_s))
    line = of.line_s(n.height, n.refresh_hz, n.v_retrace_s)
    pixel = of.pixel_s(n.width, n.height, n.refresh_hz, n.h_retrace_s, n.v_retrace_s)
    share = of.retrace_share(n.height, n.refresh_hz, n.h_retrace_s, n.v_retrace_s)
    fault = ""
    if pixel <= 0:
        taken = n.height * n.h_retrace_s + n.v_retrace_s
        fault = _(
            "the retraces take {taken} of a frame of {frame}, which leaves no time for pixels; shorten them"
        ).format(taken=time_text(taken), frame=frame)
    return [
        Sum(
            _("Line time, given retraces"),
            "(1 / f \u2212 t_v) / H",
            f"({frame} \u2212 {v}) / {n.height}",
            "" if line <= 0 else time_text(line),
            fault if line <= 0 else "",
        ),
        Sum(
            _("Pixel time, given retraces"),
            "(1 / f \u2212 H t_h \u2212 t_v) / (W H)",
            f"({frame} \u2212 {n.height} \u00b7 {h} \u2212 {v}) / ({n.width} \u00b7 {n.height})",
            "" if fault else time_text(pixel),
            fault,
        ),
        Sum(
            _("Share of retrace, given retraces"),
            "(H t_h + t_v) f",
            f"({n.height} \u00b7 {h} + {v}) \u00b7 {_short(n.refresh_hz)} Hz",
            "" if fault else f"{float(100 * share):.1f} %",
            fault,
        ),
    ]


def _totals(timing: RasterTiming, bits: int) -> list[Sum]:
    clock = f"{float(timing.pixel_clock_hz) / 1e6:.10g} MHz"
    across, down = timing.h_total, timing.v_total
    rows = [
        Sum(_("Pixel time, the mode's clock"), "1 / f_{clock}", f"1 / {clock}", time_text(timing.pixel_s)),
        Sum(
            _("Line time, the mode's totals"),
            "h_{total} / f_{clock}",
            f"{across} / {clock}",
            time_text(timing.line_s),
        ),
        Sum(
            _("Line rate"),
            "f_{clock} / h_{total}",
            f"{clock} / {across}",
            f"{_short(1 / timing.line_s / 1000)} kHz",
        ),
        Sum(
            _("Refresh, the mode's totals"),
            "f_{clock} / (h_{total} v_{total})",
            f"{clock} / ({across} \u00b7 {down})",
            f"{_short(timing.refresh_hz)} Hz",
        ),
        Sum(
            _("Share of retrace, the mode's totals"),
            "1 \u2212 W H / (h_{total} v_{total})",
            f"1 \u2212 {timing.h_active} \u00b7 {timing.v_active} / ({across} \u00b7 {down})",
            f"{float(100 * (1 - timing.lit_share)):.1f} %",
        ),
        Sum(
            _("Bandwidth of the video amplifier, at least"),
            "f_{clock} / 2",
            f"{clock} / 2",
            f"{_short(timing.pixel_clock_hz / 2 / 10**6)} MHz",
        ),
    ]
    rows.append(
        Sum(
            _("Read from the frame buffer, at the peak"),
            "f_{clock} \u00b7 b / 8",
            f"{clock} \u00b7 {bits} / 8",
            f"{_short(timing.pixel_clock_hz * bits / 8 / 10**6)} MB/s",
        )
    )
    if timing.interlaced:
        rows.append(
            Sum(
                _("Fields a second"),
                "2 f_{clock} / (h_{total} v_{total})",
                f"2 \u00b7 {clock} / ({across} \u00b7 {down})",
                f"{_short(2 * timing.refresh_hz)} Hz",
            )
        )
    return rows


def _number(value: Fraction) -> str:
    return f"{value.numerator:,}" if value.denominator == 1 else f"{float(value):,.10g}"


def _kibibytes(size: Fraction) -> str:
    """What so many bytes are in KiB: equal in seven digits at most, or about."""
    exact = f"{float(size / 1024):,.7g}"
    if Fraction(exact.replace(",", "")) == size / 1024:
        return f"= {exact} KiB"
    return f"\N{ALMOST EQUAL TO} {_short(size / 1024)} KiB"


def _short(value: Fraction) -> str:
    return f"{float(value):,.4g}" if value.denominator != 1 or value >= 10**9 else f"{int(value):,}"
