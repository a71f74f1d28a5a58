"""Why is this pixel as it is, step by step: what wrote, tested or refused it, with the numbers that decided.

The steps are found by the reading that probes one pixel, or, for a text that is stepped only, in its
recording; what is said of them comes from replaying them, so that every number is the real one.
"""

from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np

from workbench.algorithms import catalogue
from workbench.document.model import AnyFigure, Polygon, Sheet
from workbench.engine.compiled import Stop
from workbench.engine.observation import Step, Steps
from workbench.engine.pending import PixelTests
from workbench.engine.recorder import LIMIT, Recorder
from workbench.engine.touches import StepTouch, touches
from workbench.language import _, ngettext
from workbench.rendering.inside import verdict
from workbench.rendering.mapping import Call
from workbench.rendering.raster import calls_in_views, emitted, painter_of, seen_bounds
from workbench.rendering.why_clipped import clipped_away

Verb = Literal["wrote", "tested", "refused"]
MOST = 200
_MOST_LOOKED_AT = 4000


class Answer(NamedTuple):
    """One thing that happened to the pixel.

    ``figure`` is the index on the sheet; ``step`` counts over all calls of the figure's algorithm, 0 is
    before the first. ``stands`` marks the one whose colour is seen.
    """

    figure: int
    figure_id: str
    step: int
    verb: Verb
    sentence: str
    stands: bool = False


class Abandoned(Exception):  # noqa: N818 - nothing is wrong
    """Nobody waits for the answer any more."""


def why_steps(sheet: Sheet, x: int, y: int, stopped: Callable[[], bool] = lambda: False) -> list[Answer]:
    """Everything that happened to device pixel (x, y), in the order of painting, at most ``MOST`` things.

    Takes as long as the runs of the figures near it: not for the thread of an interface. Raises Abandoned as
    soon as ``stopped()`` is true.
    """
    answers: list[Answer] = []
    for place, seen in enumerate(sheet.seen):
        for index, figure in enumerate(sheet.figures):
            x_first, x_last, y_first, y_last = seen_bounds(seen, figure)
            if figure.visible and x_first <= x <= x_last and y_first <= y <= y_last:
                answers += _of_figure(sheet, place, index, figure, x, y, stopped)
    inside = 0 <= x < sheet.width_px and 0 <= y < sheet.height_px
    painter = int(painter_of(sheet)[y, x]) if inside else -1
    for k in range(len(answers) - 1, -1, -1):
        if answers[k].verb == "wrote":
            if answers[k].figure == painter:
                answers[k] = answers[k]._replace(stands=True)
            break
    return answers[-MOST:]


def _of_figure(
    sheet: Sheet, view: int, index: int, figure: AnyFigure, x: int, y: int, stopped: Callable[[], bool]
) -> list[Answer]:
    """What happened to the pixel in the view of this number; steps are counted from those of the first."""
    answers: list[Answer] = []
    before = 0
    in_views = calls_in_views(sheet, figure)[: view + 1]
    earlier = sum(map(len, in_views[:-1]))
    calls = [call for calls_ in in_views for call in calls_]
    for number, call in enumerate(calls):
        if stopped():
            raise Abandoned
        last = number == len(calls) - 1
        near = number >= earlier and _near(call, x, y)
        if not near and last:
            break
        steps = _replayed(call, stopped)
        for touch in _touches(call, steps, x, y) if near else ():
            step = steps[touch.step] if touch.step <= len(steps) else None
            verb, sentence = _told(touch, step, (x, y))
            answers.append(Answer(index, figure.id, before + touch.step, verb, sentence))
        before += len(steps)
    return answers


def _near(call: Call, x: int, y: int) -> bool:
    """Whether the call can have come to the pixel: within two pixels of what it emitted."""
    rows = emitted(call)
    if not len(rows):
        return True
    if call.entry.emits == "spans":
        cells = np.concatenate([rows[:, [1, 0]], rows[:, [2, 0]]])
    else:
        cells = rows[:, :2]
    low, high = cells.min(axis=0) - 2, cells.max(axis=0) + 2
    return bool(low[0] <= x <= high[0] and low[1] <= y <= high[1])


def _replayed(call: Call, stopped: Callable[[], bool]) -> Steps:
    given = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in call.arguments)
    recorder = Recorder(call.entry.function, *given, limit=LIMIT, depth_limit=call.recursion_limit or None)
    recorder.start()
    while not recorder.join(0.02):
        if stopped():
            recorder.stop()
            raise Abandoned
    return Steps(call.entry, recorder.recording)


def _touches(call: Call, steps: Steps, x: int, y: int) -> list[StepTouch]:
    if not call.entry.compiles:
        function = call.entry.function
        found = list(touches(function, x, y, *call.arguments, compiling=False, stop=Stop()))
        wrote_in = {touch.step for touch in found if touch.emitted}
        found = [touch for touch in found if touch.emitted or touch.step not in wrote_in]
        if not found and not any(view.considers for view in call.entry.views):
            found = _lost(steps, (x, y))
        return found[-MOST:]
    found = []
    tested = PixelTests(steps)
    while tested.advance(1000):
        pass
    rows = emitted(call).reshape(-1, 2)
    hits = np.flatnonzero((rows == (x, y)).all(axis=1)).tolist()
    wrote = {steps.step_of(steps.recording.event_at(int(hit))): int(hit) for hit in hits}
    for step in sorted({*wrote, *tested.steps_at((x, y))}):
        found.append(StepTouch(step in wrote, wrote.get(step, 0), step))
    return found


def _lost(steps: Steps, cell: tuple[int, int]) -> list[StepTouch]:
    """The steps of which the pixel was a candidate that lost."""
    numbers = range(1, min(len(steps), _MOST_LOOKED_AT) + 1)
    return [StepTouch(False, 0, number) for number in numbers if cell in steps[number].rejected]


def _told(touch: StepTouch, step: Step | None, cell: tuple[int, int]) -> tuple[Verb, str]:
    if step is None:
        return (
            "wrote" if touch.emitted else "tested",
            _("Step {n} is too far along to be replayed.").format(n=touch.step),
        )
    verb: Verb = "wrote" if touch.emitted else "refused" if cell in step.rejected else "tested"
    return verb, "".join(part.text for part in step.sentence)


def nothing_happened(sheet: Sheet, x: int, y: int) -> str:
    """Why no figure touched a pixel: it was clipped away, is outside of a polygon, or none came near."""
    if clipped := clipped_away(sheet, x, y):
        return clipped
    said = []
    for figure in sheet.figures:
        if isinstance(figure, Polygon) and figure.visible:
            asked = verdict(sheet, figure, float(x), float(y))
            if asked is not None:
                said.append(f"{figure.name or _('Polygon')}: {asked.sentence}")
    if said:
        return "\n".join(said)
    nearest = _distance(sheet, x, y)
    if nearest is None:
        return _("No figure came near ({x}, {y}).").format(x=x, y=y)
    name, away = nearest
    text = ngettext(
        "No figure came near ({x}, {y}): the nearest one, {name}, passes {away} pixel away.",
        "No figure came near ({x}, {y}): the nearest one, {name}, passes {away} pixels away.",
        away,
    )
    return text.format(x=x, y=y, name=name, away=away)


def _called(figure: AnyFigure) -> str:
    return figure.name or _(catalogue.get(figure.drawn_with).title)


def _distance(sheet: Sheet, x: int, y: int) -> tuple[str, int] | None:
    """The figure that painted nearest to a pixel, and how many pixels away that is."""
    painter = painter_of(sheet)
    rows, columns = np.nonzero(painter >= 0)
    if not len(rows):
        return None
    away = np.maximum(np.abs(columns - x), np.abs(rows - y))
    nearest = int(np.argmin(away))
    figure = sheet.figures[int(painter[rows[nearest], columns[nearest]])]
    return _called(figure), int(away[nearest])
