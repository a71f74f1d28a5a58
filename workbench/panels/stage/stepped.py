"""A panel of figures whose algorithms are stepped and compared: two canvases, export, answers, the box."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from workbench.language import _
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.boxing import Boxing
from workbench.panels.stage.card import ParameterCard
from workbench.panels.stage.clipboard import copy_figures, paste_figures
from workbench.panels.stage.export import Exporter
from workbench.panels.stage.gesture import Tool
from workbench.panels.stage.panel import FigurePanel
from workbench.panels.stage.tools import FigureTool
from workbench.panels.stage.transforming import BOX, MOTIONS, ON_CHAINS, transform_commands
from workbench.panels.stage.view import FigureView
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.look.split import Split


class SteppedPanel(FigurePanel):
    """Adds a second canvas for what is compared, the commands of export, answers by clicks, and the box that
    transforms what is selected, which is there instead of single handles while it is switched on.

    A panel makes its ``card`` and ``view`` and then calls ``start``. One that has a box of its own, which
    writes chains, sets ``moves_points`` to False.
    """

    card: ParameterCard
    view: FigureView
    paper: Exporter
    moves_points = True

    def __init__(self, session: Session, tools: Sequence[Tool], parent: QWidget | None = None) -> None:
        super().__init__(session, tools, parent)
        self._sharing = False
        self.second = PixelCanvas()
        self.second.hide()
        self.boxing = self.make_boxing()
        commands = transform_commands(self.boxing, self.toggle_box)
        self.transforms = [each for each in commands if self.moves_points or each[0] in ON_CHAINS]

    def make_boxing(self) -> Boxing:
        """What transforms what is selected here, by whole pixels where it is only moved."""
        return Boxing(self.session, self.canvas, self.tools[0], whole_moves=True)

    def start(self, invitation: str, commands: Sequence[PanelCommand] = ()) -> None:
        """Lay out and connect what the panel has made."""
        self.exporter = self.paper = exporter = Exporter(self.view, self)
        split = Split(Qt.Orientation.Horizontal)
        split.addWidget(self.canvas)
        split.addWidget(self.second)
        exporter.said.connect(self.hover_text)
        self.card.side_by_side_changed.connect(self.refresh_soon)
        self.card.folded.connect(self.leave_room)
        self.card.algorithm_chosen.connect(self._choose_algorithm)
        self.view.box = self.boxing.box if self.moves_points else None
        self.card.chain.bake_wanted.connect(self.boxing.bake)
        self.card.chain.removal_wanted.connect(self.boxing.remove)
        self.boxing.said.connect(self.hover_text)
        self.boxing.began.connect(lambda: self.session.hold_runs(True))
        self.boxing.ended.connect(self._after_boxing)
        self.boxing.box.looks_changed.connect(self._look_at_box)
        for one, other in ((self.canvas, self.second), (self.second, self.canvas)):
            one.view_changed.connect(partial(self._share_view, one, other))
        self.begin(
            split,
            self.card,
            invitation,
            [
                ("cut", _("Cut"), "scissors", "", self.cut),
                ("copy", _("Copy"), "copy", "", self.copy),
                ("paste", _("Paste"), "clipboard-text", "", self.paste),
                ("copy_picture", _("Copy picture"), "clipboard", "Ctrl+Shift+C", exporter.copy_picture),
                *commands,
            ],
        )
        if self.moves_points:
            self._actions[BOX].setCheckable(True)
            self.card.form.connect_to(self.boxing, [self._actions[name] for name in MOTIONS])

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

    # The box

    def toggle_box(self) -> None:
        """Take up the box around what is selected, or lay it down."""
        on = not self.boxing.on
        self.choose_tool(self.tools[0].name)
        self.boxing.switch(on)
        self.refresh()

    def choose_tool(self, name: str) -> None:
        """Take up the tool of this name; the box is laid down."""
        self.boxing.switch(False)
        super().choose_tool(name)

    def let_go(self) -> None:
        """Escape: as everywhere, but the box is laid down before what is selected is let go.

        The canvas takes the focus of a field that goes with the selection.
        """
        focus = QApplication.focusWidget()
        if focus is not None and self.card.isAncestorOf(focus):
            self.canvas.setFocus()
        if self.boxing.on and not self.gesturing:
            self.choose_tool(self.tools[0].name)
        else:
            super().let_go()

    def _after_gesture(self) -> None:
        super()._after_gesture()
        if self.boxing.on:
            self.canvas.takes_handles = False

    def _look_at_box(self) -> None:
        """Show the box as it is, unless the document has changed with it, which is told and shown anyway."""
        if not self.tool.busy or self.boxing.moving is not None:
            self.refresh_soon()

    def _after_boxing(self) -> None:
        self.session.hold_runs(False)
        self._after_gesture()

    def transforming(self) -> list[QAction]:
        """The commands of the box, for a menu."""
        return [self._actions[name] for name, *_rest in self.transforms]

    def refresh(self) -> None:
        """As everywhere; only what is selected can be transformed."""
        super().refresh()
        chosen, on = self.selected(), self.isVisible()
        if self.moves_points:
            self._actions[BOX].setChecked(self.boxing.on)
            self._actions[self.tools[0].name].setChecked(self.tool is self.tools[0] and not self.boxing.on)
            for name in MOTIONS:
                self._actions[name].setEnabled(on and bool(chosen))
        for name in ON_CHAINS:
            self._actions[name].setEnabled(on and any(figure.transforms for figure in chosen))

    def show_now(self) -> None:
        """Canvases and card as the session is now, and what the panel shows beside them."""
        if (moving := self.boxing.moving) is not None:
            self.canvas.set_overlay(self.boxing.box.over(Overlay(outlined=tuple(moving))))
            return
        self.boxing.follow()
        self.card.form.refresh(self.boxing.pivot_world)
        self.view.refresh(self.tool, self.handle_drag)

    def copy(self) -> bool:
        """Put the selected figures on the clipboard, as they are drawn, or with none selected the picture."""
        sheet, chosen = self.session.sheet, {figure.id for figure in self.selected()}
        if chosen:
            figures = [figure for figure in sheet.figures if figure.id in chosen]
            self.hover_text.emit(copy_figures(sheet, figures))
        else:
            self.paper.copy_picture()
        return True

    def cut(self) -> bool:
        """Put what is selected on the clipboard and remove it; False where nothing is."""
        if not self.selected() or self.gesturing:
            return False
        self.copy()
        self.delete_selected()
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
