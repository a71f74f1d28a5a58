"""A shading as far as it is stepped: the light that each pixel has so far, and what is drawn of the step."""

import numpy as np
from numpy.typing import NDArray

from workbench.display.exposure import srgb_encoded
from workbench.geometry.meshes import Array
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.emissions import emitted
from workbench.rendering.mapping import Call
from workbench.session.session import Session
from workbench.widgets.look.tokens import Tokens

_PALE = 0.35


def light_so_far(session: Session, call: Call) -> tuple[Array, Array]:
    """The light (h, w) of the pixels that have any by now, and in the end; not a number where none has."""
    run, whole = session.run, emitted(call)
    rows: NDArray[np.float64] = np.zeros((0, 3))
    if run.entry is call.entry and run.recording is not None and run.moment is not None:
        count = len(run.moment.emitted) if run.detail or run.step is None else run.step.emitted_to
        rows = run.recording.emitted.array(0, count)
    shape = call.arguments[0].shape
    return _picture(rows, shape), _picture(np.asarray(whole, np.float64), shape)


def _picture(rows: Array, shape: tuple[int, int]) -> Array:
    light = np.full(shape, np.nan)
    if len(rows):
        x, y = rows[:, 0].astype(np.int64), rows[:, 1].astype(np.int64)
        light[y, x] = rows[:, 2]  # of several NumPy keeps the last
    return light


def greys(now: Array, ended: Array, theme: Tokens) -> Pixels:
    """Light as greys of a screen; pale what is still to come."""
    canvas = packed(theme.canvas)
    paper = np.full(now.shape, canvas, np.uint32)
    for light, share in ((np.where(np.isnan(now), ended, np.nan), _PALE), (now, 1.0)):
        lit = np.isfinite(light)
        level = np.floor(srgb_encoded(light[lit]) * 255 + 0.5)
        mixed = np.zeros(len(level), np.uint32)
        for shift in (16, 8, 0):
            under = float(canvas >> shift & 255)
            mixed |= np.round(under + share * (level - under)).astype(np.uint32) << np.uint32(shift)
        paper[lit] = mixed
    return paper
