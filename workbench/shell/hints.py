"""Three short hints for the first time in Draw: canvas, step bar, source."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget
from shiboken6 import isValid

from workbench.language import _

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

_WIDTH = 300


class Hints(QFrame):
    """One hint at a time, beside what it speaks of; dismissed for good by one button or Esc."""

    def __init__(self, window: "MainWindow", places: list[tuple[QWidget, str]]) -> None:
        super().__init__(window)
        self.setObjectName("hint")
        self._window = window
        self._places = places
        self._at = 0
        self.setFixedWidth(_WIDTH)
        self._count = QLabel()
        self._count.setProperty("role", "muted")
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._next = QPushButton()
        self._next.setProperty("primary", True)
        self._next.clicked.connect(self._go_on)
        dismiss = QPushButton(_("No more hints"))
        dismiss.setProperty("flat", True)
        dismiss.setToolTip(_("Hide the hints for good; Help brings them back"))
        dismiss.clicked.connect(self.dismiss)
        row = QHBoxLayout()
        row.addWidget(self._count, 1)
        row.addWidget(dismiss)
        row.addWidget(self._next)
        column = QVBoxLayout(self)
        column.setContentsMargins(12, 10, 12, 10)
        column.setSpacing(8)
        column.addWidget(self._text)
        column.addLayout(row)
        window.installEventFilter(self)
        self._show()

    @property
    def text(self) -> str:
        """The hint now shown."""
        return self._text.text()

    def dismiss(self) -> None:
        """Hide the hints for good."""
        self._window.settings.set("hints", False)
        self.end()

    def _go_on(self) -> None:
        self._at += 1
        if self._at == len(self._places):
            self.dismiss()
        else:
            self._show()

    def end(self) -> None:
        """Take the hint away, for now."""
        self._window.removeEventFilter(self)
        self.hide()
        self.deleteLater()

    def _show(self) -> None:
        last = self._at == len(self._places) - 1
        self._text.setText(self._places[self._at][1])
        self._count.setText(_("{n} of {total}").format(n=self._at + 1, total=len(self._places)))
        self._next.setText(_("Begin") if last else _("Next"))
        self._next.setToolTip(_("Close the hints") if last else _("The next hint"))
        self.setAccessibleName(self.text)
        self.adjustSize()
        self._place()
        self.show()
        self.raise_()

    def _place(self) -> None:
        """Beside the middle of its target, inside the window."""
        window, (target, _text) = self._window, self._places[self._at]
        if not isValid(target):  # the workspace was reset
            self.end()
            return
        corner = target.mapTo(window, QPoint(0, 0))
        middle = corner + QPoint(target.width() // 2, target.height() // 2)
        x, y = middle.x() - self.width() // 2, middle.y() - self.height() // 2
        if target.height() < 160:
            y = corner.y() - self.height() - 12
        elif target.width() < window.width() // 2:
            x, y = corner.x() - self.width() - 12, corner.y() + 24
        else:
            y = corner.y() + target.height() - self.height() - 48
        self.move(
            max(8, min(window.width() - self.width() - 8, x)),
            max(8, min(window.height() - self.height() - 8, y)),
        )

    def event(self, event: QEvent) -> bool:
        """As large as its words are, also when all type has become larger."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest and self._at < len(self._places):
            self.adjustSize()
            self._place()
        return done

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.dismiss()
        else:
            super().keyPressEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and self._at < len(self._places):
            self._place()
        return super().eventFilter(watched, event)


def show_hints(window: "MainWindow") -> Hints | None:
    """Show the hints unless they were dismissed for good, or are there already."""
    if not window.settings.get("hints") or window.findChild(Hints) is not None:
        return None
    area = window.arrangements.area("draw")
    if area is None:
        return None
    source = next((dock for dock in area.docks if dock.objectName() == "source"), None)
    places: list[tuple[QWidget, str]] = [
        (
            area.host,
            _("Drag a handle, and every other view follows. The tools on the left draw more."),
        ),
        (window.steps, _("Step through the algorithm here, or with the keys , and . everywhere.")),
    ]
    if source is not None:
        text = _("This is the very algorithm that draws. The marked lines ran in this step.")
        places.append((source, text))
    return Hints(window, places)


def end_hints(window: "MainWindow") -> None:
    """Take hints away when their workspace is left; they come again next time."""
    for hints in window.findChildren(Hints):
        hints.end()
