"""A part behind other tabs is not in sight, and costs nothing there."""

import numpy as np
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QVBoxLayout, QWidget

from tests.panels.by_hand import settle
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.tube.view import TubeView

RIGHT = Qt.DockWidgetArea.RightDockWidgetArea


def docked(qtbot, inner: QWidget) -> tuple[QMainWindow, QDockWidget, QDockWidget]:
    """A window with two docks behind one another; ``inner`` lies deep in the second."""
    window = QMainWindow()
    qtbot.addWidget(window)
    window.resize(500, 400)
    window.setCentralWidget(QWidget())
    holder = QWidget()
    QVBoxLayout(holder).addWidget(inner)
    front, behind = QDockWidget("one"), QDockWidget("two")
    for dock, content in ((front, QWidget()), (behind, holder)):
        dock.setWidget(content)
        window.addDockWidget(RIGHT, dock)
    window.tabifyDockWidget(front, behind)
    front.raise_()
    window.show()
    settle()
    return window, front, behind


def test_what_lies_behind_a_tab_is_not_in_sight(qtbot) -> None:
    part = QWidget()
    sight, told = InSight(part), list[bool]()
    sight.changed.connect(told.append)
    window, front, behind = docked(qtbot, part)
    assert part.isVisible()
    assert not sight.now
    behind.raise_()
    settle()
    assert sight.now
    front.raise_()
    settle()
    assert not sight.now
    assert told[-2:] == [True, False]
    window.setCentralWidget(part)  # as when the tube takes the place of the canvas
    settle()
    behind.hide()
    settle()
    assert sight.now


def test_a_part_outlives_the_dock_that_it_was_in(qtbot) -> None:
    part = QWidget()
    sight = InSight(part)
    window, _front, behind = docked(qtbot, part)
    behind.raise_()
    settle()
    part.setParent(None)  # as when a workspace is reset: its parts go to docks made anew
    behind.deleteLater()
    QApplication.sendPostedEvents(behind, QEvent.Type.DeferredDelete)
    window.setCentralWidget(part)
    part.show()
    settle()
    assert sight.now


def test_a_tube_behind_a_tab_rests(qtbot) -> None:
    tube = TubeView("raster")
    tube.set_image(np.zeros((12, 16), np.uint32))
    _window, front, behind = docked(qtbot, tube)
    assert not tube.running
    assert tube.driver is None
    behind.raise_()
    qtbot.waitUntil(lambda: tube.driver is not None)
    tube.set_slow_motion(1000.0)
    assert tube.running
    front.raise_()
    settle()
    assert not tube.running


def test_a_part_that_is_taken_apart_may_still_hide(qtbot) -> None:
    part = QWidget()
    qtbot.addWidget(part)
    sight = InSight(part)
    part.show()
    settle()
    assert sight.now
    vars(sight).clear()  # as the collector of garbage does before the part is gone
    part.hide()
    assert not sight.now
