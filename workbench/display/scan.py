"""A frame buffer under a mode: what each pixel clock of a frame fetches, looks up and sends to the beam."""

from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from workbench.display.colour_table import DIRECT, FrameBuffer
from workbench.display.raster_sums import address_of
from workbench.display.timings import RasterTiming

T = TypeVar("T", bound=np.generic)


class Moment(NamedTuple):
    """What the text ``raster_scan`` has in its variables when it sends a pixel, by the same names."""

    field: int
    line: int
    x: int
    y: int
    address: int
    bits: int
    colour: int
    red: int
    green: int
    blue: int
    x_mm: float
    y_mm: float
    clock: int

    @property
    def lit(self) -> bool:
        """Whether the beam is on."""
        return self.colour != 0


def resampled(image: NDArray[T], timing: RasterTiming) -> NDArray[T]:
    """A picture (h, w) in as many pixels as a mode scans, each the one of the picture that it lies in."""
    height, width = image.shape
    if (timing.v_active, timing.h_active) == image.shape:
        return image
    rows = (2 * np.arange(timing.v_active) + 1) * height // (2 * timing.v_active)
    columns = (2 * np.arange(timing.h_active) + 1) * width // (2 * timing.h_active)
    found: NDArray[T] = image[rows[:, None], columns]
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Scan:
    """``buffer`` has the size that ``timing`` scans; ``size_mm`` is the size of the picture on the tube."""

    timing: RasterTiming
    buffer: FrameBuffer
    size_mm: tuple[float, float]

    @property
    def table(self) -> NDArray[np.int64]:
        """The colour table as the text takes it; none where the bits are the colour."""
        kept = self.buffer.table[: 1 << self.buffer.depth] or (0,)
        return np.array(() if self.buffer.depth >= DIRECT else kept, np.int64)

    def at(self, clock: int) -> Moment | None:
        """What a clock of the frame does, 0 its first; None while the beam is dark for a retrace."""
        timing = self.timing
        line, x = divmod(clock % timing.clocks_per_frame, timing.h_total)
        row = timing.row_of_line(line)
        if row is None or x >= timing.h_active:
            return None
        y = timing.v_active - 1 - row
        bits, colour = int(self.buffer.bits[y, x]), int(self.buffer.shown[y, x])
        return Moment(
            row % timing.fields,
            row,
            x,
            y,
            address_of(x, y, timing.h_active),
            bits,
            colour,
            colour // 65536,
            colour // 256 % 256,
            colour % 256,
            ((x + 0.5) / timing.h_active - 0.5) * self.size_mm[0],
            ((y + 0.5) / timing.v_active - 0.5) * self.size_mm[1],
            clock,
        )

    def clock_at(self, seconds: Fraction) -> int:
        """The clock of its frame that runs at a time."""
        return int(seconds * self.timing.pixel_clock_hz // 1) % self.timing.clocks_per_frame
