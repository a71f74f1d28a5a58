"""The Fill panel as a student uses it: polygons, rings, seeds, brush, one point, the stack, bad input."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.panels.by_hand import at, keep_until_the_end, settle
from workbench.algorithms.marks import Spot, Stroke, Word
from workbench.document.model import Circle, Polygon, Polyline, SeedFill
from workbench.document.samples.examples import blank_sheet, example
from workbench.panels.fill.panel import FillPanel
from workbench.rendering import frame_buffer, painter_of
from workbench.session.session import Session

LEFT = Qt.MouseButton.LeftButton


def opened(qtbot, document):
    session = Session(document=document)
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(900, 620)
    panel.show()
    qtbot.waitExposed(panel)
    figures = session.sheet.figures
    if figures:
        session.update_state(active=figures[-1].id, selection=(figures[-1].id,))
        qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=15000)
    settle()
    return panel


def click(qtbot, panel, x, y, modifiers=Qt.KeyboardModifier.NoModifier):
    qtbot.mouseMove(panel.canvas, at(panel, x, y))
    qtbot.mouseClick(panel.canvas, LEFT, modifiers, at(panel, x, y))
    settle()


@pytest.fixture
def blank(qtbot):
    return opened(qtbot, blank_sheet(30, 24))


def test_corners_are_clicked_and_enter_closes(qtbot, blank):
    for x, y in ((12, 3), (24, 4), (18, 18)):
        click(qtbot, blank, x, y)
    qtbot.keyClick(blank.canvas, Qt.Key.Key_Return)
    (polygon,) = blank.session.sheet.figures
    assert isinstance(polygon, Polygon)
    assert [(p.x, p.y) for p in polygon.points_world] == [(12, 3), (24, 4), (18, 18)]
    assert (painter_of(blank.session.sheet) == 0).sum() > 60
    blank.session.undo_stack.undo()
    assert blank.session.sheet.figures == ()


def test_two_corners_are_no_polygon_and_that_is_said(qtbot, blank):
    said = []
    blank.hover_text.connect(said.append)
    click(qtbot, blank, 12, 3)
    click(qtbot, blank, 24, 4)
    qtbot.keyClick(blank.canvas, Qt.Key.Key_Return)
    settle()
    assert any("three" in text for text in said)
    assert blank.session.sheet.figures == ()


def test_with_shift_a_second_ring_is_a_hole(qtbot, blank):
    for x, y in ((11, 2), (26, 2), (26, 20), (11, 20), (11, 2)):
        click(qtbot, blank, x, y)
    blank.choose_tool("polygon")
    for k, (x, y) in enumerate(((15, 6), (22, 6), (22, 16), (15, 16))):
        click(
            qtbot,
            blank,
            x,
            y,
            Qt.KeyboardModifier.ShiftModifier if k == 0 else Qt.KeyboardModifier.NoModifier,
        )
    qtbot.keyClick(blank.canvas, Qt.Key.Key_Return)
    (polygon,) = blank.session.sheet.figures
    assert polygon.ring_ends == (4, 8)
    painter = painter_of(blank.session.sheet)
    assert painter[10, 18] == -1
    assert painter[4, 18] == 0


def test_the_brush_draws_a_boundary_and_a_seed_fills_it(qtbot, blank):
    blank.choose_tool("brush")
    corners = [(12, 4), (22, 4), (22, 14), (12, 14), (12, 5)]
    qtbot.mousePress(blank.canvas, LEFT, pos=at(blank, *corners[0]))
    for (x0, y0), (x1, y1) in pairwise(corners):
        for share in np.linspace(0, 1, 12)[1:]:
            qtbot.mouseMove(blank.canvas, at(blank, x0 + share * (x1 - x0), y0 + share * (y1 - y0)))
    qtbot.mouseRelease(blank.canvas, LEFT, pos=at(blank, *corners[-1]))
    settle()
    (stroke,) = blank.session.sheet.figures
    assert isinstance(stroke, Polyline)
    assert stroke.closed
    blank.choose_tool("seed")
    click(qtbot, blank, 17, 9)
    fill = blank.session.sheet.figures[-1]
    assert isinstance(fill, SeedFill)
    assert (painter_of(blank.session.sheet) == 1).sum() == 9 * 9
    blank.session.undo_stack.undo()
    assert len(blank.session.sheet.figures) == 1


def test_a_boundary_edited_between_runs_lets_the_fill_out(qtbot):
    panel = opened(qtbot, example("pond").document)
    before = int((painter_of(panel.session.sheet) == 3).sum())
    panel.session.update_state(selection=(panel.session.sheet.figures[0].id,))
    panel.delete_selected()
    settle()
    qtbot.waitUntil(lambda: panel.session.run.done, timeout=20000)
    assert int((painter_of(panel.session.sheet) == 2).sum()) > before
    panel.session.undo_stack.undo()
    settle()
    assert int((painter_of(panel.session.sheet) == 3).sum()) == before


@pytest.mark.parametrize(("x", "y", "word"), [(5, 3, "boundary"), (40, 9, "outside")])
def test_a_seed_that_fills_nothing_is_refused_in_place(qtbot, x, y, word):
    panel = opened(qtbot, example("pond").document)
    panel.choose_tool("seed")
    count = len(panel.session.sheet.figures)
    panel.tool.press(float(x), float(y), Qt.KeyboardModifier.NoModifier, 1.0)
    assert word in panel.tool.tag
    assert len(panel.session.sheet.figures) == count


def test_a_seed_dragged_onto_the_boundary_keeps_its_figure_and_says_why(qtbot):
    panel = opened(qtbot, example("pond").document)
    fill = panel.session.sheet.figures[-1]
    place = f"s1/{fill.id}/{fill.points_world[0].id}"
    panel.card._set(f"{place}/x", 5.0)
    panel.card._set(f"{place}/y", 3.0)
    settle()
    assert "boundary" in panel.card.note.text()
    assert panel.card.note.isVisible()
    assert panel.session.sheet.figures[-1].id == fill.id


def test_rules_and_colours_are_chosen_in_the_card(qtbot):
    panel = opened(qtbot, example("triangle").document)
    assert panel.card.extent.currentData() is True
    assert (painter_of(panel.session.sheet) == 0).sum() == 25
    panel.card.extent.setCurrentIndex(0)
    panel.card.extent.activated.emit(0)
    assert (painter_of(panel.session.sheet) == 0).sum() == 21
    panel.card.colours.chosen.emit(4)
    assert panel.session.sheet.figures[0].colour == 4
    panel.session.undo_stack.undo()
    panel.session.undo_stack.undo()
    assert (painter_of(panel.session.sheet) == 0).sum() == 25


def test_the_middle_of_the_star_depends_on_the_interior(qtbot):
    panel = opened(qtbot, example("two-interiors").document)
    painter = painter_of(panel.session.sheet)
    assert painter[9, 10] == -1
    assert painter[20, 25] == 1
    panel.choose_tool("inside")
    click(qtbot, panel, 25, 20)
    assert "inside by nonzero" in panel.card.verdict.text()
    assert "outside by even-odd" in panel.card.verdict.text()
    words = [mark.text for mark in panel.canvas.overlay.drawn if isinstance(mark, Word)]
    assert {"1 ↑", "2 ↑"} <= set(words) or {"1 ↓", "2 ↓"} <= set(words)
    panel.choose_tool("select")
    assert not panel.card.verdict.isVisible()


def test_the_inside_tool_without_a_polygon_says_so(qtbot, blank):
    blank.choose_tool("inside")
    click(qtbot, blank, 10, 10)
    assert "no polygon" in blank.tool.tag


def test_filled_circles_and_outlines_come_from_one_tool(qtbot, blank):
    blank.choose_tool("circle")
    qtbot.mousePress(blank.canvas, LEFT, pos=at(blank, 18, 12))
    qtbot.mouseMove(blank.canvas, at(blank, 24, 12))
    qtbot.mouseRelease(blank.canvas, LEFT, pos=at(blank, 24, 12))
    settle()
    (circle,) = blank.session.sheet.figures
    assert isinstance(circle, Circle)
    assert circle.algorithm == "circle_fill"
    assert painter_of(blank.session.sheet)[12, 18] == 0


def test_the_stack_is_seen_and_its_depth_is_plotted(qtbot):
    panel = opened(qtbot, example("pond").document)
    panel.plot.setParent(None)
    qtbot.addWidget(panel.plot)
    panel.plot.resize(400, 200)
    panel.plot.show()
    run = panel.session.run
    qtbot.waitUntil(lambda: len(panel.plot.depths) == len(run.steps) + 1, timeout=30000)
    number = int(np.argmax(panel.plot.depths))
    run.go(number)
    settle()
    spots = [mark for mark in panel.canvas.overlay.drawn if isinstance(mark, Spot)]
    rows = run.step.tables["Stack"][1]
    assert panel.plot.depths[number] == len(rows)
    assert len(spots) == len(rows) + 1
    panel.plot.step_wanted.emit(40)
    assert run.position == 40


def test_how_often_each_pixel_was_tested(qtbot):
    panel = opened(qtbot, example("missed").document)
    panel.card.heat.setChecked(True)
    run = panel.session.run
    run.last()
    settle()
    qtbot.waitUntil(lambda: len(panel.view._tested or ()) >= len(run.steps), timeout=20000)
    settle()
    counts = panel.view._heat(run)
    # Every filled pixel tests its four neighbours, and the seed is tested before all.
    filled = int((painter_of(panel.session.sheet) == 1).sum())
    assert counts.sum() == 4 * filled + 1
    assert counts[6, 6] == 5
    assert any(isinstance(mark, Word) for mark in panel.canvas.overlay.drawn)


@pytest.mark.parametrize("side", [60, 500])
def test_an_overflow_is_said_with_its_depth_and_hurts_nothing(qtbot, side):
    session = Session(document=blank_sheet(side, side))
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.resize(700, 500)
    panel.show()
    panel.choose_tool("seed")
    panel.tool.algorithm = "boundary_fill_recursive"
    panel.tool.recursion_limit = 200
    panel.tool.press(side / 2, side / 2, Qt.KeyboardModifier.NoModifier, 1.0)
    panel.tool.release(side / 2, side / 2)
    settle()
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=30000)
    settle()
    assert "200" in session.run.message
    assert "200" in panel.card.note.text()
    assert 0 < (painter_of(session.sheet) == 0).sum() < side * side
    assert len(session.sheet.figures) == 1
    assert panel.card.limit.isVisible()


def test_a_greater_limit_fills_what_a_small_one_could_not(qtbot):
    session = Session(document=blank_sheet(20, 20))
    panel = FillPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.show()
    panel.choose_tool("seed")
    panel.tool.algorithm = "boundary_fill_recursive"
    panel.tool.recursion_limit = 50
    panel.tool.press(10.0, 10.0, Qt.KeyboardModifier.NoModifier, 1.0)
    settle()
    assert (frame_buffer(session.sheet) != session.sheet.palette[0]).sum() == 51
    panel.card._put("recursion_limit", 1000)
    assert (frame_buffer(session.sheet) != session.sheet.palette[0]).sum() == 400


def test_ask_first_wants_the_next_pixel(qtbot):
    panel = opened(qtbot, example("missed").document)
    run = panel.session.run
    panel.session.update_state(ask_first=True)
    settle()
    while not run.waiting:
        run.forward()
    settle()
    x, y = run.steps[run.position + 1].chosen[0]
    click(qtbot, panel, x, y)
    assert (run.right, run.wrong) == (1, 0)


def test_asked_first_a_wrong_pixel_is_struck_out_until_the_right_one_is_clicked(qtbot):
    panel = opened(qtbot, example("missed").document)
    run, overlay = panel.session.run, lambda: panel.canvas.overlay
    panel.session.update_state(ask_first=True)
    settle()
    while not run.waiting:
        run.forward()
    settle()
    before = run.position
    chosen = run.steps[before + 1].chosen
    x, y = chosen[0]
    beside = next(
        (x + dx, y + dy) for dx, dy in ((0, 1), (0, -1), (1, 0), (-1, 0)) if (x + dx, y + dy) not in chosen
    )
    click(qtbot, panel, *beside)
    settle()
    assert overlay().wrong == (beside,)
    assert (run.position, run.right, run.wrong) == (before, 0, 1)
    click(qtbot, panel, x, y)
    settle()
    assert (overlay().wrong, overlay().right) == ((), ((x, y),))
    assert (run.position, run.right, run.wrong) == (before + 1, 0, 1)


def test_the_card_asks_for_what_the_text_takes(qtbot, blank):
    blank.choose_tool("seed")
    asked = {}
    for algorithm in ("boundary_fill_4", "flood_fill_8", "boundary_fill_recursive", "boundary_fill_spans"):
        blank.tool.algorithm = algorithm
        blank.refresh()
        settle()
        asked[algorithm] = blank.card.boundary.isVisible(), blank.card.limit.isVisible()
    assert asked == {
        "boundary_fill_4": (True, False),
        "flood_fill_8": (False, False),
        "boundary_fill_recursive": (True, True),
        "boundary_fill_spans": (True, False),
    }


def test_every_page_of_a_run_has_its_own_scan_line(qtbot):
    panel = opened(qtbot, example("triangle").document)
    qtbot.waitUntil(lambda: panel.session.run.done, timeout=15000)
    for number in (2, 5):
        (line,) = [
            mark
            for mark in panel.view.on_paper(number).overlay.drawn
            if isinstance(mark, Stroke) and mark.pattern == "dash"
        ]
        assert line.points[:, 1].tolist() == [number, number]


def test_a_scan_line_shows_its_crossings(qtbot):
    panel = opened(qtbot, example("triangle").document)
    run = panel.session.run
    run.run_to_pixel(5, 4)
    settle()
    words = {mark.text for mark in panel.canvas.overlay.drawn if isinstance(mark, Word)}
    assert {"3.5", "6.5"} <= words
    assert any(isinstance(mark, Stroke) and mark.pattern == "dash" for mark in panel.canvas.overlay.drawn)


def test_every_tool_has_a_key_of_its_own(qtbot, blank):
    keys = [action.shortcut().toString() for action in blank.actions() if action.shortcut().toString()]
    assert len(keys) == len(set(keys))
    qtbot.keyClick(blank.canvas, Qt.Key.Key_S)
    assert blank.tool.name == "seed"
    qtbot.keyClick(blank.canvas, Qt.Key.Key_I)
    assert blank.tool.name == "inside"


def test_a_panel_that_is_not_seen_takes_no_keys(qtbot, blank):
    unseen = FillPanel(blank.session)
    keep_until_the_end(qtbot, unseen)
    assert not any(action.isEnabled() for action in unseen.actions())
    assert any(action.isEnabled() for action in blank.actions())
    blank.hide()
    assert not any(action.isEnabled() for action in blank.actions())
