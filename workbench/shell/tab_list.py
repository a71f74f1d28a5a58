"""The list of the tabs of a bar that has no room for all of them, in place of Qt's arrows."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeyEvent
from PySide6.QtWidgets import QMenu, QTabBar, QToolButton
from shiboken6 import isValid

from workbench.language import _
from workbench.widgets.look.icons import set_icon

_WIDE_PX = 30
_CHANGES = (QEvent.Type.Show, QEvent.Type.Hide, QEvent.Type.Move, QEvent.Type.Resize)
_OPENING = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Down)


class TabList(QToolButton):
    """A button at the end of ``bar``, seen while some of its tabs are not; it lists all to choose from."""

    def __init__(self, bar: QTabBar) -> None:
        super().__init__(bar)
        self._bar = bar
        self._arrows = [each for each in bar.findChildren(QToolButton) if each is not self]
        set_icon(self, "caret-down")
        self.setAutoRaise(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(_("All views in this place"))
        self.setAccessibleName(_("All views in this place"))
        self.clicked.connect(self.open)
        for arrow in self._arrows:
            arrow.installEventFilter(self)
        self._place()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Qt shows its arrows where there is no room for all tabs."""
        if event.type() in _CHANGES:
            self._place()
        return False

    def _place(self) -> None:
        """Lie over the arrows, as long as they are there."""
        arrows = [arrow for arrow in self._arrows if isValid(arrow)]  # a bar that goes takes them first
        if not arrows:
            return
        self.setVisible(any(not arrow.isHidden() for arrow in arrows))
        left = min(self._bar.width() - _WIDE_PX, *(arrow.x() for arrow in arrows))
        self.setGeometry(left, 0, self._bar.width() - left, self._bar.height())
        self.raise_()

    def list(self) -> QMenu:
        """The tabs in their order, the one in front marked."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        one = QActionGroup(menu)
        for number in range(self._bar.count()):
            action = QAction(self._bar.tabText(number), one, checkable=True)
            action.setChecked(number == self._bar.currentIndex())
            action.triggered.connect(lambda _on, number=number: self._bar.setCurrentIndex(number))
            menu.addAction(action)
            if action.isChecked():
                menu.setActiveAction(action)
        return menu

    def open(self) -> None:
        """Show the list under the button."""
        menu = self.list()
        corner = self.rect().bottomRight()
        corner.setX(corner.x() - menu.sizeHint().width() + 1)
        menu.popup(self.mapToGlobal(corner))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter and Down open the list too."""
        if event.key() in _OPENING:
            self.open()
        else:
            super().keyPressEvent(event)
