"""Curves are drawn with the pen: clicks, handles, closing, going on."""

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    CTRL,
    ZIGZAG,
    click,
    curve_through,
    drag,
    hover,
    opened,
    places,
    send,
    the_curve,
)


def test_clicks_with_the_pen_draw_a_curve_and_enter_ends_it(qtbot):
    panel = opened(qtbot)
    assert panel.tool.name == "pen"
    for place in ZIGZAG:
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert places(panel) == list(ZIGZAG)
    assert the_curve(panel).spline == "b_spline"
    assert not the_curve(panel).closed
    panel.session.undo_stack.undo()
    assert panel.session.sheet.figures == ()


SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 48"><path d="M8 8C20 40 40 40 56 8"/></svg>'


@pytest.mark.parametrize("ended_by", ["a drawing that comes in", "undo", "a new picture"])
@pytest.mark.parametrize("then", ["moved", "clicked", "entered"])
def test_what_is_done_while_a_curve_is_drawn_stays_done(qtbot, ended_by, then):
    """It ends the curve where it is; to go on with that would take back what was done."""
    panel = opened(qtbot)
    session = panel.session
    for place in ZIGZAG[:3]:
        click(panel, *place)
    if ended_by == "undo":
        session.end_merge()
        session.undo_stack.undo()
    elif ended_by == "a new picture":
        session.new()
    else:
        panel.exchange.take_svg(SVG)
    done = session.document
    if then == "moved":
        send(panel, QEvent.Type.MouseMove, 40, 20)
        assert session.document is done
        assert not panel.gesturing
    elif then == "clicked":
        click(panel, 40, 20)
        click(panel, 50, 30)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    kept = done.sheets[0].figures
    assert session.sheet.figures[: len(kept)] == kept
    assert len(session.sheet.figures) <= len(kept) + (then == "clicked")


def test_a_click_on_the_first_point_closes_the_curve(qtbot):
    panel = opened(qtbot)
    for place in (*ZIGZAG, ZIGZAG[0]):
        click(panel, *place)
    assert places(panel) == list(ZIGZAG)
    assert the_curve(panel).closed
    assert not panel.gesturing


def test_backspace_takes_the_last_point_back_and_escape_all(qtbot):
    panel = opened(qtbot)
    for place in ZIGZAG[:3]:
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Backspace)
    settle()
    assert places(panel) == list(ZIGZAG[:2])
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    settle()
    assert panel.session.sheet.figures == ()


def test_one_click_is_no_curve_and_that_is_said(qtbot):
    panel = opened(qtbot)
    said = []
    panel.hover_text.connect(said.append)
    click(panel, 30, 20)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    assert any("two" in text for text in said)
    assert panel.session.sheet.figures == ()


def test_the_pen_pulls_symmetric_handles_out_of_the_points_of_a_path(qtbot):
    panel = opened(qtbot)
    panel.pen.model = replace(panel.pen.model, spline="bezier_path")
    drag(panel, (28, 10), (32, 14), (34, 16))
    drag(panel, (44, 30), (44, 34))
    click(panel, 58, 12)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    found = the_curve(panel)
    assert places(panel)[:5] == [(28, 10), (34, 16), (44, 26), (44, 30), (44, 34)]
    assert [found.points_world[k].joint for k in (0, 3, 6)] == ["symmetric", "symmetric", "corner"]


def test_a_pulled_tangent_of_a_hermite_spline_is_the_derivative(qtbot):
    panel = opened(qtbot)
    panel.pen.model = replace(panel.pen.model, spline="hermite")
    drag(panel, (28, 10), (32, 14))
    click(panel, 50, 30)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    point = the_curve(panel).points_world[0]
    assert (point.tangent_x, point.tangent_y) == (12, 12)


@pytest.mark.parametrize("spline", ["b_spline", "natural_cubic", "bezier_path"])
@pytest.mark.parametrize("end", [-1, 0])
def test_the_pen_goes_on_from_the_end_of_an_open_curve(qtbot, spline, end):
    seven = (*ZIGZAG, (54.0, 40.0), (30.0, 44.0))
    panel = opened(qtbot, curve_through(*seven, spline=spline))
    panel.choose_tool("pen")
    click(panel, *seven[end])
    click(panel, 56, 4)
    click(panel, 60, 20)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    found = places(panel)
    assert len(found) == 7 + 2 * (3 if spline == "bezier_path" else 1)
    assert found[end] == (60, 20)
    assert panel.session.undo_stack.count() == 1
    panel.session.undo_stack.undo()
    assert places(panel) == list(seven)


def test_control_keeps_the_pen_to_eight_directions(qtbot):
    panel = opened(qtbot)
    click(panel, 28, 10)
    send(panel, QEvent.Type.MouseMove, 40, 11, CTRL)
    click(panel, 40, 11, CTRL)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert places(panel) == [(28, 10), (40, 10)]


def test_a_curve_with_two_ends_is_not_closed_by_a_click_on_its_first_point(qtbot):
    panel = opened(qtbot)
    panel.pen.model = replace(panel.pen.model, spline="natural_cubic")
    for place in (*ZIGZAG, ZIGZAG[0]):
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    assert places(panel) == [*ZIGZAG, ZIGZAG[0]]
    assert not the_curve(panel).closed


def test_a_single_click_of_the_pen_leaves_nothing_behind_whatever_follows(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    session = panel.session
    before = session.document
    panel.choose_tool("pen")
    click(panel, 8, 8)
    assert session.document is before
    panel.delete_selected()
    settle()
    assert session.document is before
    assert not session.undo_stack.canUndo()
    click(panel, 8, 8)
    click(panel, 20, 8)
    assert [len(figure.points_world) for figure in session.sheet.figures] == [len(ZIGZAG), 2]


@pytest.mark.parametrize("tool", ["pen", "select"])
@pytest.mark.parametrize("ended_by", ["undo", "a new picture"])
def test_words_beside_the_pointer_go_with_what_was_drawn_or_dragged(qtbot, tool, ended_by):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    session = panel.session
    panel.choose_tool(tool)
    if tool == "pen":
        click(panel, 4, 40)
        click(panel, 12, 40)
        send(panel, QEvent.Type.MouseMove, 14, 30)
        hover(panel, 14, 30)
    else:
        send(panel, QEvent.Type.MouseButtonPress, *ZIGZAG[1])
        send(panel, QEvent.Type.MouseMove, 20, 20)
    assert panel.canvas._tag
    session.end_merge()
    session.undo_stack.undo() if ended_by == "undo" else session.new()
    settle()
    assert panel.canvas._tag == ""
    assert not panel.tool.busy


def test_delete_takes_back_what_the_pen_draws_and_leaves_no_trace(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    session = panel.session
    before = session.document
    panel.choose_tool("pen")
    for place in ((4, 40), (12, 40), (12, 44)):
        click(panel, *place)
    assert len(session.sheet.figures) == 2
    panel.delete_selected()
    settle()
    assert session.document == before
    assert not session.undo_stack.canUndo()
    assert not panel.gesturing
