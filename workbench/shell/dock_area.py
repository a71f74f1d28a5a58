"""The docking area of one workspace: what fills its middle, and a dock of its own for everything beside it.

What several workspaces show is one widget, which moves into the docks of the workspace that is entered. The
docks themselves never change hands: Qt keeps the tab bars of docks that are put together anew in the same
window, paints them over those that came after, and dies when one of them is dragged.
"""

import zlib
from collections.abc import Mapping, Sequence

from PySide6.QtCore import QByteArray, QSize, Qt, QTimer
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QMainWindow,
    QSizePolicy,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from workbench.language import _
from workbench.panels.panel import DockPart, SwapPlace
from workbench.shell.dock_tabs import DockTabs
from workbench.shell.reading import SOURCE, Reading, can_be_read

VERSION = 3
_TUBE = "tube"
_LOW_PX, _HIGH_PX = 600, 860
_SIDE_SHARE = 0.36
_SHARES = (0.58, 0.42)
_CANVAS_SHARE = 0.56
_SIDES = {
    "left": Qt.DockWidgetArea.LeftDockWidgetArea,
    "right": Qt.DockWidgetArea.RightDockWidgetArea,
    "top": Qt.DockWidgetArea.TopDockWidgetArea,
    "bottom": Qt.DockWidgetArea.BottomDockWidgetArea,
}

_CHECKSUM_BYTES = 4
_LEAST_PX = 72
_TABS_PX = 30


class DockArea(QMainWindow):
    """A workspace's area. Docks are added one by one; those named in ``lower`` begin in the lower half of the
    right side. Widgets that another area shows stay there until ``gather``. ``host`` is what the middle is
    in, ``halves`` the room that it has beside the docks.
    """

    def __init__(self, middle: QWidget, lower: Sequence[str]) -> None:
        super().__init__()
        self.setWindowFlags(Qt.WindowType.Widget)
        self.setMinimumSize(1, 1)  # an area that is not shown must not hold the window open
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)
        self.setDockOptions(QMainWindow.DockOption.AllowTabbedDocks | QMainWindow.DockOption.AllowNestedDocks)
        self.setTabPosition(Qt.DockWidgetArea.AllDockWidgetAreas, QTabWidget.TabPosition.North)
        self.swapped = False
        inner = middle.findChild(SwapPlace)
        self._middle = middle if inner is None else inner.content
        self._lower = tuple(lower)
        self._columns: list[tuple[list[list[QDockWidget]], bool]] = []
        self._afloat: list[QDockWidget] = []
        self._rooms: dict[QDockWidget, QSize] = {}
        self._rooms_to_read: dict[QDockWidget, QSize] = {}
        self._before_source: dict[QDockWidget, int] = {}
        self._focus: QWidget | None = None
        self.host = QWidget()
        column = QVBoxLayout(self.host)
        column.setContentsMargins(0, 0, 0, 0)
        self.halves = QSplitter()
        self.halves.addWidget(self.host)
        self.setCentralWidget(self.halves)
        self._place = self.host if inner is None else inner
        if inner is not None:
            column.addWidget(middle)
        self.docks: list[QDockWidget] = []
        self.tabs = DockTabs(self, lambda: self.docks)
        self.tabs.chosen.connect(self.make_room)
        self._widgets: dict[str, QWidget] = {}
        self._sides: dict[str, Qt.DockWidgetArea] = {}
        self._fill_middle(self._middle)

    def add(self, part: DockPart) -> None:
        """Add a dock; those of one side keep the order in which they come."""
        name, title, widget, side = part
        asked = _SIDES[side] if isinstance(side, str) else side
        self._widgets[name] = widget
        self._sides[name] = _SIDES["right"] if name in self._lower else asked
        dock = QDockWidget(title, self)
        dock.setObjectName(name)
        dock.toggleViewAction().setToolTip(_("Show or hide {title}").format(title=title))
        self.tabs.follow(dock)
        self.docks.append(dock)
        self.addDockWidget(self._sides[name], dock)
        if self._sides[name] in (_SIDES["left"], _SIDES["right"]):
            _let_be_low(widget)
        if widget.parentWidget() is None:
            dock.setWidget(widget)

    def dock(self, name: str) -> QDockWidget:
        """The dock of this name."""
        return next(dock for dock in self.docks if dock.objectName() == name)

    # What the docks and the middle hold

    def gather(self) -> None:
        """Take the widgets that other areas had meanwhile."""
        for name, widget in self._widgets.items():
            swapped = self.swapped and name == _TUBE
            self._fill(self.dock(name), self._middle if swapped else widget)
        self._fill_middle(self._widgets[_TUBE] if self.swapped else self._middle)

    @property
    def can_swap(self) -> bool:
        """Whether there is a tube to take the place of the middle."""
        return _TUBE in self._widgets

    def swap(self) -> None:
        """Exchange what fills the middle with the tube, or back; the focus stays where it is."""
        focus = self.window().focusWidget()
        self.swapped = not self.swapped
        rooms = self.in_front()
        self.gather()
        dock = self.dock(_TUBE)
        dock.setWindowTitle(_("Canvas") if self.swapped else _("Tube"))
        dock.show()
        dock.raise_()
        if self.swapped:
            self._rooms = rooms
            self._give_room([dock], [round(self.height() * _CANVAS_SHARE)], Qt.Orientation.Vertical)
        else:
            self.bring_to_front(self._rooms)
        self._focus_again(focus)

    @staticmethod
    def _fill(dock: QDockWidget, widget: QWidget) -> None:
        if dock.widget() is not widget:
            dock.setWidget(widget)
            widget.show()

    def _fill_middle(self, widget: QWidget) -> None:
        layout = self._place.layout()
        if layout is not None and layout.indexOf(widget) < 0:
            layout.addWidget(widget)
            widget.show()
        self.host.setFocusProxy(widget)

    # Reading

    @property
    def can_read(self) -> bool:
        """Whether there are a source and tables to be read."""
        return can_be_read(self._widgets)

    def read(self) -> Reading:
        """A page with the middle in its left half, source and tables in its right one; this area rests."""
        self._rooms_to_read = self.in_front()
        self.rest()
        titles = {dock.objectName(): dock.windowTitle() for dock in self.docks}
        parts = {name: (titles[name], widget) for name, widget in self._widgets.items()}
        return Reading(self.host, parts, self.width())

    def stop_reading(self) -> None:
        """Take back from the page what it shows, once this area is on the screen again."""
        self.halves.addWidget(self.host)
        self.host.show()
        self.gather()
        self.bring_to_front(self._rooms_to_read)
        self.wake()

    def _focus_again(self, focus: QWidget | None) -> None:
        if focus is not None and self.isAncestorOf(focus) and focus.isVisibleTo(self):
            focus.setFocus()
        else:
            self.host.setFocus()

    # Where the docks are

    def place(self, window_height: int) -> None:
        """Put the docks of an area that was just made where they begin; they get their room by ``wake``.

        A side column is one group of tabs in a very low window, two in a low one, all stacked in a high one.
        """
        by_side: dict[Qt.DockWidgetArea, list[QDockWidget]] = {}
        for dock in self.docks:
            by_side.setdefault(self._sides[dock.objectName()], []).append(dock)
        for side, docks in by_side.items():
            self._place_side(side, docks, window_height)

    def _place_side(self, side: Qt.DockWidgetArea, docks: list[QDockWidget], height: int) -> None:
        sideways = side in (_SIDES["left"], _SIDES["right"])
        along = Qt.Orientation.Vertical if sideways else Qt.Orientation.Horizontal
        upper = [dock for dock in docks if dock.objectName() not in self._lower]
        lower = sorted(
            (dock for dock in docks if dock not in upper), key=lambda d: self._lower.index(d.objectName())
        )
        for dock in (*upper, *lower):
            self.addDockWidget(side, dock, along)
        groups = [group for group in (upper, lower) if group]
        if height < _LOW_PX:
            groups = [[*upper, *lower]]
        if sideways and height < _HIGH_PX:
            for group in groups:
                for dock in group[1:]:
                    self.tabifyDockWidget(group[0], dock)
                group[0].raise_()
        if sideways:
            self._columns.append((groups, height < _HIGH_PX))

    def _share_room(self) -> None:
        """Give the columns of docks that were just placed the room they begin with."""
        columns, self._columns = self._columns, []
        for groups, tabbed in columns:
            first = [group[0] for group in groups]
            if tabbed and len(groups) == 2:
                self._give_room(first, self._heights(groups[0]), Qt.Orientation.Vertical)
            widths = [round(self.width() * _SIDE_SHARE)] * len(first)
            self._give_room(first, widths, Qt.Orientation.Horizontal)

    def _heights(self, upper: list[QDockWidget]) -> list[int]:
        """How high the two groups of a side column begin: the upper one as its source asks for."""
        whole = self.height()
        high = round(whole * _SHARES[0])
        if upper[0].objectName() == SOURCE:
            high = min(max(high, self._widgets[SOURCE].sizeHint().height() + _TABS_PX), whole - _LEAST_PX)
        return [high, whole - high]

    @property
    def arrangement(self) -> QByteArray:
        """Where the docks are, to be remembered, behind its checksum."""
        state = self.saveState(VERSION)
        return QByteArray(_checksum(state) + state.data())

    def restore(self, kept: QByteArray) -> bool:
        """Take a remembered arrangement, in an area that was just made; False when it cannot be used.

        Docks that it does not know, as it was kept before they came to be, are shown where they begin.
        """
        state = kept.sliced(_CHECKSUM_BYTES) if kept.size() > _CHECKSUM_BYTES else QByteArray()
        # Qt dies of some arrangements in which a byte is wrong.
        return kept.startsWith(_checksum(state)) and self.restoreState(state, VERSION)

    def in_front(self) -> dict[QDockWidget, QSize]:
        """The docks that are seen, with the room each has, its tabs included."""
        seen = [dock for dock in self.docks if not dock.isFloating() and self._is_seen(dock)]
        return {dock: dock.size() + QSize(0, self.tabs.height(dock)) for dock in seen}

    def _is_seen(self, dock: QDockWidget) -> bool:
        """Whether it lies in the area; one behind another tab is put outside."""
        return dock.isVisible() and self.rect().intersects(dock.geometry())

    def bring_to_front(self, rooms: Mapping[QDockWidget, QSize]) -> None:
        """Let these docks be seen again, in the room that they had."""
        docks, sizes = list(rooms), list(rooms.values())
        if not docks:
            return
        for dock in docks:
            dock.raise_()
        self._give_room(docks, [size.width() for size in sizes], Qt.Orientation.Horizontal)
        self._give_room(docks, [size.height() for size in sizes], Qt.Orientation.Vertical)

    def _give_room(self, docks: Sequence[QDockWidget], sizes: Sequence[int], along: Qt.Orientation) -> None:
        """Widths or heights of docks; those that float meanwhile keep theirs."""
        rooms = {dock: size for dock, size in zip(docks, sizes, strict=True) if not dock.isFloating()}
        self.resizeDocks(list(rooms), list(rooms.values()), along)

    def bring_forward(self, name: str) -> None:
        """Show a dock, before those that it shares its place with."""
        dock = self.dock(name)
        dock.show()
        dock.raise_()
        QTimer.singleShot(0, self, lambda: self.make_room(dock))  # once it is in front

    def make_room(self, dock: QDockWidget) -> None:
        """Let the source be as high as it asks for when it is chosen.

        When it is left for another tab, the column is as before.
        """
        if dock.objectName() == SOURCE:
            asked = self._widgets[SOURCE].sizeHint().height()
            if dock.height() < asked and not dock.isFloating() and self._is_seen(dock):
                self._before_source = self._in_column(dock)
                self._set_heights({**self._before_source, dock: asked + self.tabs.height(dock)}, dock)
        elif self._before_source and dock in self.tabifiedDockWidgets(self.dock(SOURCE)):
            before, self._before_source = self._before_source, {}
            docks = [dock if each.objectName() == SOURCE else each for each in before]
            self._give_room(docks, list(before.values()), Qt.Orientation.Vertical)

    def _in_column(self, dock: QDockWidget) -> dict[QDockWidget, int]:
        """The docks above and below one that are seen, itself included, with the height of each."""
        left, right = dock.geometry().left(), dock.geometry().right()
        return {
            each: size.height()
            for each, size in self.in_front().items()
            if each.geometry().left() <= right and each.geometry().right() >= left
        }

    def _set_heights(self, heights: Mapping[QDockWidget, int], first: QDockWidget) -> None:
        """Give ``first`` its height, and the others of a column theirs as far as there is room."""
        others = {dock: height for dock, height in heights.items() if dock is not first}
        room = sum(self._in_column(first).values()) - heights[first]
        share = room / max(sum(others.values()), 1)
        docks = [first, *others]
        sizes = [heights[first], *(max(round(height * share), 1) for height in others.values())]
        self._give_room(docks, sizes, Qt.Orientation.Vertical)

    # Leaving and coming back

    def rest(self) -> None:
        """Leave the screen: docks that float would stay, and the focus would go to whoever comes next."""
        focus = QApplication.focusWidget() or self.window().focusWidget()
        self._focus = focus if focus is not None and self.isAncestorOf(focus) else None
        self._afloat = [dock for dock in self.docks if dock.isFloating() and not dock.isHidden()]
        for dock in self._afloat:
            dock.hide()

    def wake(self) -> None:
        """Come to the screen: as its docks were just placed, or as it was left."""
        self._share_room()
        for dock in self._afloat:
            dock.show()
        self._afloat = []
        focus = self._focus if self._focus is not None and isValid(self._focus) else None
        if focus is None or not self.isAncestorOf(focus) or not focus.isVisibleTo(self):
            focus = self.host
        focus.setFocus()


def _let_be_low(widget: QWidget) -> None:
    """Let a dock beside the middle be as low as the window makes it.

    Where two above one another ask for more than there is, Qt lays the upper one over the lower.
    """
    policy = widget.sizePolicy()
    policy.setVerticalPolicy(QSizePolicy.Policy.Ignored)
    widget.setSizePolicy(policy)
    widget.setMinimumHeight(min(_LEAST_PX, widget.minimumSizeHint().height()))


def _checksum(state: QByteArray) -> bytes:
    return zlib.crc32(state.data()).to_bytes(_CHECKSUM_BYTES)
