"""The bar along the top: Home and the workspaces, the current one underlined; a drop-down when narrow."""

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QMenu, QSizePolicy, QToolButton, QWidget

from workbench.language import _
from workbench.widgets.icons import set_icon
from workbench.widgets.tokens import tokens

HEIGHT_PX = 36


class _Tab(QToolButton):
    """One workspace; a line under it while it is current."""

    def __init__(self, title: str, tooltip: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setText(title)
        self.setToolTip(tooltip)
        self.setAccessibleName(title)
        self.setCheckable(True)
        self.setAutoRaise(True)
        self.setFixedHeight(HEIGHT_PX - 1)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setObjectName("workspaceTab")

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().horizontalAdvance(self.text()) + 28, HEIGHT_PX - 1)

    def paintEvent(self, event: QPaintEvent) -> None:
        now = tokens()
        painter = QPainter(self)
        if self.underMouse() or self.hasFocus():
            painter.fillRect(self.rect().adjusted(0, 4, 0, -4), QColor(now.selected))
        if self.isChecked():
            painter.fillRect(8, self.height() - 3, self.width() - 16, 3, QColor(now.accent))
        painter.setPen(QColor(now.text if self.isChecked() or self.underMouse() else now.muted))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.text())
        if self.hasFocus():
            painter.setPen(QColor(now.accent))
            painter.drawRoundedRect(self.rect().adjusted(1, 4, -2, -5), 4, 4)


class WorkspaceBar(QWidget):
    """``chosen`` carries the slug of what was pressed. Commands stand at the right end."""

    chosen = Signal(str)

    def __init__(self, places: Sequence[tuple[str, str, str]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("workspaces")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(HEIGHT_PX)
        self.setAccessibleName(_("Workspaces"))
        self._tabs: dict[str, _Tab] = {}
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(4, 0, 6, 1)
        self._row.setSpacing(0)
        self._folded = QToolButton(self)
        self._folded.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._folded.setToolTip(_("Change the workspace"))
        self._folded.setMenu(QMenu(self._folded))
        self._folded.hide()
        self._row.addWidget(self._folded)
        for slug, title, tooltip in places:
            tab = _Tab(title, tooltip, self)
            tab.clicked.connect(lambda _checked=False, slug=slug: self.chosen.emit(slug))
            self._row.addWidget(tab)
            self._tabs[slug] = tab
            entry = self._folded.menu().addAction(title)
            entry.triggered.connect(lambda _checked=False, slug=slug: self.chosen.emit(slug))
        self._row.addStretch(1)
        self._commands: list[QToolButton] = []

    def show_current(self, slug: str) -> None:
        """Mark where one is; a page that is no workspace marks none."""
        for each, tab in self._tabs.items():
            tab.setChecked(each == slug)
            if each == slug:
                self._folded.setText(tab.text() + "  \u25be")
        if slug not in self._tabs:
            self._folded.setText(_("Workspaces") + "  \u25be")

    def set_waiting(self, slug: str, waiting: bool) -> None:
        """Tell that a workspace is being prepared."""
        self._tabs[slug].setAccessibleDescription(_("being prepared") if waiting else "")

    def add_commands(self, actions: Sequence[tuple[QAction, str]]) -> None:
        """Put commands with their icons at the right end."""
        for action, name in actions:
            button = QToolButton(self)
            button.setDefaultAction(action)
            button.setAccessibleName(action.text().replace("&", ""))
            button.setIconSize(QSize(20, 20))
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            set_icon(action, name)
            self._row.addWidget(button)
            self._commands.append(button)
        self._fold()

    @property
    def folded(self) -> bool:
        """Whether the workspaces are a drop-down now."""
        return not self._folded.isHidden()

    def minimumSizeHint(self) -> QSize:
        return QSize(160, HEIGHT_PX)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fold()

    def _fold(self) -> None:
        needed = sum(tab.sizeHint().width() for tab in self._tabs.values())
        needed += sum(button.sizeHint().width() for button in self._commands) + 24
        narrow = needed > self.width()
        self._folded.setVisible(narrow)
        for tab in self._tabs.values():
            tab.setVisible(not narrow)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
