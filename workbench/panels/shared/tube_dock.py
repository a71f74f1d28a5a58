"""The small tube beside the canvas: the open sheet, glowing."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QPushButton, QStackedLayout, QVBoxLayout, QWidget

from workbench.language import _
from workbench.panels.panel import DockPart, PlainPanel
from workbench.panels.shared.tube_feed import TubeFeed
from workbench.session.session import Session
from workbench.widgets.tube.view import TubeView


class TubeDock(QWidget):
    """One tube, raster or vector, over a session."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.raster, self.vector = TubeView("raster"), TubeView("vector")
        self.feed = TubeFeed(session, [self.raster, self.vector], self)
        self.raster.probed.connect(lambda x, y: session.update_state(pixel=(x, y)))
        self._choices = QButtonGroup(self)
        row = QHBoxLayout()
        row.setSpacing(4)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(8, 4, 8, 8)
        whole.setSpacing(4)
        holder = QWidget()
        self._stack = QStackedLayout(holder)
        for view, title, hint in (
            (self.raster, _("Raster"), _("Scan the frame buffer line by line")),
            (self.vector, _("Vector"), _("Draw the display list stroke by stroke")),
        ):
            self._stack.addWidget(view)
            button = QPushButton(title)
            button.setCheckable(True)
            button.setFlat(True)
            button.setToolTip(hint)
            button.setAccessibleName(hint)
            self._choices.addButton(button, self._stack.indexOf(view))
            row.addWidget(button)
        row.addStretch(1)
        self._choices.button(0).setChecked(True)
        self._choices.idClicked.connect(self._stack.setCurrentIndex)
        whole.addWidget(holder, 1)
        whole.addLayout(row)
        self.setMinimumSize(160, 150)

    def copy(self) -> None:
        """Put the tube as it glows now on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.view.grab())

    @property
    def view(self) -> TubeView:
        """The tube that is seen."""
        return self.raster if self._stack.currentIndex() == 0 else self.vector


class TubePanel(PlainPanel):
    """The tube as a dock of a workspace that has its own middle."""

    def __init__(self, session: Session) -> None:
        self.title = _("Tube")
        self.tube = TubeDock(session)

    @property
    def center(self) -> QWidget:
        """The dock's content, for a workspace that wants it in the middle."""
        return self.tube

    def docks(self) -> list[DockPart]:
        """The tube at the right."""
        return [("tube", self.title, self.tube, Qt.DockWidgetArea.RightDockWidgetArea)]
