"""The Draw panel: lines, circles, ellipses, polylines on a pixel canvas, drawn, typed and compared."""

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSplitter, QWidget

from workbench.language import _
from workbench.panels.draw_export import Exporter
from workbench.panels.draw_view import DrawView
from workbench.panels.figure_card import ParameterCard
from workbench.panels.figure_panel import FigurePanel
from workbench.panels.figure_tools import (
    CircleTool,
    EllipseTool,
    FigureTool,
    LineTool,
    PolylineTool,
    SelectTool,
)
from workbench.session.session import Session
from workbench.widgets.canvas_surface import CanvasSurface
from workbench.widgets.distance_plot import DistancePlot
from workbench.widgets.pixel_canvas import PixelCanvas


class DrawPanel(FigurePanel):
    """Canvas, tools and card over one session."""

    slug = "draw"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (SelectTool, LineTool, CircleTool, EllipseTool, PolylineTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Draw")
        self._sharing = False
        self.second = PixelCanvas()
        self.second.hide()
        self.card = ParameterCard(session, self.canvas)
        self.plot = DistancePlot()
        self.view = DrawView(session, self.canvas, self.second, self.card, self.plot)
        self.exporter = Exporter(self.view, self)
        self._split = QSplitter(Qt.Orientation.Horizontal)
        self._split.setChildrenCollapsible(False)
        self._split.addWidget(self.canvas)
        self._split.addWidget(self.second)
        self._connect()
        exporter = self.exporter
        self.begin(
            self._split,
            self.card,
            _("Drag on the canvas to draw a line."),
            [
                ("copy_picture", _("Copy picture"), "clipboard", "Ctrl+Shift+C", exporter.copy_picture),
                ("save_step", _("Save this step..."), "image-square", "", exporter.save_step),
                ("save_run", _("Save this run..."), "files", "", exporter.save_run),
                ("save_pixels", _("Save pixels as CSV..."), "table", "", exporter.save_pixels),
            ],
        )

    def docks(self) -> list[tuple[str, str, QWidget, Qt.DockWidgetArea]]:
        """The plot of the distances."""
        title = _("Distance from the ideal curve")
        return [("distance", title, self.plot, Qt.DockWidgetArea.BottomDockWidgetArea)]

    def show_example(self) -> None:
        """Open the picture with one line."""
        self.session.open_example("line")
        figures = self.session.sheet.figures
        if figures:
            self.session.update_state(active=figures[0].id)

    def _connect(self) -> None:
        self.session.run.moved.connect(self.view.forget_answers)
        self.exporter.said.connect(self.hover_text)
        self.card.side_by_side_changed.connect(self.refresh_soon)
        self.card.folded.connect(self.leave_room)
        self.card.algorithm_chosen.connect(self._choose_algorithm)
        self.plot.pixel_wanted.connect(self._go_to_emission)
        self.plot.shown.connect(self.refresh_soon)
        for one, other in ((self.canvas, self.second), (self.second, self.canvas)):
            one.view_changed.connect(partial(self._share_view, one, other))

    def _share_view(self, one: CanvasSurface, other: CanvasSurface, _percent: float) -> None:
        """Both pictures side by side show the same cells; the first one fits, with room for the card."""
        if self.second.isHidden() or self._sharing:
            return
        self._sharing = True
        if one is self.second and one.keeps_fit:
            one.look_like(other)
        else:
            other.look_like(one)
        self._sharing = False

    def show_now(self) -> None:
        """Canvases, card and plot as the session is now."""
        self.view.refresh(self.tool, self.handle_drag)
        for name in ("save_run", "save_pixels"):
            self._actions[name].setEnabled(self.session.active_figure is not None)

    def describe(self, x: int, y: int) -> str:
        """A cell's name and what painted it."""
        return self.view.describe(x, y)

    def clicked(self, x: int, y: int) -> None:
        """With *Ask first* a click on a cell answers."""
        if self.view.answer((x, y)):
            self.refresh()

    def _choose_algorithm(self, slug: str) -> None:
        if isinstance(self.tool, FigureTool):
            self.tool.algorithm = slug
            self.refresh()

    def _go_to_emission(self, number: int) -> None:
        active = self.session.active_figure
        if active is not None:
            self.session.run.run_to_pixel(*self.view.emitted_cell(active, number))
