"""Each scene of the tour brings the window to its place, without a word said in passing."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QEventLoop
from PySide6.QtWidgets import QApplication

from workbench.shell.start import Building, make_window
from workbench.shell.tour import scenes
from workbench.shell.window import MainWindow

SCENES = scenes()


@pytest.fixture(scope="module")
def window(qapp: QApplication) -> Iterator[MainWindow]:
    window = make_window()
    window.settings.set("hints", False)
    building = Building(window, warms=False)
    built = QEventLoop()
    building.built.connect(built.quit)
    window.first_frame.connect(building.start)
    window.show()
    built.exec()
    window.arriving = None
    yield window
    building.end()
    window.session.undo_stack.setClean()
    window.close()
    window.deleteLater()


@pytest.mark.parametrize(("name", "act"), SCENES, ids=[name for name, _act in SCENES])
def test_it_brings_the_window_to_its_place(
    window: MainWindow, name: str, act: Callable[[MainWindow], object]
) -> None:
    window.messages.dismiss()
    if window.views.swapped:
        window.views.swap()
    window.go("home")
    act(window)
    QApplication.processEvents()
    place = name.partition("-")[0]
    if place in window.workspace_slugs:
        assert window.place == place
