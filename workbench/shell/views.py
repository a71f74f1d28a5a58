"""Views that take each other's place: canvas and tube swapped, or the focused view alone."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QObject
from PySide6.QtWidgets import QDockWidget, QWidget

from workbench.language import _
from workbench.shell.arrangement import VERSION

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow


class Views(QObject):
    """What T and F11 do to the window."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._before: tuple[QByteArray, list[QWidget], bool] | None = None
        self._swapped: set[str] = set()

    @property
    def alone(self) -> bool:
        """Whether one view is shown alone."""
        return self._before is not None

    @property
    def swapped(self) -> bool:
        """Whether the tube fills the middle of the workspace that is shown."""
        return self._window.place in self._swapped

    def swap(self) -> None:
        """Exchange what fills the middle with what the tube dock holds."""
        place = self._window.place
        dock = self._tube_dock(place)
        if dock is None:
            self._window.say_status(_("This page has no canvas and tube to swap."))
            return
        self._swapped ^= {place}
        self._exchange(place, dock, self.swapped)
        dock.show()
        dock.raise_()

    def turn_over(self, place: str, entering: bool) -> None:
        """On entering and on leaving a workspace with both exchanged: the tube is other workspaces', too."""
        dock = self._tube_dock(place)
        if dock is not None and place in self._swapped:
            self._exchange(place, dock, entering)

    def _tube_dock(self, place: str) -> QDockWidget | None:
        docks = self._window.arrangements.docks(place)
        return next((each for each in docks if each.objectName() == "tube"), None)

    def _exchange(self, place: str, dock: QDockWidget, tube_in_middle: bool) -> None:
        host = self._window.centres[place]
        layout = host.layout()
        item = layout.itemAt(0) if layout is not None else None
        middle = item.widget() if item is not None else None
        beside = dock.widget()
        if layout is None or middle is None or beside is None:
            return
        layout.replaceWidget(middle, beside)
        dock.setWidget(middle)
        for widget in (middle, beside):
            widget.show()
        host.setFocusProxy(beside)
        dock.setWindowTitle(_("Canvas") if tube_in_middle else _("Tube"))

    def toggle_alone(self) -> None:
        """Show only the view that has the focus, or bring the rest back."""
        if self.alone:
            self.together()
            return
        window = self._window
        focus = window.focusWidget()
        docks = window.arrangements.docks(window.place)
        kept: QDockWidget | None = next(
            (d for d in docks if focus is not None and d.isAncestorOf(focus)), None
        )
        hidden: list[QWidget] = [window.top, window.statusBar()]
        hidden += [dock for dock in docks if dock is not kept and not dock.isHidden()]
        if kept is not None:
            hidden.append(window.stack)
        self._before = (window.saveState(VERSION), hidden, window.isMaximized())
        for widget in hidden:
            widget.hide()
        window.showFullScreen()

    def together(self) -> None:
        """Bring back what was hidden; nothing happens when nothing was."""
        if self._before is None:
            return
        state, hidden, maximised = self._before
        self._before = None
        for widget in hidden:
            widget.show()
        self._window.restoreState(state, VERSION)
        if maximised:
            self._window.showMaximized()
        else:
            self._window.showNormal()
