"""Y: what answers why a pixel is as it is comes before the other docks, also for the same pixel again."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from tests.shell.keys.focus import settle
from workbench.panels.space.panel import SpacePanel
from workbench.panels.space.visibility.page import VisibilityPage
from workbench.panels.stage.stepped import SteppedPanel
from workbench.shell.start import Building, make_window
from workbench.shell.window import MainWindow
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.in_sight import in_front


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    """The whole program, with its docks in their first places."""
    window = make_window()
    building = Building(window, warms=False)
    window.first_frame.connect(building.start)
    with qtbot.waitSignal(building.built, timeout=60_000):
        window.show()
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    yield window
    leave(window)


def canvas_of(window: MainWindow) -> PixelCanvas:
    panel = window.panels(window.place)[0]
    if isinstance(panel, SpacePanel):
        page = panel.page_of("visibility")
        assert isinstance(page, VisibilityPage)
        return page.canvas
    assert isinstance(panel, SteppedPanel)
    return panel.canvas


def dock_called(window: MainWindow, title: str) -> QDockWidget:
    return next(each for each in window.arrangements.docks(window.place) if each.windowTitle() == title)


@pytest.mark.parametrize(
    ("example", "cell"), [("line", (24, 13)), ("overlapping-triangles", (23, 15))], ids=["draw", "space"]
)
def test_the_answer_comes_forward(
    qtbot: QtBot, window: MainWindow, example: str, cell: tuple[int, int]
) -> None:
    window.open_example(example)
    run = window.session.run
    settle()
    qtbot.waitUntil(lambda: run.entry is not None and run.done, timeout=20_000)
    canvas = canvas_of(window)
    qtbot.waitUntil(canvas.isVisible)
    answer, other = dock_called(window, "Why this pixel?"), dock_called(window, "Hand table")
    for _time in range(2):
        window.arrangements.bring_forward(other.objectName())
        qtbot.waitUntil(lambda: not in_front(answer), timeout=5_000)
        canvas.setFocus()
        qtbot.mouseMove(canvas, canvas.widget_position(*cell).toPoint())
        qtbot.waitUntil(lambda: canvas.pointed_cell == cell)
        qtbot.keyClick(canvas, Qt.Key.Key_Y)
        qtbot.waitUntil(lambda: in_front(answer), timeout=5_000)
        assert window.session.state.pixel == cell
