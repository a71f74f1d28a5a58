"""What two algorithms do with the same input: calls, counted work and painted pixels of each, as values."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import (
    AnyFigure,
    Curve,
    Line,
    Polygon,
    Polyline,
    SeedFill,
    Sheet,
)
from workbench.document.sheet_edits import with_clipper
from workbench.engine.compiled import Stop
from workbench.engine.counts import counts
from workbench.engine.pending import largest
from workbench.engine.recording import Recording
from workbench.language import _
from workbench.rendering.clipping import clipper_calls, clipper_of, clippers_of
from workbench.rendering.compare import compare, figure_pixels
from workbench.rendering.mapping import Call
from workbench.rendering.outline_fill import outline_fill
from workbench.rendering.raster import emitted, figure_calls, pixels
from workbench.widgets.canvas.overlay import compare_classes

Cells = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One algorithm and its calls; ``before`` are pixels that are painted before it can begin."""

    slug: str
    calls: tuple[Call, ...]
    before: Cells | None = None

    @property
    def title(self) -> str:
        """What the algorithm is called."""
        return _(catalogue.get(self.slug).title)


@dataclass(frozen=True, slots=True, eq=False)
class Job:
    """What is to be compared: ``figures`` under ``first`` and, unless there is none, ``second``.

    ``recordings`` are those of the two stepped runs, from which the largest stack is read.
    """

    sheet: Sheet
    figures: tuple[AnyFigure, ...]
    clipping: bool
    first: str
    second: str = ""
    recordings: tuple[Recording | None, Recording | None] = (None, None)


@dataclass(slots=True)
class Work:
    """What one side did; ``counted`` is what its entry names beside, ``deepest`` is its largest stack, and
    ``stopped`` says why it is not all.
    """

    title: str
    calls: int = 0
    tests: int = 0
    additions: int = 0
    multiplications: int = 0
    divisions: int = 0
    counted: dict[str, int] = field(default_factory=dict)
    emitted: int = 0
    writes: int | None = None
    before: int | None = None
    deepest: str = ""
    stopped: str = ""
    cells: Cells = field(default_factory=lambda: np.empty((0, 2), np.int64))


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What a job found; ``classes`` is the difference picture, ``ties`` how many differences are ties."""

    job: Job
    first: Work
    second: Work | None
    classes: NDArray[np.uint8] | None = None
    both: int = 0
    only_first: int = 0
    only_second: int = 0
    ties: int = 0


def choices(sheet: Sheet, figure: AnyFigure | None, clipping: bool) -> tuple[str, tuple[str, ...]]:
    """The slug of the algorithm at work on a figure, and those that it can be compared with."""
    if figure is None:
        return "", ()
    if clipping:
        now = clipper_of(sheet, figure)
        return now, tuple(slug for slug in clippers_of(figure) if slug != now)
    known = {entry.slug for entry in catalogue.entries()}
    others = list(figure.algorithms)
    if isinstance(figure, Polygon):
        others += SeedFill.algorithms
    return figure.drawn_with, tuple(slug for slug in others if slug in known and slug != figure.drawn_with)


def figures_compared(
    sheet: Sheet, figure: AnyFigure, clipping: bool, first: str, whole: bool
) -> tuple[AnyFigure, ...]:
    """The figure, or with ``whole`` every visible figure of the sheet that the same algorithm works on."""
    if not whole:
        return (figure,)
    if clipping:
        return tuple(f for f in sheet.figures if f.visible and clipper_of(sheet, f) == first)
    return tuple(f for f in sheet.figures if f.visible and type(f) is type(figure))


def side_of(job: Job, slug: str) -> Side:
    """The calls of one side of a job."""
    made: list[Call] = []
    before: list[Cells] = []
    for figure in job.figures:
        if job.clipping:
            made += clipper_calls(job.sheet, figure, slug)
        elif isinstance(figure, Polygon) and slug in SeedFill.algorithms:
            filled = outline_fill(job.sheet, figure, slug)
            before.append(filled.outline)
            made += [filled.call] if filled.call is not None else []
        else:
            made += figure_calls(job.sheet, figure, slug)
    return Side(slug, tuple(made), np.concatenate(before) if before else None)


def work_of(side: Side, stop: Stop) -> Work:
    """Count what a side does; a span written at a stroke counts all its pixels. Raises Stopped."""
    work = Work(side.title, before=None if side.before is None else len(side.before))
    for call in side.calls:
        try:
            counted = counts(call.entry.function, *call.arguments, stop=stop, compiling=False)
        except RecursionError:
            work.stopped = _("The recursion went too deep to be counted.")
            continue
        work.calls += 1
        work.tests += counted.tests
        work.additions += counted.additions
        work.multiplications += counted.multiplications
        work.divisions += counted.divisions
        work.emitted += counted.emitted
        for label, titles in call.entry.counted.items():
            visits = (times for title, times in counted.block_visits.items() if title.startswith(titles))
            work.counted[label] = work.counted.get(label, 0) + sum(visits)
        if call.entry.writes:
            spans = call.entry.emits == "spans"
            written = len(pixels(call.entry, emitted(call))) if spans else counted.writes
            work.writes = (work.writes or 0) + written
    return work


def deepest_of(slug: str, recording: Recording | None) -> str:
    """The largest stack of a recorded run, or how many calls nested; empty for texts without either."""
    entry = catalogue.get(slug)
    if recording is None or not entry.stack:
        return ""
    most = largest(entry, recording)
    return str(most) if recording.complete else _("at least {n}").format(n=most)


def outcome_of(job: Job, stop: Stop) -> Outcome:
    """Do a job. Raises Stopped."""
    first = work_of(side_of(job, job.first), stop)
    first.deepest = deepest_of(job.first, job.recordings[0])
    if not job.second:
        return Outcome(job, first, None)
    second = work_of(side_of(job, job.second), stop)
    second.deepest = deepest_of(job.second, job.recordings[1])
    sets = [_painted(job, slug) for slug in (job.first, job.second)]
    first.cells, second.cells = sets
    tied = _ties(job)
    size = job.sheet.width_px, job.sheet.height_px
    classes = compare_classes(size, sets[0], sets[1], tied)
    counted = np.bincount(classes.ravel(), minlength=6).tolist()
    return Outcome(
        job, first, second, classes, counted[3], counted[1], counted[2], max(counted[4], counted[5])
    )


def _painted(job: Job, slug: str) -> Cells:
    """The pixels of the figures under one side."""
    found: list[Cells] = []
    sheet = with_clipper(job.sheet, slug) if job.clipping else job.sheet
    for figure in job.figures:
        if job.clipping:
            found.append(figure_pixels(sheet, figure))
        elif isinstance(figure, Polygon) and slug in SeedFill.algorithms:
            filled = outline_fill(sheet, figure, slug)
            found.append(filled.outline)
            if filled.call is not None:
                found.append(pixels(filled.call.entry, emitted(filled.call)))
        else:
            found.append(figure_pixels(sheet, figure, slug))
    return np.concatenate(found) if found else np.empty((0, 2), np.int64)


def _ties(job: Job) -> Cells | None:
    if job.clipping or not all(isinstance(figure, Line | Polyline | Curve) for figure in job.figures):
        return None
    found = [compare(job.sheet, figure, job.first, job.second) for figure in job.figures]
    tied = [cells for each in found for cells in (each.tied_first, each.tied_second)]
    return np.concatenate(tied) if tied else None


ComparedCount = tuple[str, Any, Any]


def _counted(label: str, work: Work) -> int | None:
    return work.counted.get(label)


def table_rows(outcome: Outcome) -> list[ComparedCount]:
    """Label and the number of each side; rows in which neither did anything are left out."""
    first, second = outcome.first, outcome.second
    emits = catalogue.get(outcome.job.first).emits
    what = {"segments": _("Lines kept"), "points": _("Points handed on"), "spans": _("Spans")}
    clips = outcome.job.clipping
    labels = dict.fromkeys(label for work in (first, second) if work is not None for label in work.counted)
    readers: list[tuple[str, Callable[[Work], Any]]] = [
        *((_(label), partial(_counted, label)) for label in labels),
        (_("Tests"), lambda work: work.tests),
        (_("Additions"), lambda work: work.additions),
        (_("Multiplications"), lambda work: work.multiplications),
        (_("Divisions"), lambda work: work.divisions),
        (_("Writes"), lambda work: work.writes),
        (what.get(emits, ""), lambda work: work.emitted if emits in what else None),
        (_("Pixels"), lambda work: None if clips or second is None else len(work.cells)),
        (_("Outline first"), lambda work: work.before),
        (_("Runs"), lambda work: work.calls if work.calls > 1 else None),
    ]
    kept = {_("Tests"), _("Additions"), _("Multiplications"), _("Divisions")}
    kept |= {_(label) for label in labels}
    rows: list[ComparedCount] = []
    for label, read in readers:
        values = read(first), read(second) if second is not None else None
        if any(values) or label in kept:
            rows.append((label, *values))
    if first.deepest or (second is not None and second.deepest):
        rows.append((_("Largest stack"), first.deepest, second.deepest if second is not None else ""))
    if second is not None and outcome.classes is not None:
        rows.append((_("Only this one"), outcome.only_first, outcome.only_second))
        rows.append((_("Both alike"), outcome.both, outcome.both))
        if outcome.ties:
            rows.append((_("Ties"), outcome.ties, outcome.ties))
    return rows
