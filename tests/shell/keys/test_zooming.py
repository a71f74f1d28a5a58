"""The menu View zooms what is in the middle of the workspace."""

import pytest

from tests.shell.keys.focus import settle, work_in
from workbench.shell.window import MainWindow


@pytest.mark.parametrize("place", ["draw", "fill", "clip", "curves", "transform"])
def test_the_menu_zooms_the_canvas(window: MainWindow, place: str) -> None:
    work_in(window, place)
    canvas = window.panels(place)[0].canvas
    canvas.fit()
    fitted = canvas.view.cell
    for name, larger in (("zoom_in", True), ("zoom_out", False)):
        before = canvas.view.cell
        window.menus.actions[name].trigger()
        assert (canvas.view.cell > before) is larger
    window.menus.actions["fit"].trigger()
    settle()
    assert canvas.view.cell == fitted
