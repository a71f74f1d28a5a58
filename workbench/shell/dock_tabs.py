"""Docks that share a place are named by their tabs alone; a menu on the tab floats or closes them."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QMenu, QTabBar, QWidget

from workbench.language import _

_UNTIL_RELEASED_MS = 50


class DockTabs(QObject):
    """Takes the title bar from docks that have a tab, which says the same, and gives it back later."""

    def __init__(self, area: QMainWindow, docks: Callable[[], list[QDockWidget]]) -> None:
        super().__init__(area)
        self._area = area
        self._docks = docks
        self._bare: dict[QDockWidget, QWidget] = {}
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.refresh)

    def follow(self, dock: QDockWidget) -> None:
        """Look again whenever this dock has moved."""
        self._bare[dock] = QWidget(dock)
        self._bare[dock].hide()
        for signal in (dock.visibilityChanged, dock.topLevelChanged, dock.dockLocationChanged):
            signal.connect(self._look_later)

    def _look_later(self, *_what: object) -> None:
        self._later.start(0)

    def refresh(self) -> None:
        """Give title bars to those without a tab, and to the tabs their menu."""
        if QApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._later.start(_UNTIL_RELEASED_MS)  # a dock that is being dragged keeps what it is dragged by
            return
        for dock in self._docks():
            tabbed = bool(self._area.tabifiedDockWidgets(dock)) and not dock.isFloating()
            bare = dock.titleBarWidget() is not None
            if tabbed and not bare:
                dock.setTitleBarWidget(self._bare[dock])
            elif bare and not tabbed:
                dock.setTitleBarWidget(None)  # type: ignore[arg-type]
        for bar in self._bars():
            if bar.contextMenuPolicy() != Qt.ContextMenuPolicy.CustomContextMenu:
                bar.setElideMode(Qt.TextElideMode.ElideNone)
                bar.setUsesScrollButtons(True)
                bar.setToolTip(_("Drag a tab to move its view; right-click to float or close it"))
                bar.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
                bar.customContextMenuRequested.connect(lambda at, bar=bar: self._show_menu(bar, at))

    def _bars(self) -> list[QTabBar]:
        return self._area.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)

    def height(self, dock: QDockWidget) -> int:
        """How much room the tabs beside a dock take; 0 for one that has its place to itself."""
        if not self._area.tabifiedDockWidgets(dock):
            return 0
        return max((bar.height() for bar in self._bars() if bar.isVisible()), default=0)

    def menu(self, dock: QDockWidget) -> QMenu:
        """What can be done with one dock."""
        menu = QMenu(self._area)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(_("Float {title}").format(title=dock.windowTitle()), lambda: dock.setFloating(True))
        menu.addAction(_("Close {title}").format(title=dock.windowTitle()), dock.close)
        return menu

    def _show_menu(self, bar: QTabBar, at: QPoint) -> None:
        title = bar.tabText(bar.tabAt(at))
        dock = next((each for each in self._docks() if each.windowTitle() == title), None)
        if dock is not None:
            self.menu(dock).popup(bar.mapToGlobal(at))
