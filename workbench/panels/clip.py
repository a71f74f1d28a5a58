"""The Clip panel: a window dragged by hand, and what the clippers keep of lines, polygons and points."""

from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from workbench.algorithms.clipping.edges import region_code
from workbench.document.edits import set_clip
from workbench.language import _
from workbench.panels.clip_card import ClipCard
from workbench.panels.clip_run import clip_moment, run_marks
from workbench.panels.clip_scene import code_text, scene
from workbench.panels.clip_window import (
    ClipDrag,
    ClipSelectTool,
    PointTool,
    WindowTool,
    usual_window,
    window_handles,
)
from workbench.panels.figure_outline import handles
from workbench.panels.figure_panel import FigurePanel
from workbench.panels.figure_picture import packed, picture, with_faint
from workbench.panels.figure_tools import FigureTool, LineTool, PolygonTool, PolylineTool
from workbench.rendering.clipping import clip_box
from workbench.session.session import Session
from workbench.widgets.canvas_drawing import Drawn
from workbench.widgets.canvas_overlay import Handle, Overlay
from workbench.widgets.tokens import tokens

EXAMPLE = "clip"


class ClipPanel(FigurePanel):
    """Canvas, tools and card; the stepped run is that of the clipper on the active figure."""

    slug = "clip"
    first_tool = "window"
    stepped = "clipper"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (ClipSelectTool, WindowTool, LineTool, PolylineTool, PolygonTool, PointTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Clip")
        self.handle_drag = ClipDrag(session)
        self.card = ClipCard(session, self.canvas)
        self.card.folded.connect(self.leave_room)
        self.card.codes.toggled.connect(self.refresh_soon)
        self.card.window_wanted.connect(self.add_window)
        self.begin(
            self.canvas,
            self.card,
            _("Drag on the canvas to draw the clip window, then lines across it."),
            [
                (
                    "codes",
                    _("Region codes"),
                    "hash",
                    "R",
                    lambda: self.card.codes.setChecked(not self.card.codes.isChecked()),
                ),
                ("copy_picture", _("Copy picture"), "clipboard", "Ctrl+Shift+C", self.copy_picture),
            ],
        )

    def docks(self) -> list[tuple[str, str, QWidget, Qt.DockWidgetArea]]:
        """None of its own."""
        return []

    def show_example(self) -> None:
        """Open the lines at a window."""
        self.session.open_example(EXAMPLE)
        self.session.update_state(active=self.session.sheet.figures[0].id)

    def showEvent(self, event: QShowEvent) -> None:
        """A sheet without a window asks for one."""
        super().showEvent(event)
        self._ask_for_window()

    def _ask_for_window(self) -> None:
        if self.session.sheet.clip_world is None and self.isVisible() and not self.gesturing:
            self.choose_tool("window")

    def _release(self, x: float, y: float, modifiers: Any) -> None:
        """Once the window is drawn, lines are drawn across it."""
        drew = isinstance(self.tool, WindowTool) and self.tool.busy
        super()._release(x, y, modifiers)
        if drew and self.session.sheet.clip_world is not None:
            self.choose_tool("select" if self.session.sheet.figures else "line")

    def copy_picture(self) -> None:
        """Put what the canvas shows on the clipboard."""
        from PySide6.QtGui import QGuiApplication

        QGuiApplication.clipboard().setImage(self.canvas.grab_picture())
        self.hover_text.emit(_("The picture is on the clipboard."))

    def add_window(self) -> None:
        """Give the sheet a clip window over its middle."""
        self.apply(set_clip(self.session.sheet.id, usual_window(self.session.sheet)), _("Add a clip window"))
        self.choose_tool("select" if self.session.sheet.figures else "line")

    def show_now(self) -> None:
        """Canvas and card as the session is now."""
        session, now = self.session, tokens()
        sheet, active = session.sheet, session.active_figure
        run = session.run
        busy = self.gesturing
        ours = active is not None and run.figure_id == active.id and not busy
        moment = clip_moment(run) if ours else None
        shown = picture(sheet, now)
        if moment is not None and active is not None and not moment.ended:
            empty = shown[:0].reshape(0, 2).astype("int64")
            shown = with_faint(shown, sheet, active, empty, now, hidden=run.ask_first)
        asking = run.waiting and ours
        drawn: list[Drawn] = list(
            scene(sheet, active, moment is not None or asking, self.card.codes.isChecked())
        )
        if moment is not None:
            drawn += run_marks(moment)
        chosen = self.selected()
        grips: list[Handle] = window_handles(sheet, self.held)
        for figure in chosen:
            grips += handles(sheet, figure, self.held)
        overlay = Overlay(drawn=tuple(drawn), handles=tuple(grips))
        if self.tool.band is not None:
            overlay = replace(overlay, outlined=(self.tool.band,))
        tool = self.tool if isinstance(self.tool, FigureTool) else None
        if tool is not None:
            overlay = replace(overlay, snap=tool.snap)
        self.first_tool = "window" if sheet.clip_world is None else "line"
        self.canvas.set_picture(shown, packed(now.canvas))
        self.canvas.set_overlay(overlay)
        self.card.refresh(tool, chosen, "")

    @property
    def held(self) -> str:
        """The handle or grip that is being dragged."""
        side = self.tool.side.held if isinstance(self.tool, ClipSelectTool) else ""
        return self.handle_drag.held or side

    def describe(self, x: int, y: int) -> str:
        """A cell with its region code, and what became of it."""
        window = clip_box(self.session.sheet)
        if window is None:
            return f"({x}, {y})"
        code = region_code(x, y, *window)
        where = _("inside") if code == 0 else _("outside")
        return _("({x}, {y}) code {code}, {where}").format(x=x, y=y, code=code_text(code), where=where)
