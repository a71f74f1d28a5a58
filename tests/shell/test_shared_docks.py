"""Docks that several workspaces have: made once, placed by each for itself, also when exchanged."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from workbench.document.samples import example_document
from workbench.panels.tube_dock import TubeDock
from workbench.session.session import Session
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    window.attach(Session(window, example_document()))
    window.go("draw")
    window.go("fill")
    yield window
    window.close()
    window.deleteLater()


def dock(window: MainWindow, workspace: str, name: str) -> QDockWidget:
    """The dock of this name among those of a workspace."""
    return next(each for each in window.arrangements.docks(workspace) if each.objectName() == name)


def test_both_workspaces_have_the_same_docks_but_for_their_own(window: MainWindow) -> None:
    drawing, filling = (
        {each.objectName() for each in window.arrangements.docks(slug)} for slug in ("draw", "fill")
    )
    assert drawing - filling == {"distance"}
    assert filling - drawing == {"depth"}
    assert all(
        dock(window, "draw", name) is dock(window, "fill", name) for name in drawing.intersection(filling)
    )
    assert dock(window, "draw", "distance").isHidden()
    assert not dock(window, "fill", "depth").isHidden()


@pytest.mark.qt_log_ignore("does not support raise", extend=True)
def test_a_dock_closed_in_one_workspace_stays_open_in_the_other(window: MainWindow) -> None:
    hand = dock(window, "fill", "hand_table")
    hand.close()
    window.go("draw")
    assert not hand.isHidden()
    hand.setFloating(True)
    window.go("fill")
    assert hand.isHidden()
    window.go("draw")
    assert not hand.isHidden()
    assert hand.isFloating()


def test_a_tube_in_the_middle_of_one_workspace_is_a_dock_in_the_other(
    qtbot: QtBot, window: MainWindow
) -> None:
    tube, middle = dock(window, "fill", "tube"), window.panels("fill")[0].center
    qtbot.keyClick(window, Qt.Key.Key_T)
    assert tube.widget() is middle
    window.go("draw")
    assert isinstance(tube.widget(), TubeDock)
    assert tube.windowTitle() == "Tube"
    assert window.panels("draw")[0].center.isVisibleTo(window)
    window.go("home")
    window.go("fill")
    assert tube.widget() is middle
    assert tube.windowTitle() == "Canvas"
    qtbot.keyClick(window, Qt.Key.Key_T)
    assert isinstance(tube.widget(), TubeDock)
    assert middle.isVisibleTo(window)
