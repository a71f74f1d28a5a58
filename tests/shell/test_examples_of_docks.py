"""Docks and examples: one with nothing to show opens one, and an example names the dock that tells of it."""

from collections.abc import Iterator

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.document.samples.examples import Example, blank_sheet, example, examples
from workbench.panels.shared.inspector import InspectorPanel
from workbench.panels.stage.panel import FigurePanel
from workbench.session.session import Session
from workbench.shell.dock_area import DockArea
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import panel_of

OWN = {
    "draw": "line",
    "fill": "triangle",
    "clip": "clip",
    "space": "space-house",
}


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    window = make_window(Settings())
    window.show()
    window.resize(1280, 680)
    window.attach(Session(window, blank_sheet()))
    for slug in OWN:
        window.go(slug)
    yield window
    window.close()
    window.deleteLater()


def area_of(window: MainWindow) -> DockArea:
    """The area of the workspace that is shown."""
    area = window.arrangements.area(window.place)
    assert area is not None
    return area


@pytest.mark.parametrize("slug", OWN)
def test_a_dock_without_a_run_opens_the_example_of_its_own_workspace(
    window: MainWindow, qtbot: QtBot, slug: str
) -> None:
    window.go(slug)
    panels = window.panels(slug)
    docks = panel_of(panels, InspectorPanel)
    button = docks.source.findChild(QPushButton)
    assert button is not None
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    session = window.session
    assert session is not None
    assert session.sheet == example(OWN[slug]).document.sheets[0]
    assert window.place == slug
    if isinstance(panels[0], FigurePanel):
        assert panels[0].tool.name == "select"


@pytest.mark.parametrize("slug", ["fill", "clip", "draw"])
def test_an_example_is_taken_hold_of_whatever_was_drawn_before(window: MainWindow, slug: str) -> None:
    window.go(slug)
    panel, session = window.panels(slug)[0], window.session
    assert isinstance(panel, FigurePanel)
    assert session is not None
    drawing = panel.tool.name
    assert drawing != "select"
    session.open_example(OWN[slug])
    assert panel.tool.name == "select"
    session.new()
    assert panel.tool.name == drawing


@pytest.mark.parametrize("chosen", [each for each in examples() if each.entry], ids=lambda each: each.slug)
def test_an_example_is_run_under_what_it_is_about_whatever_was_run_before(
    window: MainWindow, qtbot: QtBot, chosen: Example
) -> None:
    session = window.session
    for _time in range(2):
        window.open_example(chosen.slug)
        qtbot.waitUntil(lambda: session.run.entry is not None and session.run.entry.slug == chosen.entry)
        session.update_state(subject=replace(session.subject, entry="depth_buffer"))
        qtbot.waitUntil(lambda: session.run.entry.slug == "depth_buffer")


def test_an_example_names_an_entry_that_there_is() -> None:
    named = {each.entry for each in examples() if each.entry}
    assert "octree_of_solid" in named
    assert named <= {entry.slug for entry in catalogue.entries()}


@pytest.mark.parametrize("slug", ["animate-letter", "animate-turn", "animate-ball", "shading-lamps"])
def test_an_example_begins_in_its_frame_with_the_dock_that_tells_of_it(
    qtbot: QtBot, window: MainWindow, slug: str
) -> None:
    chosen = example(slug)
    window.open_example("animate-pendulum")
    qtbot.waitUntil(lambda: window.place == "animate", timeout=60_000)
    window.open_example(slug)
    qtbot.waitUntil(lambda: window.place == chosen.workspace, timeout=60_000)
    dock = area_of(window).dock(chosen.dock)
    qtbot.waitUntil(lambda: not dock.visibleRegion().isEmpty(), timeout=10_000)
    assert window.session.frames.number == chosen.frame


def test_every_example_names_a_dock_that_its_workspace_has(window: MainWindow) -> None:
    named = {(each.workspace, each.dock) for each in examples() if each.dock}
    for slug in {workspace for workspace, _dock in named}:
        window.go(slug)
        QApplication.processEvents()
        has = {dock.objectName() for dock in area_of(window).docks}
        assert {dock for workspace, dock in named if workspace == slug} <= has
