"""Keeps the canvas, the card and the plot of the Fill panel in step with the session and its run."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QTimer

from workbench.algorithms.entry import CALLS
from workbench.document.model import AnyFigure
from workbench.engine.observation import Steps
from workbench.engine.pending import Depths, PixelTests, stack_at
from workbench.panels.fill.card import FillCard
from workbench.panels.fill.tools import InsideTool
from workbench.panels.stage.compose import Composition, Progress
from workbench.panels.stage.heat import heat_words, heated
from workbench.panels.stage.view import FigureView
from workbench.rendering.inside import Verdict, verdict
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.depth_plot import DepthPlot

_SLICE_MS, _STEPS, _VISITS = 8, 150, 300
_READABLE_PX = 12
_NOTHING = np.zeros(0, np.int64)


class FillView(FigureView):
    """Shows a session on canvases, card and ``plot``; what is found slowly is found a slice at a time."""

    def __init__(
        self,
        session: Session,
        canvas: PixelCanvas,
        second: PixelCanvas,
        card: FillCard,
        plot: DepthPlot,
        inside: InsideTool,
        changed: Callable[[], object],
    ) -> None:
        super().__init__(session, canvas, second, card)
        self.fill_card = card
        self.plot = plot
        self.inside = inside
        self.changed = changed
        self.verdict: Verdict | None = None
        self._steps: Steps | None = None
        self._depths: Depths | None = None
        self._tested: PixelTests | None = None
        self._slices = QTimer(canvas)
        self._slices.setSingleShot(True)
        self._slices.setInterval(_SLICE_MS)
        self._slices.timeout.connect(self._look_on)

    def completed(
        self, made: Composition, progress: Progress | None, number: int | None = None
    ) -> Composition:
        """With the heat map in place of what is drawn of the run, and the ray of a point asked about."""
        if number is not None:
            return super().completed(made, progress, number)
        heat = self._heat(self.stepped_run())
        if heat is None:
            made = super().completed(made, progress)
        else:
            words = heat_words(heat) if self._cell_px >= _READABLE_PX else ()
            overlay = replace(made.overlay, drawn=words)
            made = replace(made, pixels=heated(made.pixels, heat, tokens()), overlay=overlay)
        self.verdict = self._verdict()
        self.fill_card.say_verdict("" if self.verdict is None else self.verdict.sentence)
        if self.verdict is None:
            return made
        return replace(made, overlay=replace(made.overlay, drawn=(*made.overlay.drawn, *self.verdict.marks)))

    @property
    def _cell_px(self) -> float:
        return self.canvas.view.cell / self.canvas.devicePixelRatioF()

    def _verdict(self) -> Verdict | None:
        polygon = self.inside.polygon()
        if self.inside.point is None or polygon is None:
            return None
        return verdict(self.sheet, polygon, *self.inside.point)

    def _heat(self, run: Run | None) -> NDArray[np.int64] | None:
        """How often each pixel was tested up to the cursor; None when that is not to be seen."""
        if not self.fill_card.heat.isChecked() or self.fill_card.heat.isHidden():
            return None
        self._take(run)
        if run is None or self._tested is None:
            return None
        number = run.step_number or (0 if run.ask_first else len(run.steps or ()))
        return self._tested.counts(number, run.image_size)

    def show_beside(self, active: AnyFigure | None, compared: str, progress: Progress | None) -> None:
        """The depth of the stack, and what became of a recursion."""
        run = self.stepped_run()
        self._take(run)
        recording = None if run is None else run.recording
        self.fill_card.say_heat(0 if run is None else run.passed)
        if run is None or self._steps is None or self._depths is None or recording is None:
            self.plot.show_depths(_NOTHING, False)
            return
        entry, depths = self._steps.entry, self._depths.values
        self.plot.show_depths(
            depths,
            entry.stack == CALLS,
            run.depth_limit if entry.stack == CALLS else 0,
            begin_at=run.passed,
            whole=run.done and not run.in_stretches and len(depths) > len(self._steps),
        )
        if self.plot.isVisible() and run.line_event >= 0:
            now = len(stack_at(entry, recording, run.line_event))
            self.plot.show_cursor(run.passed + run.step_number, now)
        self.fill_card.say_overflow(run.message if recording.error is not None else "")

    def _take(self, run: Run | None) -> None:
        """Follow another run, or more of the same; only one with a stack is looked at."""
        steps = None
        if run is not None and run.entry is not None and run.entry.stack:
            steps = run.steps
        if steps is not self._steps:
            self._steps = steps
            self._depths = None if steps is None else Depths(steps)
            self._tested = None if steps is None else PixelTests(steps)
        if steps is not None and not self._slices.isActive():
            self._slices.start()

    def _look_on(self) -> None:
        """Look at a slice of what is not yet known, while it is to be seen."""
        if self._steps is None or self._depths is None or self._tested is None:
            return
        known = len(self._depths.values), len(self._tested)
        more = self.plot.isVisible() and self._depths.advance(_STEPS)
        heat = self.fill_card.heat.isChecked() and not self.fill_card.heat.isHidden()
        more = (heat and self._tested.advance(_VISITS)) or more
        if more:
            self._slices.start()
        if (len(self._depths.values), len(self._tested)) != known:
            self.changed()
