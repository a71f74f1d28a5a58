"""The pages of the window by name. Home is there at the first frame; the others are made when asked for."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from workbench.shell.home import HomePage

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from workbench.shell.window import MainWindow

__all__ = ["HomePage", "make_page"]


def make_page(window: MainWindow, name: str) -> QWidget:
    """The page home, settings, help, keys or about."""
    if name == "home":
        return _home(window)
    from workbench.shell.about import AboutPage
    from workbench.shell.help import HelpPage, KeysPage
    from workbench.shell.settings_page import SettingsPage

    kinds = {"settings": SettingsPage, "about": AboutPage, "help": HelpPage, "keys": KeysPage}
    return kinds[name](window)


def _home(window: MainWindow) -> HomePage:
    home = HomePage(window.settings.recent())
    home.new_wanted.connect(lambda: window.when_ready(window.files.new))
    home.open_wanted.connect(lambda: window.when_ready(window.files.open))
    home.file_chosen.connect(lambda path: window.when_ready(partial(window.files.open_path, path)))
    home.example_chosen.connect(lambda slug: window.when_ready(partial(window.open_example, slug)))
    home.question_chosen.connect(lambda question: window.when_ready(partial(window.open_question, question)))
    return home
