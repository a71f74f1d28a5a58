"""Menus and actions, made from the table of commands, and kept as able as the session is."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMenu

from workbench.language import _, legible
from workbench.shell.actions import commands, key_text, menu_titles, submenu_titles
from workbench.shell.choice_keys import ChoiceKeys
from workbench.shell.enter_key import EnterKey
from workbench.shell.workspace_bar import WorkspaceBar
from workbench.widgets.look.comfort import comfort
from workbench.widgets.look.tips import plain_tip

if TYPE_CHECKING:
    from workbench.document.state import SessionState
    from workbench.shell.window import MainWindow

_CHECKABLE = ("ask_first", "detail")
_ON_THE_BAR = ("undo", "redo", "palette", "settings")


class Menus(QObject):
    """``actions``, ``commands`` and ``submenus`` by their id."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.commands = {command.id: command for command in commands()}
        self.actions: dict[str, QAction] = {}
        self.submenus: dict[str, QMenu] = {}
        self._listed_sheets: list[QAction] = []
        for command in self.commands.values():
            told = f"\t{key_text(command.focused_key)}" if command.focused_key else ""
            action = QAction(command.text + told, window)
            action.setObjectName(command.id)
            action.setShortcuts([QKeySequence(key) for key in command.keys])
            keys = f" ({key_text(command.keys[0])})" if command.keys else ""
            action.setToolTip(command.tooltip + keys)
            action.setCheckable(command.id in _CHECKABLE)
            action.triggered.connect(lambda _checked=False, command=command: window.do(command))
            window.addAction(action)
            self.actions[command.id] = action
        comfort.changed.connect(self._keep_calm)
        self._make_menus()
        EnterKey(window)
        ChoiceKeys(window)
        self.refresh()

    def refresh(self, *_what: object) -> None:
        """Enable what can be done now; name what undo and redo would do."""
        session = self._window.session
        stepping = session is not None and session.run.entry is not None
        able_to = {"run": stepping, "answer": session is not None and session.run.refused}
        for command in self.commands.values():
            if command.needs in able_to:
                self.actions[command.id].setEnabled(able_to[command.needs])
        stack = None if session is None else session.undo_stack
        for name, able, what in (
            ("undo", stack and stack.canUndo(), stack and stack.undoText()),
            ("redo", stack and stack.canRedo(), stack and stack.redoText()),
        ):
            verb = self.commands[name].text
            self.actions[name].setEnabled(bool(able))
            self.actions[name].setText(f"{verb}: {what}" if able and what else verb)

    def take_state(self, _old: object, state: "SessionState") -> None:
        """Check what is switched on."""
        for name in _CHECKABLE:
            self.actions[name].setChecked(getattr(state, name))

    def _keep_calm(self) -> None:
        """What is chosen in Display holds the next time, too."""
        self._window.settings.set("calm", comfort.calm)

    def add_icons(self, bar: WorkspaceBar) -> Iterator[None]:
        """Give the actions their icons, and the bar its buttons."""
        from workbench.widgets.look.icons import set_icon

        yield
        bar.add_commands([(self.actions[name], self.commands[name].icon) for name in _ON_THE_BAR])
        yield
        for command in self.commands.values():
            if command.icon and command.id not in _ON_THE_BAR:
                set_icon(self.actions[command.id], command.icon)
        yield

    def _make_menus(self) -> None:
        for menu_id, title in menu_titles():
            menu = self._window.menu_bar.addMenu(title)
            self._fill_menu(menu, menu_id)
            if menu_id == "view":
                menu.addSeparator()
                self._docks = menu.addMenu(_("Docks"))
                self._docks.aboutToShow.connect(self._fill_docks)
                self._sheets = self.submenus["sheets"]
                self._sheets.addSeparator()
                self._sheets.aboutToShow.connect(self._fill_sheets)
                menu.addMenu(self._sheets)  # after the docks

    def _fill_menu(self, menu: QMenu, menu_id: str) -> None:
        menu.setToolTipsVisible(True)
        for command in self.commands.values():
            if command.menu != menu_id:
                continue
            if command.separated:
                menu.addSeparator()
            menu.addAction(self.actions[command.id])
            if command.id == "open":
                self._recent = menu.addMenu(_("Open recent"))
                self._recent.aboutToShow.connect(self._fill_recent)
            if command.id == "select_all":
                self._transforms = menu.addMenu(_("Transform"))
                self._transforms.aboutToShow.connect(self._fill_transforms)
            for inner, title, follows in submenu_titles():
                if command.id == follows:
                    self.submenus[inner] = menu.addMenu(title)
                    self._fill_menu(self.submenus[inner], inner)
        if menu_id == "export":
            self._tables = menu.addMenu(_("Export another table"))
            self._tables.aboutToShow.connect(self._fill_tables)

    def _fill_tables(self) -> None:
        self._tables.clear()
        for offer in self._window.files.exports.tables():
            self._tables.addAction(offer.title, offer.ask)
        self._if_empty(self._tables, _("None here"))

    def _fill_transforms(self) -> None:
        self._transforms.clear()
        for panel in self._window.panels(self._window.place)[:1]:
            self._transforms.addActions(panel.transforming())
        self._if_empty(self._transforms, _("None here"))

    def _fill_recent(self) -> None:
        window, menu = self._window, self._recent
        menu.clear()
        for path in window.settings.recent():
            entry = menu.addAction(legible(path.name).replace("&", "&&"))
            entry.setToolTip(plain_tip(str(path)))
            entry.triggered.connect(partial(window.when_ready, partial(window.files.open_path, path)))
        self._if_empty(menu, _("None yet"))

    def _fill_docks(self) -> None:
        self._docks.clear()
        arrangements = self._window.arrangements
        for dock in arrangements.docks(self._window.place):
            if arrangements.reading:  # all of them are put away, and one that is chosen brings them back
                bring = partial(arrangements.bring_forward, dock.objectName())
                self._docks.addAction(dock.windowTitle(), bring)
            else:
                self._docks.addAction(dock.toggleViewAction())
        self._if_empty(self._docks, _("This page has none"))

    def _fill_sheets(self) -> None:
        while self._listed_sheets:
            self._sheets.removeAction(self._listed_sheets.pop())
        session = self._window.session
        for sheet in session.document.sheets if session is not None else ():
            entry = self._sheets.addAction(legible(sheet.name).replace("&", "&&"))
            entry.setCheckable(True)
            entry.setChecked(sheet is session.sheet)
            entry.triggered.connect(partial(self._window.files.show_sheet, sheet.id))
            self._listed_sheets.append(entry)

    @staticmethod
    def _if_empty(menu: QMenu, text: str) -> None:
        if menu.isEmpty():
            menu.addAction(text).setEnabled(False)
