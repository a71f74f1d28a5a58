"""Views that take each other's place: canvas and tube swapped, or the focused view alone."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSize, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget

from workbench.language import _

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


class Views(QObject):
    """What T, R and F11 do to the window."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._hidden: list[QWidget] | None = None
        self._in_front: dict[QDockWidget, QSize] = {}
        self._maximised = False
        self._kept: QAction | None = None
        self._soon = QTimer(self, interval=0, singleShot=True)
        self._soon.timeout.connect(self.together)

    @property
    def alone(self) -> bool:
        """Whether one view is shown alone."""
        return self._hidden is not None

    @property
    def swapped(self) -> bool:
        """Whether the tube fills the middle of the workspace that is shown."""
        area = self._window.arrangements.area(self._window.place)
        return area is not None and area.swapped

    def swap(self) -> None:
        """Exchange what fills the middle with what the tube dock holds."""
        area = self._window.arrangements.area(self._window.place)
        if area is None or not area.can_swap:
            self.together()  # alone, the window has no status bar
            self._window.say_status(_("This page has no canvas and tube to swap."))
            return
        self.together()
        self._window.arrangements.stop_reading()
        area.swap()

    def read(self) -> None:
        """Give source and tables half of the window, or bring the docks back."""
        area = self._window.arrangements.area(self._window.place)
        if area is None or not area.can_read:
            self.together()
            self._window.say_status(_("There is no source to read here; go to a workspace with steps."))
            return
        self.together()
        arrangements = self._window.arrangements
        (arrangements.stop_reading if arrangements.reading else arrangements.read)()

    def toggle_alone(self) -> None:
        """Show only the view that has the focus, or bring the rest back."""
        if self.alone:
            self.together()
            return
        window = self._window
        area = window.arrangements.area(window.place)
        window.arrangements.stop_reading()
        focus = QApplication.focusWidget() or window.focusWidget()
        docks = window.arrangements.docks(window.place)
        kept = next((dock for dock in docks if focus is not None and dock.isAncestorOf(focus)), None)
        if kept is not None and kept.isFloating():
            window.say_status(_("This view floats, so it is already alone."))
            return
        hidden: list[QWidget] = [window.top, window.statusBar()]
        hidden += [dock for dock in docks if dock is not kept and not dock.isHidden()]
        if kept is not None and area is not None:
            hidden.append(area.halves)
        if area is not None:
            self._in_front = area.in_front()
        self._hidden, self._maximised = hidden, window.isMaximized()
        for widget in hidden:
            widget.hide()
        if kept is not None:  # closed, it would leave nothing to be seen
            self._kept = kept.toggleViewAction()
            self._kept.toggled.connect(self._soon.start)
        window.showFullScreen()

    def together(self) -> None:
        """Bring back what was hidden; nothing happens when nothing was."""
        if self._hidden is None:
            return
        hidden, self._hidden = self._hidden, None
        if self._kept is not None:
            self._kept.toggled.disconnect(self._soon.start)
            self._kept = None
        for widget in hidden:
            widget.show()
        area = self._window.arrangements.area(self._window.place)
        if area is not None:
            area.bring_to_front(self._in_front)
        self._in_front = {}
        if self._maximised:
            self._window.showMaximized()
        else:
            self._window.showNormal()
