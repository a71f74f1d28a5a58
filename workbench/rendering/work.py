"""What two entries do with the same input: calls, counted work and painted pixels of each, as values."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import Sheet
from workbench.document.subjects import Subject
from workbench.engine.compiled import Stop
from workbench.engine.counts import counts
from workbench.engine.pending import largest
from workbench.engine.recording import Recording
from workbench.language import _
from workbench.rendering.comparing import (
    BOTH,
    ONLY_FIRST,
    ONLY_SECOND,
    TIE_FIRST,
    TIE_SECOND,
    Cells,
    compare_classes,
    in_common,
    is_line,
)
from workbench.rendering.mapping import Call
from workbench.rendering.raster import emitted, pixels
from workbench.rendering.subjects.registry import calls_of, comparing


class Part(NamedTuple):
    """A subject under an entry: its calls, the pixels (n, 2) painted, those ``before`` they can begin."""

    calls: Sequence[Call]
    painted: Cells
    before: Cells | None


@dataclass(frozen=True, slots=True, eq=False)
class Side:
    """One entry at work on some subjects."""

    slug: str
    parts: tuple[Part, ...]

    @property
    def title(self) -> str:
        """What the algorithm is called."""
        return _(catalogue.get(self.slug).title)

    @property
    def calls(self) -> list[Call]:
        """The calls on all of them."""
        return [call for part in self.parts for call in part.calls]

    @property
    def painted(self) -> Cells:
        """The pixels (n, 2) of all of them."""
        return _joined([part.painted for part in self.parts])


@dataclass(frozen=True, slots=True, eq=False)
class Job:
    """What is to be compared: ``subjects`` under ``first`` and, unless there is none, ``second``.

    ``recordings`` are those of the two stepped runs, from which the largest stack is read.
    """

    sheet: Sheet
    subjects: tuple[Subject, ...]
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


def side_of(job: Job, slug: str) -> Side:
    """One side of a job."""
    sheet = job.sheet
    under = [replace(subject, entry=slug) for subject in job.subjects]
    ways = [comparing(subject) for subject in under]
    return Side(
        slug,
        tuple(
            Part(calls_of(sheet, subject), way.painted(sheet, subject), way.before(sheet, subject))
            for subject, way in zip(under, ways, strict=True)
        ),
    )


def _joined(cells: Sequence[Cells]) -> Cells:
    return np.concatenate(cells) if cells else np.empty((0, 2), np.int64)


def work_of(side: Side, stop: Stop) -> Work:
    """Count what a side does; a span written at a stroke counts all its pixels. Raises Stopped."""
    before = [len(part.before) for part in side.parts if part.before is not None]
    work = Work(side.title, before=sum(before) if before else None, cells=side.painted)
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
        for label, each in call.entry.counted.items():
            visits = (times for title, times in counted.block_visits.items() if title.startswith(each.blocks))
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
    sides = [side_of(job, slug) for slug in (job.first, job.second) if slug]
    works = []
    for side, recording in zip(sides, job.recordings, strict=False):
        works.append(work_of(side, stop))
        works[-1].deepest = deepest_of(side.slug, recording)
    if not job.second:
        return Outcome(job, works[0], None)
    size = job.sheet.width_px, job.sheet.height_px
    classes = compare_classes(size, works[0].cells, works[1].cells, _ties(*sides))
    counted = np.bincount(classes.ravel(), minlength=TIE_SECOND + 1).tolist()
    return Outcome(
        job,
        works[0],
        works[1],
        classes,
        counted[BOTH],
        counted[ONLY_FIRST],
        counted[ONLY_SECOND],
        max(counted[TIE_FIRST], counted[TIE_SECOND]),
    )


def _ties(first: Side, second: Side) -> Cells:
    """The pixels (n, 2) that only one of two sides paints since a line passes half way between two."""
    common = [
        in_common(one.painted, other.painted, one.calls)
        for one, other in zip(first.parts, second.parts, strict=True)
        if any(map(is_line, one.calls))
    ]
    return _joined([cells for each in common for cells in (each.tied_first, each.tied_second)])
