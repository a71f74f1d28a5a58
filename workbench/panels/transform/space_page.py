"""The page of Transform about space: an object under its chain, step by step, over its matrices."""

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from workbench.document.scene.model import Object
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.stage.invitation import Invitation
from workbench.panels.transform.chain_dock import ChainDock
from workbench.panels.transform.chain_edits import ObjectChain
from workbench.panels.transform.ground import Ground
from workbench.panels.transform.matrices import Matrices
from workbench.panels.transform.space_rows import space_rows
from workbench.panels.transform.space_scene import scene_of, stepped_turn
from workbench.panels.transform.space_view import SpaceView
from workbench.rendering.subjects.space_chain import (
    KIND,
    VERTEX,
    is_of_a_chain_in_space,
    object_of,
    vertex_of,
)
from workbench.session.session import Session
from workbench.widgets.stepping.step_bar import stepping_key

EXAMPLE = "transform-axis"
SLUG = "transform_space"
_LEAST_VIEW_PX, _LOW_PX, _LEAST_LOW_PX = 240, 480, 200


class SpacePage(QWidget):
    """``said`` sends a sentence. ``beside`` are the cards of the chain, for a dock."""

    said = Signal(str)
    usual = Subject(KIND)

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.view, self.matrices = SpaceView(), Matrices()
        self.matrices.said.connect(self.said)
        self.matrices.fit_wanted.connect(self._fit)
        self.view.next_wanted.connect(self.next_vertex)
        self.empty = Invitation(self.view, _("There is nothing in space yet."), self.show_example)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(1)
        column.addWidget(self.view, 1)
        column.addWidget(self.matrices)
        self.chain = ChainDock(session, ObjectChain())
        self.chain.said.connect(self.said)
        self.chain.stage_pointed.connect(self._point)
        self.objects = QComboBox()
        self.objects.setAccessibleName(_("Object"))
        self.objects.setToolTip(_("The object whose transforms are shown"))
        self.objects.activated.connect(self._choose)
        self.beside = Ground()
        beside = QVBoxLayout(self.beside)
        beside.setContentsMargins(0, 0, 0, 0)
        beside.setSpacing(0)
        row = QVBoxLayout()
        row.setContentsMargins(12, 4, 12, 0)
        row.addWidget(self.objects)
        beside.addLayout(row)
        beside.addWidget(self.chain, 1)
        self._lit: int | None = None
        self.setFocusProxy(self.view)

    def show_example(self) -> None:
        """Open the house that is turned about an axis."""
        self._session.open_example(EXAMPLE)

    @property
    def thing(self) -> Object | None:
        """The object whose transforms are shown: the chosen one of the scene, else what is stepped."""
        session = self._session
        subject = session.subject
        if not is_of_a_chain_in_space(subject) or session.state.thing:
            subject = Subject(KIND, (session.state.thing,))
        return object_of(session.frames.sheet, subject)

    @property
    def step(self) -> int:
        """Which of the seven steps of the last rotation is looked at."""
        run = self._session.run
        if self._lit is not None:
            return self._lit
        if run.entry is None or run.subject is None or not is_of_a_chain_in_space(run.subject):
            return 0
        return stepped_turn(run.entry.slug, run.step_number)

    def refresh(self) -> None:
        """Show the session as it is now."""
        thing = self.thing
        scene = self._session.frames.sheet.scene
        things = scene.objects if scene is not None else ()
        names = [each.name or each.id for each in things]
        if names != [self.objects.itemText(k) for k in range(self.objects.count())]:
            self.objects.clear()
            self.objects.addItems(names)
        self.objects.setVisible(len(things) > 1)
        self.empty.setVisible(thing is None)
        self.chain.follow(thing, self._lit)
        if thing is None:
            self.view.show_scene(None)
            self.matrices.show_rows([])
        else:
            self.objects.setCurrentIndex(things.index(thing))
            self.view.show_scene(scene_of(thing, self._session.subject, self.step))
            self.matrices.show_rows(space_rows(thing, self.step))
            self._follow(thing)
        self._fit()

    def _follow(self, thing: Object) -> None:
        """Step what is shown."""
        subject = self._session.subject
        if self.isVisible() and is_of_a_chain_in_space(subject) and subject.ids != (thing.id,):
            self._session.update_state(subject=replace(subject, ids=(thing.id,)), step=0)

    def _point(self, number: int | None) -> None:
        """A step that is pointed at on a card is shown in the picture."""
        if number != self._lit:
            self._lit = number
            self.refresh()

    def _choose(self, index: int) -> None:
        scene = self._session.sheet.scene
        if scene is not None and 0 <= index < len(scene.objects):
            self._session.update_state(thing=scene.objects[index].id)

    def next_vertex(self) -> None:
        """Follow the next vertex of the object."""
        thing, subject = self.thing, self._session.subject
        if thing is not None and is_of_a_chain_in_space(subject):
            following = (vertex_of(thing, subject) + 1) % len(thing.mesh.vertices)
            arguments = {**subject.arguments, VERTEX: following}
            self._session.update_state(subject=replace(subject, arguments=arguments))

    def _fit(self) -> None:
        """The picture keeps a least height."""
        least = _LEAST_VIEW_PX if self.height() >= _LOW_PX else _LEAST_LOW_PX
        high = self.matrices.height_within(max(self.height() - least, 0)) if self.matrices.rows else 0
        self.matrices.setVisible(high > 0)
        if high and high != self.matrices.height():
            self.matrices.setFixedHeight(high)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The picture keeps a least height."""
        super().resizeEvent(event)
        self._fit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that the picture left step the run."""
        do = stepping_key(self._session.run, event)
        if do is None:
            super().keyPressEvent(event)
        else:
            do()
