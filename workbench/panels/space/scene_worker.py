"""Draws scenes on a thread of its own, one at a time; of those asked for meanwhile only the last is drawn."""

from contextlib import suppress
from functools import partial
from queue import SimpleQueue
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Signal
from shiboken6 import isValid

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine import background
from workbench.language import _, reason_of
from workbench.rendering.scene.edge_picture import EdgePicture, edge_picture
from workbench.rendering.scene.viewpoint import Size, Viewpoint


class SceneJob(NamedTuple):
    """What is drawn: a scene through its camera and a window of the view plane, ``size`` in device pixels."""

    scene: Scene
    size: Size
    window: Rectangle
    faces: bool

    @property
    def viewpoint(self) -> Viewpoint:
        """How its points come into the picture."""
        return Viewpoint.of(self.scene.camera, self.size, self.window, np.zeros((0, 3)))


class SceneWorker(QObject):
    """``drawn`` sends the job and its picture, ``failed`` the job and one sentence."""

    drawn = Signal(object, object)
    failed = Signal(object, str)
    _done = Signal(object, object, str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._drawing: SceneJob | None = None
        self._next: SceneJob | None = None
        self._jobs: SimpleQueue[SceneJob | None] = SimpleQueue()
        self._began = False
        self._done.connect(self._take)
        self.destroyed.connect(partial(self._jobs.put, None))

    @property
    def busy(self) -> bool:
        """Whether a picture is awaited."""
        return self._drawing is not None

    def ask(self, job: SceneJob) -> None:
        """Draw this, as soon as what is being drawn is done."""
        if self._drawing is None:
            self._drawing = job
            if not self._began:
                self._began = True
                background.thread(self._work, "scene", partial(self._jobs.put, None)).start()
            self._jobs.put(job)
        else:
            self._next = job

    def _take(self, job: SceneJob, picture: EdgePicture | None, problem: str) -> None:
        self._drawing = None
        if self._next is not None:
            following, self._next = self._next, None
            self.ask(following)
        if picture is not None:
            self.drawn.emit(job, picture)
        elif problem:
            self.failed.emit(job, problem)

    def _work(self) -> None:
        """Draw one after the other, until there is to be no further one."""
        while (job := self._jobs.get()) is not None:
            picture, problem = None, ""
            try:
                picture = edge_picture(*job)
            except ValueError as error:
                problem = reason_of(error)
            except MemoryError:
                problem = _("The scene takes more memory than there is; make the picture or a solid smaller.")
            except Exception:
                self._tell(job, None, _("Something in the program failed while this scene was drawn."))
                raise
            self._tell(job, picture, problem)

    def _tell(self, job: SceneJob, picture: EdgePicture | None, problem: str) -> None:
        with suppress(RuntimeError):  # whoever asked is gone
            if isValid(self):
                self._done.emit(job, picture, problem)
