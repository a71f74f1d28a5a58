"""The Transform panel: a figure, the chain that transforms it, and the matrices of the chain."""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from workbench.document.subjects import Subject
from workbench.document.transforms.edits import extend
from workbench.document.transforms.links import Translate
from workbench.document.transforms.names import title
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.panel import DockPart
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.card import kind_title
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.panel import NUDGE
from workbench.panels.stage.stepped import SteppedPanel
from workbench.panels.stage.tools import CircleTool, EllipseTool, LineTool, PolygonTool, PolylineTool
from workbench.panels.transform.card import TransformCard
from workbench.panels.transform.chain_dock import ChainDock
from workbench.panels.transform.chain_pages import PLANE, SPACE, ChainPages
from workbench.panels.transform.derivation import derivation
from workbench.panels.transform.matrices import Matrices
from workbench.panels.transform.space_derivation import space_derivation
from workbench.panels.transform.space_page import SLUG as SPACE_RUN
from workbench.panels.transform.space_page import SpacePage
from workbench.panels.transform.tables import points_table
from workbench.panels.transform.tools import ChainSelectTool, PointDrag
from workbench.panels.transform.view import TransformView
from workbench.panels.transform.whole import WholeDock
from workbench.rendering.mapping import device_map
from workbench.rendering.subjects.chain import KIND, POINT, PRODUCT, at_vertex
from workbench.session.session import Session

EXAMPLE = "transform-pivot"
_PAGES = ("page_plane", "page_space")
_LEAST_CANVAS_PX, _LOW_PX, _LEAST_LOW_PX = 280, 480, 200


class TransformPanel(SteppedPanel):
    """Canvas, tools and card over the matrices; the chain is a dock. What is stepped are the products."""

    slug = "transform"
    first_tool = "polygon"
    usual = Subject(KIND)
    moves_points = False
    card: TransformCard
    view: TransformView

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        kinds = (ChainSelectTool, PolygonTool, LineTool, PolylineTool, CircleTool, EllipseTool)
        super().__init__(session, [kind(session) for kind in kinds], parent)
        self.title = _("Transform")
        self.handle_drag = PointDrag(session)
        self.canvas.worthwhile = 0.4
        self.card = TransformCard(session, self.canvas)
        self.chain, self.matrices, self.whole = ChainDock(session), Matrices(), WholeDock()
        self.space = SpacePage(session)
        self.chains = ChainPages(self.chain, self.space.beside)
        self.chains.chosen.connect(self.show_page)
        self.page = PLANE
        self.view = TransformView(
            session, self.canvas, self.second, self.card, self.chain, self.matrices, self.whole
        )
        self.chain.pivot = lambda: self.view.chain_box.pivot
        self.card.switched.connect(self.refresh_soon)
        for view in (self.chain, self.matrices, self.whole, self.space):
            view.said.connect(self.hover_text)
        for pointed in (self.chain.stage_pointed, self.matrices.stage_pointed, self.view.legend.pointed):
            pointed.connect(self._light)
        box = self.view.chain_box
        box.failed.connect(self.hover_text)
        box.looks_changed.connect(self.refresh_soon)
        box.held.connect(self.session.hold_runs)
        self.matrices.entry_changed.connect(self._set_entry)
        self.matrices.entry_ended.connect(self._end_entry)
        self.matrices.cell_clicked.connect(self._click_element)
        self.matrices.fit_wanted.connect(self._fit_matrices)
        for canvas in (self.canvas, self.second):
            canvas.view_changed.connect(self.refresh_soon)
        session.run.moved.connect(self._forget_question)
        self.start(
            _("Click corners on the canvas to draw a polygon, then give it a transform."),
            [
                ("step_products", _("Step through the products"), "brackets-square", "", self._step_products),
                ("step_point", _("Take a point through the chain"), "map-pin", "", self._step_point),
                ("next_vertex", _("Follow the next point"), "arrow-bend-down-right", "N", self._next_vertex),
                ("ghosts", _("Show or hide: ghosts"), "ghost", "H", self.card.ghosts.toggle),
                ("axes", _("Move the points or the axes"), "crosshair", "X", self._toggle_axes),
                (
                    "page_plane",
                    _("Transforms in the plane"),
                    "polygon",
                    "Alt+1",
                    partial(self.show_page, PLANE),
                ),
                ("page_space", _("Transforms in space"), "cube", "Alt+2", partial(self.show_page, SPACE)),
            ],
        )

        # No pixels are seen here.
        for taken in (self.canvas, self):
            taken.removeAction(self._actions["why"])
        del self._actions["why"]

    def begin(
        self, middle: QWidget, card: QWidget, invitation: str, commands: Sequence[PanelCommand]
    ) -> None:
        """The matrices lie under the canvas."""
        both = QWidget()
        column = QVBoxLayout(both)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(1)
        column.addWidget(middle, 1)
        column.addWidget(self.matrices)
        self.pages = QStackedWidget()
        self.pages.addWidget(both)
        self.pages.addWidget(self.space)
        super().begin(self.pages, card, invitation, commands)

    def docks(self) -> list[DockPart]:
        """The chain, and what it comes to."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return [
            ("chain", _("Chain"), self.chains, right),
            ("whole", _("Inverse and parts"), self.whole, right),
        ]

    def show_page(self, slug: str = "") -> None:
        """Show the plane, or space, and step what was stepped there."""
        self.page = slug or PLANE
        in_space = self.page == SPACE
        self.pages.setCurrentIndex(int(in_space))
        self.chains.show_page(self.page)
        self._bar.setVisible(not in_space)
        self.exporter = None if in_space else self.paper  # only the plane has steps on paper
        self.setFocusProxy(self.space.view if in_space else self.canvas)
        self._enable()
        self._take_run()
        self._take_tool_when_empty()
        self.refresh()

    def _enable(self) -> None:
        """What is done to figures is there while they are seen."""
        on = self.isVisible() and self.page == PLANE
        for name, action in self._actions.items():
            action.setEnabled(self.isVisible() if name in _PAGES else on)

    def derivation(self) -> Derivation | None:
        """The page of the figure, or of the object, that is worked on."""
        if self.page == SPACE:
            thing = self.space.thing
            return None if thing is None else space_derivation(thing, self.session.subject)
        frames = self.session.frames
        figure = frames.figure
        if figure is None or not figure.points_world:
            return None
        return derivation(frames.sheet, figure, figure.name or kind_title(figure), self.view.vertex)

    def tables(self) -> list[tuple[str, Table]]:
        """The figure's points at every stage."""
        figure = self.session.frames.figure
        chain = () if figure is None else figure.transforms
        return [(_("Points at every stage"), points_table(figure))] if figure is not None and chain else []

    def show_example(self) -> None:
        """Open the triangle that is turned about a point, or in space the house about an axis."""
        if self.page == SPACE:
            self.space.show_example()
        else:
            self.session.open_example(EXAMPLE)

    # What is shown

    def leave_room(self, folded: bool) -> None:
        """The picture stays beside the card, folded or not, for it would cover the figure."""
        super().leave_room(False)

    def showEvent(self, event: QShowEvent) -> None:
        """The figure that is worked on shows its box."""
        super().showEvent(event)
        self._enable()
        active = self.session.active_figure
        if active is not None and not self.session.state.selection and self.tool is self.tools[0]:
            chosen = self.session.sheet.together((active.id,))
            self.session.update_state(active=active.id, selection=chosen)
        self._fit_matrices()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The canvas keeps a least height."""
        super().resizeEvent(event)
        self._fit_matrices()

    def _fit_matrices(self) -> None:
        least = _LEAST_CANVAS_PX if self.height() >= _LOW_PX else _LEAST_LOW_PX
        shown = bool(self.matrices.rows)
        high = self.matrices.height_within(max(self.height() - least, 0)) if shown else 0
        self.matrices.setVisible(high > 0)
        if high and high != self.matrices.height():
            self.matrices.setFixedHeight(high)

    def _light(self, stage: int | None) -> None:
        if stage != self.view.lit:
            self.view.lit = stage
            self.refresh_soon()

    def refresh(self) -> None:
        """Show the session as it is now, and the matrices as high as they are."""
        if self.page == SPACE:
            self._waiting = False
            self.space.refresh()
            self.zoom_text.emit("")
            return
        super().refresh()
        self._fit_matrices()

    @property
    def gesturing(self) -> bool:
        """Whether something is being drawn or dragged."""
        return super().gesturing or self.view.chain_box.busy

    def _take_run(self) -> None:
        """Each page has a position of its own."""
        if self.page == PLANE:
            super()._take_run()
        elif self.isVisible():
            self.session.visit(SPACE_RUN, self.space.usual)

    def _take_tool_when_empty(self) -> None:
        """In space nothing is drawn."""
        if self.page == PLANE:
            super()._take_tool_when_empty()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """In space the keys of figures do nothing."""
        if self.page == PLANE:
            super().keyPressEvent(event)
        else:
            event.ignore()

    def copy(self) -> bool:
        """What is selected; in space what is seen."""
        if self.page == PLANE:
            return super().copy()
        QGuiApplication.clipboard().setPixmap(self.space.view.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def paste(self) -> bool:
        """Figures come into the plane."""
        return self.page == PLANE and super().paste()

    def _toggle_axes(self) -> None:
        (self.card.points if self.card.axes.isChecked() else self.card.axes).click()

    # What is done

    def _set_entry(self, link: str, attribute: str, value: float) -> None:
        self.session.hold_runs(True)
        if refusal := self.chain.set_number(link, attribute, value, "matrix"):
            self.hover_text.emit(refusal)
        self.refresh_soon()

    def _end_entry(self) -> None:
        self.session.hold_runs(False)
        self.session.end_merge()
        self.refresh_soon()

    def _arrow(self, dx: int, dy: int, modifiers: Modifiers) -> None:
        """Arrows move what is selected by its chain; with nothing selected they step."""
        chosen = [figure.id for figure in self.selected()]
        if not chosen:
            super()._arrow(dx, dy, modifiers)
            return
        far = 10 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1
        way = device_map(self.session.sheet).world_way(float(dx * far), float(dy * far))
        link = Translate("", tx=way[0], ty=way[1])
        self.apply(extend(chosen, link), title(link), f"{NUDGE} {' '.join(chosen)}")
        self._nudging.start()

    # What is stepped

    def _step_products(self) -> None:
        self._choose_run(PRODUCT)

    def _step_point(self) -> None:
        self._choose_run(POINT)

    def _choose_run(self, slug: str) -> None:
        if slug in self.session.choices_of():
            self.session.choose(slug)
        else:
            self.hover_text.emit(_("A single matrix has nothing to be multiplied by; add a link first."))

    def _next_vertex(self) -> None:
        figure = self.session.active_figure
        if figure is None or not figure.points_world:
            return
        following = (self.view.vertex + 1) % len(figure.points_world)
        self.session.update_state(subject=at_vertex(self.session.state.subject, following), step=0)

    def _forget_question(self) -> None:
        self.view.asked = None

    def _click_element(self, product: int, row: int, column: int) -> None:
        """*Ask first*: the element that comes next is clicked, then its number is chosen."""
        run, progress = self.session.run, self.view.chain_progress()
        if not run.waiting or progress is None or progress.point:
            return
        if product != progress.number or 3 * row + column != progress.known:
            self.view.asked = None
            self.hover_text.emit(_("Not this one: a product is worked out row by row, from the left."))
        else:
            self.view.asked = row, column
            self.hover_text.emit(_("This one comes next; choose its number below."))
        self.refresh_soon()
