"""What the Animate panel shows: the sheet in its frame, the path and the ghosts of the figure that moves."""

from dataclasses import replace

from workbench.algorithms.marks import Mark, Spot
from workbench.document.model import AnyFigure, Sheet
from workbench.panels.animate.path import (
    alone,
    equation_marks,
    ghosts,
    keyed_places,
    marked_places,
    path_marks,
)
from workbench.panels.animate.physics import equation_of
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.compose import Composition, Progress
from workbench.panels.stage.view import FigureView
from workbench.rendering.scene.backdrop import can_be_lit, with_scene
from workbench.rendering.subjects.track import is_of_a_track
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import GripShape, Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas

USUAL_REACH = 9
ON_PATH = "path/"
_MOST_GRIPS = 60


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
            run if run.subject is not None and is_of_a_track(run.subject) and run.step is not None else None
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
        if self.sheet.scene is not None and can_be_lit(self.sheet):
            pixels = with_scene(pixels, self.sheet)
        drawn = (*overlay.drawn, *self._moving(), *stepped)
        return replace(made, pixels=pixels, overlay=replace(overlay, ideal=(), drawn=drawn))

    def _point(self, figure: AnyFigure) -> str:
        """The point whose path is drawn: the one that the chosen track moves, where it moves one."""
        name, *rest = self.target.split("/")
        points = {point.id for point in figure.points_world}
        return rest[0] if name == figure.id and rest and rest[0] in points else ""

    def put(self, overlay: Overlay) -> None:
        """With every mark of the path to drag, those of keys as handles; that of this frame is the figure."""
        own, frames = self._own, self.session.frames
        boxed = self.box is not None and self.box.box is not None
        if own is not None and not (frames.playing or boxed) and (point := self.held_point):
            drawn = self._point(own.figures[0])
            keyed = keyed_places(own, drawn, point)
            keyed = keyed if len(keyed) <= _MOST_GRIPS else {}
            shapes: dict[int, GripShape] = dict.fromkeys(keyed, "square")
            grips = [
                Handle(f"{ON_PATH}{frame}", "", x, y, shape=shapes.get(frame, "mark"))
                for frame, (x, y) in (marked_places(own, drawn) | keyed).items()
                if frame != frames.number
            ]
            overlay = replace(overlay, handles=(*grips, *overlay.handles))
        super().put(overlay)

    @property
    def held_point(self) -> str:
        """The point by which the path is dragged: the one that moves on it, or the only one of the figure."""
        own = self._own
        if own is None:
            return ""
        points = own.figures[0].points_world
        return self._point(own.figures[0]) or (points[0].id if len(points) == 1 else "")

    @property
    def _own(self) -> Sheet | None:
        """The figure whose path is shown and its tracks; None where it has none."""
        figure = self.session.active_figure
        if figure is None or self.session.sheet.motion is None:
            return None
        own = alone(self.session.sheet, figure)
        return own if own.motion is not None and own.motion.tracks else None

    def _moving(self) -> tuple[Mark, ...]:
        own, frames = self._own, self.session.frames
        if own is None:
            return ()
        if self.session.run.waiting:  # frames to come would tell
            places = keyed_places(own, self._point(own.figures[0])).values()
            return tuple(Spot(x, y, "accent", "square", "small") for x, y in places)
        reach = 0 if frames.playing else self.reach
        equation = None if frames.playing else equation_of(own, self.target)
        beside = (
            []
            if equation is None
            else equation_marks(own, equation, frames.number, self._point(own.figures[0]))
        )
        return (
            *beside,
            *ghosts(own, frames.number, reach),
            *path_marks(own, frames.number, self._point(own.figures[0])),
        )
