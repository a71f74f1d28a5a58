"""The Clip panel: a window dragged by hand, and what the clippers keep of lines, polygons and points."""

from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from workbench.document.edits import set_clip
from workbench.document.model import AnyFigure
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.clip.card import ClipCard
from workbench.panels.clip.view import ClipView
from workbench.panels.clip.window import ClipDrag, ClipSelectTool, PointTool, WindowTool, usual_window
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.stepped import SteppedPanel
from workbench.panels.stage.tools import LineTool, PolygonTool, PolylineTool
from workbench.rendering.clipping import clippers_of
from workbench.session.session import Session

EXAMPLE = "clip"


class ClipPanel(SteppedPanel):
    """Canvas, tools and card; the stepped run is that of the clipper on the active figure."""

    slug = "clip"
    first_tool = "window"
    usual = Subject("clipper")
    card: ClipCard

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (ClipSelectTool, WindowTool, LineTool, PolylineTool, PolygonTool, PointTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Clip")
        self.handle_drag = ClipDrag(session)
        self.card = ClipCard(session, self.canvas)
        self.view = ClipView(session, self.canvas, self.second, self.card)
        self.card.codes.toggled.connect(self.refresh_soon)
        self.card.window_wanted.connect(self.add_window)
        self.start(
            _("Drag on the canvas to draw the clip window, then lines across it."),
            [("codes", _("Region codes"), "hash", "Shift+R", self.card.codes.toggle)],
        )

    def serves(self, figure: AnyFigure) -> bool:
        """What a clipper works on."""
        return bool(clippers_of(figure))

    def show_example(self) -> None:
        """Open the lines at a window."""
        self.session.open_example(EXAMPLE)
        self.session.update_state(active=self.session.sheet.figures[-1].id)

    def showEvent(self, event: QShowEvent) -> None:
        """A sheet without a window asks for one."""
        super().showEvent(event)
        self._take_tool_when_empty()

    def _take_tool_when_empty(self) -> None:
        """A sheet without a window asks for one first, one with a window and no figures for a line."""
        if not self.isVisible() or self.gesturing:
            return
        if self.session.sheet.first_view.clip_world is None:
            if not isinstance(self.tool, WindowTool):
                self.choose_tool("window")
        elif not self.session.sheet.figures and isinstance(self.tool, ClipSelectTool):
            self.choose_tool("line")
        elif isinstance(self.tool, WindowTool):
            self._after_window()

    def _release(self, x: float, y: float, modifiers: Modifiers) -> None:
        """Once the window is drawn, lines are drawn across it."""
        drew = isinstance(self.tool, WindowTool) and self.tool.busy
        super()._release(x, y, modifiers)
        if drew and self.session.sheet.first_view.clip_world is not None:
            self._after_window()

    def _after_window(self) -> None:
        self.choose_tool("select" if self.session.sheet.figures else "line")

    def add_window(self) -> None:
        """Give the sheet a clip window over its middle."""
        self.apply(
            set_clip(self.session.sheet.first_view.id, usual_window(self.session.sheet)),
            _("Add a clip window"),
        )
        self._after_window()
