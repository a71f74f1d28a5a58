"""Docks that share a place are named by their tabs alone; a menu on the tab floats or closes them."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow, QMenu, QTabBar, QWidget

from workbench.language import _


class DockTabs(QObject):
    """Takes the title bar from docks that have a tab, which says the same, and gives it back later."""

    def __init__(self, window: QMainWindow, docks: Callable[[], list[QDockWidget]]) -> None:
        super().__init__(window)
        self._window = window
        self._docks = docks
        self._bars: set[QTabBar] = set()
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.refresh)

    def follow(self, dock: QDockWidget) -> None:
        """Look again whenever this dock has moved."""
        for signal in (dock.visibilityChanged, dock.topLevelChanged, dock.dockLocationChanged):
            signal.connect(self._look_later)

    def _look_later(self, *_what: object) -> None:
        self._later.start(0)

    def refresh(self) -> None:
        """Give title bars to those without a tab, and to the tabs their menu."""
        for dock in self._docks():
            tabbed = bool(self._window.tabifiedDockWidgets(dock)) and not dock.isFloating()
            bare = dock.titleBarWidget() is not None
            if tabbed and not bare:
                dock.setTitleBarWidget(QWidget(dock))
            elif bare and not tabbed:
                dock.setTitleBarWidget(None)  # type: ignore[arg-type]
        only_ours = Qt.FindChildOption.FindDirectChildrenOnly
        bars = self._window.findChildren(QTabBar, options=only_ours)
        self._hide_forgotten([bar for bar in bars if bar.isVisible()])
        for bar in bars:
            if bar not in self._bars:
                self._bars.add(bar)
                bar.destroyed.connect(lambda _gone=None, bar=bar: self._bars.discard(bar))
                bar.setElideMode(Qt.TextElideMode.ElideNone)
                bar.setUsesScrollButtons(True)
                bar.setToolTip(_("Drag a tab to move its view; right-click to float or close it"))
                bar.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
                bar.customContextMenuRequested.connect(lambda at, bar=bar: self._show_menu(bar, at))

    def _hide_forgotten(self, bars: list[QTabBar]) -> None:
        """Docks put together one by one leave Qt with a bar of the first ones, which it may never hide."""
        titles = {bar: {bar.tabText(k) for k in range(bar.count())} for bar in bars}
        for bar in bars:
            if any(titles[bar] < others for others in titles.values()):
                bar.hide()

    def menu(self, dock: QDockWidget) -> QMenu:
        """What can be done with one dock."""
        made = QMenu(self._window)
        made.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        made.addAction(_("Float {title}").format(title=dock.windowTitle()), lambda: dock.setFloating(True))
        made.addAction(_("Close {title}").format(title=dock.windowTitle()), dock.close)
        return made

    def _show_menu(self, bar: QTabBar, at: QPoint) -> None:
        title = bar.tabText(bar.tabAt(at))
        dock = next((each for each in self._docks() if each.windowTitle() == title), None)
        if dock is not None:
            self.menu(dock).popup(bar.mapToGlobal(at))
