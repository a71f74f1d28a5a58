"""Pictures that follow one another, as numbered PNG files or as one GIF that moves."""

import io
from collections.abc import Iterator
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from workbench.exchange.writing import Progress, Put

Picture = NDArray[np.uint8]

_MOST_COLOURS = 256


class Frames(Protocol):
    """``parts`` pictures, (h, w, 3) each, the top row first; each is seen for ``seconds`` in a GIF."""

    @property
    def parts(self) -> int: ...

    @property
    def seconds(self) -> float: ...

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
    """One GIF of all pictures, which begins anew when it has ended; its last picture stays three times as
    long. A GIF counts hundredths of a second.
    """

    def told_of_each() -> Iterator[Image.Image]:
        for number in range(frames.parts):
            told(number, frames.parts)
            yield indexed(frames.image(number))

    images = told_of_each()
    first = next(images)
    each = max(round(100 * frames.seconds), 2) * 10
    file = io.BytesIO()
    first.save(
        file,
        "GIF",
        save_all=True,
        append_images=images,
        duration=[each] * (frames.parts - 1) + [3 * each],
        loop=0,
        optimize=False,
    )
    put(file.getvalue())


def indexed(picture: Picture) -> Image.Image:
    """``picture`` in at most 256 colours: the most frequent exactly, any other as the nearest of them."""
    red, green, blue = (picture[..., channel].astype(np.uint32) for channel in range(3))
    colours, inverse, counts = np.unique(
        red << 16 | green << 8 | blue, return_inverse=True, return_counts=True
    )
    order = np.argsort(-counts, kind="stable")
    rgb = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=-1).astype(np.int32)
    palette = rgb[order[:_MOST_COLOURS]]
    place = np.empty(len(colours), np.uint8)
    place[order[:_MOST_COLOURS]] = np.arange(len(palette))
    for rare in order[_MOST_COLOURS:]:
        place[rare] = np.argmin(((palette - rgb[rare]) ** 2).sum(axis=1))
    image = Image.fromarray(place[inverse].reshape(picture.shape[:2]), "P")
    image.putpalette(palette.astype(np.uint8).tobytes())
    return image


def _png(picture: Picture) -> bytes:
    file = io.BytesIO()
    Image.fromarray(picture).save(file, "PNG")
    return file.getvalue()
