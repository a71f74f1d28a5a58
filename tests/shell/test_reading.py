"""Read gives source and tables half of the window, and gives the docks back as they were."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontInfo
from PySide6.QtWidgets import QApplication, QDockWidget, QTabWidget
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from workbench.document.samples.examples import example_document, examples
from workbench.panels.shared.inspector import InspectorPanel
from workbench.session.session import Session
from workbench.shell.dock_area import DockArea
from workbench.shell.reading import Reading
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import panel_of, workspaces

STEPPED = [each.slug for each in workspaces() if each.steps]
LINES, LINES_WHEN_SMALL, ROWS, ROWS_OF_A_STRUCTURE = 20, 12, 8, 2


@pytest.fixture(scope="module")
def window(qapp: QApplication, tmp_path_factory: pytest.TempPathFactory) -> Iterator[MainWindow]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GRAPHICS_WORKBENCH_PROFILE", str(tmp_path_factory.mktemp("profile")))
        settings = Settings()
    settings.set("hints", False)
    made = make_window(settings)
    made.show()
    made.resize(1280, 680)
    made.attach(Session(made, example_document()))
    yield made
    leave(made)


@pytest.fixture(autouse=True)
def as_it_began(window: MainWindow) -> Iterator[None]:
    yield
    window.views.together()
    window.arrangements.stop_reading()
    window.resize(1280, 680)


def stepped_in(window: MainWindow, slug: str, qtbot: QtBot) -> InspectorPanel:
    """An example of the workspace, with a run that has steps."""
    window.open_example(next(each.slug for each in examples() if each.workspace == slug))
    figures = window.session.sheet.figures
    if figures:
        window.session.update_state(active=figures[0].id, selection=(figures[0].id,))
    parts = inspector(window, slug)
    qtbot.waitUntil(lambda: window.session.run.recording is not None)
    area = window.arrangements.area(slug)
    assert area is not None
    # Qt lays docks out only after the events that are under way, and a panel may then still change its own
    heights: list[int] = []
    while len(heights) < 4 or len(set(heights[-3:])) > 1:
        qtbot.wait(60)
        heights.append(sum(dock.height() * (k + 1) for k, dock in enumerate(area.in_front())))
    return parts


@pytest.mark.parametrize("slug", STEPPED)
def test_the_source_has_twenty_lines_and_never_scrolls_sideways(
    slug: str, qtbot: QtBot, window: MainWindow
) -> None:
    parts = stepped_in(window, slug, qtbot)
    window.arrangements.bring_forward("source")
    text = parts.source.text
    qtbot.waitUntil(lambda: text.viewport().height() >= LINES * text.fontMetrics().lineSpacing())
    assert text.isVisible()
    assert QFontInfo(text.font()).pixelSize() >= 11
    assert text.horizontalScrollBar().maximum() == 0


def test_another_tab_gives_the_room_back_that_the_source_took(qtbot: QtBot, window: MainWindow) -> None:
    window.go("transform")
    window.reset_workspace()
    stepped_in(window, "transform", qtbot)
    area = window.arrangements.area("transform")
    assert area is not None
    before = area.dock("chain").height()
    window.arrangements.bring_forward("source")
    qtbot.waitUntil(lambda: area.dock("chain").height() < before)
    window.arrangements.bring_forward("hand_table")
    qtbot.waitUntil(lambda: abs(area.dock("chain").height() - before) <= 2)


def inspector(window: MainWindow, slug: str) -> InspectorPanel:
    return panel_of(window.panels(slug), InspectorPanel)


def page(window: MainWindow) -> Reading:
    shown = window.stack.currentWidget()
    assert isinstance(shown, Reading)
    return shown


def places(area: DockArea) -> list[tuple[str, object]]:
    return [(dock.objectName(), dock.geometry()) for dock in area.in_front()]


@pytest.mark.parametrize("slug", STEPPED)
def test_source_and_tables_have_half_and_the_docks_come_back(
    slug: str, qtbot: QtBot, window: MainWindow
) -> None:
    stepped_in(window, slug, qtbot)
    qtbot.wait(1)
    area, middle = window.arrangements.area(slug), window.panels(slug)[0].center
    assert area is not None
    before = places(area)
    kept = area.saveState()
    window.menus.actions["read"].trigger()
    qtbot.wait(1)
    parts = inspector(window, slug)
    half = page(window).widget(1)
    assert window.width() * 0.47 <= half.width() <= window.width() * 0.52
    for view in (middle, parts.source, parts.hand, parts.variables):
        assert view.isVisible()
        assert page(window).isAncestorOf(view)
    source, tables = (view.mapTo(page(window), view.rect().topLeft()) for view in (parts.source, parts.hand))
    assert source.x() + parts.source.width() <= tables.x()
    header = parts.hand.view.horizontalHeader().sizeHint().height()
    row = parts.hand.view.verticalHeader().defaultSectionSize()
    assert parts.hand.height() >= header + ROWS * row
    assert parts.source.text.horizontalScrollBar().maximum() == 0
    window.menus.actions["read"].trigger()
    qtbot.wait(1)
    assert window.stack.currentWidget() is area
    qtbot.waitUntil(lambda: places(area) == before)
    assert area.saveState() == kept
    for view in (parts.source, parts.hand):
        assert any(dock.isAncestorOf(view) for dock in area.docks)
    assert middle.isVisible()


def test_in_a_narrow_window_the_tables_are_tabs_below_the_source(qtbot: QtBot, window: MainWindow) -> None:
    window.resize(960, 540)
    window.go("draw")
    window.menus.actions["read"].trigger()
    qtbot.wait(1)
    assert_stacked(window)


@pytest.mark.parametrize("slug", STEPPED)
def test_twelve_lines_can_be_read_in_a_small_window(slug: str, qtbot: QtBot, window: MainWindow) -> None:
    parts = stepped_in(window, slug, qtbot)
    window.resize(960, 540)
    window.menus.actions["read"].trigger()
    text = parts.source.text
    qtbot.waitUntil(lambda: text.viewport().height() >= LINES_WHEN_SMALL * text.fontMetrics().lineSpacing())
    row = parts.hand.view.verticalHeader().defaultSectionSize()
    assert parts.hand.view.viewport().height() >= row


def assert_stacked(window: MainWindow) -> None:
    parts = inspector(window, "draw")
    at = [view.mapTo(page(window), view.rect().topLeft()) for view in (parts.source, parts.hand)]
    assert at[0].y() + parts.source.height() <= at[1].y()
    assert at[0].x() == at[1].x()
    assert [tabs.count() for tabs in visible_tabs(window)] == [2, 2]


def visible_tabs(window: MainWindow) -> list[QTabWidget]:
    return [tabs for tabs in page(window).findChildren(QTabWidget) if tabs.isVisible()]


def test_a_window_that_becomes_narrow_or_wide_has_its_page_arranged_anew(
    qtbot: QtBot, window: MainWindow
) -> None:
    window.go("draw")
    window.menus.actions["read"].trigger()
    qtbot.wait(1)
    parts = inspector(window, "draw")
    for _turn in range(2):
        window.resize(960, 540)
        qtbot.wait(1)
        assert_stacked(window)
        window.resize(1280, 680)
        qtbot.wait(1)
        source, hand, values = (
            view.mapTo(page(window), view.rect().topLeft())
            for view in (parts.source, parts.hand, parts.values)
        )
        assert source.x() + parts.source.width() <= hand.x()
        assert hand.y() + parts.hand.height() <= values.y()
        assert sorted(tabs.count() for tabs in visible_tabs(window)) == [1, 1, 2]
    window.menus.actions["read"].trigger()
    qtbot.wait(1)
    assert any(dock.isAncestorOf(parts.values) for dock in window.arrangements.docks("draw"))


# Where a caption is long, and where there are two structures
@pytest.mark.parametrize("slug", ["piercing-planes", "two-interiors", "pond"])
def test_each_structure_has_room_for_two_rows_and_leaves_the_source_its_width(
    slug: str, qtbot: QtBot, window: MainWindow
) -> None:
    window.open_example(slug)
    window.session.flush()
    qtbot.waitUntil(lambda: window.session.run.recording is not None)
    window.menus.actions["read"].trigger()
    parts = inspector(window, window.place)
    qtbot.waitUntil(lambda: bool(parts.structures.parts) and parts.structures.isVisible())
    assert parts.source.width() > 0.55 * page(window).widget(1).width()
    rows_px = ROWS_OF_A_STRUCTURE * parts.variables.view.verticalHeader().defaultSectionSize()
    for number, (label, view, _model) in enumerate(parts.structures.parts.values()):
        seen = view.viewport()
        qtbot.waitUntil(
            lambda seen=seen, first=number == 0: (
                (seen.visibleRegion().boundingRect() if first else seen.rect()).height() >= rows_px
            )
        )
        assert label.height() >= label.heightForWidth(label.width())


def test_the_key_reads_and_the_button_ends_it(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    parts = inspector(window, "draw")
    parts.source.text.setFocus()
    qtbot.keyClick(window, "R")
    assert parts.source.text.hasFocus() or window.focusWidget() is parts.source.text
    qtbot.mouseClick(page(window).button, Qt.MouseButton.LeftButton)
    assert not window.arrangements.reading


@pytest.mark.parametrize("command", ["swap", "alone", "reset"])
def test_what_arranges_the_docks_brings_them_back_first(
    command: str, qtbot: QtBot, window: MainWindow
) -> None:
    window.go("draw")
    window.menus.actions["read"].trigger()
    window.menus.actions[command].trigger()
    qtbot.wait(1)
    assert not window.arrangements.reading
    parts = inspector(window, "draw")
    assert any(dock.isAncestorOf(parts.source) for dock in window.arrangements.docks("draw"))


def test_a_dock_that_is_asked_for_and_another_workspace_end_it(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    window.menus.actions["read"].trigger()
    window.arrangements.bring_forward("why")
    assert not window.arrangements.reading
    (why,) = (dock for dock in window.arrangements.docks("draw") if dock.objectName() == "why")
    assert isinstance(why, QDockWidget)
    assert why.isVisible()
    window.menus.actions["read"].trigger()
    window.go("fill")
    assert not window.arrangements.reading
    parts = inspector(window, "fill")
    assert any(dock.isAncestorOf(parts.source) for dock in window.arrangements.docks("fill"))


def test_where_nothing_is_stepped_that_is_said(window: MainWindow) -> None:
    window.go("home")
    window.menus.actions["read"].trigger()
    assert window.status.hover.text() == "There is no source to read here; go to a workspace with steps."
