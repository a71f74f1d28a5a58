"""A method that keeps no depths on the scene, as far as it is stepped: what it has painted, and its marks."""

from typing import NamedTuple

import numpy as np

from workbench.language import _
from workbench.panels.space.visibility.depth_run import DepthRun, method_run
from workbench.panels.space.visibility.picture import paint_surfaces, surface_colours
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.scene.fragments import NOTHING, Index
from workbench.rendering.scene.methods import seen_after
from workbench.rendering.subjects.registry import marks_on_device
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.look.tokens import Tokens

_PALE = 0.3


class SurfaceRun(NamedTuple):
    """``seen`` (h, w) the triangle that each pixel shows so far; what is drawn of the step."""

    depth: DepthRun
    seen: Index
    marks: tuple[Drawn, ...]

    @property
    def legend(self) -> str:
        """How much of the picture is painted."""
        counts = [int((seen != NOTHING).sum()) for seen in (self.seen, self._nearest)]
        return _("{now:,} of {whole:,} pixels are painted.").format(now=counts[0], whole=counts[1])

    @property
    def _nearest(self) -> Index:
        return self.depth.fragments.seen(self.depth.size)

    def picture(self, now: Tokens) -> Pixels:
        """What is painted so far, and pale what is the nearest where nothing is yet."""
        colours = surface_colours(self.depth, now)
        paper = np.full(self.depth.size[::-1], packed(now.canvas), np.uint32)
        paint_surfaces(paper, np.where(self.seen == NOTHING, self._nearest, NOTHING), colours, _PALE)
        paint_surfaces(paper, self.seen, colours, 1.0)
        return paper

    def drawn(self) -> tuple[Drawn, ...]:
        """The marks of the step."""
        return self.marks


def surface_run(depth: DepthRun, session: Session) -> SurfaceRun:
    """How far the session's run has come."""
    run, seen = method_run(session), np.full(depth.size[::-1], NOTHING)
    marks: tuple[Drawn, ...] = ()
    if run is None or run.entry is None or run.subject is None:
        return SurfaceRun(depth, seen, marks)
    if run.recording is not None and run.moment is not None:
        count = len(run.moment.emitted) if run.detail or run.step is None else run.step.emitted_to
        rows = run.recording.emitted.array(0, count)
        if run.entry.emits == "coverage" and len(rows):  # the light of a pixel: the nearest stands for it
            x, y = rows[:, 0].astype(np.int64), rows[:, 1].astype(np.int64)
            seen[y, x] = depth.fragments.seen(depth.size)[y, x]
        else:
            seen = seen_after(run.entry, rows, depth.size)
    marks = tuple(marks_on_device(session.sheet, run.subject, run.entry.frame, run.marks()))
    return SurfaceRun(depth, seen, marks)
