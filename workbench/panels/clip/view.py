"""Keeps the canvas and the card of the Clip panel in step with the session and the clipper's run."""

from dataclasses import replace

import numpy as np

from workbench.algorithms.clipping.cutting import bits
from workbench.algorithms.clipping.edges import region_code
from workbench.document.model import AnyFigure, Sheet
from workbench.engine.calls import OwnCall
from workbench.language import _
from workbench.panels.clip.card import ClipCard
from workbench.panels.clip.scene import scene
from workbench.panels.clip.window import ClipSelectTool, window_handles
from workbench.panels.stage.compose import Composition, with_answer, with_band
from workbench.panels.stage.gesture import HandleDrag, Tool
from workbench.panels.stage.outline import handles
from workbench.panels.stage.picture import packed, picture, with_faint
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.view import FigureView
from workbench.rendering.clipping import clip_box
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import LIGHT, Tokens, tokens


class ClipView(FigureView):
    """Shows the sheet's window and what its clippers keep, and the moment of the run over it."""

    card: ClipCard

    def __init__(self, session: Session, canvas: PixelCanvas, second: PixelCanvas, card: ClipCard) -> None:
        super().__init__(session, canvas, second, card)

    def refresh(self, tool: Tool, drag: HandleDrag) -> None:
        """Everything anew, from the session alone."""
        session, sheet = self.session, self.sheet
        busy = tool.busy or drag.busy
        made = self._composed(sheet, self.active, None if busy else self._own_call(), None, tokens())
        held = drag.held or (tool.side.held if isinstance(tool, ClipSelectTool) else "")
        chosen = set(session.state.selection)
        selected = [figure for figure in sheet.figures if figure.id in chosen]
        grips = [*window_handles(sheet, held)]
        for figure in selected:
            grips += handles(sheet, figure, held)
        overlay = with_band(replace(made.overlay, handles=tuple(grips)), tool.band)
        drawing = tool if isinstance(tool, FigureTool) else None
        self.canvas.set_picture(made.pixels, made.background)
        overlay = with_answer(overlay, session.run.answered)
        self.put(replace(overlay, snap=drawing.snap if drawing else None))
        self.card.refresh(drawing, selected, "")

    def _own_call(self, number: int | None = None) -> OwnCall | None:
        """How far the run is, or one of its steps; before the first step only while something is asked."""
        run = self.stepped_run()
        if run is None or (run.number == 0 and not run.waiting and number is None):
            return None
        return run.own_call(number)

    def _composed(
        self,
        sheet: Sheet,
        active: AnyFigure | None,
        call: OwnCall | None,
        number: int | None,
        now: Tokens,
    ) -> Composition:
        shown = picture(sheet, now)
        if call is not None and active is not None and not call.ended:
            nothing = np.empty((0, 2), np.int64)
            shown = with_faint(shown, sheet, active, nothing, now, hidden=self.session.run.ask_first)
        drawn = [*scene(sheet, active, call is not None, self.card.codes.isChecked())]
        if call is not None:
            drawn += self.step_marks(number)
        return Composition(shown, packed(now.canvas), Overlay(drawn=tuple(drawn)))

    def on_paper(self, number: int | None = None) -> Composition:
        """The whole sheet, or one step of the run, in the light theme and without handles."""
        call = self._own_call(number) if number != 0 else None
        frames = self.session.frames
        return self._composed(frames.sheet, frames.figure, call, number, LIGHT)

    def describe(self, x: int, y: int) -> str:
        """A cell with its region code, and what painted it."""
        window = clip_box(self.sheet)
        said = super().describe(x, y)
        if window is None:
            return said
        code = region_code(x, y, *window)
        where = _("in the window") if code == 0 else _("outside the window")
        return _("{cell}, code {code}, {where}").format(cell=said, code=bits(code), where=where)
