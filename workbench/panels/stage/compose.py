"""What the canvas shows of a sheet, a run and a comparison, as values, for screen and paper alike."""

from dataclasses import dataclass, replace
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Ink, Word
from workbench.document.model import AnyFigure, Sheet
from workbench.language import _
from workbench.panels.stage.outline import handles, outlines
from workbench.panels.stage.picture import (
    Cells,
    Pixels,
    comparison_classes,
    packed,
    picture,
    sides,
    with_faint,
    without,
)
from workbench.rendering.comparing import Comparison
from workbench.rendering.raster import pixels
from workbench.session.asking import Answer
from workbench.session.run import Run
from workbench.widgets.canvas.drawing import PenStroke
from workbench.widgets.canvas.overlay import Cell, Overlay
from workbench.widgets.look.tokens import Tokens

_MOST_POINTS = 2000  # of several figures; more of them cover the picture, and take longer than a frame


@dataclass(frozen=True, slots=True, eq=False)
class Progress:
    """How far the run of a figure has come: what it painted (n, 2), and the choice it is at.

    ``second`` is what the run of the compared algorithm painted; ``hidden`` keeps what comes next to itself.
    """

    reached: Cells
    candidates: tuple[Cell, ...] = ()
    rejected: tuple[Cell, ...] = ()
    current: tuple[Cell, ...] = ()
    second: Cells | None = None
    hidden: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Composition:
    """The picture (h, w), its background colour, its marks, and those of a second picture beside it."""

    pixels: Pixels
    background: int
    overlay: Overlay
    comparison: Comparison | None = None
    beside: Overlay | None = None


def progress_at(run: Run, number: int) -> Progress | None:
    """The run at one of its steps, recorded so far; None without one."""
    if run.steps is None or number > len(run.steps):
        return None
    step = run.steps[number]
    return Progress(
        painted(run, step.emitted_to), run.steps.candidates_next(number), step.rejected, step.chosen
    )


def painted(run: Run, count: int) -> Cells:
    """The pixels (n, 2) of the first ``count`` rows that the run emitted, spans spread out."""
    if run.recording is None or run.entry is None or count == 0:
        return np.empty((0, 2), np.int64)
    if run.entry.emits in ("points", "segments", "cells", "cubes"):
        return np.empty((0, 2), np.int64)
    width, height = run.image_size
    return pixels(run.entry, run.recording.emitted.array(0, count), (0, width - 1, 0, height - 1))


def compose(
    sheet: Sheet,
    active: AnyFigure | None,
    progress: Progress | None,
    compared: str,
    now: Tokens,
    side_by_side: bool = False,
    outlined: bool = True,
) -> Composition:
    """The sheet with the run of ``active`` at ``progress``; ``compared`` names a second algorithm.

    ``outlined``: with the ideal lines of all figures.
    """
    background = packed(now.canvas)
    seen = [figure for figure in sheet.figures if figure.visible and outlined]
    overlay = Overlay(ideal=tuple(chain.from_iterable(outlines(sheet, seen))))
    if progress is not None:
        overlay = replace(
            overlay, candidates=progress.candidates, rejected=progress.rejected, current=progress.current
        )
    if active is None or not compared:
        shown = picture(sheet, now)
        if progress is not None and active is not None:
            shown = with_faint(shown, sheet, active, progress.reached, now, hidden=progress.hidden)
        return Composition(shown, background, overlay)
    reached = None
    if progress is not None and progress.second is not None:
        reached = progress.reached, progress.second
    comparison, classes = comparison_classes(sheet, active, compared, reached)
    shown = picture(without(sheet, active), now)
    if not side_by_side:
        return Composition(shown, background, replace(overlay, classes=classes), comparison)
    first, second = sides(classes)
    return Composition(
        shown,
        background,
        replace(overlay, classes=first, drawn=(_name(sheet, active.drawn_with, "data1"),)),
        comparison,
        Overlay(ideal=overlay.ideal, classes=second, drawn=(_name(sheet, compared, "data2"),)),
    )


def _name(sheet: Sheet, slug: str, ink: Ink) -> Word:
    """Which algorithm one of two pictures is by, along its upper edge."""
    title = _(catalogue.get(slug).title)
    return Word(title, sheet.width_px / 2 - 0.5, sheet.height_px - 0.5, ink, 0, -1, carded=True, strong=True)


def with_selection(overlay: Overlay, sheet: Sheet, selected: list[AnyFigure], held: str) -> Overlay:
    """The marks with outlines of what is selected, and with its handles where these are not too many."""
    points = sum(len(figure.points_world) for figure in selected)
    held_by = selected if len(selected) == 1 or points <= _MOST_POINTS else []
    return replace(
        overlay,
        outlined=tuple(chain.from_iterable(outlines(sheet, selected))),
        handles=tuple(handle for figure in held_by for handle in handles(sheet, figure, held)),
    )


def with_band(overlay: Overlay, band: NDArray[np.float64] | None) -> Overlay:
    """The marks with the band of a selection under way."""
    return overlay if band is None else replace(overlay, outlined=(*overlay.outlined, band))


def with_answer(overlay: Overlay, answered: Answer | None) -> Overlay:
    """The marks with the pixel that was said to come next, ticked or struck out."""
    if answered is None or answered.cell is None or answered.verdict == "far":
        return overlay
    if answered.verdict == "right":
        return replace(overlay, right=(answered.cell,))
    x, y = answered.cell
    word = Word(_("Not this one"), x + 0.5, y + 0.5, "error", 1, 1, carded=True)
    return replace(overlay, wrong=(answered.cell,), drawn=(*overlay.drawn, word))


def with_asked(overlay: Overlay, cell: Cell | None) -> Overlay:
    """The marks with a frame round the pixel that is asked about."""
    if cell is None:
        return overlay
    x, y = cell
    corners = [
        (x - 0.5, y - 0.5),
        (x + 0.5, y - 0.5),
        (x + 0.5, y + 0.5),
        (x - 0.5, y + 0.5),
        (x - 0.5, y - 0.5),
    ]
    frame = PenStroke(np.array(corners, np.float64), "accent", 2.0, haloed=True)
    question = Word("?", x + 0.5, y + 0.5, "accent", 1, 1, carded=True, strong=True)
    return replace(overlay, drawn=(*overlay.drawn, frame, question))
