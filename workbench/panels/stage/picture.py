"""What the canvas of the Draw panel shows: the sheet in the theme's colours, the run so far, a comparison."""

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.model import AnyFigure, Sheet
from workbench.rendering import frame_buffer, painter_of
from workbench.rendering.comparing import (
    ONLY_FIRST,
    ONLY_SECOND,
    TIE_FIRST,
    TIE_SECOND,
    Comparison,
    compare,
    compare_classes,
    figure_pixels,
)
from workbench.widgets.look.tokens import LIGHT, Tokens

Cells = NDArray[np.int64]
Pixels = NDArray[np.uint32]
_FAINT = 0.22
_PALE = 0.4


def packed(name: str) -> int:
    """A token as 0xRRGGBB."""
    return int(name.removeprefix("#"), 16)


def data_colours(now: Tokens) -> dict[int, int]:
    """The data colours as documents name them, 0xRRGGBB, and what each of them is in the theme."""
    return {packed(light): packed(shown) for light, shown in zip(LIGHT.data, now.data, strict=True)}


def themed(sheet: Sheet, now: Tokens) -> Sheet:
    """The sheet with the theme's canvas for paper, and the theme's data colours in its present ones."""
    changed = data_colours(now)
    palette = [changed.get(colour, colour) for colour in sheet.palette]
    palette[sheet.background % len(palette)] = packed(now.canvas)
    return replace(sheet, palette=tuple(palette))


def picture(sheet: Sheet, now: Tokens) -> Pixels:
    """The whole picture (h, w), 0xRRGGBB, in the colours of the theme."""
    return frame_buffer(themed(sheet, now))


def painters(sheet: Sheet, now: Tokens) -> NDArray[np.int32]:
    """Of ``picture``, for each pixel (h, w) the index of the figure that painted it, -1 where none did."""
    return painter_of(themed(sheet, now))


def pale_picture(sheet: Sheet, now: Tokens) -> Pixels:
    """The whole picture in pale colours, for what is drawn over it."""
    shown = themed(sheet, now)
    paper = packed(now.canvas)
    palette = tuple(
        sum(
            round(((paper >> shift) & 0xFF) * (1 - _PALE) + ((colour >> shift) & 0xFF) * _PALE) << shift
            for shift in (16, 8, 0)
        )
        for colour in shown.palette
    )
    return frame_buffer(replace(shown, palette=palette))


def with_faint(
    shown: Pixels, sheet: Sheet, figure: AnyFigure, reached: Cells, now: Tokens, hidden: bool = False
) -> Pixels:
    """``shown`` with what the run of ``figure`` has not yet painted pale, or hidden."""
    if figure not in sheet.figures:
        return shown
    waiting = painters(sheet, now) == sheet.figures.index(figure)
    inside = reached[
        (reached[:, 0] >= 0)
        & (reached[:, 0] < sheet.width_px)
        & (reached[:, 1] >= 0)
        & (reached[:, 1] < sheet.height_px)
    ]
    waiting[inside[:, 1], inside[:, 0]] = False
    paper, share = packed(now.canvas), 0.0 if hidden else _FAINT
    mixed = np.zeros(int(waiting.sum()), np.uint32)
    for shift in (16, 8, 0):
        own = (shown[waiting] >> np.uint32(shift)) & np.uint32(0xFF)
        ground = (paper >> shift) & 0xFF
        mixed |= (ground + share * (own.astype(float) - ground)).astype(np.uint32) << np.uint32(shift)
    shown[waiting] = mixed
    return shown


def without(sheet: Sheet, figure: AnyFigure) -> Sheet:
    """The sheet with ``figure`` made invisible: a comparison is painted in its place."""
    hidden = tuple(replace(f, visible=False) if f.id == figure.id else f for f in sheet.figures)
    return replace(sheet, figures=hidden)


def comparison_classes(
    sheet: Sheet, figure: AnyFigure, second: str, reached: tuple[Cells, Cells] | None = None
) -> tuple[Comparison, NDArray[np.uint8]]:
    """The comparison of the figure's own algorithm with another, and its classes for the canvas.

    ``reached`` restricts the classes to what two runs have painted so far.
    """
    result = compare(sheet, figure, figure.drawn_with, second)
    first, other = reached or (
        np.concatenate([result.both, result.only_first, result.tied_first]),
        np.concatenate([result.both, result.only_second, result.tied_second]),
    )
    ties = np.concatenate([result.tied_first, result.tied_second])
    return result, compare_classes((sheet.width_px, sheet.height_px), first, other, ties)


def sides(classes: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """The classes as two pictures side by side: what the first painted, and what the second did."""
    first = np.where(np.isin(classes, (ONLY_SECOND, TIE_SECOND)), 0, classes).astype(np.uint8)
    second = np.where(np.isin(classes, (ONLY_FIRST, TIE_FIRST)), 0, classes).astype(np.uint8)
    return first, second


def pixel_rows(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> list[tuple[int, int, int]]:
    """(k, x, y) of every painted pixel, in order, as a table of numbers."""
    cells = figure_pixels(sheet, figure, algorithm)
    return [(k, int(x), int(y)) for k, (x, y) in enumerate(cells.tolist())]
