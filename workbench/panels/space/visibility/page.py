"""The page Visibility: a method for hidden surfaces from the inside, on a coarse picture of the scene."""

from collections.abc import Callable, Sequence

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QHideEvent, QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from workbench.document.errors import DocumentError
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.language import _
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.visibility.back_face_run import (
    BackFaceRun,
    back_face_run,
)
from workbench.panels.space.visibility.card import VisibilityCard
from workbench.panels.space.visibility.cost_view import CostView
from workbench.panels.space.visibility.depth_run import DepthRun, depth_run, method_run
from workbench.panels.space.visibility.derivation import derivation
from workbench.panels.space.visibility.fragment_list import FragmentList
from workbench.panels.space.visibility.line_run import LineRun, line_run
from workbench.panels.space.visibility.picture import (
    down_to_plot,
    lens_cells,
    picture,
    row_frame,
    row_of_depths,
)
from workbench.panels.space.visibility.solid_run import SolidRun, solid_run
from workbench.panels.space.visibility.surface_run import SurfaceRun, surface_run
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.scene.back_face_calls import BACK_FACES
from workbench.rendering.scene.depth_measures import differing
from workbench.rendering.scene.fragments import NOTHING
from workbench.rendering.scene.framing import framed
from workbench.rendering.scene.line_calls import HIDDEN_LINES
from workbench.rendering.subjects.registry import marks_on_device
from workbench.rendering.subjects.visibility import (
    DEPTH_BUFFER,
    KIND,
    NOT_ROUNDED,
    OCTREES,
    depth_call,
    fault_of,
    is_of_the_scene,
    method_of,
    size_of,
)
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Drawn, Marker
from workbench.widgets.canvas.lens import Lens
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.row_depths import RowDepths
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import theme_changed, tokens
from workbench.widgets.stepping.step_bar import stepping_key

CARD_GAP_PX = 8
_MOST_MARKED = 400


class VisibilityPage(PlainPage, QWidget):
    """``hover_text``: what is under the pointer or said in passing; ``zoom_text``: the scale."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)
    example = "overlapping-triangles"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = False
        self._run: DepthRun | None = None
        self.canvas = PixelCanvas()
        self.plot = RowDepths(self.canvas)
        self.lens = Lens(self.canvas)
        self.card = VisibilityCard(session, self.canvas)
        self.card.move(self._card_left, CARD_GAP_PX)
        self._leave_room(False)
        self.nothing = Invitation(self.canvas, _("This sheet has no scene."), self._show_example)
        self.bare = Invitation(
            self.canvas,
            _("No surface covers a pixel."),
            self.frame_scene,
            _("Frame the scene"),
            _("Move the camera back until the whole scene is in front of it"),
        )
        self.fragments = FragmentList(session)
        self.cost = CostView()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.canvas, 1)
        column.addWidget(self.plot)
        self.setFocusProxy(self.canvas)
        self._actions = self._made_actions()
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        rows: tuple[tuple[str, str, str, str, Callable[[], object]], ...] = (
            ("why", _("Why this pixel?"), "question", "Y", self.ask_why),
            ("frame", _("Frame the scene"), "frame-corners", "Shift+Z", self.frame_scene),
            ("fit", _("Fit the picture"), "corners-out", "Ctrl+0", self.canvas.fit),
        )
        made = []
        for name, text, icon, key, do in rows:
            action = QAction(text, self)
            action.setObjectName(f"visibility.{name}")
            action.setShortcut(QKeySequence(key))
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            action.triggered.connect(lambda _checked=False, do=do: do())
            set_icon(action, icon)
            self.addAction(action)
            self.canvas.addAction(action)
            made.append(action)
        self.canvas.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        return made

    def _connect(self) -> None:
        session, canvas = self.session, self.canvas
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, theme_changed, self.card.shown_changed):
            told.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown, session.run.asked):
            signal.connect(self.refresh_soon)
        session.run.moved.connect(lambda: canvas.point_at(None))
        canvas.cell_clicked.connect(self._clicked)
        canvas.arrow.connect(self._arrow)
        canvas.hovered.connect(self._point)
        canvas.cursor_moved.connect(self._point)
        canvas.hover_left.connect(self._leave)
        canvas.view_changed.connect(self.refresh_soon)
        canvas.set_describer(self.describe)
        self.card.folded.connect(self._leave_room)
        self.fragments.seen.connect(self.refresh_soon)

    @property
    def _card_left(self) -> int:
        return round(self.canvas.area.left / self.canvas.devicePixelRatioF()) + CARD_GAP_PX

    def _leave_room(self, folded: bool) -> None:
        self.canvas.set_covered(0 if folded else self.card.width() + CARD_GAP_PX)

    # What Space asks of a page

    def docks(self) -> Sequence[DockPart]:
        """What came to a pixel, and what the method gives and costs."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (
            ("fragments", _("Why this pixel?"), self.fragments, right),
            ("depth_cost", _("Gains and costs"), self.cost, right),
        )

    def commands(self) -> Sequence[QAction]:
        """Its commands."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def copy(self) -> bool:
        """Put the picture on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.canvas.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """The depth buffer at its step; None where something else is stepped, or nothing can be."""
        run = self._run
        if run is None or not len(run.fragments) or not self._keeps_depths:
            return None
        return derivation(run, self.cost.measures)

    def point_at(self, cell: Cell | None) -> None:
        """Ring a pixel that the sentence names; None when no longer."""
        self.canvas.point_at(cell)

    # What is shown

    @property
    def _asked(self) -> Cell | None:
        """The pixel that is asked about, here or on the page Hidden surfaces."""
        return self.session.state.asked(self.session.state.workspace)

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen.

        Fragments are listed beside the page Hidden surfaces too, which steps the same run.
        """
        if not self._waiting and (self.isVisible() or self.fragments.isVisible()):
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        if not self.isVisible():
            asked = is_of_the_scene(self.session.subject) and self._asked is not None
            self.fragments.refresh(depth_run(self.session) if asked else None, self._keeps_depths)
            return
        self.zoom_text.emit(f"{self.canvas.zoom_percent:.0f} %")
        run = self._run = depth_run(self.session)
        covered = run is not None and len(run.fragments) > 0
        fault = fault_of(self.session.sheet)
        self.nothing.sentence.setText(fault or _("This sheet has no scene."))
        self.nothing.setVisible(run is None)
        self.bare.setVisible(run is not None and not covered)
        told = None if run is None or self._keeps_depths else self._told(run)
        wrong = self._wrong_pixels(run) if run is not None and covered and told is None else []
        self.card.refresh(run if covered else None, len(wrong), told)
        self.plot.setVisible(told is None)
        if run is None or not covered:
            self._show_empty()
        elif told is not None:
            self.canvas.set_picture(told.picture(tokens()))
            self.canvas.set_overlay(Overlay(drawn=told.drawn(), snap=self._asked))
        else:
            now = tokens()
            self.canvas.set_picture(picture(run, self.card.shown, now))
            self.canvas.set_overlay(self._overlay(run, wrong))
            self.plot.show_row(row_of_depths(run, now))
        self._show_lens()
        self.fragments.refresh(run, self._keeps_depths)
        self.cost.refresh(run, self._method)

    @property
    def _method(self) -> str:
        return method_of(self.session.sheet, self.session.subject)

    @property
    def _tests_faces(self) -> bool:
        """Whether back faces are looked for, which have no pixels."""
        return self._method == BACK_FACES

    @property
    def _keeps_depths(self) -> bool:
        """Whether fragments are compared with stored depths, which lens, plot and list show."""
        return self._method == DEPTH_BUFFER

    @property
    def _paints_no_pixels(self) -> bool:
        """Whether the method is told of faces, lines or cells."""
        return self._method in (BACK_FACES, HIDDEN_LINES, *OCTREES)

    def _told(self, run: DepthRun) -> BackFaceRun | SurfaceRun | LineRun | SolidRun:
        if self._tests_faces:
            return back_face_run(run, self.session.sheet, method_run(self.session))
        if self._method == HIDDEN_LINES:
            return line_run(run, self.session)
        if self._method in OCTREES:
            return solid_run(run, self.session)
        return surface_run(run, self.session)

    def _show_empty(self) -> None:
        import numpy as np

        from workbench.panels.stage.picture import packed

        width, height = size_of(self.session.sheet, 48)
        self.canvas.set_picture(np.full((height, width), packed(tokens().canvas), np.uint32))
        self.canvas.set_overlay(Overlay())
        self.plot.show_row(None)

    def _overlay(self, run: DepthRun, wrong: list[Cell]) -> Overlay:
        session, number = self.session, run.now
        marks: tuple[Drawn, ...] = ()
        stepped = method_run(session)
        if stepped is not None and stepped.subject is not None and stepped.entry is not None:
            marks = marks_on_device(session.sheet, stepped.subject, stepped.entry.frame, stepped.marks())
        crosses = tuple(Marker(float(x), float(y), "error", "cross", 7) for x, y in wrong[:_MOST_MARKED])
        if number is None:
            return Overlay(drawn=(*marks, *crosses))
        x, y = int(run.fragments.x[number]), int(run.fragments.y[number])
        drawn = (*marks, *crosses, row_frame(run, y), down_to_plot(x, y))
        return Overlay(drawn=drawn, current=((x, y),), snap=self._asked)

    def _wrong_pixels(self, run: DepthRun) -> list[Cell]:
        """Pixels that show another surface now than they would if depths were not rounded."""
        if run.bits == NOT_ROUNDED or self.card.shown != "colour":
            return []
        subject = replace(run.subject, arguments={**run.subject.arguments, "bits": NOT_ROUNDED})
        other = depth_call(run.sheet, subject)
        if other is None:
            return []
        rows, columns = differing(run.call, other, run.reached).nonzero()
        return list(zip(columns.tolist(), rows.tolist(), strict=True))

    def _show_lens(self) -> None:
        run = self._run
        middle = self.canvas.pointed_cell if self.canvas.underMouse() or self.canvas.cursor_cell else None
        if run is not None and middle is None and run.now is not None:
            middle = int(run.fragments.x[run.now]), int(run.fragments.y[run.now])
        covered = self._card_left + self.card.width()
        if run is None or middle is None or not len(run.fragments) or not self._keeps_depths:
            self.lens.show_cells(None, covered)
        else:
            self.lens.show_cells(lens_cells(run, middle, _("Depth buffer"), tokens()), covered)

    def describe(self, x: int, y: int) -> str:
        """A pixel, the depth stored there, and whose it is."""
        run = self._run
        inside = run is not None and 0 <= x < run.size[0] and 0 <= y < run.size[1]
        if run is None or not inside or not self._keeps_depths:
            return f"({x}, {y})"
        z = run.depth_text(float(run.so_far.depths(run.size, run.farthest)[y, x]))
        surface = int(run.so_far.seen(run.size)[y, x])
        if surface == NOTHING:
            return _("({x}, {y}) depth {z}, empty").format(x=x, y=y, z=z)
        return _("({x}, {y}) depth {z}, {surface}").format(x=x, y=y, z=z, surface=run.name_of(surface))

    # The hand

    def _point(self, x: int, y: int) -> None:
        self.hover_text.emit(self.describe(x, y))
        self._show_lens()

    def _leave(self) -> None:
        self.hover_text.emit("")
        self._show_lens()

    def _clicked(self, x: int, y: int) -> None:
        """Go to the next fragment of the pixel, and list all that came to it."""
        if self._paints_no_pixels:
            return
        self.session.update_state(pixel=(x, y), pixel_of=self.session.state.workspace)
        if not self.session.run.waiting and not self.session.run.run_to_pixel(x, y):
            said = _("No fragment reaches ({x}, {y}).")
            if not self._keeps_depths:
                said = _("Nothing is painted at ({x}, {y}).")
            self.hover_text.emit(said.format(x=x, y=y))

    def ask_why(self) -> None:
        """List what came to the pixel that is pointed at."""
        cell = self.canvas.pointed_cell
        if self._paints_no_pixels:
            self.hover_text.emit(_("This method is not told of pixels: choose one that paints some."))
        elif cell is None:
            self.hover_text.emit(_("Point at a pixel first, then ask why it is as it is."))
        else:
            self.session.update_state(pixel=cell, pixel_of=self.session.state.workspace)
            self.session.why_asked.emit()

    def frame_scene(self) -> None:
        """Move the camera, and the window if there is one, so far that all of the scene is seen."""
        sheet = self.session.sheet
        if sheet.scene is None:
            return
        try:
            self.session.apply(framed(sheet), _("Frame the scene"))
        except DocumentError as problem:
            self.hover_text.emit(problem.short)
        except ValueError as problem:
            self.hover_text.emit(str(problem))

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
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        """Its docks have nothing to tell meanwhile."""
        super().hideEvent(event)
        self.fragments.refresh(None)
        self.cost.refresh(None)
