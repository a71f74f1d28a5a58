"""The Fill panel: polygons by scan lines, areas from a seed, and the test of one point."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from workbench.algorithms.catalogue import entries
from workbench.document.model import AnyFigure, SeedFill
from workbench.language import _
from workbench.panels.fill.card import FillCard
from workbench.panels.fill.tools import (
    AreaCircleTool,
    AreaEllipseTool,
    BoundaryLineTool,
    BrushTool,
    FillPolygonTool,
    InsideTool,
    SeedTool,
)
from workbench.panels.fill.view import FillView
from workbench.panels.panel import DockPart
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.stepped import SteppedPanel
from workbench.panels.stage.tools import SelectTool
from workbench.session.session import Session
from workbench.widgets.plots.depth_plot import DepthPlot

SPANS = frozenset(entry.slug for entry in entries() if entry.emits == "spans")


class FillPanel(SteppedPanel):
    """Canvas, tools and card over one session, and the plot of the stack's depth."""

    slug = "fill"
    first_tool = "polygon"
    card: FillCard

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        self.inside = InsideTool(session)
        drawing = (
            FillPolygonTool,
            AreaCircleTool,
            AreaEllipseTool,
            BrushTool,
            BoundaryLineTool,
            SeedTool,
        )
        tools = [SelectTool(session), *(kind(session) for kind in drawing), self.inside]
        super().__init__(session, tools, parent)
        self.title = _("Fill")
        card = FillCard(session, self.canvas)
        card.heat_changed.connect(self.refresh_soon)
        self.plot = DepthPlot()
        self.plot.step_wanted.connect(self._go_to_counted)
        self.plot.shown.connect(self.refresh_soon)
        self.card = card
        self.view = FillView(
            session, self.canvas, self.second, card, self.plot, self.inside, self.refresh_soon
        )
        self.start(
            _("Click the corners of a polygon one after another; Enter closes it."),
            [("heat", _("How often each pixel was tested"), "thermometer", "H", card.heat.toggle)],
        )

    def docks(self) -> list[DockPart]:
        """The plot of the stack's depth."""
        return [("depth", _("Depth of the stack"), self.plot, Qt.DockWidgetArea.BottomDockWidgetArea)]

    def serves(self, figure: AnyFigure) -> bool:
        """Areas, and fills from a seed."""
        return isinstance(figure, SeedFill) or figure.drawn_with in SPANS

    def show_example(self) -> None:
        """Open the triangle of the course."""
        self.session.open_example("triangle")
        figures = self.session.sheet.figures
        if figures:
            self.session.update_state(active=figures[-1].id)

    def _go_to_counted(self, step: int) -> None:
        """Go to a step of the whole run that is recorded, as its depth is known."""
        self.session.run.go_to_step(step - self.session.run.passed)

    def _press(self, x: float, y: float, modifiers: Modifiers) -> None:
        super()._press(x, y, modifiers)
        if self.tool is self.inside:
            self.refresh_soon()

    def _move(self, x: float, y: float, modifiers: Modifiers) -> None:
        super()._move(x, y, modifiers)
        if self.tool is self.inside and self.canvas.dragging:
            self.refresh_soon()
        self.canvas.set_tag(self.tool.tag)
