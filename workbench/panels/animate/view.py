"""What the Animate panel shows: the sheet in its frame, the path and the ghosts of the figure that moves."""

from dataclasses import replace

from workbench.algorithms.marks import Mark
from workbench.algorithms.visibility import depth_buffer
from workbench.document.model import AnyFigure
from workbench.engine.compiled import ready
from workbench.panels.animate.path import alone, ghosts, path_marks
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.compose import Composition, Progress
from workbench.panels.stage.view import FigureView
from workbench.rendering.scene.backdrop import with_scene
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas

USUAL_REACH = 9


class AnimateView(FigureView):
    """Shows a session on canvases and card; ``reach``: how many frames before and after are ghosts.

    ``target`` is that of the chosen track.
    """

    def __init__(
        self, session: Session, canvas: PixelCanvas, second: PixelCanvas, card: ParameterCard
    ) -> None:
        super().__init__(session, canvas, second, card)
        self.reach = USUAL_REACH
        self.target = ""

    def stepped_run(self) -> Run | None:
        """The session's run when it is that of a track and something of it is recorded."""
        run = self.session.run
        return (
            run if run.subject is not None and run.subject.kind == "track" and run.step is not None else None
        )

    def progress(self) -> Progress | None:
        """None: what is stepped are numbers and outlines, never the pixels of the picture."""
        return None

    def compared(self) -> str:
        """Nothing."""
        return ""

    def completed(
        self, made: Composition, progress: Progress | None, number: int | None = None
    ) -> Composition:
        """With the scene, once its text is compiled, the path, the ghosts, and what the run draws."""
        overlay = made.overlay
        run = self.stepped_run()
        stepped: tuple[Mark, ...] = ()
        if run is not None and (number is not None or run.number > 0):
            stepped = self.step_marks(number)
        pixels = made.pixels
        if self.sheet.scene is not None and ready(depth_buffer):
            pixels = with_scene(pixels, self.sheet)
        drawn = (*overlay.drawn, *self._moving(), *stepped)
        return replace(made, pixels=pixels, overlay=replace(overlay, ideal=(), drawn=drawn))

    def _point(self, figure: AnyFigure) -> str:
        """The point whose path is drawn: the one that the chosen track moves, where it moves one."""
        name, *rest = self.target.split("/")
        points = {point.id for point in figure.points_world}
        return rest[0] if name == figure.id and rest and rest[0] in points else ""

    def _moving(self) -> tuple[Mark, ...]:
        figure, frames = self.session.active_figure, self.session.frames
        if figure is None or self.session.sheet.motion is None:
            return ()
        own = alone(self.session.sheet, figure)
        if own.motion is None or not own.motion.tracks:
            return ()
        reach = 0 if frames.playing else self.reach
        return (
            *ghosts(own, frames.number, reach),
            *path_marks(own, frames.number, self._point(own.figures[0])),
        )
