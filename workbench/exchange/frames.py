"""Pictures that follow one another, as numbered PNG files or as one GIF that moves."""

import io
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from workbench.exchange.writing import Progress, Put
from workbench.language import _

if TYPE_CHECKING:
    from PIL import Image

Picture = NDArray[np.uint8]

_MOST_COLOURS = 256
_MOST_PIXELS = 300_000_000  # of all pictures together: so many bytes are held while a GIF is made


class Frames(Protocol):
    """``parts`` pictures, (h, w, 3) each, the top row first; each is seen for ``seconds`` in a GIF.

    Where it ``rests`` the last one stays three times as long.
    """

    @property
    def parts(self) -> int: ...

    @property
    def seconds(self) -> float: ...

    @property
    def rests(self) -> bool: ...

    def image(self, number: int) -> Picture:
        """Picture ``number``, from 0."""
        ...


def one_png(frames: Frames, put: Put, _told: Progress) -> None:
    """The first picture as a PNG."""
    put(_png(frames.image(0)))


def each_png(frames: Frames, put: Put, told: Progress) -> None:
    """Every picture as a PNG of its own."""
    for number in range(frames.parts):
        told(number, frames.parts)
        put(_png(frames.image(number)))


def animation(frames: Frames, put: Put, told: Progress) -> None:
    """One GIF of all pictures, which begins anew when it has ended.

    A GIF counts hundredths of a second: of 24 pictures a second some are seen for 4 and some for 5.
    """

    def told_of_each() -> "Iterator[Image.Image]":
        for number in range(frames.parts):
            told(number, frames.parts)
            yield indexed(frames.image(number))

    images = told_of_each()
    first = next(images)
    if first.width * first.height * frames.parts > _MOST_PIXELS:
        sentence = _("A GIF of {parts} pictures {width} pixels wide is too large; choose a smaller size.")
        raise ValueError(sentence.format(parts=frames.parts, width=first.width))
    file = _Telling(lambda: told(frames.parts, frames.parts))
    first.save(
        file,
        "GIF",
        save_all=True,
        append_images=images,
        duration=delays_ms(frames),
        loop=0,
        optimize=False,
    )
    put(file.getvalue())


def delays_ms(frames: Frames) -> list[int]:
    """How long each picture of a GIF is seen, in whole hundredths that add up to the time of all."""
    ends = [round(100 * frames.seconds * number) for number in range(frames.parts + 1)]
    delays = [max(end - start, 2) * 10 for start, end in pairwise(ends)]
    return [*delays[:-1], 3 * delays[-1]] if frames.rests else delays


def indexed(picture: Picture) -> "Image.Image":
    """``picture`` in at most 256 colours: the most frequent exactly, any other as the nearest of them."""
    from PIL import Image

    red, green, blue = (picture[..., channel].astype(np.uint32) for channel in range(3))
    pixels = (red << 16 | green << 8 | blue).ravel()
    starts = np.flatnonzero(np.diff(pixels, prepend=~pixels[:1]))  # of runs of one colour, which are few
    lengths = np.diff(starts, append=len(pixels))
    colours, inverse = np.unique(pixels[starts], return_inverse=True)
    order = np.argsort(-np.bincount(inverse, lengths), kind="stable")
    rgb = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=-1).astype(np.int32)
    palette = rgb[order[:_MOST_COLOURS]]
    place = np.empty(len(colours), np.uint8)
    place[order[:_MOST_COLOURS]] = np.arange(len(palette))
    for rare in order[_MOST_COLOURS:]:
        place[rare] = np.argmin(((palette - rgb[rare]) ** 2).sum(axis=1))
    image = Image.fromarray(np.repeat(place[inverse], lengths).reshape(picture.shape[:2]), "P")
    image.putpalette(palette.astype(np.uint8).tobytes())
    return image


class _Telling(io.BytesIO):
    """A file in memory that calls ``tell`` whenever something is written into it."""

    def __init__(self, tell: Callable[[], object]) -> None:
        super().__init__()
        self._tell = tell

    def write(self, data: Any) -> int:
        self._tell()
        return super().write(data)


def _png(picture: Picture) -> bytes:
    from PIL import Image

    file = io.BytesIO()
    Image.fromarray(picture).save(file, "PNG")
    return file.getvalue()
