"""How many bits a frame buffer has for a pixel, and the colours that a table makes of them.

Colours are coded sRGB, 0xRRGGBB, as the picture has them; what is lost is measured in their channels.
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.language import _

DEPTHS = (1, 2, 4, 8, 24)
DIRECT = 24
"""With so many bits a pixel holds its colour itself, eight bits for each of three ramps."""

BLACK, WHITE = 0x000000, 0xFFFFFF
_MIDDLE = 3 * 255 / 2
_SIXTEEN = (
    0x000000, 0x0000AA, 0x00AA00, 0x00AAAA, 0xAA0000, 0xAA00AA, 0xAA5500, 0xAAAAAA,
    0x555555, 0x5555FF, 0x55FF55, 0x55FFFF, 0xFF5555, 0xFF55FF, 0xFFFF55, 0xFFFFFF,
)  # fmt: skip
_AT_ONCE = 1 << 14

Table = tuple[int, ...]
Colours = NDArray[np.integer[Any]]


def ramp(count: int, last: int = WHITE, first: int = BLACK) -> Table:
    """``count`` colours in equal steps from ``first`` to ``last``."""
    steps = np.linspace(channels_of(np.array([first]))[0], channels_of(np.array([last]))[0], max(count, 2))
    levels = np.floor(steps[:count] + 0.5).astype(np.int64)
    return tuple((levels @ (65536, 256, 1)).tolist())


def usual_table(bits: int, background: int = BLACK) -> Table:
    """What a table holds at first: the background and white (black on a bright one), four greys, 16 colours,
    or 8 x 8 x 4 levels.
    """
    if bits == 1:
        return background, WHITE if int(channels_of(np.array([background])).sum()) < _MIDDLE else BLACK
    if bits == 4:
        return _SIXTEEN
    if bits == 8:
        levels = [
            (r * 255 // 7, g * 255 // 7, b * 255 // 3) for r in range(8) for g in range(8) for b in range(4)
        ]
        return tuple((red << 16) + (green << 8) + blue for red, green, blue in levels)
    return () if bits >= DIRECT else ramp(1 << bits)


def table_fault(bits: int, table: Table) -> str:
    """What is wrong with a colour table, "" where nothing is."""
    if bits >= DIRECT:
        return ""
    if not table:
        return _("The colour table is empty, so every pixel would be black: load a ramp, or add a colour.")
    if len(table) == 1 << bits:
        return ""
    if len(table) > 1 << bits:
        said = _(
            "{bits} bits tell {most} entries apart, and the table has {count}: those beyond are left out."
        )
    else:
        said = _(
            "The colour table is too short: {bits} bits tell {most} entries apart, and it has {count}. Each "
            "pixel takes the nearest of those; load a ramp, or add colours."
        )
    return said.format(bits=bits, most=1 << bits, count=len(table))


def channels_of(colours: Colours) -> NDArray[np.int64]:
    """Red, green and blue (n, 3), 0 to 255, of colours (n,)."""
    wide = np.asarray(colours, np.int64)
    return np.stack([wide >> 16 & 255, wide >> 8 & 255, wide & 255], axis=-1)


class Loss(NamedTuple):
    """What a picture loses: its colours and those left, the pixels that change, the errors in levels of 255.

    ``largest`` is the greatest error of a channel, ``mean`` that of all channels of all pixels.
    """

    colours: int
    kept: int
    changed: int
    largest: int
    mean: float

    @property
    def lost(self) -> int:
        """Colours that are told apart no longer."""
        return self.colours - self.kept


@dataclass(frozen=True, slots=True, eq=False)
class FrameBuffer:
    """A picture as it is stored: ``bits`` (h, w), row 0 at the bottom; the table, and what that shows.

    ``shown`` is (h, w), 0xRRGGBB.
    """

    depth: int
    table: Table
    bits: NDArray[np.uint32]
    shown: NDArray[np.uint32]
    loss: Loss


def stored(image: NDArray[np.uint32], depth: int, table: Table, background: int | None = None) -> FrameBuffer:
    """``image`` (h, w), 0xRRGGBB, in a frame buffer of ``depth`` bits: each pixel gets the nearest entry.

    Nearest is by the sum of squared differences of the channels, of equals the first. Entries beyond
    2 ** depth are left out; an empty table shows black. One bit tells a ``background`` that is given from
    all else: with two entries the background gets the first, any other colour the second.
    """
    flat = image.ravel()
    begins = np.flatnonzero(np.concatenate(([True], flat[1:] != flat[:-1])))
    colours, which = np.unique(flat[begins] & 0xFFFFFF, return_inverse=True)
    entries = colours.astype(np.int64)
    made = entries
    if depth < DIRECT:
        kept = np.array(table[: 1 << depth] or (BLACK,), np.int64)
        tells_background = background is not None and depth == 1 and len(kept) > 1
        entries = (colours != background).astype(np.int64) if tells_background else _nearest(colours, kept)
        made = kept[entries]
    lengths = np.diff(np.append(begins, flat.size))
    bits = np.repeat(entries[which], lengths).astype(np.uint32).reshape(image.shape)
    shown = np.repeat(made[which], lengths).astype(np.uint32).reshape(image.shape)
    errors = np.abs(channels_of(colours) - channels_of(made))
    pixels = np.bincount(which, lengths, len(colours))
    return FrameBuffer(
        depth,
        table,
        bits,
        shown,
        Loss(
            len(colours),
            len(np.unique(made)),
            int(pixels[errors.any(axis=1)].sum()),
            int(errors.max()),
            float(pixels @ errors.mean(axis=1) / flat.size),
        ),
    )


def _nearest(colours: Colours, table: NDArray[np.int64]) -> NDArray[np.int64]:
    """The entry nearest to each colour (n,)."""
    entries = channels_of(table)
    found = np.empty(len(colours), np.int64)
    for first in range(0, len(colours), _AT_ONCE):
        some = channels_of(colours[first : first + _AT_ONCE])
        squares = (some * some).sum(axis=1)[:, None] - 2 * some @ entries.T + (entries * entries).sum(axis=1)
        found[first : first + _AT_ONCE] = squares.argmin(axis=1)
    return found


def most_frequent(image: NDArray[np.uint32], count: int) -> Table:
    """The colours of a picture that most pixels have, at most ``count``, the most frequent first."""
    colours, pixels = np.unique(image & 0xFFFFFF, return_counts=True)
    order = np.argsort(-pixels, kind="stable")[:count]
    return tuple(colours[order].tolist())
