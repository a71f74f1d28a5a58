"""The main window: bars, pages and workspaces around one session.

What the first frame needs is made first; ``complete`` makes the rest, and a session arrives by ``attach``.
For the sake of that first frame this module, and what it imports at its top, names no part of Qt that is slow
to load: the namespace ``Qt`` alone takes a tenth of the time a bare window takes from start to first frame.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QSize, QTimer, Signal
from PySide6.QtWidgets import QMainWindow, QMenuBar, QStackedWidget, QVBoxLayout, QWidget

from workbench.language import _
from workbench.paths import resource
from workbench.shell.places import HomePage, make_page
from workbench.shell.settings import Settings
from workbench.shell.theme import ThemeSwitch
from workbench.shell.workspace_bar import WorkspaceBar
from workbench.shell.workspace_panels import WorkspacePanels
from workbench.shell.workspaces import Workspace, titles, workspaces
from workbench.widgets.look.type_faces import type_scale

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QPaintEvent
    from PySide6.QtWidgets import QToolBar

    from workbench.panels.panel import Panel
    from workbench.session.session import Session
    from workbench.shell.actions import Command
    from workbench.shell.arrangement import Arrangements
    from workbench.shell.arriving import Arriving
    from workbench.shell.files import Files
    from workbench.shell.menus import Menus
    from workbench.shell.message_bar import MessageBar
    from workbench.shell.questions import Question
    from workbench.shell.status import Status
    from workbench.shell.views import Views

PROGRAM = "Graphics Workbench"
FIRST_SIZE = (1280, 680)
SMALLEST, FRAME = (640, 420), QSize(8, 36)
MENU_PADDING, STATUS_PADDING = 14, 10


class MainWindow(QMainWindow):
    """Home can be painted without a session; ``attach`` brings one, and ``build`` the rest in slices.

    ``place`` is the slug of the workspace or page in the middle, ``came_from`` that from which a page beside
    the work was opened. ``first_frame`` is sent once, after it was painted; ``entered`` after a workspace is
    shown.
    """

    first_frame = Signal()
    entered = Signal(str)
    place = came_from = ""
    files: Files
    arrangements: Arrangements
    views: Views
    menus: Menus
    messages: MessageBar
    status: Status
    steps: QToolBar

    def __init__(
        self, settings: Settings, themes: ThemeSwitch, offered: Sequence[Workspace] | None = None
    ) -> None:
        super().__init__()
        self.settings = settings
        self.themes = themes
        self.session: Any = None
        self._offered = {each.slug: each for each in (workspaces() if offered is None else offered)}
        self._panels = WorkspacePanels(self)
        self._pages: dict[str, QWidget] = {}
        self.arriving: Arriving | None = None
        self._painted = False
        self._complete = False
        self._closing = False
        self._wanted: list[Callable[[], object]] = []
        self.setWindowTitle(PROGRAM)
        themes.dress(self)
        self.setMinimumSize(*SMALLEST)
        self.resize(QSize(*FIRST_SIZE).boundedTo(self.screen().availableSize() - FRAME))
        self.setAcceptDrops(True)
        self.top = QWidget()
        self._top_column = QVBoxLayout(self.top)
        self._top_column.setContentsMargins(0, 0, 0, 0)
        self._top_column.setSpacing(0)
        self.menu_bar = QMenuBar()
        home = ("home", _("Home"), _("Recent pictures, examples and questions"))
        self.bar = WorkspaceBar([home, *((w.slug, w.title, w.tooltip) for w in self._offered.values())])
        self.bar.chosen.connect(self.go)
        self._top_column.addWidget(self.menu_bar)
        self._top_column.addWidget(self.bar)
        self.setMenuWidget(self.top)
        self.stack = QStackedWidget()
        self.setCentralWidget(self.stack)
        type_scale.changed.connect(self._fit_bars)
        self._fit_bars()
        if (geometry := settings.arrangement("window")) is not None:
            self.restoreGeometry(geometry)
        self.show_page("home")

    def _fit_bars(self) -> None:
        self.menu_bar.setFixedHeight(self.fontMetrics().height() + MENU_PADDING)
        self.statusBar().setFixedHeight(self.fontMetrics().height() + STATUS_PADDING)

    def complete(self) -> None:
        """Make what the first frame did without: menus, messages, docks, step bar, status."""
        if self._complete:
            return
        self._complete = True
        from PySide6.QtCore import Qt
        from PySide6.QtGui import QIcon
        from PySide6.QtWidgets import QToolBar

        from workbench.shell.arrangement import Arrangements
        from workbench.shell.files import Files
        from workbench.shell.menus import Menus
        from workbench.shell.message_bar import MessageBar
        from workbench.shell.status import Status
        from workbench.shell.views import Views

        self.setWindowIcon(QIcon(str(resource("icon", "graphics-workbench.png"))))
        self.themes.follow_system()
        self.messages = MessageBar()
        self.messages.postponed.connect(self.say_status)
        self._top_column.addWidget(self.messages)
        self.files = Files(self)
        self.arrangements = Arrangements(self.stack, self.settings)
        self.views = Views(self)
        self.status = Status(self.statusBar())
        self.status.preparing(_("preparing"))
        self.menus = Menus(self)
        self.steps = QToolBar(_("Step bar"), self)
        self.steps.setObjectName("steps")
        self.steps.setMovable(False)
        self.steps.toggleViewAction().setVisible(False)
        self.addToolBar(Qt.ToolBarArea.BottomToolBarArea, self.steps)
        self.steps.hide()
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)

    def do(self, command: Command) -> None:
        """Carry out a command of the table, or keep it until the session it needs is there."""
        if command.needs:
            self.when_ready(partial(command.handler, self))
        else:
            command.handler(self)

    # After the first frame

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._painted:
            self._painted = True
            QTimer.singleShot(0, self.first_frame.emit)

    def attach(self, session: Session) -> None:
        """Take the session that everything works on."""
        self.complete()
        self.session = session
        session.changed.connect(self.menus.refresh)
        session.undo_stack.indexChanged.connect(self.menus.refresh)
        session.state_changed.connect(self.menus.take_state)
        session.path_changed.connect(self.files.refresh_title)
        session.dirty_changed.connect(self.files.refresh_title)
        for signal in (session.run.changed, session.run.asked):
            signal.connect(self.menus.refresh)
        self.status.follow(session.run)
        session.unfolding.progressed.connect(self.status.tell_unfolding)
        self.files.follow(session)
        self.files.refresh_title()
        self.menus.refresh()
        self.menus.take_state(session.state, session.state)
        wanted, self._wanted = self._wanted, []
        for act in wanted:
            act()

    def build(self) -> Iterator[None]:
        """The rest of the window, one slice per step."""
        from workbench.shell.home_examples import thumbnails

        home = self._pages["home"]
        assert isinstance(home, HomePage)
        home.show_questions()
        yield from self.menus.add_icons(self.bar)
        shown = []
        for example, picture in thumbnails(self.devicePixelRatioF()):
            shown.append((example.slug, example.title, titles()[example.workspace], picture))
            yield
        home.show_examples(shown)

    # Workspaces and pages

    @property
    def workspace_slugs(self) -> tuple[str, ...]:
        """The workspaces offered, in order."""
        return tuple(self._offered)

    def go(self, slug: str) -> None:
        """Show a page or a workspace."""
        (self.enter if slug in self._offered else self.show_page)(slug)

    def enter(self, slug: str, then: Callable[[], object] = lambda: None) -> None:
        """Show a workspace, then do ``then``; ``arriving``, if any, makes its panels the first time."""
        if self.session is None:
            self.bar.set_waiting(slug, True)
            if self._complete:
                self.status.preparing(_("Preparing {title}").format(title=self._offered[slug].title))
            self.when_ready(partial(self.enter, slug, then))
            return
        if self.arriving is not None and not self._panels.of(slug):
            self.arriving.enter(self._offered[slug], then)
            return
        for _panel in self.prepare(slug):
            pass
        if self.place != slug:
            self._show(slug)
        then()

    def _show(self, slug: str) -> None:
        self._leave()
        usable = self.arrangements.show(slug)
        self.steps.setVisible(self._offered[slug].steps)
        self.place = slug
        self.bar.show_current(slug)
        self.status.in_workspace(self._offered[slug].steps, self.panels(slug))
        if not usable:
            self.messages.say(_("The remembered arrangement could not be used, so this is the original one."))
        elif self.settings.drop_older_arrangements():
            self.messages.say(_("Docks are arranged differently in this version; your old layout was reset."))
        self.entered.emit(slug)

    def workspace(self, slug: str) -> Workspace:
        """The workspace of this slug, one of those offered."""
        return self._offered[slug]

    def panels(self, slug: str) -> list[Panel]:
        """The panels of a workspace, empty before it was first shown."""
        return self._panels.of(slug)

    def prepare(self, slug: str) -> Iterator[None]:
        """Make the panels of a workspace step by step; who asks later goes on where the first stopped."""
        return self._panels.prepare(slug)

    def show_page(self, name: str) -> None:
        """Show a page: home, settings, help, keys or about."""
        if name not in self._pages:
            self._pages[name] = make_page(self, name)
            self.stack.addWidget(self._pages[name])
        if self._complete:
            self._leave()
        self.stack.setCurrentWidget(self._pages[name])
        self._pages[name].setFocus()
        self.place = name
        self.bar.show_current(name)

    def _leave(self) -> None:
        """Take leave of a workspace: what floats over it goes, its arrangement is remembered."""
        from workbench.shell.command_palette import CommandPalette
        from workbench.shell.hints import end_hints

        end_hints(self)
        for palette in self.findChildren(CommandPalette):
            palette.leave()
        self.views.together()
        self.arrangements.leave()
        self.steps.hide()
        self.status.in_workspace(False)

    def when_ready(self, act: Callable[[], object]) -> None:
        """Do something now, or as soon as the session is there."""
        if self.session is None:
            self._wanted.append(act)
        else:
            act()

    def open_example(self, slug: str) -> None:
        """Open a built-in picture in its workspace."""
        from workbench.shell import opening

        opening.open_example(self, slug)

    def open_question(self, question: Question) -> None:
        """Open workspace, example and step of a question."""
        from workbench.shell import opening

        opening.open_question(self, question)

    def refresh_recent(self) -> None:
        """Show the recent files anew."""
        home = self._pages.get("home")
        if isinstance(home, HomePage):
            home.show_recent(self.settings.recent())

    # Commands that the table names

    def undo(self) -> None:
        """Take the last edit back."""
        self.session.end_merge()
        self.session.undo_stack.undo()

    def run_do(self, name: str) -> None:
        """Move the cursor of the run (first, back, forward, last), or act on a wrong answer."""
        if self.place in self._offered:
            getattr(self.session.run, name)()

    def toggle_detail(self) -> None:
        """Change between rows and lines."""
        self.session.run.set_detail(not self.session.run.detail)

    def toggle_ask_first(self) -> None:
        """Ask for the next pixel before it is shown, or stop asking."""
        self.session.update_state(ask_first=not self.session.state.ask_first)

    def show_palette(self) -> None:
        """Find a command by a few letters."""
        from workbench.shell.command_palette import CommandPalette

        CommandPalette.open_over(self)

    def show_hints_again(self) -> None:
        """Point at canvas, step bar and source once more."""
        self.settings.set("hints", True)
        self.enter("draw", self.show_hints)

    def show_hints(self, workspace: str = "draw") -> None:
        """Point at canvas, step bar and source, unless this was dismissed for good."""
        from workbench.shell.hints import show_hints

        if workspace == "draw":
            show_hints(self)

    def reset_workspace(self) -> None:
        """Put every dock, and every line between parts, back where it was at first."""
        self.views.together()
        self.arrangements.reset()

    def say_status(self, text: str) -> None:
        """Say something in passing."""
        self.status.say(text)

    # Dropped files, closing

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if self.session is not None:
            self.files.offer_drop(event)

    def dropEvent(self, event: QDropEvent) -> None:
        self.files.take_drop(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.session is not None and not self.files.finish_saving():
            event.ignore()  # else the failure would be said in a window that goes
            return
        if self.session is not None and self.session.dirty and not self._closing:
            event.ignore()
            self.files.unless_unsaved(self._close_now)
            return
        if self._complete:
            self._leave()
        self.settings.keep_arrangement("window", self.saveGeometry())
        self.settings.write()
        if self.session is not None:
            self.session.undo_stack.indexChanged.disconnect(self.menus.refresh)  # its end sends it once more
            self.session.close()
        super().closeEvent(event)

    def _close_now(self) -> None:
        """Close; where something keeps the window open, what is changed from then on is asked about again."""
        self._closing = True
        self.close()
        self._closing = False
