"""The Curves panel as a person uses it: pen, points, handles, tangents, bands, the parameter, bad input."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, Qt

from tests.panels.curves.by_hand import (
    CTRL,
    LEFT,
    SHIFT,
    ZIGZAG,
    click,
    curve_through,
    drag,
    opened,
    places,
    send,
    settle,
    the_curve,
)
from workbench.document.subjects import Subject
from workbench.widgets.canvas.drawing import Stroke
from workbench.widgets.stepping.step_bar import Steps


@pytest.fixture
def zigzag(qtbot):
    return opened(qtbot, curve_through(*ZIGZAG))


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


def test_a_dragged_point_moves_alone_and_is_one_step_of_undo(zigzag):
    drag(zigzag, ZIGZAG[1], (34, 30), (36, 28))
    assert places(zigzag) == [ZIGZAG[0], (36, 28), *ZIGZAG[2:]]
    assert zigzag.session.undo_stack.count() == 1
    zigzag.session.undo_stack.undo()
    assert places(zigzag) == list(ZIGZAG)


def test_control_keeps_a_drag_to_eight_directions(zigzag):
    drag(zigzag, ZIGZAG[1], (36, 35), modifiers=CTRL)
    assert places(zigzag)[1] == (36, 34)
    drag(zigzag, (36, 34), (41, 40), modifiers=CTRL)
    x, y = places(zigzag)[1]
    assert x - 36 == pytest.approx(y - 34)


def test_shift_chooses_several_and_all_of_them_move(zigzag):
    click(zigzag, *ZIGZAG[1])
    click(zigzag, *ZIGZAG[3], SHIFT)
    assert zigzag.focus.numbers(the_curve(zigzag)) == [1, 3]
    drag(zigzag, ZIGZAG[3], (48, 13))
    assert places(zigzag) == [ZIGZAG[0], (34, 35), ZIGZAG[2], (48, 13), ZIGZAG[4]]


def test_a_band_chooses_the_points_inside(zigzag):
    drag(zigzag, (28, 30), (38, 42), (44, 44))
    assert zigzag.focus.numbers(the_curve(zigzag)) == [1, 2]
    assert zigzag.session.state.selection == (the_curve(zigzag).id,)


def test_a_click_on_one_of_several_leaves_that_one(zigzag):
    drag(zigzag, (28, 30), (44, 44))
    click(zigzag, *ZIGZAG[2])
    assert zigzag.focus.numbers(the_curve(zigzag)) == [2]


def test_escape_lets_go_of_points_then_of_the_curve(qtbot, zigzag):
    click(zigzag, *ZIGZAG[2])
    qtbot.keyClick(zigzag.canvas, Qt.Key.Key_Escape)
    assert not zigzag.focus.points
    assert zigzag.session.state.selection
    qtbot.keyClick(zigzag.canvas, Qt.Key.Key_Escape)
    assert zigzag.session.state.selection == ()


def test_escape_while_dragging_brings_the_point_back(qtbot, zigzag):
    send(zigzag, QEvent.Type.MouseButtonPress, *ZIGZAG[1])
    send(zigzag, QEvent.Type.MouseMove, 50, 20)
    assert places(zigzag)[1] == (50, 20)
    qtbot.keyClick(zigzag.canvas, Qt.Key.Key_Escape)
    settle()
    assert places(zigzag) == list(ZIGZAG)
    assert zigzag.focus.moving == ()


def test_the_tangent_of_a_hermite_spline_is_dragged(qtbot):
    curve = curve_through((28, 20), (52, 20), spline="hermite")
    points = tuple(replace(p, tangent_x=12.0, tangent_y=18.0) for p in curve.points_world)
    panel = opened(qtbot, replace(curve, points_world=points))
    drag(panel, (32, 26), (34, 23))
    assert (the_curve(panel).points_world[0].tangent_x, the_curve(panel).points_world[0].tangent_y) == (18, 9)


def test_u_is_dragged_along_the_curve(zigzag):
    zigzag.focus.switch("construction", True)
    settle()
    from workbench.panels.curves.scene import point_at

    start = point_at(zigzag.session.sheet, the_curve(zigzag), zigzag.focus.u)
    end = point_at(zigzag.session.sheet, the_curve(zigzag), 0.8)
    drag(zigzag, start, end)
    assert zigzag.focus.u == pytest.approx(0.8, abs=5e-3)
    assert places(zigzag) == list(ZIGZAG)


def test_what_is_missing_is_said_on_the_card(qtbot):
    panel = opened(qtbot, curve_through((30, 10), (40, 20)))
    assert panel.card.fault.isVisible()
    assert "There are 2 points, and 4 are needed; add 2." in panel.card.fault.text()


def test_both_countings_stand_on_the_card(zigzag):
    said = zigzag.card.count.text()
    assert "n + 1 = 5" in said
    assert "d = 4" in said
    assert "5 points, degree 3, 2 pieces" in said


def test_a_span_without_length_is_no_piece(qtbot):
    panel = opened(qtbot)
    panel.session.open_example("curve-circle")
    settle()
    assert "9 points, degree 2, 4 pieces" in panel.card.count.text()


def test_other_kinds_are_shown_beside_and_named(zigzag):
    zigzag.card._kinds["catmull_rom"].trigger()
    settle()
    assert the_curve(zigzag).beside == ("catmull_rom",)
    assert "Catmull-Rom" in zigzag.card.legend.text()


def test_typed_coordinates_move_the_chosen_point(qtbot, zigzag):
    click(zigzag, *ZIGZAG[1])
    sheet, curve = zigzag.session.sheet, the_curve(zigzag)
    field = zigzag.card._fields[f"{sheet.id}/{curve.id}/{curve.points_world[1].id}/x"].field
    field.selectAll()
    qtbot.keyClicks(field, "60/2")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert places(zigzag)[1] == (30, 34)


def test_what_a_point_moves_is_local_for_a_b_spline_and_everything_for_a_natural_spline():
    from workbench.panels.curves.scene import influence

    many = [(float(k), float(k % 3)) for k in range(12)]
    local = influence(curve_through(*many), (6,))
    assert np.flatnonzero(local).tolist() == [3, 4, 5, 6]
    everywhere = influence(curve_through(*many, spline="natural_cubic"), (6,))
    assert (everywhere > 0).sum() == len(many) - 1


@pytest.mark.parametrize("spline", ["b_spline", "natural_cubic", "bezier_path"])
def test_a_long_curve_looks_the_same_while_dragged_and_when_let_go(qtbot, spline):
    """What stays is painted once; nothing of it may be missing, or stand where it no longer is."""
    turn = np.linspace(0, 12 * np.pi, 601)
    far = np.linspace(3, 20, 601)
    places_ = np.column_stack([42 + far * np.cos(turn), 24 + far * np.sin(turn)]).round(2).tolist()
    panel = opened(qtbot, curve_through(*map(tuple, places_), spline=spline))
    panel.focus.switch("construction", False)
    panel.focus.switch("influence", False)
    x, y = places_[450]
    send(panel, QEvent.Type.MouseButtonPress, x, y)
    send(panel, QEvent.Type.MouseMove, x + 3, y + 2)
    assert panel.canvas.overlay.still is not None
    kept = panel.canvas.overlay.still
    dragged = panel.canvas.grab().toImage()
    send(panel, QEvent.Type.MouseMove, x + 2, y + 2)
    assert panel.canvas.overlay.still is kept
    send(panel, QEvent.Type.MouseMove, x + 3, y + 2)
    assert panel.canvas.grab().toImage() == dragged
    send(panel, QEvent.Type.MouseButtonRelease, x + 3, y + 2)
    assert panel.canvas.overlay.still is None
    whole = panel.canvas.grab().toImage()
    one, other = (
        np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1).astype(int)
        for image in (dragged, whole)
    )
    # The pixels beneath follow when the point is let go, so only what is dark is compared: curve and grips.
    ink = (other.reshape(*other.shape[:1], -1, 4)[..., 2] < 60).sum()
    was = (one.reshape(*one.shape[:1], -1, 4)[..., 2] < 60).sum()
    assert was > 0.9 * ink


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


def test_the_text_that_is_stepped_is_chosen_on_the_card(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    assert panel.card.steps.currentData() == "de_boor"
    panel.card.steps.setCurrentIndex(panel.card.steps.findData("flatten_bezier"))
    panel.card.steps.activated.emit(panel.card.steps.currentIndex())
    settle()
    qtbot.waitUntil(lambda: panel.session.run.entry.slug == "flatten_bezier", timeout=5000)
    assert panel.card.tolerance.isVisible()
    panel.card.tolerance.edited.emit(0.5)
    assert the_curve(panel).tolerance_px == 0.5
    panel.card.spline.setCurrentIndex(panel.card.spline.findData("nurbs"))
    panel.card.spline.activated.emit(panel.card.spline.currentIndex())
    settle()
    assert the_curve(panel).spline == "nurbs"


def test_control_keeps_the_pen_to_eight_directions(qtbot):
    panel = opened(qtbot)
    click(panel, 28, 10)
    send(panel, QEvent.Type.MouseMove, 40, 11, CTRL)
    click(panel, 40, 11, CTRL)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert places(panel) == [(28, 10), (40, 10)]


def test_with_snap_points_go_to_pixels_and_it_is_seen(zigzag):
    zigzag._toggle_snap()
    send(zigzag, QEvent.Type.MouseButtonPress, *ZIGZAG[1])
    send(zigzag, QEvent.Type.MouseMove, 35.3, 30.8)
    assert places(zigzag)[1] == (35, 31)
    assert zigzag.canvas.overlay.snap == (35, 31)
    send(zigzag, QEvent.Type.MouseButtonRelease, 35.3, 30.8)
    assert zigzag.canvas.overlay.snap is None


@pytest.mark.parametrize(
    ("spline", "round_", "choice"),
    [("natural_cubic", False, False), ("clamped_cubic", False, False), ("periodic_cubic", True, False),
     ("catmull_rom", True, True)],
)  # fmt: skip
def test_only_what_may_be_closed_is_offered_to_be(qtbot, spline, round_, choice):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline=spline, closed=spline != "periodic_cubic"))
    said = []
    panel.hover_text.connect(said.append)
    assert (panel.card.closed.isChecked(), panel.card.closed.isEnabled()) == (round_, choice)
    before = the_curve(panel)
    panel.commands.toggle_closed()
    assert (the_curve(panel) == before) == bool(said) == (not choice)


def test_a_curve_with_two_ends_is_not_closed_by_a_click_on_its_first_point(qtbot):
    panel = opened(qtbot)
    panel.pen.model = replace(panel.pen.model, spline="natural_cubic")
    for place in (*ZIGZAG, ZIGZAG[0]):
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    assert places(panel) == [*ZIGZAG, ZIGZAG[0]]
    assert not the_curve(panel).closed


def test_knots_are_freed_of_a_curve_that_is_there(qtbot):
    """What the pen draws next has no knots yet that could be freed."""
    panel = opened(qtbot)
    rule = panel.card.rule
    free = rule.model().index(rule.findData("free"), 0)
    offered = Qt.ItemFlag.ItemIsEnabled
    assert rule.isVisible()
    assert not free.flags() & offered
    for place in ZIGZAG:
        click(panel, *place)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    assert free.flags() & offered
    rule.setCurrentIndex(free.row())
    rule.activated.emit(free.row())
    settle()
    assert the_curve(panel).knot_rule == "free"


@pytest.mark.parametrize("rule", ["uniform", "free"])
def test_a_closed_b_spline_is_counted_as_it_goes_round(qtbot, rule):
    panel = opened(qtbot, curve_through(*ZIGZAG, closed=True))
    panel.card.rule.setCurrentIndex(panel.card.rule.findData(rule))
    panel.card.rule.activated.emit(panel.card.rule.currentIndex())
    settle()
    assert the_curve(panel).knot_rule == rule
    assert f"{len(ZIGZAG)} pieces" in panel.card.count.text()


@pytest.mark.parametrize(("spline", "pieces"), [("natural_cubic", 4), ("periodic_cubic", 5)])
def test_pieces_are_counted_and_legs_drawn_as_the_curve_goes(qtbot, spline, pieces):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline=spline, closed=spline == "natural_cubic"))
    assert f"{pieces} cubic pieces" in panel.card.count.text()
    (legs,) = [each for each in panel.view.drawn() if isinstance(each, Stroke) and each.pattern == "dash"]
    assert len(legs.points) == pieces + 1


def test_asked_first_what_becomes_of_a_piece_is_chosen_and_tried_again(qtbot):
    panel = opened(qtbot, curve_through((6, 6), (16, 40), (40, 40), (56, 8), spline="bezier"))
    session, run = panel.session, panel.session.run
    bar = Steps(run)
    qtbot.addWidget(bar)
    bar.show()
    session.update_state(subject=Subject("curve", entry="flatten_bezier"), ask_first=True)
    settle()
    qtbot.waitUntil(lambda: run.entry.slug == "flatten_bezier" and run.done, timeout=5000)
    settle()

    def choose(text):
        button = next(button for button in bar.options.buttons if button.text() == text)
        qtbot.mouseClick(button, LEFT)
        settle()

    again, show = bar.bar.after_wrong
    assert [button.text() for button in bar.options.buttons] == ["Flat", "Divide"]
    choose("Flat")
    assert bar.sentence.plain.startswith("Not so: “flat” is not what comes next.")
    assert (run.position, run.right, run.wrong) == (0, 0, 1)
    qtbot.mouseClick(again, LEFT)
    choose("Divide")
    assert (run.position, run.right, run.wrong) == (1, 0, 1)
    choose("Flat" if run.steps[2].answer == "divide" else "Divide")
    qtbot.mouseClick(show, LEFT)
    assert (run.position, run.right, run.wrong) == (2, 0, 2)
    before = run.position
    qtbot.mouseClick(panel.canvas, LEFT, pos=panel.canvas.widget_position(30, 30).toPoint())
    settle()
    assert (run.position, run.right, run.wrong) == (before, 0, 2)
