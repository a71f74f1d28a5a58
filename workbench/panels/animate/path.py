"""The path of a figure over all frames, and its ghosts in the frames around, drawn over the picture."""

from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Ink, Mark, Pattern, Spot, Stroke, Word
from workbench.document.model import AnyFigure, Sheet
from workbench.document.motion.evaluation import at, values_along
from workbench.document.motion.groups import OUTLINE
from workbench.document.motion.tracks import group_moved, motion_of
from workbench.language import _
from workbench.panels.animate.physics import Equation, by_equation
from workbench.panels.stage.outline import outline
from workbench.rendering import figure_map

_GHOST_STEP = 3
_MOST_GHOSTS = 8


@lru_cache(maxsize=16)
def alone(sheet: Sheet, figure: AnyFigure) -> Sheet:
    """The sheet with one figure and what moves it, so that a frame of it costs little."""
    motion = motion_of(sheet)
    tracks = tuple(track for track in motion.tracks if track.target.split("/")[0] == figure.id)
    return replace(sheet, figures=(figure,), scene=None, motion=replace(motion, tracks=tracks))


@lru_cache(maxsize=16)
def path_of(moving: Sheet, point: str = "") -> NDArray[np.float64]:
    """The middle (n, 2) of the only figure of a sheet, or one of its points, in every frame, on the device.

    Of more than 600 frames every second, third and so on.
    """
    motion, figure = motion_of(moving), moving.figures[0]
    frames = np.arange(0, motion.frames, -(-motion.frames // MOST_SPOTS), dtype=np.float64)
    places = _points_over(moving, frames)
    if places is None:
        return np.array([_middle(at(moving, int(frame)), point) for frame in frames], np.float64)
    drawn = [number for number, each in enumerate(figure.points_world) if not point or each.id == point]
    return figure_map(moving, figure).points(places[:, drawn].mean(axis=1))


def _points_over(moving: Sheet, frames: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The points (n, points, 2) of the only figure in many frames at once; None where it is morphed, or its
    transforms move.
    """
    own = np.array([(each.x, each.y) for each in moving.figures[0].points_world], np.float64)
    places = np.repeat(own[None], len(frames), axis=0)
    for track in motion_of(moving).tracks:
        group = group_moved(moving, track)
        part = "" if group is None else group.slots[0].path[2]
        if group is None or part not in (OUTLINE, "transforms"):
            continue
        if part != OUTLINE or any(len(key.value) != len(group.slots) for key in track.keys):
            return None
        for slot, values in zip(group.slots, values_along(track, frames, group).T, strict=True):
            number, name = slot.path[3:]
            places[:, int(number), ("x", "y").index(str(name))] = values
    return places


def _middle(sheet: Sheet, point: str) -> tuple[float, float]:
    figure = sheet.figures[0]
    places = [(each.x, each.y) for each in figure.points_world if not point or each.id == point]
    x, y = np.array(places, np.float64).mean(axis=0).tolist()
    place = figure_map(sheet, figure).point(x, y)
    return float(place[0]), float(place[1])


def keyed_places(moving: Sheet, point: str = "", of: str = "") -> dict[int, tuple[float, float]]:
    """Where the path is in each frame that has a key, on the device; with ``of`` only those of that part."""
    path, motion = path_of(moving, point), motion_of(moving)
    step = -(-motion.frames // MOST_SPOTS)
    tracks = [track for track in motion.tracks if not of or f"/{of}/" in track.target]
    frames = sorted({key.frame for track in tracks for key in track.keys})
    return {
        frame: (path[frame // step, 0], path[frame // step, 1]) for frame in frames if frame < motion.frames
    }


def marked_places(moving: Sheet, point: str = "") -> dict[int, tuple[float, float]]:
    """Where the path is in each frame that has a mark, on the device; nowhere where nothing moves."""
    path = path_of(moving, point)
    step = -(-motion_of(moving).frames // MOST_SPOTS)
    if not np.ptp(path, axis=0).any():
        return {}
    return {number * step: (x, y) for number, (x, y) in enumerate(path.tolist())}


def path_marks(moving: Sheet, frame: int, point: str = "") -> Iterator[Mark]:
    """A mark for each frame, so that speed is seen, larger ones at keys, and a ring where it is now."""
    path = path_of(moving, point)
    if len(path) < 2 or not np.ptp(path, axis=0).any():
        return
    step = -(-motion_of(moving).frames // MOST_SPOTS)
    yield Stroke(path, "muted", "hair")
    for x, y in path.tolist():
        yield Spot(x, y, "text", "dot", "pixel")
    for x, y in keyed_places(moving, point).values():
        yield Spot(x, y, "accent", "square", "small")
    x, y = path[min(frame // step, len(path) - 1)].tolist()
    yield Spot(x, y, "accent", "ring", "large")


def equation_marks(moving: Sheet, equation: Equation, frame: int, point: str = "") -> Iterator[Mark]:
    """The path by an equation, where it is on it in a frame, and under it what it is."""
    path = path_of(by_equation(moving, equation), point)
    yield Stroke(path, "data4", "thin", "dot")
    step = -(-motion_of(moving).frames // MOST_SPOTS)
    x, y = path[min(frame // step, len(path) - 1)].tolist()
    yield Spot(x, y, "data4", "ring", "large")
    x, y = float(path[:, 0].mean()), float(path[:, 1].min())
    words = {
        "fall": _("dotted: falling by its equation, t²"),
        "swing": _("dotted: a pendulum by its equation"),
    }
    yield Word(words[equation.law], x, y, "data4", 0, -1)


def ghosts(moving: Sheet, frame: int, reach: int) -> Iterator[Mark]:
    """The outlines of the figure before and after a frame, as far as they reach, some frames apart."""
    last = motion_of(moving).frames - 1
    step = max(_GHOST_STEP, -(-reach // _MOST_GHOSTS)) if reach >= _GHOST_STEP else 1
    sides: tuple[tuple[int, Ink, Pattern], ...] = ((-1, "data1", "solid"), (1, "data2", "dash"))
    for side, ink, pattern in sides:
        for away in range(step, reach + 1, step):
            other = frame + side * away
            if 0 <= other <= last:
                seen = at(moving, other)
                for curve in outline(seen, seen.figures[0]):
                    yield Stroke(curve, ink, "thin", pattern)
