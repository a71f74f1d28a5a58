"""A panel of figures whose algorithms are stepped and compared: two canvases, export, *Ask first*."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QSplitter, QWidget

from workbench.language import _
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.clipboard import copy_figures, paste_figures
from workbench.panels.stage.export import Exporter
from workbench.panels.stage.gesture import Tool
from workbench.panels.stage.panel import FigurePanel
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.view import FigureView
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.surface import CanvasSurface


class SteppedPanel(FigurePanel):
    """Adds a second canvas for what is compared, the commands of export, and answers by clicks.

    A panel makes its ``card`` and ``view`` and then calls ``start``.
    """

    card: ParameterCard
    view: FigureView
    exporter: Exporter

    def __init__(self, session: Session, tools: Sequence[Tool], parent: QWidget | None = None) -> None:
        super().__init__(session, tools, parent)
        self._sharing = False
        self.second = PixelCanvas()
        self.second.hide()

    def start(self, invitation: str, commands: Sequence[PanelCommand] = ()) -> None:
        """Lay out and connect what the panel has made."""
        self.exporter = exporter = Exporter(self.view, self)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.setChildrenCollapsible(False)
        split.addWidget(self.canvas)
        split.addWidget(self.second)
        exporter.said.connect(self.hover_text)
        self.card.side_by_side_changed.connect(self.refresh_soon)
        self.card.folded.connect(self.leave_room)
        self.card.algorithm_chosen.connect(self._choose_algorithm)
        for one, other in ((self.canvas, self.second), (self.second, self.canvas)):
            one.view_changed.connect(partial(self._share_view, one, other))
        self.begin(
            split,
            self.card,
            invitation,
            [
                ("copy_picture", _("Copy picture"), "clipboard", "Ctrl+Shift+C", exporter.copy_picture),
                *commands,
            ],
        )

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
        """Canvases and card as the session is now, and what the panel shows beside them."""
        self.view.refresh(self.tool, self.handle_drag)

    def copy(self) -> bool:
        """Put the selected figures on the clipboard, or with none selected the picture."""
        if chosen := self.selected():
            self.hover_text.emit(copy_figures(chosen))
        else:
            self.exporter.copy_picture()
        return True

    def paste(self) -> bool:
        """Put the figures of the clipboard on the sheet."""
        if not self.gesturing:
            paste_figures(self.session, self.hover_text.emit)
        return True

    def offer_export(self, menu: QMenu) -> None:
        """Let the canvas's menu lead to what can be exported."""
        self.canvas.addAction(menu.menuAction())

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
