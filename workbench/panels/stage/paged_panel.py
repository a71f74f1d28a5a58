"""The middle of a workspace of several pages, which are switched at the top."""

from collections.abc import Mapping, Sequence
from functools import partial

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QDockWidget,
    QMainWindow,
    QMenu,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, PlainPanel, Said
from workbench.panels.stage.workspace_page import Page, PageRow
from workbench.session.session import Session
from workbench.widgets.look.flow_layout import flowing
from workbench.widgets.look.in_sight import dock_around, in_front


class PagedPanel(PlainPanel, QWidget):
    """The pages of ``rows``, one at a time, and a switch for them. ``wing`` begins the names of its commands,
    ``pages`` are those of its pages that are made already.

    ``hover_text`` and ``zoom_text`` are for the status bar; ``page`` is the slug of the one that is shown.
    """

    hover_text = Signal(str)
    zoom_text = Signal(str)

    def __init__(
        self,
        session: Session,
        wing: str,
        rows: Sequence[PageRow],
        parent: QWidget | None = None,
        pages: Mapping[str, Page] | None = None,
    ) -> None:
        super().__init__(parent)
        self.session = session
        self._wing, self._rows = wing, rows
        self._pages: dict[str, Page] = {}
        self._zooms: dict[str, str] = {}  # what each page said last
        self._actions: list[QAction] = []
        self.page = ""
        self.stack = QStackedWidget()
        strip = QWidget()
        self.switch = flowing(strip, 4, 0)  # in a narrow window in further rows, so that no title is cut
        self.buttons = QButtonGroup(self)
        for number, row in enumerate(self._rows, 1):
            page = self._pages[row.slug] = (pages or {}).get(row.slug) or row.make(session)
            self.stack.addWidget(page.widget)
            self._connect(row.slug, page)
            self._add_switch(number, row.slug, row.title, row.tooltip)
        KeysWhileSeen(self, self._actions)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        if len(self._rows) > 1:
            around = QVBoxLayout()
            around.setContentsMargins(8, 4, 8, 4)
            around.addWidget(strip)
            whole.addLayout(around)
        whole.addWidget(self.stack, 1)
        self._docks_placed = False
        self._stand_ins: list[QDockWidget] = []  # of no page, in front only for want of a page's own
        self.show_page(self._rows[0].slug)
        session.path_changed.connect(self._take_run)
        session.state_changed.connect(self._follow)

    def _connect(self, slug: str, page: Page) -> None:
        said = page.said()
        if said.hover is not None:
            said.hover.connect(self.hover_text)
        if said.zoom is not None:
            said.zoom.connect(partial(self._take_zoom, slug))

    def _take_zoom(self, slug: str, text: str) -> None:
        self._zooms[slug] = text
        if self.page == slug:
            self.zoom_text.emit(text)

    def _add_switch(self, number: int, slug: str, title: str, tooltip: str) -> None:
        button = QPushButton(title)
        button.setCheckable(True)
        button.setProperty("flat", True)
        button.setToolTip(f"{tooltip} (Alt+{number})")
        button.clicked.connect(partial(self.show_page, slug))
        self.buttons.addButton(button)
        self.switch.addWidget(button)
        action = QAction(_("Page {title}").format(title=title), self)
        action.setObjectName(f"{self._wing}.page_{number}")
        action.setShortcut(QKeySequence(f"Alt+{number}"))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.triggered.connect(partial(self.show_page, slug))
        self.addAction(action)
        self._actions.append(action)

    def show_page(self, slug: str = "", *_checked: object) -> None:
        """Show one of the pages, by default the first, and step what was stepped there."""
        if slug != self.page:
            self.hover_text.emit("")  # what was said is about the page before
        self.page = slug = slug or self._rows[0].slug
        number = [row.slug for row in self._rows].index(slug)
        page = self._pages[slug]
        self.stack.setCurrentIndex(number)
        self.zoom_text.emit(self._zooms.get(slug, ""))
        self.buttons.buttons()[number].setChecked(True)
        self.setFocusProxy(page.widget)
        self._bring_docks_forward()
        self._take_run()

    def _bring_docks_forward(self) -> None:
        """Where a dock of another page lies in front, put one of this page there, or else one of no page."""
        docks = {
            slug: [
                dock for _name, _title, part, _area in page.docks() if (dock := dock_around(part)) is not None
            ]
            for slug, page in self._pages.items()
        }
        own = docks[self.page]
        of_others = [dock for slug, those in docks.items() if slug != self.page for dock in those]
        stand_ins, self._stand_ins = filter(isValid, self._stand_ins), []  # those of a reset area are gone
        for foreign in [*of_others, *stand_ins]:
            area = foreign.parentWidget()
            if not isinstance(area, QMainWindow) or foreign.isFloating() or not in_front(foreign):
                continue
            beside = [foreign, *area.tabifiedDockWidgets(foreign)]
            if here := [dock for dock in own if dock in beside]:
                here[0].raise_()
            elif common := [dock for dock in beside if dock not in of_others]:
                self._stand_ins.append(common[0])
                common[0].raise_()

    def _follow(self, *_states: object) -> None:
        """Show the page whose run is stepped, since another page may have led there."""
        visited = self.session.state.workspace
        if self.isVisible() and visited != self.page and visited in self._pages:
            self.show_page(visited)

    def page_of(self, slug: str) -> Page:
        """The page of this slug. LookupError: there is none."""
        return self._pages[slug]

    def _take_run(self, *_path: object) -> None:
        """Step what is stepped on this page, when it comes to be seen, or another document under it."""
        if self.isVisible():
            self.session.visit(self.page, self._pages[self.page].usual)

    def showEvent(self, event: QShowEvent) -> None:
        """The run is that of the page."""
        super().showEvent(event)
        self._take_run()
        if not self._docks_placed:
            self._docks_placed = True
            QTimer.singleShot(0, self, self._bring_docks_forward)

    def point_at(self, cell: Cell | None) -> None:
        """Show on the page where a pixel is that the sentence names."""
        self._pages[self.page].point_at(cell)

    def show_example(self) -> None:
        """That of the page."""
        self.session.open_example(self._pages[self.page].example)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """Those of the page."""
        return self._pages[self.page].tables()

    def copy(self) -> bool:
        """What the page copies."""
        return self._pages[self.page].copy()

    def paste(self) -> bool:
        """Into the page."""
        return self._pages[self.page].paste()

    def derivation(self) -> Derivation | None:
        """That of the page."""
        return self._pages[self.page].derivation()

    def drawing(self) -> Derivation | None:
        """That of the page."""
        return self._pages[self.page].drawing()

    def offer_export(self, menu: QMenu) -> None:
        """Let the menus of every page lead to what can be exported."""
        for page in self._pages.values():
            page.offer_export(menu)

    # What the window places

    @property
    def center(self) -> QWidget:
        """What fills the middle of the workspace."""
        return self

    def docks(self) -> Sequence[DockPart]:
        """Those of all pages."""
        return [part for page in self._pages.values() for part in page.docks()]

    def actions(self) -> list[QAction]:
        """Every command of its pages, and the switch."""
        return [*self._actions, *(action for page in self._pages.values() for action in page.commands())]

    def said(self) -> Said:
        """What is pointed at or said in passing, and the scale."""
        return Said(self.hover_text, self.zoom_text)
