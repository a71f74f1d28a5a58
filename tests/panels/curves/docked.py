"""A Curves panel with its docks."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    opened,
)

PLACES = ((26.0, 10.0), (32.0, 34.0), (40.0, 40.0), (46.0, 12.0), (58.0, 30.0), (60.0, 8.0), (50.0, 4.0))


def with_docks(qtbot, *curves):
    """The panel in a window, with its docks to be seen."""
    panel = opened(qtbot, *curves)
    window = QMainWindow()
    qtbot.addWidget(window)
    for name, title, widget, _area in panel.docks():
        dock = QDockWidget(title, window)
        dock.setObjectName(name)
        dock.setWidget(widget)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.resize(800, 1100)
    window.show()
    qtbot.waitExposed(window)
    panel.docked_in = window
    panel.refresh()
    qtbot.waitUntil(lambda: not panel.beside.comparing)
    settle()
    return panel
