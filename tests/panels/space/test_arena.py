"""The page Hidden surfaces as a person uses it: run, looked at, chosen, stepped, measured, exported."""

import time

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import keep_until_the_end, recorded
from workbench.document.samples.arena import READY
from workbench.document.subjects import Subject
from workbench.engine.stopping import Stopped
from workbench.exchange.diagram_svg import write_diagram
from workbench.exchange.diagrams import Drawing, Sentence
from workbench.panels.space.arena import work
from workbench.panels.space.arena.page import ArenaPage
from workbench.panels.space.arena.tile import MethodTile
from workbench.panels.space.panel import SpacePanel
from workbench.rendering.scene.growth import Growth
from workbench.session.session import Session

LEFT = Qt.MouseButton.LeftButton
METHODS = 10


@pytest.fixture
def session(qtbot):
    made = Session()
    made.open_example("arena-ring")
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def page(qtbot, session):
    made = ArenaPage(session)
    keep_until_the_end(qtbot, made)
    made.resize(820, 480)
    made.show()
    session.visit("arena", Subject("visibility", entry="painter", arguments={"columns": 16}))
    until_run(qtbot, made)
    return made


def until_run(qtbot, page, count=METHODS):
    qtbot.waitUntil(
        lambda: len(page.measures.runs) == count and not page.worker.busy and page._job is not None,
        timeout=60_000,
    )
    QApplication.processEvents()


def middle_of(tile):
    return tile.rect().center()


def grown(method, *_arguments):
    slow = method == "octree"
    return Growth(
        method, ((10, 1e-4), (100, 1e-3)), ((6, 1e-4), (24, 1.6e-3)), 5.0 if slow else 1e-3, not slow
    )


def test_every_method_has_a_tile_that_tells_what_it_does_and_the_wrong_one_says_so(page):
    tiles = page.grid.tiles
    assert list(tiles) == [
        "depth_buffer", "scan_line_surfaces", "painter", "depth_sort", "bsp_tree", "area_subdivision",
        "octree", "ray_casting", "ray_casting_boxes", "a_buffer",
    ]  # fmt: skip
    assert {method for method, tile in tiles.items() if tile.wrong} == {"painter"}
    painter = tiles["painter"]
    assert f"{painter.wrong} px differ" in painter.accessibleDescription()
    assert "keeps 176 depths" in tiles["depth_buffer"].accessibleDescription()
    assert page.chosen == "painter"
    assert page.sentence.text().startswith(
        f"Painter's algorithm shows another surface at {painter.wrong} pixel"
    )
    assert "their farthest corners do not tell which is nearer" in page.sentence.text()


def test_wrong_pixels_are_checked_unless_that_is_switched_off(qtbot, page):
    def picture(method):
        return page.grid.tiles[method].state.picture

    wrong = page.measures.runs["painter"].different
    apart = picture("painter") != picture("ray_casting")
    assert np.array_equal(apart, wrong)
    marked = picture("painter")[wrong].tolist()
    page.bar.marks.click()
    assert (picture("painter")[wrong] != marked).any()
    assert not np.array_equal(picture("painter"), picture("ray_casting"))
    assert np.array_equal(picture("octree"), picture("ray_casting"))


def test_a_click_speaks_of_a_method_and_the_step_bar_steps_it(qtbot, page, session):
    qtbot.mouseClick(page.grid.tiles["ray_casting"], LEFT, pos=middle_of(page.grid.tiles["ray_casting"]))
    recorded(qtbot, session)
    assert page.chosen == "ray_casting"
    assert page.grid.tiles["ray_casting"].is_chosen
    assert not page.grid.tiles["painter"].is_chosen
    assert session.run.entry.slug == "ray_casting"
    assert page.sentence.text().startswith("Ray casting compares all surfaces")


@pytest.mark.parametrize("way", ["button", "double click", "Enter"])
def test_a_method_is_stepped_on_the_page_visibility_with_the_same_scene(qtbot, page, session, way):
    tile = page.grid.tiles["painter"]
    wrong = page.measures.runs["painter"].different
    if way == "button":
        qtbot.mouseClick(tile.button, LEFT)
    elif way == "double click":
        qtbot.mouseDClick(tile, LEFT, pos=middle_of(tile))
    else:
        tile.setFocus()
        qtbot.keyClick(tile, Qt.Key.Key_Return)
    recorded(qtbot, session)
    assert session.state.workspace == "visibility"
    assert session.run.entry.slug == "painter"
    assert session.state.subject.arguments["columns"] == 16
    x, y = session.state.pixel
    assert wrong[y, x]


def test_the_panel_shows_the_page_that_is_stepped_and_measures_nothing_unseen(qtbot, session):
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(820, 480)
    panel.show()
    panel.show_page("arena")
    page = panel.page_of("arena")
    qtbot.waitUntil(lambda: page.worker.busy, timeout=5_000)
    page.step_method("bsp_tree")
    qtbot.waitUntil(lambda: panel.page == "visibility", timeout=5_000)
    assert not page.worker.busy
    assert session.state.subject.entry == "bsp_tree"
    panel.show_page("arena")
    qtbot.waitUntil(lambda: page.worker.busy, timeout=5_000)


def test_the_docks_forget_the_counts_of_a_scene_that_has_been_left(qtbot, session):
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(820, 480)
    panel.show()
    panel.show_page("arena")
    page = panel.page_of("arena")
    until_run(qtbot, page)
    assert any("comparisons here" in row.image_space for row in page.question.rows)
    panel.show_page("space")
    assert page.measures.runs
    session.open_example("space-house")
    qtbot.waitUntil(lambda: not page.measures.runs)
    assert not any("comparisons here" in row.image_space for row in page.question.rows)


def test_keys_go_from_tile_to_tile(qtbot, page):
    first = page.grid.tiles["depth_buffer"]
    page.setFocus()
    assert QApplication.focusWidget() is first
    qtbot.keyClick(first, Qt.Key.Key_Right)
    assert page.chosen == "scan_line_surfaces"
    assert page.grid.tiles["scan_line_surfaces"].hasFocus()
    qtbot.keyClick(page.grid.tiles["scan_line_surfaces"], Qt.Key.Key_Down)
    order = list(page.grid.tiles)
    assert page.chosen == order[1 + page.grid.columns]
    qtbot.keyClick(page.grid.tiles[page.chosen], Qt.Key.Key_Down)
    assert page.chosen == order[1 + page.grid.columns]


def test_the_pixel_under_the_pointer_is_ringed_in_all_and_told(qtbot, page):
    wrong = page.measures.runs["painter"].different
    y, x = np.argwhere(wrong)[0].tolist()
    tile = page.grid.tiles["bsp_tree"]
    cell = tile._cells(x, y, x, y)
    said = []
    page.hover_text.connect(said.append)
    assert tile.cell_at(QPointF(cell.center())) == (x, y)
    tile.pointed.emit((x, y))
    assert {each.ring for each in page.grid.tiles.values()} == {(x, y)}
    assert said[-1].startswith(f"({x}, {y}) Bar ")
    assert "Painter's algorithm: Bar " in said[-1]
    tile.pointed.emit(None)
    assert said[-1] == ""


@pytest.mark.parametrize("way", ["click", "Y"])
def test_a_wrong_pixel_that_is_asked_about_tells_what_was_painted_there(qtbot, session, way):
    panel = SpacePanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(820, 480)
    panel.show()
    session.visit("arena", Subject("visibility", entry="painter", arguments={"columns": 16}))
    page, told = panel.page_of("arena"), panel.page_of("visibility").fragments
    qtbot.waitUntil(page.isVisible)
    told.show()
    panel.activateWindow()
    qtbot.waitUntil(panel.isActiveWindow)
    until_run(qtbot, page)
    recorded(qtbot, session)
    assert told.caption.text().startswith("Click a pixel")
    tile = page.grid.tiles["painter"]
    y, x = np.argwhere(page.measures.runs["painter"].different)[0].tolist()
    place = tile._cells(x, y, x, y).center().toPoint()
    if way == "click":
        qtbot.mouseClick(tile, LEFT, pos=place)
    else:
        qtbot.mouseMove(tile, place)
        qtbot.waitUntil(lambda: page.grid.pointed_cell == (x, y))
        tile.setFocus()
        qtbot.keyClick(tile, Qt.Key.Key_Y)
    qtbot.waitUntil(lambda: told.list.count() >= 2)
    assert f"({x}, {y})" in told.caption.text()
    last = told.list.item(told.list.count() - 1).text()
    assert "painted, and remains" in last
    assert "over what is nearer" in last
    page.grid.point_at(None)
    assert {tile.ring for tile in page.grid.tiles.values()} == {(x, y)}
    qtbot.mouseClick(page.grid.tiles["depth_buffer"], LEFT, pos=QPoint(20, 10))
    qtbot.waitUntil(lambda: "fragments reached it" in told.caption.text())


def test_a_pixel_that_the_pictures_do_not_have_is_not_ringed(page, session):
    session.update_state(pixel=(15, 100), pixel_of="arena")
    QApplication.processEvents()
    assert {tile.ring for tile in page.grid.tiles.values()} == {None}


def test_a_ready_scene_is_opened_here_and_run(qtbot, page, session):
    page.bar.ready.activated.emit(READY.index("arena-bracket"))
    session.visit("arena", page.usual)
    until_run(qtbot, page, METHODS + 1)
    assert {method for method, tile in page.grid.tiles.items() if tile.wrong} == {"back_faces", "painter"}


def test_tiles_that_are_replaced_are_out_of_sight_at_once(page):
    inner = page.grid.widget()
    page.grid.show_methods(("painter",), (3, 2))
    assert [tile.method for tile in inner.findChildren(MethodTile) if tile.isVisible()] == ["painter"]


def test_a_sheet_without_a_scene_says_so_and_offers_one(qtbot, page, session):
    session.new()
    session.visit("arena", page.usual)
    qtbot.waitUntil(page.empty.isVisible, timeout=5_000)
    assert page.empty.sentence.text() == "This sheet has no scene."
    assert not page.bar.measure.isEnabled()
    assert page.derivation() is None
    assert not page.tables()
    qtbot.mouseClick(page.empty.button, LEFT)
    session.visit("arena", Subject("visibility", arguments={"columns": 16}))
    until_run(qtbot, page)
    assert not page.empty.isVisible()


def test_times_are_measured_told_and_plotted(qtbot, page, monkeypatch):
    monkeypatch.setattr(work, "growth_of", grown)
    monkeypatch.setattr(work, "_prepare", lambda *_work: None)
    qtbot.mouseClick(page.bar.measure, LEFT)
    qtbot.waitUntil(lambda: len(page.measures.growth) == METHODS and not page.worker.busy, timeout=60_000)
    assert "1 ms" in page.grid.tiles["painter"].values()
    assert "about 5 s" in page.grid.tiles["octree"].values()
    rows = {row.feature: row for row in page.question.rows}
    assert "Depth sort n^2.0" in rows["Cost, n polygons"].object_space
    assert "Ray casting p^1.0" in rows["Cost, p pixels"].image_space
    assert "squares divided, then" in rows["Precision"].image_space
    tables = dict(page.tables())
    assert len(tables["Hidden surfaces"].rows) == METHODS
    assert tables["Time by polygons"].rows[0] == ("Depth buffer", 6, pytest.approx(0.1), pytest.approx(2.0))


def test_measuring_is_stopped_by_the_button_and_by_escape(qtbot, page, monkeypatch):
    def endless(_method, _scene, _size, _window, stop):
        while not stop.is_set:
            time.sleep(0.01)
        raise Stopped

    monkeypatch.setattr(work, "growth_of", endless)
    monkeypatch.setattr(work, "_prepare", lambda *_work: None)
    for stop in (lambda: page.bar.measure.click(), lambda: qtbot.keyClick(page, Qt.Key.Key_Escape)):
        page.bar.measure.click()
        assert page.worker.busy
        assert page.bar.measure.text() == "Stop"
        stop()
        assert not page.worker.busy
        assert page.bar.measure.text() == "Measure times"
    assert len(page.measures.runs) == METHODS


def test_what_fails_is_said_in_one_sentence(qtbot, page, monkeypatch):
    def without(*_work):
        raise ValueError("There is no compiler here.")

    monkeypatch.setattr(work, "_prepare", without)
    page.bar.measure.click()
    qtbot.waitUntil(lambda: not page.worker.busy, timeout=5_000)
    assert page.sentence.text() == "There is no compiler here."


def test_the_two_spaces_are_exported_as_a_labelled_page(qtbot, page):
    page.measures = page.measures._replace(growth={each: grown(each) for each in page.grid.tiles})
    made = page.derivation()
    assert made is not None
    said = [block.text for block in made.blocks if isinstance(block, Sentence)]
    wrong = page.grid.tiles["painter"].wrong
    assert any(f"{wrong} of 176 pixels are wrong" in text for text in said)
    assert sum(isinstance(block, Drawing) for block in made.blocks) == 4
    assert "<svg" in write_diagram(made)
    seen_by_none = {each: grown(each)._replace(by_polygons=()) for each in page.grid.tiles}
    page.measures = page.measures._replace(growth=seen_by_none)
    made = page.derivation()
    assert made is not None
    assert sum(isinstance(block, Drawing) for block in made.blocks) == 3


def test_every_control_has_a_name_and_a_tip(page):
    for control in (
        page.bar.ready,
        page.bar.size_box,
        page.bar.marks,
        page.bar.measure,
        page.growth.what,
        page.question.table,
    ):
        assert control.toolTip()
        assert control.accessibleName() or control.text()
    for tile in page.grid.tiles.values():
        assert tile.toolTip()
        assert tile.accessibleName()
        assert tile.button.accessibleName().startswith("Step ")
