"""Puts a theme on the whole program: Qt's palette, the style sheet, the tokens that painted widgets read."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QColor, QFont, QPalette
from PySide6.QtWidgets import QApplication, QMainWindow

from workbench.shell.style_sheet import style_sheet
from workbench.widgets.look.tokens import DARK, LIGHT, TEXT_PX, Tokens, theme
from workbench.widgets.look.type_faces import scaled, type_scale

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

CHOICES = ("system", "light", "dark")
_LARGE = 1.25


def palette_of(chosen: Tokens) -> QPalette:
    """Qt's palette for one theme."""
    role = QPalette.ColorRole
    made = QPalette()
    for which, value in (
        (role.Window, chosen.window),
        (role.Base, chosen.surface),
        (role.AlternateBase, chosen.window),
        (role.Button, chosen.raised),
        (role.Text, chosen.text),
        (role.WindowText, chosen.text),
        (role.ButtonText, chosen.text),
        (role.BrightText, chosen.error),
        (role.PlaceholderText, chosen.muted),
        (role.ToolTipBase, chosen.raised),
        (role.ToolTipText, chosen.text),
        (role.Highlight, chosen.accent),
        (role.HighlightedText, chosen.on_accent),
        (role.Link, chosen.accent),
        (role.LinkVisited, chosen.accent),
        (role.Light, chosen.raised),
        (role.Midlight, chosen.line),
        (role.Mid, chosen.line),
        (role.Dark, chosen.field_edge),
        (role.Shadow, chosen.field_edge),
        (role.Accent, chosen.accent),
    ):
        made.setColor(which, QColor(value))
    for which in (role.Text, role.WindowText, role.ButtonText):
        made.setColor(QPalette.ColorGroup.Disabled, which, QColor(chosen.field_edge))
    return made


class ThemeSwitch(QObject):
    """Keeps the application in the chosen theme: light, dark, or whatever the system says, as it says it."""

    def __init__(self, application: QApplication, choice: str = "system", large: bool = False) -> None:
        super().__init__(application)
        self._application = application
        self._choice = choice if choice in CHOICES else "system"
        self._large = large
        self._shown: tuple[str, bool] | None = None
        self._base = application.font()
        application.setStyle("Fusion")
        self._system_dark = application.palette().window().color().lightness() < 128
        self.apply()

    def follow_system(self) -> None:
        """Ask the system for its colour scheme and follow it from now on; before, its palette told."""
        hints = self._application.styleHints()
        hints.colorSchemeChanged.connect(self._take_scheme)
        self._take_scheme(hints.colorScheme())

    def _take_scheme(self, scheme: object) -> None:
        from PySide6.QtCore import Qt

        if scheme != Qt.ColorScheme.Unknown:
            self._system_dark = scheme == Qt.ColorScheme.Dark
        self.apply()

    @property
    def choice(self) -> str:
        """ "system", "light" or "dark"."""
        return self._choice

    def choose(self, choice: str, large: bool | None = None) -> None:
        """Take another theme, or larger type."""
        self._choice = choice if choice in CHOICES else "system"
        self._large = self._large if large is None else large
        self.apply()

    def apply(self) -> None:
        """Show the theme that the choice and the system ask for."""
        dark = self._choice == "dark" or (self._choice == "system" and self._system_dark)
        if self._shown == (("dark" if dark else "light"), self._large):
            return
        chosen = DARK if dark else LIGHT
        self._shown = (chosen.name, self._large)
        before, type_scale.factor = type_scale.factor, _LARGE if self._large else 1.0
        font = QFont(self._base)
        font.setPixelSize(scaled(TEXT_PX))
        self._application.setFont(font)
        self._application.setPalette(palette_of(chosen))
        theme.use(chosen)
        self._sheet = style_sheet(chosen)
        for window in self._application.topLevelWidgets():
            if isinstance(window, QMainWindow):
                self.dress(window)
        if type_scale.factor != before:
            type_scale.changed.emit()

    def dress(self, window: QMainWindow) -> None:
        """Put the style sheet on a window and all that belongs to it.

        On the application Qt would go through every widget once for each of its ancestors.
        """
        window.setStyleSheet(self._sheet)


def choose_type(window: "MainWindow", large: bool) -> None:
    """Take larger type or standard type, also the next time."""
    window.settings.set("large_text", large)
    window.themes.choose(window.themes.choice, large)


def choose_theme(window: "MainWindow", name: str) -> None:
    """Take a theme of CHOICES, also the next time."""
    window.settings.set("theme", name)
    window.themes.choose(name)
