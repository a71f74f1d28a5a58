"""Keeps the canvases and the card of a panel in step with the session and the run of its active figure."""

from dataclasses import replace
from html import escape

from PySide6.QtGui import QImage

from workbench.algorithms import catalogue
from workbench.algorithms.marks import Mark
from workbench.document.model import AnyFigure, Sheet
from workbench.document.state import FIGURES
from workbench.language import _
from workbench.panels.stage.card import ParameterCard, kind_title
from workbench.panels.stage.compose import (
    Composition,
    Progress,
    compose,
    painted,
    progress_at,
    with_answer,
    with_asked,
    with_band,
    with_selection,
)
from workbench.panels.stage.gesture import HandleDrag, Tool
from workbench.panels.stage.pages import Page
from workbench.panels.stage.picture import painters
from workbench.panels.stage.tools import FigureTool
from workbench.rendering.comparing import Comparison, figure_pixels
from workbench.rendering.subjects.registry import marks_on_device
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Cell, Overlay
from workbench.widgets.canvas.painter import Picture
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.transform_frame import TransformFrame
from workbench.widgets.look.tokens import LIGHT, tokens


class FigureView:
    """Shows a session on canvases and card: ``refresh`` after anything changed.

    A panel may add to what is drawn of the run, and show more beside the canvas.
    """

    def __init__(
        self, session: Session, canvas: PixelCanvas, second: PixelCanvas, card: ParameterCard
    ) -> None:
        self.session = session
        self.canvas, self.second, self.card = canvas, second, card
        self.comparison: Comparison | None = None
        self.box: TransformFrame | None = None

    @property
    def sheet(self) -> Sheet:
        """What is painted."""
        return self.session.shown

    @property
    def active(self) -> AnyFigure | None:
        """The active figure as it is painted."""
        return self.session.shown_figure

    def refresh(self, tool: Tool, drag: HandleDrag) -> None:
        """Everything anew, from the session alone."""
        session = self.session
        sheet, active = self.sheet, self.active
        progress = None if tool.busy or drag.busy else self.progress()
        compared = self.compared()
        still = not session.frames.playing  # ideal lines of another frame every 16 ms are seen by nobody
        beside = self.card.side_by_side.isChecked()
        made = compose(sheet, active, progress, compared, tokens(), beside, outlined=still)
        made = self.completed(made, progress)
        self.comparison = made.comparison
        chosen = set(session.state.selection)
        selected = [figure for figure in session.frames.sheet.figures if figure.id in chosen]
        overlay = with_band(with_selection(made.overlay, sheet, selected, drag.held), tool.band)
        overlay = with_answer(with_asked(overlay, session.state.asked(FIGURES)), session.run.answered)
        snap = tool.snap if isinstance(tool, FigureTool) else None
        self.canvas.set_picture(made.pixels, made.background)
        self.put(replace(overlay, snap=snap))
        self.second.setVisible(made.beside is not None)
        if made.beside is not None:
            self.second.set_picture(made.pixels, made.background)
            self.second.set_overlay(made.beside)
        self.card.refresh(tool if isinstance(tool, FigureTool) else None, selected, self.summary())
        if not tool.busy and not drag.busy:
            self.show_beside(active, compared, progress)

    def put(self, overlay: Overlay) -> None:
        """Show marks on the canvas; a box around what is selected lies over them, with the only handles."""
        if self.box is not None and self.box.box is not None:
            overlay = self.box.over(replace(overlay, handles=()))
        self.canvas.set_overlay(overlay)

    def completed(
        self, made: Composition, progress: Progress | None, number: int | None = None
    ) -> Composition:
        """What is shown, now or at a step, with what is drawn of the run; a panel may add to it."""
        if progress is None or made.comparison is not None:
            return made
        overlay = made.overlay
        return replace(made, overlay=replace(overlay, drawn=(*overlay.drawn, *self.step_marks(number))))

    def show_beside(self, active: AnyFigure | None, compared: str, progress: Progress | None) -> None:
        """Bring what stands beside the canvas up to date; not while something is being drawn."""

    def stepped_run(self) -> Run | None:
        """The session's run when it is that of the active figure and something of it is recorded.

        A run that waits, as under a drag, may still be of a picture of another size: that is not this one's.
        """
        run, active, subject = self.session.run, self.active, self.session.subject
        here = active is not None and active.id in subject.ids and subject.is_of(run.subject)
        fits = run.image_size == (self.sheet.width_px, self.sheet.height_px)
        return run if here and fits and run.step is not None else None

    def progress(self) -> Progress | None:
        """How far the run has come; None before its first step, when the picture is shown whole."""
        run = self.stepped_run()
        if run is None or run.step is None or (run.number == 0 and not run.ask_first):
            return None
        made = progress_at(run, run.step.number)
        if made is None:
            return None
        if run.detail and run.moment is not None:
            made = replace(made, reached=painted(run, len(run.moment.emitted)))
        follower = self.session.followers[0]
        if self.compared() and follower.moment is not None:
            made = replace(made, second=painted(follower, len(follower.moment.emitted)))
        return replace(made, hidden=run.ask_first)

    def step_marks(self, number: int | None = None) -> tuple[Mark, ...]:
        """What the run's algorithm draws at the cursor, or at the end of a step, device coordinates."""
        run = self.stepped_run()
        if run is None or run.entry is None or run.subject is None:
            return ()
        return marks_on_device(self.sheet, run.subject, run.entry.frame, run.marks(number))

    def compared(self) -> str:
        """The slug of the second algorithm, when there is one that can draw the active figure."""
        active, slug = self.active, self.session.state.compare
        fits = active is not None and slug in active.algorithms and slug != active.drawn_with
        return slug if fits else ""

    def on_paper(self, number: int | None = None) -> Composition:
        """The whole sheet, or one step of the run, in the light theme and without handles."""
        run = self.stepped_run()
        progress = self.progress() if number is None or run is None else progress_at(run, number)
        frames = self.session.frames
        made = compose(frames.sheet, frames.figure, progress, self.compared(), LIGHT)
        return self.completed(made, progress, number)

    def page(self, number: int | None, caption: str) -> Page:
        """What the canvas shows now, or at one step of the run, over a sentence."""
        made = self.on_paper(number)
        return Page(Picture(made.pixels, made.background), made.overlay, caption)

    def grab_picture(self) -> QImage:
        """What the canvas shows, as it is seen."""
        return self.canvas.grab_picture()

    def answer(self, cell: Cell) -> bool:
        """*Ask first*: ``cell`` is what the person expects next; False when nothing was asked."""
        run = self.session.run
        if not run.waiting or run.options:
            return False
        run.answer(*cell)
        return True

    def summary(self) -> str:
        """What the comparison found, with the mark of each kind of pixel."""
        active, result = self.active, self.comparison
        if active is None or result is None:
            return ""
        now = tokens()
        first, second = (
            escape(_(catalogue.get(slug).title)) for slug in (active.drawn_with, self.compared())
        )
        lines = [
            (now.agreement, "■", _("{n} pixels agree").format(n=len(result.both))),
            (now.data[0], "◪", _("{n} only {title}").format(n=len(result.only_first), title=first)),
            (now.data[1], "⬔", _("{n} only {title}").format(n=len(result.only_second), title=second)),
            (now.muted, "◈", _("{n} ties: exactly halfway").format(n=result.ties)),
        ]
        return "<br>".join(f'<span style="color:{ink}">{mark}</span> {text}' for ink, mark, text in lines)

    def emitted_cell(self, number: int) -> Cell | None:
        """The pixel that the active figure's algorithm paints as its ``number``-th; None without one."""
        active = self.active
        cells = [] if active is None else figure_pixels(self.sheet, active).tolist()
        return (cells[number][0], cells[number][1]) if 0 <= number < len(cells) else None

    def describe(self, x: int, y: int) -> str:
        """A cell's name and what painted it."""
        sheet = self.sheet
        inside = 0 <= x < sheet.width_px and 0 <= y < sheet.height_px
        index = int(painters(sheet, tokens())[y, x]) if inside else -1
        if index < 0:
            return f"({x}, {y})"
        figure = sheet.figures[index]
        title = _(catalogue.get(figure.drawn_with).title)
        name = figure.name or kind_title(figure)
        return _("({x}, {y}) {name}, {title}").format(x=x, y=y, name=name, title=title)
