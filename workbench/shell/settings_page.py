"""Settings, as a page: every choice takes effect at once."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QLabel, QPushButton

from workbench.language import _
from workbench.shell.pages import SidePage, heading, paragraph
from workbench.shell.theme import choose_theme
from workbench.widgets.look.flash_warning import CalmSwitch, FlashWarning

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

_FIELD_WIDTH = 240


class SettingsPage(SidePage):
    """Theme, size of type, calm, ask first, hints."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window, _("Settings"))
        settings = window.settings
        heading(self.column, _("Appearance"))
        form = QFormLayout()
        form.setHorizontalSpacing(16)
        self.theme = QComboBox()
        for name, title in (("system", _("Same as the system")), ("light", _("Light")), ("dark", _("Dark"))):
            self.theme.addItem(title, name)
        self.theme.setCurrentIndex(max(0, self.theme.findData(settings.get("theme"))))
        self.theme.setToolTip(_("The colours of the program"))
        self.theme.setAccessibleName(_("Theme"))
        self.theme.setMaximumWidth(_FIELD_WIDTH)
        self.theme.currentIndexChanged.connect(self._take_theme)
        label = QLabel(_("&Theme"))
        label.setBuddy(self.theme)
        form.addRow(label, self.theme)
        self.column.addLayout(form)
        self.large = self._choice("large_text", _("Larger type"), _("All text a quarter larger"))
        self.large.toggled.connect(lambda on: window.themes.choose(window.themes.choice, on))
        heading(self.column, _("Comfort"))
        self.calm, self.warning = CalmSwitch(), FlashWarning()
        self.calm.flash_wanted.connect(lambda: self.warning.ask())
        self.column.addWidget(self.calm)
        self.column.addWidget(self.warning)
        paragraph(
            self.column,
            _("With Calm on, tubes show steady light, and nothing moves unless you ask for it."),
            "muted",
        )
        heading(self.column, _("Stepping"))
        self.ask = self._choice(
            "ask_first", _("Ask for the next pixel first"), _("New pictures start with Ask first switched on")
        )
        self.ask.toggled.connect(self._take_ask_first)
        heading(self.column, _("Hints and history"))
        self.hints = self._choice("hints", _("Show hints in Draw"), _("Three short hints to begin with"))
        forget = QPushButton(_("Forget recent pictures"))
        forget.setToolTip(_("Empty the list of recent pictures; the files stay"))
        forget.clicked.connect(self._forget)
        self.column.addWidget(forget, 0, Qt.AlignmentFlag.AlignLeft)
        paragraph(self.column, settings.problem or _("Kept in {path}").format(path=settings.path), "muted")
        self.column.addStretch(1)

    def showEvent(self, event: QShowEvent) -> None:
        """Theme and type may have been chosen elsewhere meanwhile."""
        self.theme.setCurrentIndex(max(0, self.theme.findData(self._window.settings.get("theme"))))
        self.large.setChecked(self._window.settings.get("large_text"))
        super().showEvent(event)

    def _choice(self, name: str, text: str, tooltip: str) -> QCheckBox:
        box = QCheckBox(text)
        box.setToolTip(tooltip)
        box.setChecked(self._window.settings.get(name))
        box.toggled.connect(lambda on: self._window.settings.set(name, on))
        self.column.addWidget(box)
        return box

    def _take_theme(self) -> None:
        choose_theme(self._window, self.theme.currentData())

    def _take_ask_first(self, on: bool) -> None:
        if self._window.session is not None:
            self._window.session.update_state(ask_first=on)

    def _forget(self) -> None:
        self._window.settings.forget_recent()
        self._window.refresh_recent()
        self._window.say_status(_("The list of recent pictures is empty."))
