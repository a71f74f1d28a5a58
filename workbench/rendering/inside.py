"""Whether a point is inside a polygon: the answer of the inside-outside test, in words and marks."""

from typing import NamedTuple

import numpy as np

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Mark
from workbench.document.model import Polygon, Sheet
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.rendering.marks import on_device
from workbench.rendering.pipeline import calls


class Verdict(NamedTuple):
    """The text's own last sentence, and what it draws of the whole run, device coordinates."""

    sentence: str
    marks: tuple[Mark, ...]


def verdict(sheet: Sheet, polygon: Polygon, x: float, y: float) -> Verdict | None:
    """What the test says of a device point in the first view; None where nothing is left to be drawn."""
    runs = calls(sheet, polygon)
    if not runs:
        return None
    entry = catalogue.get("inside_outside")
    vertices, ring_ends = runs[0].arguments[:2]
    arguments = vertices, ring_ends, x, y, polygon.nonzero
    recording = record(entry.function, *arguments)
    said = "".join(part.text for part in Steps(entry, recording).told(len(recording)))
    emitted = recording.emitted.array().reshape(-1, 3).astype(np.float64)
    return Verdict(said, on_device(sheet, entry.frame, entry.marks(arguments, {}, emitted, True)))
