"""The Draw panel: lines, circles, ellipses, polylines on a pixel canvas, drawn, typed and compared."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.draw.view import DrawView
from workbench.panels.panel import DockPart
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.stepped import SteppedPanel
from workbench.panels.stage.tools import (
    CircleTool,
    EllipseTool,
    LineTool,
    PolylineTool,
    SelectTool,
)
from workbench.session.session import Session
from workbench.widgets.plots.distance_plot import DistancePlot


class DrawPanel(SteppedPanel):
    """Canvas, tools and card over one session, and the plot of the distances."""

    slug = "draw"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (SelectTool, LineTool, CircleTool, EllipseTool, PolylineTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Draw")
        self.card = ParameterCard(session, self.canvas)
        self.plot = DistancePlot()
        self.plot.pixel_wanted.connect(self._go_to_emission)
        self.plot.shown.connect(self.refresh_soon)
        self.view = DrawView(session, self.canvas, self.second, self.card, self.plot)
        self.start(_("Drag on the canvas to draw a line."))

    def docks(self) -> list[DockPart]:
        """The plot of the distances."""
        title = _("Distance")
        return [("distance", title, self.plot, Qt.DockWidgetArea.BottomDockWidgetArea)]

    def show_example(self) -> None:
        """Open the picture with one line."""
        self.session.open_example("line")
        figures = self.session.sheet.figures
        if figures:
            self.session.update_state(active=figures[0].id)

    def _go_to_emission(self, number: int) -> None:
        cell = self.view.emitted_cell(number)
        if cell is not None:
            self.session.run.run_to_pixel(*cell)
