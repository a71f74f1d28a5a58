"""Where frames lie on a timeline."""

from typing import NamedTuple

LABEL_PX = 200
RIGHT_PX = 16
ROW_PX = 24
RULER_PX = 24
MOST_PIXELS = 60.0


class Scale(NamedTuple):
    """``pixels`` wide is a frame; ``first`` is the one at the left edge, behind the labels."""

    pixels: float
    first: int

    def x(self, frame: float) -> float:
        """Where a frame is."""
        return LABEL_PX + 8 + (frame - self.first) * self.pixels

    def frame(self, x: float) -> int:
        """The frame nearest to x; it may be none that there is."""
        return round(self.first + (x - LABEL_PX - 8) / self.pixels)

    def last(self, width: float) -> int:
        """The last frame that is seen in so wide a timeline."""
        return int(self.frame(width) + 1)


def fitting(frames: int, width: float) -> Scale:
    """All frames in so wide a timeline."""
    room = max(width - LABEL_PX - 8 - RIGHT_PX, 40.0)
    return Scale(min(room / max(frames - 1, 1), MOST_PIXELS), 0)


def zoomed(scale: Scale, factor: float, about: int, frames: int, width: float) -> Scale:
    """A scale ``factor`` times as wide, in which a frame stays where it is, as far as that goes."""
    least = fitting(frames, width).pixels
    pixels = min(max(scale.pixels * factor, least), MOST_PIXELS)
    if pixels <= least:
        return fitting(frames, width)
    first = about - (about - scale.first) * scale.pixels / pixels
    return Scale(pixels, max(min(round(first), frames - 1), 0))
