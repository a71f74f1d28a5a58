"""What the Draw panel shows beside its canvas: how far the pixels lie from the ideal curve."""

from workbench.algorithms import catalogue
from workbench.document.model import AnyFigure
from workbench.language import _
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.compose import Progress
from workbench.panels.stage.view import FigureView
from workbench.rendering.comparing import distances
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.plots.distance_plot import DistancePlot


class DrawView(FigureView):
    """Shows a session on canvases, card and ``plot``."""

    def __init__(
        self,
        session: Session,
        canvas: PixelCanvas,
        second: PixelCanvas,
        card: ParameterCard,
        plot: DistancePlot,
    ) -> None:
        super().__init__(session, canvas, second, card)
        self.plot = plot

    def show_beside(self, active: AnyFigure | None, compared: str, progress: Progress | None) -> None:
        """Plot the distances of what is active, with a mark at the pixel painted last."""
        if not self.plot.isVisible():
            return
        if active is None:
            self.plot.show_distances([])
            return
        slugs = [active.drawn_with, *([compared] if compared else [])]
        sheet = self.sheet
        self.plot.show_distances(
            [(_(catalogue.get(slug).title), distances(sheet, active, slug)) for slug in slugs]
        )
        painted = 0 if progress is None else len(progress.reached)
        self.plot.show_cursor(painted - 1 if painted else None)
