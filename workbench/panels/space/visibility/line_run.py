"""The removal of hidden lines, as far as it is stepped: what is drawn of the edges so far."""

from typing import NamedTuple

import numpy as np

from workbench.language import ngettext
from workbench.panels.space.visibility.depth_run import DepthRun, method_run
from workbench.panels.space.visibility.picture import paint_surfaces, surface_colours
from workbench.panels.stage.picture import Pixels, packed
from workbench.rendering.subjects.registry import marks_on_device
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.look.tokens import Tokens

_PALE = 0.3


class LineRun(NamedTuple):
    """``parts`` parts of edges are drawn so far; the marks of the step."""

    depth: DepthRun
    parts: int
    marks: tuple[Drawn, ...]

    @property
    def legend(self) -> str:
        """How much is drawn."""
        return ngettext(
            "{n:,} part of an edge is drawn.", "{n:,} parts of edges are drawn.", self.parts
        ).format(n=self.parts)

    def picture(self, now: Tokens) -> Pixels:
        """The scene, pale: lines alone are drawn."""
        paper = np.full(self.depth.size[::-1], packed(now.canvas), np.uint32)
        nearest = self.depth.fragments.seen(self.depth.size)
        paint_surfaces(paper, nearest, surface_colours(self.depth, now), _PALE)
        return paper

    def drawn(self) -> tuple[Drawn, ...]:
        """All edges thin, what is seen of them, and the surface in hand."""
        return self.marks


def line_run(depth: DepthRun, session: Session) -> LineRun:
    """How far the session's run has come."""
    run = method_run(session)
    if run is None or run.entry is None or run.subject is None:
        return LineRun(depth, 0, ())
    parts = 0
    if run.moment is not None:
        parts = len(run.moment.emitted) if run.detail or run.step is None else run.step.emitted_to
    marks = tuple(marks_on_device(session.sheet, run.subject, run.entry.frame, run.marks()))
    return LineRun(depth, parts, marks)
