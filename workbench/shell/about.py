"""About: version, licence, and a diagnosis that one can copy into a report."""

import platform
import sys
from importlib import metadata
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, qVersion
from PySide6.QtGui import QGuiApplication, QPixmap, QShowEvent
from PySide6.QtWidgets import QLabel, QPushButton

from workbench import __version__
from workbench.language import _
from workbench.paths import cache_folder, resource, settings_folder
from workbench.shell.pages import SidePage, heading, paragraph

if TYPE_CHECKING:
    from workbench.shell.window import MainWindow

_PACKAGES = ("PySide6-Essentials", "numpy", "numba", "pyqtgraph", "msgspec", "QtAwesome")


def diagnosis(window: "MainWindow") -> str:
    """What helps to understand a failure elsewhere; nothing of the picture."""
    screen = window.screen()
    lines = [
        f"Graphics Workbench {__version__}",
        f"Python {sys.version.split()[0]}, Qt {qVersion()}, {platform.platform()}",
        f"Qt platform {QGuiApplication.platformName()}",
        f"Screen {screen.size().width()} x {screen.size().height()} at {screen.devicePixelRatio():g}, "
        f"window {window.width()} x {window.height()}",
        f"Theme {window.themes.choice}, place {window.place}",
        f"Settings {settings_folder()}",
        f"Compiled readings {cache_folder()}",
    ]
    for name in _PACKAGES:
        try:
            lines.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            lines.append(f"{name} is missing")
    return "\n".join(lines)


class AboutPage(SidePage):
    """What this program is."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window, _("About"))
        picture = QLabel()
        ratio = window.devicePixelRatioF()
        image = QPixmap(str(resource("icon", "graphics-workbench.png")))
        image = image.scaledToHeight(round(96 * ratio), Qt.TransformationMode.SmoothTransformation)
        image.setDevicePixelRatio(ratio)
        picture.setPixmap(image)
        self.column.addWidget(picture)
        heading(self.column, f"Graphics Workbench {__version__}", "title")
        paragraph(
            self.column, _("Draw something, watch the algorithm make it pixel by pixel, and see it glow.")
        )
        paragraph(self.column, _("Free software under the MIT licence."), "muted")
        heading(self.column, _("Diagnosis"))
        self.text = paragraph(self.column, diagnosis(window), "muted")
        self.text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.copy = QPushButton(_("Copy the diagnosis"))
        self.copy.setToolTip(_("Put the lines above on the clipboard"))
        self.copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(diagnosis(window)))
        self.column.addWidget(self.copy, 0, Qt.AlignmentFlag.AlignLeft)
        self.column.addStretch(1)

    def showEvent(self, event: QShowEvent) -> None:
        """What is diagnosed may have changed."""
        self.text.setText(diagnosis(self._window))
        super().showEvent(event)
