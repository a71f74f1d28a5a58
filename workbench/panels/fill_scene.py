"""What the Fill canvas draws: a scan line with its crossings, a stack, a ray, how often was tested."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import Polygon, Sheet
from workbench.engine.observation import Steps
from workbench.engine.pending import keeps_stack, pending, read
from workbench.engine.recorder import record
from workbench.engine.recording import Recording
from workbench.panels.figure_picture import Pixels, packed
from workbench.rendering import figure_calls
from workbench.session.run import Run
from workbench.widgets.canvas_drawing import Drawn, Spot, Stroke, Word
from workbench.widgets.tokens import Tokens

MOST_SPOTS = 600
MOST_WORDS = 24
_SCAN_LINE = "scan_line_fill"
_ROWS = ("row", "y")


def event_of(run: Run) -> int | None:
    """The line event whose state is drawn: in detail the present one, else the last of the step."""
    step, recording = run.step, run.recording
    if step is None or recording is None or not len(recording):
        return None
    if run.detail:
        return min(run.position, len(recording) - 1)
    return max(min(step.last, len(recording) - 1), 0)


def scan_line(run: Run, width_px: int) -> list[Drawn]:
    """The present row, where the active edges cross it, and the spans filled on it so far."""
    recording, crossed = run.recording, _crossed(run)
    if recording is None or crossed is None:
        return []
    y, crossings = crossed
    reach = np.array([(-0.5, y), (width_px - 0.5, y)], np.float64)
    drawn: list[Drawn] = [Stroke(reach, "accent", 1.5, "dash")]
    rows = recording.emitted.array(0, _emitted_to(run))
    for row in rows[-64:]:
        if row[0] == y:
            span = np.array([(row[1], y), (row[2], y)], np.float64)
            drawn.append(Stroke(span, "accent", 4.0, haloed=True))
    named = len(crossings) <= MOST_WORDS
    for number, x in enumerate(crossings, 1):
        drawn.append(Spot(x, y, "data 2", "ring", 10))
        if named:
            close = any(0 < abs(other - x) < 1.5 for other in crossings[: number - 1])
            drawn.append(Word(f"{x:.4g}", x, y, "text", 0, -1 if close else 1, carded=True))
    return drawn


def _crossed(run: Run) -> tuple[float, list[float]] | None:
    """The present row and where it is crossed, as it was before the first step of the row moved anything."""
    step, steps, recording = run.step, run.steps, run.recording
    if step is None or steps is None or recording is None or step.number == 0:
        return None
    found = _row_at(recording, step.first)
    for number in range(step.number - 1, max(step.number - MOST_WORDS, 0), -1):
        before = _row_at(recording, steps.span(number)[0])
        if found is None or before is None or before[0] != found[0]:
            break
        found = before
    return found


def _row_at(recording: Recording, event: int) -> tuple[float, list[float]] | None:
    """The row that the text is on at an event, and where its active edges cross it."""
    for name in _ROWS:
        found = read(recording, event, ("active", name))
        if found is not None:
            return float(found[name]), sorted(float(edge.x) for edge in found["active"])
    return None


def _emitted_to(run: Run) -> int:
    step, moment = run.step, run.moment
    if run.detail and moment is not None:
        return len(moment.emitted)
    return 0 if step is None else step.emitted_to


def stack(run: Run, cell_px: float) -> list[Drawn]:
    """What is still to be done: the pixels on the stack, or those of the calls under way, the top ringed."""
    event, recording, entry = event_of(run), run.recording, run.entry
    if event is None or recording is None or entry is None:
        return []
    spans = entry.emits == "spans"
    waiting = pending(recording, event, spans)
    if spans:
        rows = [np.array([(row[1], row[0]), (row[2], row[0])], np.float64) for row in waiting[-MOST_SPOTS:]]
        return [Stroke(row, "data 5", 3.0, "dot", haloed=True) for row in rows]
    if not waiting:
        return []
    x, y = waiting[-1]
    if not keeps_stack(recording) and len(waiting) > 1:
        path = np.array(waiting, np.float64)
        return [Stroke(path, "text", min(3.0, cell_px / 3), haloed=True), Spot(x, y, "text", "ring", 13)]
    size = max(2.0, min(6.0, cell_px / 2))
    spots: list[Drawn] = [Spot(x, y, "text", "dot", size) for x, y in waiting[-MOST_SPOTS:]]
    return [*spots, Spot(x, y, "text", "ring", 13)]


def construction(run: Run, width_px: int, cell_px: float) -> tuple[Drawn, ...]:
    """What is drawn of the run's own structures; a cell is ``cell_px`` logical pixels wide."""
    entry = run.entry
    if entry is None:
        return ()
    if entry.slug == _SCAN_LINE:
        return tuple(scan_line(run, width_px))
    return tuple(stack(run, cell_px)) if entry.topic == "seed_fill" else ()


def heated(shown: Pixels, counts: NDArray[np.int64], now: Tokens) -> Pixels:
    """``shown`` with the tested pixels coloured by how often, from pale to full."""
    most = int(counts.max())
    if most == 0:
        return shown
    share = np.where(counts > 0, 0.2 + 0.8 * counts / most, 0.0)
    low, high = packed(now.canvas), packed(now.data[1])
    made = shown.copy()
    tested = counts > 0
    mixed = np.zeros(int(tested.sum()), np.uint32)
    for shift in (16, 8, 0):
        a, b = (low >> shift) & 0xFF, (high >> shift) & 0xFF
        mixed |= (a + share[tested] * (b - a)).astype(np.uint32) << np.uint32(shift)
    made[tested] = mixed
    return made


def heat_words(counts: NDArray[np.int64]) -> tuple[Drawn, ...]:
    """The numbers in the cells; none where there are too many to be read."""
    ys, xs = np.nonzero(counts)
    if len(xs) > MOST_SPOTS:
        return ()
    return tuple(Word(str(counts[y, x]), float(x), float(y), "text") for y, x in zip(ys, xs, strict=True))


@dataclass(frozen=True, slots=True, eq=False)
class Verdict:
    """One point asked about: the crossings of its ray (x, direction), and the text's own sentence."""

    x: float
    y: float
    crossings: tuple[tuple[float, int], ...]
    sentence: str


def verdict(sheet: Sheet, polygon: Polygon, x: float, y: float) -> Verdict | None:
    """Whether a device point is inside ``polygon``, as the inside-outside test says; None without corners."""
    calls = figure_calls(sheet, polygon)
    if not calls:
        return None
    entry = catalogue.get("inside_outside")
    vertices, ring_ends = calls[0].arguments[:2]
    recording = record(entry.function, vertices, ring_ends, x, y, polygon.nonzero)
    steps = Steps(entry, recording)
    said = "".join(part.text for part in steps.told(len(recording)))
    crossings = sorted((float(row[0]), int(row[2])) for row in recording.emitted)
    return Verdict(x, y, tuple(crossings), said)


def ray(sheet: Sheet, found: Verdict) -> tuple[Drawn, ...]:
    """The point, its ray to the right, and the crossings, numbered, with an arrow for their direction."""
    far = max([sheet.width_px - 0.5, *(x + 1.0 for x, _direction in found.crossings)])
    line = np.array([(found.x, found.y), (far, found.y)], np.float64)
    drawn: list[Drawn] = [
        Stroke(line, "accent", 2.0, haloed=True),
        Spot(found.x, found.y, "accent", "dot", 10),
    ]
    drawn.append(
        Word(f"({_short(found.x)}, {_short(found.y)})", found.x, found.y, "text", -1, 1, carded=True)
    )
    for number, (x, direction) in enumerate(found.crossings[:MOST_WORDS], 1):
        drawn.append(Spot(x, found.y, "data 2", "ring", 11))
        arrow = "↑" if direction > 0 else "↓"
        above = 1 if number % 2 else -1
        drawn.append(Word(f"{number} {arrow}", x, found.y, "text", 0, above, carded=True))
    return tuple(drawn)


def _short(value: float) -> str:
    return f"{value:.4g}" if math.isfinite(value) else str(value)
