"""Docks that share a place are named by their tabs, dragged by them, floated and closed by their menu."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QMenu, QTabBar, QWidget

from workbench.language import _
from workbench.shell.tab_list import TabList

_UNTIL_RELEASED_MS = 50
_AWAY_PX = 24
_TITLE_PX = 10
_FLOATING = QSize(420, 320)


class DockTabs(QObject):
    """Takes the title bar from docks that have a tab, which says the same, and gives it back later.

    ``chosen``: a dock whose tab was clicked.
    """

    chosen = Signal(QDockWidget)

    def __init__(self, area: QMainWindow, docks: Callable[[], list[QDockWidget]]) -> None:
        super().__init__(area)
        self._area = area
        self._docks = docks
        self._bare: dict[QDockWidget, QWidget] = {}
        self._held: QDockWidget | None = None
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
                bar.installEventFilter(self)
                bar.tabBarClicked.connect(lambda at, bar=bar: self._choose(bar, at))
                TabList(bar)

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
        menu.addAction(_("Float {title}").format(title=dock.windowTitle()), lambda: self.set_afloat(dock))
        menu.addAction(_("Close {title}").format(title=dock.windowTitle()), dock.close)
        return menu

    def set_afloat(self, dock: QDockWidget) -> None:
        """Make a window of a dock, over its area: Qt would put one that is behind others off the screen."""
        dock.raise_()
        dock.setFloating(True)
        dock.resize(dock.size().expandedTo(_FLOATING))
        dock.move(self._area.mapToGlobal(self._area.rect().center()) - dock.rect().center())

    def _choose(self, bar: QTabBar, at: int) -> None:
        dock = next((each for each in self._docks() if each.windowTitle() == bar.tabText(at)), None)
        if dock is not None:
            QTimer.singleShot(0, self, lambda: self.chosen.emit(dock))  # once it is in front

    def _dock_at(self, bar: QTabBar, at: QPoint) -> QDockWidget | None:
        title = bar.tabText(bar.tabAt(at))
        return next((each for each in self._docks() if each.windowTitle() == title), None)

    def _show_menu(self, bar: QTabBar, at: QPoint) -> None:
        dock = self._dock_at(bar, at)
        if dock is not None:
            self.menu(dock).popup(bar.mapToGlobal(at))

    # Dragging a dock by its tab

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A tab that is dragged off its bar takes its dock along."""
        if not isinstance(watched, QTabBar) or not isinstance(event, QMouseEvent):
            return False
        at = event.position().toPoint()
        if event.type() == QEvent.Type.MouseButtonPress:
            self._held = self._dock_at(watched, at) if event.button() == Qt.MouseButton.LeftButton else None
        elif event.type() == QEvent.Type.MouseButtonRelease:
            self._held = None
        elif self._held is not None and event.buttons() & Qt.MouseButton.LeftButton:
            off = max(-at.y(), at.y() - watched.height(), -at.x(), at.x() - watched.width())
            if off > _AWAY_PX:
                dock, self._held = self._held, None
                self._hand_over(watched, dock, event)
                return True
        return False

    @staticmethod
    def _hand_over(bar: QTabBar, dock: QDockWidget, event: QMouseEvent) -> None:
        """Let go of the tab, and take hold of its dock by the title: it follows the mouse from then on."""

        def send(kind: QEvent.Type, to: QWidget, at: QPointF, held: bool) -> None:
            left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
            button = none if kind == QEvent.Type.MouseMove else left
            buttons = left if held else none
            sent = QMouseEvent(kind, at, to.mapToGlobal(at), button, buttons, event.modifiers())
            QApplication.sendEvent(to, sent)

        send(QEvent.Type.MouseButtonRelease, bar, event.position(), False)
        dock.setTitleBarWidget(None)  # type: ignore[arg-type]
        layout = dock.layout()
        if layout is not None:
            layout.activate()
        title = QPointF(dock.width() / 2, _TITLE_PX)
        send(QEvent.Type.MouseButtonPress, dock, title, True)
        send(QEvent.Type.MouseMove, dock, title + QPointF(0, 2 * QApplication.startDragDistance()), True)
