"""The pictures of a sheet that moves, one for each frame of what is written."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.model import Sheet
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of
from workbench.exchange.frames import Picture
from workbench.exchange.writing import Progress, Put
from workbench.geometry.conventions import top_row_first
from workbench.language import _
from workbench.rendering import frame_buffer
from workbench.rendering.scene.backdrop import with_scene

MOST_SIDE_PX = 4096
_CONTACTS = 24
_GAP_PX = 4
_PAPER = 0xFF


class Size(NamedTuple):
    """Width and height in pixels."""

    width: int
    height: int


@dataclass(frozen=True, slots=True)
class MovingSheet:
    """Frames for a GIF or for PNG files: ``rate`` a second, each as large as ``size`` or as the sheet, whose
    shape is kept.

    Raises: ValueError, a sentence, for a size or a rate that cannot be.
    """

    sheet: Sheet
    size: Size | None = None
    rate: float = 0.0

    def __post_init__(self) -> None:
        if self.size is not None and not all(0 < side <= MOST_SIDE_PX for side in self.size):
            sentence = _("A picture of {width} × {height} pixels cannot be made; give 1 to {most} each way.")
            raise ValueError(
                sentence.format(width=self.size.width, height=self.size.height, most=MOST_SIDE_PX)
            )
        if self.rate and not 0.1 <= self.rate <= 100.0:
            sentence = _("{rate:g} frames per second cannot be written; give a rate from 0.1 to 100.")
            raise ValueError(sentence.format(rate=self.rate))

    @property
    def seconds(self) -> float:
        """How long each is seen."""
        return 1.0 / self._rate

    @property
    def rests(self) -> bool:
        """Whether the last one stays longer: what moves round does not."""
        return False

    @property
    def _rate(self) -> float:
        return self.rate or min(motion_of(self.sheet).rate, 100.0)

    @property
    def parts(self) -> int:
        """How many pictures there are."""
        motion = motion_of(self.sheet)
        return max(math.floor(motion.frames * self._rate / motion.rate + 1e-9), 1)

    def frame(self, number: int) -> int:
        """The frame of the sheet that picture ``number`` shows."""
        motion = motion_of(self.sheet)
        return min(math.floor(number * motion.rate / self._rate + 1e-9), motion.frames - 1)

    def image(self, number: int) -> Picture:
        """Picture ``number``, from 0, (h, w, 3), the top row first."""
        seen = at(self.sheet, self.frame(number))
        ground = seen.palette[seen.background]
        return _sized(with_scene(frame_buffer(seen), seen), self.size, ground)


def _sized(image: NDArray[np.uint32], size: Size | None, ground: int) -> Picture:
    """A picture with every pixel as it is, only larger or smaller, in the middle of its ground."""
    packed = top_row_first(image)
    if size is not None:
        height, width = packed.shape
        scale = min(size.width / width, size.height / height)
        wide, high = max(round(width * scale), 1), max(round(height * scale), 1)
        larger = packed[np.arange(high) * height // high][:, np.arange(wide) * width // wide]
        packed = np.full((size.height, size.width), ground, np.uint32)
        left, top = (size.width - wide) // 2, (size.height - high) // 2
        packed[top : top + high, left : left + wide] = larger
    return np.stack([packed >> 16 & 255, packed >> 8 & 255, packed & 255], axis=-1).astype(np.uint8)


def contact_sheet(frames: MovingSheet, put: Put, told: Progress) -> None:
    """At most 24 frames in rows, evenly spread from the first to the last, as one PNG."""
    import io

    from PIL import Image

    count = min(frames.parts, _CONTACTS)
    numbers = [round(place * (frames.parts - 1) / max(count - 1, 1)) for place in range(count)]
    columns = math.ceil(math.sqrt(count))
    first = frames.image(0)
    height, width = first.shape[0] + _GAP_PX, first.shape[1] + _GAP_PX
    whole = np.full((math.ceil(count / columns) * height, columns * width, 3), _PAPER, np.uint8)
    for place, number in enumerate(numbers):
        told(place, count)
        y, x = place // columns * height, place % columns * width
        whole[y : y + first.shape[0], x : x + first.shape[1]] = frames.image(number)
    file = io.BytesIO()
    Image.fromarray(whole).save(file, "PNG")
    put(file.getvalue())
