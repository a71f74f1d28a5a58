"""The page Projection: what the eye sees."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QSplitter, QVBoxLayout, QWidget

from workbench.document.scene.model import Scene
from workbench.document.subjects import Subject
from workbench.panels.panel import Cell, DockPart, Said
from workbench.panels.space.eye_view import EyeView
from workbench.panels.space.looking import Looking
from workbench.rendering.scene.edge_picture import object_at
from workbench.session.session import Session


class ProjectionPage(QWidget):
    """``hover_text``: said in passing; ``zoom_text``: the scale."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.looking = Looking(session)
        self.eye = EyeView()
        self.views = QSplitter(Qt.Orientation.Horizontal)
        self.views.setChildrenCollapsible(False)
        self.views.addWidget(self.eye)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self.views, 1)
        self.setFocusProxy(self.eye)
        self._waiting = False
        self._kept: Scene | None = None
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed):
            told.connect(self.refresh_soon)
        self.eye.turned.connect(lambda theta, phi: self._say(self.looking.orbit(theta, phi)))
        self.eye.faced.connect(lambda side: self._say(self.looking.face(side)))
        self.eye.clicked.connect(self._pick)
        self.refresh()

    @property
    def widget(self) -> QWidget:
        """Itself."""
        return self

    def docks(self) -> Sequence[DockPart]:
        """None."""
        return ()

    def commands(self) -> Sequence[QAction]:
        """None."""
        return ()

    def said(self) -> Said:
        """What is said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)

    def point_at(self, cell: Cell | None) -> None:
        """Its sentences name no pixels."""

    def _say(self, sentence: str) -> None:
        self.hover_text.emit(sentence)

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen."""
        if not self._waiting and self.isVisible():
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        scene = self.looking.scene or Scene()
        kept = self.session.sheet.scene
        self.eye.show_scene(scene, self.session.state.thing)
        if kept is not self._kept:
            self._kept = kept
            if self.eye.keeps_fit:
                self.eye.fit()

    def _pick(self, position: QPointF) -> None:
        view = self.eye
        ratio = view.devicePixelRatioF()
        x, y = position.x() * ratio - 0.5, view.device_size[1] - 0.5 - position.y() * ratio
        name = object_at(view.scene, view.device_size, view.window_world, x, y)
        self.session.update_state(thing=name)

    def showEvent(self, event: object) -> None:
        """Show what happened while it was hidden."""
        self.refresh()
