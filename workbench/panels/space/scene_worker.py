"""Draws scenes on a thread of its own, one at a time; of those asked for meanwhile only the last is drawn.

A picture that takes long gives way to the next one, so that nobody waits for what is no longer to be seen.
"""

import sys
import threading
from functools import partial
from time import monotonic
from typing import Literal, NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine.stopping import Stop, Stopped
from workbench.language import _, reason_of
from workbench.rendering.scene.edge_picture import EdgePicture, edge_picture, image_over_nothing
from workbench.rendering.scene.line_drawing import line_drawing, line_picture
from workbench.rendering.scene.shaded import Model, shaded
from workbench.rendering.scene.shading import QUICK
from workbench.rendering.scene.viewpoint import Size, Viewpoint
from workbench.session.answers import Answers

PATIENCE_S = 1.0
"""So long a picture is drawn although another one is asked for: of a scene that is turned some are seen."""

Draws = Literal["faces", "edges", "lines"]
"""Faces with their edges, all edges, or edges without what faces hide."""


class SceneJob(NamedTuple):
    """What is drawn: a scene through its camera and a window of the view plane, ``size`` in device pixels;
    its shading, with the edges only of a quick one."""

    scene: Scene
    size: Size
    window: Rectangle
    draws: Draws
    shading: str = QUICK
    model: Model = Model()

    @property
    def viewpoint(self) -> Viewpoint:
        """How its points come into the picture."""
        return Viewpoint.of(self.scene.camera, self.size, self.window, np.zeros((0, 3)))


class SceneAnswer(NamedTuple):
    """A job and its picture; ``problem``, one sentence, tells why there is none, or all edges instead of
    those that are seen. Neither where it was stopped."""

    job: SceneJob
    picture: EdgePicture | None = None
    problem: str = ""


class _Turn:
    """The drawing of one picture: ``since`` when, once it is its turn."""

    def __init__(self) -> None:
        self.stop = Stop()
        self.since: float | None = None


class SceneWorker(QObject):
    """``drawn`` sends the job and its picture, ``failed`` the job and one sentence."""

    drawn = Signal(object, object)
    failed = Signal(object, str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._turn: _Turn | None = None
        self._left = False
        self._next: SceneJob | None = None
        self._patience = QTimer(self, interval=round(PATIENCE_S * 1000), singleShot=True)
        self._patience.timeout.connect(self._give_way)
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether a picture is awaited."""
        return self._turn is not None

    def ask(self, job: SceneJob) -> None:
        """Draw this, as soon as what is being drawn is done, or has taken long enough."""
        if self._turn is not None:
            self._next = job
            if not self._patience.isActive():
                self._patience.start()
        else:
            self._turn = _Turn()
            self._answers.ask(partial(_draw, job, self._turn), "scene", self._turn.stop.set)

    def _give_way(self) -> None:
        turn = self._turn
        if turn is None or self._next is None:
            return
        if turn.since is not None and monotonic() - turn.since >= PATIENCE_S:
            turn.stop.set()
        else:
            self._patience.start()

    def leave(self) -> None:
        """Nobody wants what is being drawn any more."""
        self._left, self._next = self.busy, None
        if self._turn is not None:
            self._turn.stop.set()

    def _take(self, answer: SceneAnswer) -> None:
        left, self._left, self._turn = self._left, False, None
        self._patience.stop()
        if self._next is not None:
            following, self._next = self._next, None
            self.ask(following)
        if left:
            return
        if answer.picture is not None:
            self.drawn.emit(answer.job, answer.picture)
        if answer.problem:
            self.failed.emit(answer.job, answer.problem)


_one_at_a_time = threading.Lock()
"""Two views of a scene take no longer one after the other, and half of the memory."""


def _answer(job: SceneJob, stop: Stop) -> SceneAnswer:
    none, nobody = np.zeros((0, 4)), np.zeros(0, np.int64)
    if job.draws == "lines":
        try:
            return SceneAnswer(job, line_picture(line_drawing(job.scene), *job[:3]))
        except ValueError as error:
            return SceneAnswer(job, edge_picture(*job[:3], faces=False), reason_of(error))
    if job.shading == QUICK:
        return SceneAnswer(job, edge_picture(*job[:3]))
    image, depth = shaded(job.scene, job.shading, job.size, job.window, job.model, stop)
    return SceneAnswer(job, EdgePicture(image_over_nothing(image, depth), none, nobody, none, nobody))


def _draw(job: SceneJob, turn: _Turn) -> SceneAnswer:
    try:
        with _one_at_a_time:
            turn.since = monotonic()
            return _answer(job, turn.stop)
    except Stopped:
        return SceneAnswer(job)  # to nobody: another one is wanted, or the program ends
    except ValueError as error:
        return SceneAnswer(job, problem=reason_of(error))
    except MemoryError:
        sentence = _("There is not enough memory for this scene; make the picture or a solid smaller.")
    except Exception:
        sentence = _("Something in the program failed while this scene was drawn.")
        threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), threading.current_thread())))
    return SceneAnswer(job, problem=sentence)
