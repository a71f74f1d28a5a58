"""A shading as far as it is stepped: the light that each pixel has so far, and what is drawn of the step."""

from functools import partial

import numpy as np
from PySide6.QtCore import QObject, Signal

from workbench.display.exposure import srgb_encoded
from workbench.engine.at_hand import at_hand
from workbench.engine.stopping import Stop
from workbench.engine.turns import interface, short_turns
from workbench.geometry.meshes import Array
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.emissions import emitted
from workbench.rendering.mapping import Call
from workbench.session.answers import Answers
from workbench.session.session import Session
from workbench.widgets.look.tokens import Tokens

_PALE = 0.35


class EndedLight(QObject):
    """What a shading comes to in the end, found on a thread of its own where that takes long.

    ``arrived``: what was asked for last is known now.
    """

    arrived = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._asked: Call | None = None
        self._found: Array | None = None
        self._stop = Stop()
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    def of(self, call: Call) -> Array | None:
        """The light (h, w) when all of the call has run; None while that is being found."""
        if at_hand(call.entry.function, "collect"):
            return _picture(np.asarray(emitted(call), np.float64), call.arguments[0].shape)
        if call is not self._asked:
            self._stop.set()
            self._asked, self._found, self._stop = call, None, Stop()
            self._answers.ask(partial(_ended, call, self._stop), "light in the end", self._stop.set)
        return self._found

    def _take(self, answer: tuple[Call, Array] | None) -> None:
        if answer is not None and answer[0] is self._asked:
            self._found = answer[1]
            self.arrived.emit()


def _ended(call: Call, stop: Stop) -> tuple[Call, Array] | None:
    """The plain reading, which lets the interface go first; None where it was stopped."""
    given = tuple(each.copy() if isinstance(each, np.ndarray) else each for each in call.arguments)
    rows = []
    with short_turns:
        for row in call.entry.function(*given):
            rows.append(row)
            interface.wait()
            if stop.is_set:
                return None
    return call, _picture(np.array(rows, np.float64), call.arguments[0].shape)


def light_so_far(session: Session, call: Call) -> Array:
    """The light (h, w) of the pixels that have any by now; not a number where none has."""
    rows = rows_so_far(session) if session.run.entry is call.entry else np.zeros((0, 3))
    return _picture(rows, call.arguments[0].shape)


def rows_so_far(session: Session) -> Array:
    """What the run has emitted by now (n, 3): x, y, light."""
    run = session.run
    if run.recording is None or run.moment is None:
        return np.zeros((0, 3))
    count = len(run.moment.emitted) if run.detail or run.step is None else run.step.emitted_to
    return np.array(run.recording.emitted.array(0, count), np.float64).reshape(-1, 3)


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
