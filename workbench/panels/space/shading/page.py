"""The page Shading: a shading step by step on a coarse picture, beside it the scene at full size.

Four shadings can be shown side by side in their place.
"""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QGridLayout, QStackedWidget, QVBoxLayout, QWidget

from workbench.algorithms import catalogue
from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.language import _, ngettext
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.looking import Looking
from workbench.panels.space.shading.bar import ShadingBar
from workbench.panels.space.shading.derivation import derivation
from workbench.panels.space.shading.lamps_dock import LampsDock
from workbench.panels.space.shading.lit_view import LitView
from workbench.panels.space.shading.run import EndedLight, greys, light_so_far, rows_so_far
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.picture import packed
from workbench.panels.stage.plain_page import PlainPage
from workbench.panels.stage.pointed import Pointed
from workbench.rendering.scene.shading import LIT_SHADINGS
from workbench.rendering.subjects.registry import marks_on_device
from workbench.rendering.subjects.shading import KIND, call_of, lighting_of, model_of, shading_of
from workbench.rendering.subjects.visibility import USUAL_COLUMNS, fault_of, size_of
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.split import Split
from workbench.widgets.look.tokens import theme_changed, tokens
from workbench.widgets.stepping.step_bar import stepping_key

PAGE = "shading"


class ShadingPage(PlainPage, QWidget):
    """``hover_text``: what is under the pointer or said in passing; ``zoom_text``: the scale."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND, entry=LIT_SHADINGS[1], arguments={"columns": 24})
    example = "shading-ball"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.looking = Looking(session)
        self._waiting = False
        self._light = np.zeros((0, 0))
        self.ended = EndedLight(self)
        self.canvas = PixelCanvas()
        self.nothing = Invitation(self.canvas, _("This sheet has no scene."), self._show_example)
        self.view = LitView("")
        self.four = [LitView(_(catalogue.get(slug).title)) for slug in LIT_SHADINGS]
        for view in (self.view, *self.four):
            session.opened.connect(view.begin_anew)
        self.lamps = LampsDock(session)
        self.stack = QStackedWidget()
        beside = Split(Qt.Orientation.Horizontal)
        for widget in (self.canvas, self.view):
            beside.addWidget(widget)
            beside.setStretchFactor(beside.count() - 1, 1)
        beside.setSizes([1000, 1000])
        together = QWidget()
        grid = QGridLayout(together)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(1)
        for k, view in enumerate(self.four):
            grid.addWidget(view, k // 2, k % 2)
        self.stack.addWidget(beside)
        self.stack.addWidget(together)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.setFocusProxy(self.canvas)
        self._actions = self._made_actions()
        self.bar = ShadingBar(session, self.looking, self.together)
        column.addWidget(self.bar)
        column.addWidget(self.stack, 1)
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        self.together = self._action("four", _("Four shadings side by side"), "squares-four", "Shift+4")
        self.together.setCheckable(True)
        self.together.toggled.connect(self.show_four)
        fit = self._action("fit", _("Fit the picture"), "corners-out", "Ctrl+0")
        fit.triggered.connect(lambda _checked=False: self.fit())
        for view in (self.canvas, self.view, *self.four):
            view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            view.addActions([self.together, fit])
        return [self.together, fit]

    def _action(self, name: str, text: str, icon: str, key: str) -> QAction:
        action = QAction(text, self)
        action.setObjectName(f"shading.{name}")
        action.setShortcut(QKeySequence(key))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        set_icon(action, icon)
        self.addAction(action)
        return action

    def _connect(self) -> None:
        session, canvas = self.session, self.canvas
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, theme_changed, self.ended.arrived):
            told.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown, session.run.asked):
            signal.connect(self.refresh_soon)
        session.run.moved.connect(lambda: canvas.point_at(None))
        canvas.cell_clicked.connect(self._clicked)
        canvas.arrow.connect(self._arrow)
        self._pointed = Pointed(canvas, self.describe, self.hover_text)
        canvas.view_changed.connect(self.refresh_soon)
        canvas.set_describer(self.describe)
        self.lamps.said.connect(self.hover_text)
        self.lamps.chosen_changed.connect(lambda _id: self.refresh_soon())
        for view in (self.view, *self.four):
            view.light_moved.connect(self.lamps.move_light)
            view.light_moved.connect(lambda identity, _place: self.lamps.choose(identity))
            view.light_left.connect(session.end_merge)
            view.turned.connect(lambda theta, phi: self.hover_text.emit(self.looking.orbit(theta, phi)))
            view.faced.connect(lambda side: self.hover_text.emit(self.looking.face(side)))
            view.failed.connect(self.hover_text)

    # What Space asks of a page

    def docks(self) -> Sequence[DockPart]:
        """Lights, and what materials make of them."""
        return (("lamps", _("Lights"), self.lamps, Qt.DockWidgetArea.RightDockWidgetArea),)

    def commands(self) -> Sequence[QAction]:
        """Its commands."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def copy(self) -> bool:
        """Put what is shown on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.stack.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """The light of the chosen pixel, else of that which was lit last; None before anything is lit."""
        subject = self.session.state.subject
        lighting, cell = lighting_of(self.session.sheet, subject), self._lit_cell()
        if lighting is None or cell is None:
            return None
        x, y = cell
        scene = self.session.sheet.scene or Scene()
        names = tuple(light.name or light.id for light in scene.lights) or (_("Light above the eye"),)
        return derivation(lighting, shading_of(subject), x, y, names, float(self._light[y, x]))

    def _lit_cell(self) -> Cell | None:
        """The chosen pixel where that is lit by now, else the one that was lit last."""
        lit = {(int(x), int(y)): None for x, y, _light in rows_so_far(self.session).tolist()}
        chosen = self.session.state.asked(PAGE)
        return chosen if chosen in lit else next(reversed(lit), None)

    def point_at(self, cell: Cell | None) -> None:
        """Ring a pixel that the sentence names; None when no longer."""
        self.canvas.point_at(cell)

    # What is shown

    def show_four(self, on: bool) -> None:
        """Show the scene in all four shadings, or one beside its steps."""
        self.together.setChecked(on)
        self.stack.setCurrentIndex(int(on))
        self.refresh_soon()

    def fit(self) -> None:
        """Show all of the scene."""
        self.canvas.fit()
        for view in (self.view, *self.four):
            view.fit()

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen."""
        if not self._waiting and (self.isVisible() or self.lamps.isVisible()):
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        scene = self.session.sheet.scene or Scene()
        self.lamps.show_scene(scene)
        if not self.isVisible() or self.session.state.workspace != PAGE:
            return
        self.bar.refresh(self.looking.around)
        self._show_views()
        if self.stack.currentIndex() == 0:
            self._show_steps()

    def _show_views(self) -> None:
        """The pictures at full size that are seen now."""
        scene, subject = self.looking.scene or Scene(), self.session.state.subject
        model, chosen = model_of(subject), self.lamps.chosen
        self.view.set_title(_(catalogue.get(shading_of(subject)).title))
        for view, slug in ((self.view, shading_of(subject)), *zip(self.four, LIT_SHADINGS, strict=True)):
            view.chosen_light = chosen.id if chosen else ""
            anew = scene.objects != view.scene.objects
            view.show_scene(scene)
            view.set_shading(slug, model)
            if anew and view.keeps_fit:
                view.fit()

    def _show_steps(self) -> None:
        session = self.session
        self.zoom_text.emit(f"{self.canvas.zoom_percent:.0f} %")
        call, fault = call_of(session.sheet, session.state.subject), fault_of(session.sheet)
        self.nothing.sentence.setText(fault or _("The scene has no faces to be lit; add an object."))
        covered = call is not None and len(call.arguments[1]) > 0
        self.nothing.setVisible(not covered)
        if call is None or not covered:
            self.bar.progress.setText("")
            width, height = size_of(session.sheet, USUAL_COLUMNS)
            self.canvas.set_picture(np.full((height, width), packed(tokens().canvas), np.uint32))
            self.canvas.set_overlay(Overlay())
            return
        self._light, ended = light_so_far(session, call), self.ended.of(call)
        now = int(np.isfinite(self._light).sum())
        said = ngettext("{now:,} pixel lit", "{now:,} pixels lit", now).format(now=now)
        if ended is None:  # nothing is known of what is still to come
            ended = np.full_like(self._light, np.nan)
        else:
            whole = int(np.isfinite(ended).sum())
            said = ngettext("{now:,} of {whole:,} pixel lit", "{now:,} of {whole:,} pixels lit", whole)
            said = said.format(now=now, whole=whole)
        self.bar.progress.setText(said)
        self.canvas.set_picture(greys(self._light, ended, tokens()))
        marks: tuple[Drawn, ...] = ()
        run = session.run
        if run.subject is not None and run.entry is not None:
            marks = tuple(marks_on_device(session.sheet, run.subject, run.entry.frame, run.marks()))
        self.canvas.set_overlay(Overlay(drawn=marks, snap=session.state.asked(PAGE)))

    def describe(self, x: int, y: int) -> str:
        """A pixel, and its light."""
        light = self._light
        if not (0 <= y < light.shape[0] and 0 <= x < light.shape[1]) or np.isnan(light[y, x]):
            return f"({x}, {y})"
        return _("({x}, {y}) light {light:.4f}").format(x=x, y=y, light=light[y, x])

    # The hand

    def _clicked(self, x: int, y: int) -> None:
        """Go to the step that lights the pixel."""
        self.session.update_state(pixel=(x, y), pixel_of=PAGE)
        if not self.session.run.waiting and not self.session.run.run_to_pixel(x, y):
            self.hover_text.emit(_("Nothing is lit at ({x}, {y}).").format(x=x, y=y))

    def _show_example(self) -> None:
        self.session.open_example(self.example)

    def _arrow(self, dx: int, _dy: int, _modifiers: object) -> None:
        if dx > 0:
            self.session.run.forward()
        elif dx < 0:
            self.session.run.back()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Home, End and Space are for the run."""
        do = stepping_key(self.session.run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()
