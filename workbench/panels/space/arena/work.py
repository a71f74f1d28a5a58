"""Runs all methods on a scene on a thread of its own, and times them; each is told as soon as it is done."""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from PySide6.QtCore import QObject, Signal

from workbench.algorithms import catalogue
from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.engine.background import report
from workbench.engine.stopping import Stop, Stopped
from workbench.engine.turns import short_turns
from workbench.language import _, reason_of
from workbench.rendering.scene.arena import MethodRun, device_of, runs_of
from workbench.rendering.scene.growth import Growth, growth_of
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.scene.viewpoint import Size
from workbench.session.answers import Answers


class ArenaJob(NamedTuple):
    """A scene seen through a window of the view plane, at a coarse ``size``, and the slugs of the methods."""

    scene: Scene
    size: Size
    window: Rectangle | None
    methods: tuple[str, ...]

    @property
    def twice(self) -> Size:
        """Twice the width and height."""
        return 2 * self.size[0], 2 * self.size[1]


class Twice(NamedTuple):
    """A run at twice the width and height: what of the work depends on the size of the picture?"""

    run: MethodRun


class Preparing(NamedTuple):
    """So many of all kernels are compiled that are needed before anything can be timed."""

    done: int
    total: int


Told = DeviceTriangles | MethodRun | Twice | Growth | Preparing


class ArenaWorker(QObject):
    """``told`` sends what is done of the last job, ``ended`` that all is, or one sentence why not."""

    told = Signal(object)
    ended = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._work: _Work | None = None
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether anything is awaited."""
        return self._work is not None

    def run(self, job: ArenaJob) -> None:
        """Let all methods loose; what was asked before is stopped."""
        self._ask(partial(_run, job), "arena")

    def time(self, job: ArenaJob) -> None:
        """Measure how the time of each grows; what was asked before is stopped."""
        self._ask(partial(_time, job), "times of the arena")

    def cancel(self) -> None:
        """The last job is not of interest any more."""
        if self._work is not None:
            self._work.stop()
            self._work = None

    def _ask(self, do: "Callable[[_Work, Callable[[Told], None]], None]", name: str) -> None:
        self.cancel()
        self._work = _Work(do)
        self._answers.ask(partial(self._work.done, self._answers.tell), name, self._work.stop)

    def _take(self, answer: "tuple[_Work, Any]") -> None:
        work, what = answer
        if work is not self._work:
            return
        if isinstance(what, str):
            self._work = None
            self.ended.emit(what)
        else:
            self.told.emit(what)


class _Work:
    """What a thread does, and how it is stopped. Of Qt it knows nothing."""

    def __init__(self, do: "Callable[[_Work, Callable[[Told], None]], None]") -> None:
        self._do = do
        self.flag = Stop()
        self.stop_child: Callable[[], None] = lambda: None

    def stop(self) -> None:
        """End it; from any thread."""
        self.flag.set()
        self.stop_child()

    def done(self, tell: Callable[[Any], None]) -> "tuple[_Work, str] | None":
        """Do it, telling what is done; then a sentence if it failed."""
        try:
            with short_turns:
                self._do(self, lambda told: tell((self, told)))
        except Stopped:
            return None
        except ValueError as error:
            return self, reason_of(error)
        except MemoryError:
            return self, _("There is not enough memory for this scene; hide some of its objects.")
        except Exception:
            report()
            return self, _("Something in the program failed while the methods were run.")
        return self, ""


def _run(job: ArenaJob, work: _Work, tell: Callable[[Told], None]) -> None:
    tell(device_of(job.scene, job.size, job.window))
    for run in runs_of(job.scene, job.size, job.window, job.methods, work.flag):
        if work.flag.is_set:
            raise Stopped
        tell(run)


def _time(job: ArenaJob, work: _Work, tell: Callable[[Told], None]) -> None:
    _prepare(job, work, tell)
    counted = [method for method in job.methods if catalogue.get(method).counted]
    for run in runs_of(job.scene, job.twice, job.window, counted, work.flag):
        tell(Twice(run))
    for method in job.methods:
        tell(growth_of(method, job.scene, job.size, job.window, work.flag))


def _prepare(job: ArenaJob, work: _Work, tell: Callable[[Told], None]) -> None:
    """Have compiled, in another process, what is not yet. Raises ValueError where there is no compiler."""
    from workbench.engine import compiled
    from workbench.engine.warm import Warming

    if not compiled.available():
        raise ValueError(_("Times are those of compiled algorithms, and there is no compiler here."))
    child = Warming(job.methods, ("paint", "collect", "count"))
    work.stop_child = child.stop
    if work.flag.is_set:
        child.stop()
    child.follow(lambda progress: tell(Preparing(progress.done, progress.total)))
    if work.flag.is_set:
        raise Stopped
