"""When the beam is where: raster timings in whole pixel clocks and lines.

Order of a line: active, front porch, sync, back porch; of a frame the same, in lines. For an interlaced
mode the vertical counts are those of both fields together, and a field is half of them: with an odd number
of lines the second field starts half a line later and its rows fall between those of the first.
"""

import tomllib
from dataclasses import dataclass, replace
from difflib import get_close_matches
from fractions import Fraction
from functools import cache
from typing import Any

from workbench.language import _
from workbench.paths import resource

LEAST_CLOCK_HZ = 1


@dataclass(frozen=True, slots=True)
class RasterTiming:
    """One raster mode; horizontal counts in pixel clocks, vertical ones in lines, the clock in hertz.

    ``uncertain_fields`` are those of which the sources are not sure, ``note`` says more of them.
    """

    name: str
    pixel_clock_hz: Fraction
    h_active: int
    h_front_porch: int
    h_sync: int
    h_back_porch: int
    v_active: int
    v_front_porch: int
    v_sync: int
    v_back_porch: int
    interlaced: bool = False
    uncertain_fields: tuple[str, ...] = ()
    note: str = ""

    @staticmethod
    def named(name: str) -> "RasterTiming":
        """The mode with that id, as "vga-640x480-60". Raises LookupError with close matches."""
        table = _table()
        if name not in table:
            close = get_close_matches(name, table, n=3, cutoff=0.3) or list(table)[:3]
            sentence = _("There is no raster mode {name}. Try one of {close}.")
            raise LookupError(sentence.format(name=name, close=", ".join(close)))
        return table[name]

    @staticmethod
    def synthesised(width: int, height: int, refresh_hz: Fraction | int) -> "RasterTiming":
        """A mode for any frame buffer, blanked in the proportions of VGA; frames last exactly 1/refresh."""
        vga = RasterTiming.named("vga-640x480-60")
        return vga.scaled(width, height).at(Fraction(refresh_hz))

    def scaled(self, width: int, height: int) -> "RasterTiming":
        """The mode for another frame buffer: blanked in the same proportions, as many frames a second.

        It is interlaced where this is and there are rows for two fields.
        """

        def across(part: int) -> int:
            return max(min(part, 1), (part * width + self.h_active // 2) // self.h_active)

        def down(part: int) -> int:
            return max(min(part, 1), (part * height + self.v_active // 2) // self.v_active)

        counts = replace(
            self,
            name=f"{width} x {height}",
            h_active=width,
            h_front_porch=across(self.h_front_porch),
            h_sync=across(self.h_sync),
            h_back_porch=across(self.h_back_porch),
            v_active=height,
            v_front_porch=down(self.v_front_porch),
            v_sync=down(self.v_sync),
            v_back_porch=down(self.v_back_porch),
            interlaced=self.interlaced and height > 1,
        )
        return counts.at(self.refresh_hz)

    def at(self, refresh_hz: Fraction) -> "RasterTiming":
        """The same counts with the clock that gives exactly ``refresh_hz`` frames a second."""
        return replace(self, pixel_clock_hz=refresh_hz * self.clocks_per_frame)

    @property
    def fault(self) -> str:
        """Why no tube can be driven so, "" where it can; what is typed may be anything."""
        if self.h_active < 1 or self.v_active < 1:
            return _("The picture has no pixels: {w} \u00d7 {h}. Give it at least one each way.").format(
                w=self.h_active, h=self.v_active
            )
        if min(self.h_sync, self.v_sync) < 1:
            return _("Without a sync pulse the beam never flies back: give it at least 1.")
        if min(self.h_front_porch, self.h_back_porch, self.v_front_porch, self.v_back_porch) < 0:
            return _("A porch is negative, so the totals are smaller than the picture: give it 0 or more.")
        if self.pixel_clock_hz < LEAST_CLOCK_HZ:
            return _(
                "At a pixel clock of {clock:g} MHz no picture ever comes: give it at least 1e-6 MHz."
            ).format(clock=float(self.pixel_clock_hz / 10**6))
        if self.interlaced and self.v_active < 2:
            return _("Two fields need at least two lines: give the picture more, or scan it in one field.")
        return ""

    @property
    def h_total(self) -> int:
        """Pixel clocks per line."""
        return self.h_active + self.h_front_porch + self.h_sync + self.h_back_porch

    @property
    def v_total(self) -> int:
        """Lines per frame."""
        return self.v_active + self.v_front_porch + self.v_sync + self.v_back_porch

    @property
    def clocks_per_frame(self) -> int:
        """Pixel clocks per frame."""
        return self.h_total * self.v_total

    @property
    def pixel_s(self) -> Fraction:
        """Seconds per pixel clock."""
        return 1 / self.pixel_clock_hz

    @property
    def line_s(self) -> Fraction:
        """Seconds per line."""
        return self.h_total / self.pixel_clock_hz

    @property
    def frame_s(self) -> Fraction:
        """Seconds per frame (both fields)."""
        return self.clocks_per_frame / self.pixel_clock_hz

    @property
    def refresh_hz(self) -> Fraction:
        """Frames per second."""
        return 1 / self.frame_s

    @property
    def h_blank(self) -> int:
        """Pixel clocks of a line in which the beam is dark."""
        return self.h_total - self.h_active

    @property
    def v_blank(self) -> int:
        """Lines of a frame in which the beam is dark."""
        return self.v_total - self.v_active

    @property
    def fields(self) -> int:
        """Vertical sweeps of a frame: 2 where it is interlaced."""
        return 2 if self.interlaced else 1

    @property
    def lines_per_field(self) -> Fraction:
        """Lines from one vertical retrace to the next; a half-integer when the fields interleave."""
        return Fraction(self.v_total, 2 if self.interlaced else 1)

    @property
    def lit_share(self) -> Fraction:
        """Share of the time in which the beam may be on."""
        return Fraction(self.h_active * self.v_active, self.clocks_per_frame)

    def line_of_row(self, row_from_top: int) -> int:
        """Number of the line, from the start of the frame, that scans a row of the picture."""
        if not self.interlaced:
            return row_from_top
        half, second = divmod(row_from_top, 2)
        return half + (self.v_total + 1) // 2 * second

    def hit_s(self, x: int, y: int) -> Fraction:
        """When in a frame the beam is in the middle of a pixel of the mode, row 0 at the bottom."""
        clock = self.line_of_row(self.v_active - 1 - y) * self.h_total + x
        return (clock + Fraction(1, 2)) / self.pixel_clock_hz

    def row_of_line(self, line: int) -> int | None:
        """The row from the top that a line of the frame scans; None while it is blanked."""
        if not self.interlaced:
            return line if line < self.v_active else None
        start = (self.v_total + 1) // 2
        second, half = (1, line - start) if line >= start else (0, line)
        row = 2 * half + second
        return row if row < self.v_active else None


COUNTS = tuple(key for key in RasterTiming.__dataclass_fields__ if key[:2] in ("h_", "v_"))
"""The fields that are counts: of a line in pixel clocks, of a frame in lines, in their order in time."""


def raster_modes() -> tuple[str, ...]:
    """The ids of all raster modes, in the order of the table."""
    return tuple(_table())


def _mode(record: dict[str, Any]) -> RasterTiming:
    counts = {key: record[key] for key in COUNTS}
    return RasterTiming(
        record["name"],
        Fraction(record["pixel_clock_hz"]),
        interlaced=record["interlaced"],
        uncertain_fields=tuple(record["uncertain_fields"]),
        note=record["note"],
        **counts,
    )


@cache
def _table() -> dict[str, RasterTiming]:
    with resource("video-timings.toml").open("rb") as file:
        return {record["id"]: _mode(record) for record in tomllib.load(file)["raster"]}
