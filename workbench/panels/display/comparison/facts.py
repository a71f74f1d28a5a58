"""Raster and random scan feature by feature, with the numbers of one picture on two displays."""

from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.list_time import ListTime, list_time
from workbench.display.refresh_limit import LineTime, longest_steady_s
from workbench.display.setup import TubeSetup, area_mm, too_many_pixels
from workbench.display.timings import RasterTiming
from workbench.display.vector_timing import VectorTiming
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.language import _, ngettext
from workbench.rendering.display_program import DisplayProgram, Strokes
from workbench.rendering.hatching import filled_pixels, hatched
from workbench.rendering.scene.backdrop import whole_picture
from workbench.rendering.subjects.comparison import comparison_program, number_of
from workbench.rendering.subjects.random_scan import shortest_ps_of, timing_of, units_of

BYTES_PER_INSTRUCTION = 4
BYTES_PER_PIXEL = 3
DARK = np.zeros((3, 4), np.uint32)
"""What a raster tube is given where it can show no picture."""


class Feature(NamedTuple):
    """One row: what is compared, and what is to be added."""

    name: str
    raster: str
    random: str
    but: str


class Facts(NamedTuple):
    """One picture of ``size`` pixels on both displays. ``stairs`` are the steps of its slanted lines on the
    raster, ``filled`` the pixels of its areas, ``hatches`` the strokes that hint at them.
    """

    size: tuple[int, int]
    raster: RasterTiming
    timing: VectorTiming
    units: float
    program: DisplayProgram
    time: ListTime
    line: LineTime
    stairs: int
    filled: int
    hatches: int
    fusion_hz: float
    most: int | None

    @property
    def frame_buffer_bytes(self) -> int:
        """Three bytes for each pixel."""
        return self.size[0] * self.size[1] * BYTES_PER_PIXEL

    @property
    def list_bytes(self) -> int:
        """Four bytes for each instruction."""
        return len(self.program) * BYTES_PER_INSTRUCTION

    @property
    def pitch_mm(self) -> float:
        """From one pixel to the next on the face."""
        left, _bottom, right, _top = area_mm(self.size)
        return (right - left) / self.size[0]

    @property
    def as_long_as_raster(self) -> int:
        """How many lines take as long as the raster takes for any picture."""
        return int(float(self.raster.frame_s) * 1e12) // max(self.line.total_ps, 1)


def measured(sheet: Sheet, subject: Subject, setup: TubeSetup) -> tuple[Facts, NDArray[np.uint32]]:
    """What is compared of a sheet, and its frame buffer (h, w); black where that has too many pixels."""
    size, hatch = (sheet.width_px, sheet.height_px), int(number_of(subject, "hatch"))
    program, timing = comparison_program(sheet, hatch), timing_of(subject)
    units, shortest = units_of(sheet, subject), shortest_ps_of(subject)
    time = list_time(program.rows, units, timing, shortest)
    line = LineTime.mean(time, len(program.strokes))
    rate, longest = Fraction(str(number_of(subject, "refresh"))), longest_steady_s(setup.guns())
    facts = Facts(
        size, RasterTiming.synthesised(*size, rate),
        timing, units, program, time, line, stairs_of(comparison_program(sheet, 0).strokes),
        filled_pixels(sheet), len(hatched(sheet, hatch)) if hatch else 0,
        1.0 / longest, line.most_lines(longest, shortest),
    )  # fmt: skip
    return facts, DARK if too_many_pixels(size) else whole_picture(sheet)


def stairs_of(strokes: Strokes) -> int:
    """How often all lines together go over to the next row of the raster, or column where they are steep."""
    ways = np.abs(np.rint(strokes.ends[:, 1]) - np.rint(strokes.ends[:, 0]))
    return int(ways.min(axis=1).sum()) if len(ways) else 0


def features(facts: Facts) -> list[Feature]:
    """The rows of the course's table, each with this picture's numbers."""
    width, height = facts.size
    raster_ms, list_ms = float(facts.raster.frame_s) * 1e3, facts.time.list_ps * 1e-9
    rate = facts.time.refresh_hz
    unit_mm = facts.pitch_mm / facts.units
    return [
        Feature(
            _("Beam"),
            _("row by row over the whole screen, {lines} lines, whatever the picture").format(lines=height),
            ngettext(
                "from end to end of {n:,} stroke, and nowhere else",
                "from end to end of {n:,} strokes, and nowhere else",
                len(facts.program.strokes),
            ).format(n=len(facts.program.strokes)),
            _("Both begin anew before the phosphor has faded: refresh."),
        ),
        Feature(
            _("Memory"),
            _("frame buffer: {w} · {h} · 24 bits = {n:,} bytes").format(
                w=width, h=height, n=facts.frame_buffer_bytes
            ),
            _("display list: {i:,} instructions · {b} bytes = {n:,} bytes").format(
                i=len(facts.program), b=BYTES_PER_INSTRUCTION, n=facts.list_bytes
            ),
            _("A list grows with each line, a frame buffer never: {n:,} instructions fill as much.").format(
                n=facts.frame_buffer_bytes // BYTES_PER_INSTRUCTION
            ),
        ),
        Feature(
            _("Refresh"),
            _("{ms:.3g} ms, {hz:.3g} Hz, for any picture").format(
                ms=raster_ms, hz=float(facts.raster.refresh_hz)
            ),
            _("{ms:.3g} ms for this list, {hz:.3g} Hz: {verdict}").format(
                ms=list_ms, hz=rate, verdict=_("it flickers") if rate < facts.fusion_hz else _("steady")
            ),
            _("A line like the mean one takes {t:.3g} µs; {n:,} of them take as long as the raster.").format(
                t=facts.line.total_ps * 1e-6, n=facts.as_long_as_raster
            ),
        ),
        Feature(
            _("Resolution"),
            _("{w} × {h} pixels, {mm:.2g} mm from one to the next").format(
                w=width, h=height, mm=facts.pitch_mm
            ),
            _("{grid:,} places across, {mm:.2g} mm: {n:.3g} in each pixel").format(
                grid=facts.timing.grid, mm=unit_mm, n=facts.units
            ),
            _("Either is blurred by the spot of the beam."),
        ),
        Feature(
            _("Smoothness"),
            ngettext(
                "staircase: {n:,} stair in the slanted lines, off by up to half a pixel",
                "staircase: {n:,} stairs in the slanted lines, each off by up to half a pixel",
                facts.stairs,
            ).format(n=facts.stairs)
            if facts.stairs
            else _("no stairs: no line here is slanted"),
            _("straight from end to end, without a stair"),
            _("Antialiasing hides the stairs of a raster, at the price of sharpness."),
        ),
        Feature(
            _("Areas, realism"),
            ngettext(
                "{n:,} pixel filled; any colour in each, so shading and photographs",
                "{n:,} pixels filled; any colour in each, so shading and photographs",
                facts.filled,
            ).format(n=facts.filled)
            if facts.filled
            else _("nothing is filled here; any colour in each pixel, so shading and photographs"),
            ngettext(
                "no areas: outlines, or {n:,} stroke of hatching",
                "no areas: outlines, or {n:,} strokes of hatching",
                facts.hatches,
            ).format(n=facts.hatches)
            if facts.hatches
            else _("no areas: outlines only"),
            _("To fill by strokes takes a stroke for each row, and the list flickers."),
        ),
        Feature(
            _("Scan conversion"),
            _("each line and area becomes pixels before it is seen"),
            _("none: the ends of the lines are the picture"),
            _("So a moved line costs little on a random-scan display: two instructions change."),
        ),
        Feature(
            _("Cost"),
            _("memory was expensive and is cheap now; the deflection always runs the same way"),
            _("little memory, but fast and exact deflection, and a processor that draws"),
            _("Raster won when memory became cheap."),
        ),
    ]
