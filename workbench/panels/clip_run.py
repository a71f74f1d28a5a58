"""What the Clip canvas draws of the stepped run: the edge it is at, what is left, and where it was cut."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP
from workbench.engine.recording import Recording
from workbench.panels.clip_scene import PATTERNS, Fate, closed, code_text, degenerate_marks, window_corners
from workbench.rendering.mapping import Box
from workbench.session.run import Run
from workbench.widgets.canvas_drawing import Drawn, Region, Spot, Stroke, Word

_BY_NUMBER = (LEFT, RIGHT, BOTTOM, TOP)


class ClipMoment(NamedTuple):
    """Where a clipper is: its arguments in this call, of which it is the ``call``-th, its variables."""

    slug: str
    arguments: tuple[Any, ...]
    variables: dict[str, Any]
    call: int
    ended: bool


def clip_moment(run: Run, number: int | None = None) -> ClipMoment | None:
    """The clipper's own call under way at the cursor, or at the end of a step; None for other runs."""
    recording, steps, step = run.recording, run.steps, run.step
    if run.entry is None or run.entry.topic != "clipping" or recording is None or not len(recording):
        return None
    if steps is None or step is None or (number is not None and number > len(steps)):
        return None
    if number is None and run.detail:
        first = last = min(run.position, len(recording) - 1)
    else:
        first, last = steps.span(step.number if number is None else number)
    root, event = _own_call(recording, max(first, 0), max(last, 0))
    depths = np.frombuffer(recording.frame_depths[:root], np.uint32)
    call = min(int((depths == 0).sum()), len(run.calls) - 1)
    ended = event < last or (recording.complete and event == len(recording) - 1)
    variables = recording.after(event) if ended else recording.stack(event)[-1][2]
    return ClipMoment(run.entry.slug, run.calls[call], variables, call, ended)


def _own_call(recording: Recording, first: int, last: int) -> tuple[int, int]:
    """The outermost frame that event ``first`` is in, and the last event, up to ``last``, that still is."""
    frame = root = int(recording.frame_column[first])
    while frame >= 0:
        root, frame = frame, int(recording.frame_parents[frame])
    frames = np.frombuffer(recording.frame_column[first : last + 1], np.uint32)
    others = np.frombuffer(recording.frame_depths[root + 1 :], np.uint32)
    following = np.flatnonzero(others == 0)
    if len(following):
        beyond = np.flatnonzero(frames >= root + 1 + int(following[0]))
        if len(beyond):
            return root, first + int(beyond[0]) - 1
    return root, last


def edge_points(window: Box, edge: int) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Both ends of one edge of the window, by its bit in a region code."""
    corners = window_corners(window)
    first = {BOTTOM: 0, RIGHT: 1, TOP: 2, LEFT: 3}[edge]
    return corners[first : first + 2]


def run_marks(moment: ClipMoment) -> Iterator[Drawn]:
    """The construction of one moment of a clipper."""
    xmin, ymin, xmax, ymax = (float(value) for value in moment.arguments[-4:])
    window: Box = (xmin, ymin, xmax, ymax)
    match moment.slug:
        case "cohen_sutherland":
            yield from _cohen_sutherland(moment, window)
        case "liang_barsky":
            yield from _liang_barsky(moment, window)
        case "sutherland_hodgman":
            yield from _sutherland_hodgman(moment, window)
        case "clip_point":
            yield Spot(moment.variables["x"], moment.variables["y"], "accent", "ring", 12)


def _edge(window: Box, edge: int) -> Iterator[Drawn]:
    yield Stroke(edge_points(window, edge), "accent", 5.0, haloed=True)


def _original(moment: ClipMoment) -> tuple[tuple[float, float], tuple[float, float]]:
    x0, y0, x1, y1 = (float(value) for value in moment.arguments[:4])
    return (x0, y0), (x1, y1)


def _cohen_sutherland(moment: ClipMoment, window: Box) -> Iterator[Drawn]:
    """The line as it is now, its two codes, the edge that it was cut off at."""
    now = moment.variables
    first, last = _original(moment)
    a, b = (float(now["x0"]), float(now["y0"])), (float(now["x1"]), float(now["y1"]))
    yield Stroke(np.array([first, last]), "muted", 1.5, "dash")
    if "edge" in now:
        yield from _edge(window, now["edge"])
    codes = now.get("code_0"), now.get("code_1")
    gone = "code_1" in now and now["code_0"] & now["code_1"] != 0
    fate: Fate = "rejected" if gone else "accepted"
    yield Stroke(np.array([a, b]), "data 4" if gone else "data 1", 3.0, PATTERNS[fate], haloed=True)
    for at, other, origin, code in ((a, b, first, codes[0]), (b, a, last, codes[1])):
        yield Spot(*at, "data 2" if at != origin else "text", "ring" if at != origin else "dot", 8)
        if code is not None and at != origin:
            yield Word(code_text(code), *at, "text", 1 if at[0] >= other[0] else -1, 1, True, True)


def _liang_barsky(moment: ClipMoment, window: Box) -> Iterator[Drawn]:
    """The interval from u1 to u2 on the line, the edge that is looked at, where the line crosses it."""
    now = moment.variables
    (x0, y0), (x1, y1) = _original(moment)

    def at(u: float) -> tuple[float, float]:
        return x0 + u * (x1 - x0), y0 + u * (y1 - y0)

    yield Stroke(np.array([(x0, y0), (x1, y1)]), "muted", 1.5, "dash")
    if "k" in now and not moment.ended:
        yield from _edge(window, _BY_NUMBER[now["k"] - 1])
    u1, u2 = now.get("u1", 0.0), now.get("u2", 1.0)
    if u1 <= u2:
        yield Stroke(np.array([at(u1), at(u2)]), "data 1", 4.0, haloed=True)
    if "r" in now and not moment.ended and -1 <= now["r"] <= 2:
        yield Spot(*at(now["r"]), "data 2", "cross", 9)
    for name, u, side in (("u₁", u1, -1), ("u₂", u2, 1)):
        yield Spot(*at(u), "data 1", "ring", 8)
        right = side if x1 >= x0 else -side
        yield Word(f"{name} = {u:.3g}", *at(u), "text", right, 1, True)


def _sutherland_hodgman(moment: ClipMoment, window: Box) -> Iterator[Drawn]:
    """The polygon that this stage takes, what it has handed on so far, the side and the edge it is at."""
    now = moment.variables
    given = closed(np.asarray(moment.arguments[0], np.float64))
    yield Stroke(given, "muted", 1.0, "dot")
    polygon, clipped = now.get("polygon") or [], now.get("clipped") or []
    if moment.ended or "edge" not in now:
        if len(polygon) > 1:
            yield Region(np.array(polygon, np.float64), "data 1", 40)
            yield Stroke(closed(np.array(polygon, np.float64)), "data 1", 3.0, haloed=True)
            yield from degenerate_marks([tuple(point) for point in polygon], window)
        return
    yield from _edge(window, now["edge"])
    if polygon:
        yield Stroke(closed(np.array(polygon, np.float64)), "data 2", 1.5, "dash")
    if "i" in now and polygon and now["i"] < len(polygon):
        side = np.array([polygon[now["i"] - 1], polygon[now["i"]]], np.float64)
        yield Stroke(side, "data 2", 4.0, haloed=True)
    if len(clipped) > 1:
        yield Region(np.array(clipped, np.float64), "data 1", 40)
        yield Stroke(np.array(clipped, np.float64), "data 1", 3.0, haloed=True)
    many = len(clipped) > 20
    for number, (x, y) in enumerate(clipped):
        yield Spot(x, y, "data 1", "square", 7)
        if not many:
            yield Word(str(number), x, y, "text", 1, 1)
