"""What the Curves panel shows of a curve: basis functions, knots, weights, joints, marks, construction."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtWidgets import QDockWidget, QLabel, QMainWindow

from tests.panels.curves.by_hand import (
    CTRL,
    ZIGZAG,
    click,
    curve_through,
    hover,
    opened,
    places,
    send,
    settle,
    the_curve,
)
from workbench.algorithms import curves, marks
from workbench.algorithms.curves import piece_points
from workbench.document.curves.pieces import parameter_at, pieces_of
from workbench.document.curves.settings import set_spline
from workbench.document.model import SPLINES, Curve, CurvePoint
from workbench.panels.curves.basis import MOST, basis_of
from workbench.panels.curves.compare import MEASURED_DEGREE
from workbench.panels.curves.insight import switches
from workbench.panels.curves.marks import ALONG, MOST_CROSSED, crossings
from workbench.panels.curves.scene import point_at
from workbench.widgets.canvas.drawing import Spot, Stroke

PLACES = ((26.0, 10.0), (32.0, 34.0), (40.0, 40.0), (46.0, 12.0), (58.0, 30.0), (60.0, 8.0), (50.0, 4.0))


def with_docks(qtbot, *curves):
    """The panel in a window, with its docks to be seen."""
    panel = opened(qtbot, *curves)
    window = QMainWindow()
    qtbot.addWidget(window)
    for name, title, widget, _area in panel.docks():
        dock = QDockWidget(title, window)
        dock.setObjectName(name)
        dock.setWidget(widget)
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.resize(800, 1100)
    window.show()
    qtbot.waitExposed(window)
    panel.docked_in = window
    panel.refresh()
    qtbot.waitUntil(lambda: not panel.beside.comparing)
    settle()
    return panel


@pytest.mark.parametrize("spline", SPLINES)
def test_the_plotted_functions_add_up_to_the_curve(spline):
    """Whatever the kind: functions times points is the curve, when the kind is linear in its points."""
    curve = curve_through(*PLACES, spline=spline)
    if spline == "nurbs":
        points = [replace(p, weight=1.0 + k % 3) for k, p in enumerate(curve.points_world)]
        curve = replace(curve, points_world=tuple(points))
    if spline == "catmull_rom":
        curve = replace(curve, alpha=0.0)
    found = basis_of(curve, 0.5)
    pieces = pieces_of(curve)
    places = np.array([(p.x, p.y) for p in curve.points_world])
    made = found.values @ places[list(found.numbers)]
    assert made == pytest.approx(piece_points(pieces, found.us), abs=1e-6)
    assert found.values.sum(axis=1) == pytest.approx(1.0)


@pytest.mark.parametrize("spline", ["b_spline", "nurbs", "catmull_rom", "bezier_path"])
@pytest.mark.parametrize("share", [0.0, 0.31, 1.0])
def test_of_very_many_functions_those_that_matter_at_u_are_shown(spline, share):
    curve = curve_through(*((float(k), float(k % 5)) for k in range(61)), spline=spline, alpha=0.0)
    found = basis_of(curve, share)
    assert len(found.numbers) == len(found.names) == MOST
    at_u = found.values[round(share * (len(found.us) - 1))]
    assert at_u.sum() == pytest.approx(1.0)


def arrived_at(panel, share):
    """The point that a whole construction has come to."""
    panel.focus.switch("construction", True)
    panel.focus.set_u(share)
    panel.session.update_state(step=0)
    settle()
    last, place = [e for e in panel.view.drawn() if isinstance(e, marks.Spot) and e.size == "large"]
    assert (last.x, last.y) == pytest.approx((place.x, place.y))
    return last


@pytest.mark.parametrize("spline", SPLINES)
@pytest.mark.parametrize("share", [0.0, 0.37, 0.5, 1.0])
def test_the_construction_ends_on_the_curve(qtbot, spline, share):
    curve = curve_through(*PLACES, spline=spline)
    weighted = tuple(replace(p, weight=1.0 + k % 3) for k, p in enumerate(curve.points_world))
    panel = opened(qtbot, replace(curve, points_world=weighted))
    curve = the_curve(panel)
    last = arrived_at(panel, share)
    assert (last.x, last.y) == pytest.approx(piece_points(pieces_of(curve), parameter_at(curve, share)))


def test_stepping_builds_the_construction_point_by_point(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    panel.focus.switch("construction", True)
    qtbot.waitUntil(lambda: panel.session.run.done, timeout=15000)
    assert panel.session.run.entry.slug == "de_boor"
    seen = []
    for number in (1, 3, 6):
        panel.session.run.go_to_step(number)
        settle()
        drawn = panel.view.drawn()
        seen.append(sum(isinstance(each, marks.Spot) and each.shape == "dot" for each in drawn))
    assert seen == sorted(set(seen))


def test_under_a_drag_the_construction_stays_as_far_as_it_was_on_the_curve_as_it_is(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG, spline="bezier"))
    panel.focus.switch("construction", True)
    qtbot.waitUntil(lambda: panel.session.run.done, timeout=15000)
    panel.session.run.go_to_step(2)
    settle()
    start, end = ZIGZAG[1], (ZIGZAG[1][0] + 9.0, ZIGZAG[1][1] - 14.0)
    send(panel, QEvent.Type.MouseButtonPress, *start)
    send(panel, QEvent.Type.MouseMove, *end)
    assert panel.session.run.arguments[0][1].tolist() == list(start)
    dots = [(e.x, e.y) for e in panel.view.drawn() if isinstance(e, marks.Spot) and e.shape == "dot"]
    moved, u = np.array([ZIGZAG[0], end, ZIGZAG[2]]), panel.focus.u
    np.testing.assert_allclose(dots, (1 - u) * moved[:-1] + u * moved[1:], atol=1e-6)
    send(panel, QEvent.Type.MouseButtonRelease, *end)


def test_every_switch_draws_something_and_takes_it_away(qtbot):
    loop = ((24.0, 10.0), (58.0, 40.0), (58.0, 10.0), (24.0, 40.0), (22.0, 20.0))
    panel = with_docks(qtbot, curve_through(*loop, spline="catmull_rom"))
    panel.focus.choose({the_curve(panel).points_world[2].id})
    for name, _title, _meaning in switches():
        if name == "pixels":
            continue
        for box in panel.beside.insight.boxes.values():
            box.setChecked(False)
        settle()
        before = len(panel.view.drawn())
        panel.beside.insight.boxes[name].click()
        settle()
        assert len(panel.view.drawn()) > before, name
        panel.beside.insight.boxes[name].click()
        settle()
        assert len(panel.view.drawn()) == before, name


def test_a_knot_is_dragged_and_the_knots_become_free(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    before = panel.session.undo_stack.count()
    panel.beside.basis.knot_dragged.emit("#5", 2.5)
    panel.beside.basis.knot_dragged.emit("#5", 2.75)
    panel.beside.basis.knot_released.emit("#5")
    settle()
    curve = the_curve(panel)
    assert curve.knot_rule == "free"
    assert curve.knots[5].u == 2.75
    assert panel.session.undo_stack.count() == before + 1
    panel.session.undo_stack.undo()
    assert the_curve(panel).knot_rule == "open_uniform"


def test_a_knot_is_removed_where_the_curve_stays(qtbot):
    panel = opened(qtbot, curve_through(*PLACES[:5], spline="b_spline"))
    before = the_curve(panel)
    said = []
    panel.hover_text.connect(said.append)
    panel.beside.basis.knot_unwanted.emit("#4")
    assert the_curve(panel) == before
    assert "the curve would change by up to" in said[-1]
    panel.beside.basis.knot_wanted.emit(0.5)
    (new,) = [knot.id for knot in the_curve(panel).knots if knot.u == 0.5]
    panel.beside.basis.knot_unwanted.emit(new)
    assert len(the_curve(panel).points_world) == 5
    np.testing.assert_allclose(places(panel), [(p.x, p.y) for p in before.points_world], atol=1e-9)
    assert said[-1].startswith("The knot is gone")
    panel.session.undo_stack.undo()
    assert len(the_curve(panel).points_world) == 6


def test_the_knot_nearest_to_u_is_removed_by_a_command(qtbot):
    panel = opened(qtbot, curve_through(*PLACES[:5], spline="b_spline"))
    panel.beside.basis.knot_wanted.emit(0.5)
    panel.focus.set_u(0.26)
    panel.commands.remove_knot_at_u()
    assert 0.5 not in [knot.u for knot in the_curve(panel).knots]
    said = []
    panel.hover_text.connect(said.append)
    panel.session.apply(set_spline(the_curve(panel).id, "bezier"), "Change kind")
    panel.commands.remove_knot_at_u()
    assert said == ["Only a B-spline or NURBS curve has knots; convert the curve before."]


def test_a_knot_that_would_pass_its_neighbour_is_refused_in_words(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    said = []
    panel.hover_text.connect(said.append)
    panel.beside.basis.knot_dragged.emit("#5", 99.0)
    panel.beside.basis.knot_released.emit("#5")
    assert "knots" in said[-1]
    assert the_curve(panel).knot_rule == "open_uniform"
    assert not panel.session.undo_stack.canUndo()


def test_a_weight_is_dragged_as_one_step_of_undo(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, spline="nurbs"))
    for weight in (2.0, 3.0, 4.0):
        panel.beside.basis.weight_dragged.emit(1, weight)
    panel.beside.basis.weight_released.emit(1)
    settle()
    assert the_curve(panel).points_world[1].weight == 4.0
    panel.beside.basis.weight_dragged.emit(2, 5.0)
    panel.beside.basis.weight_released.emit(2)
    panel.session.undo_stack.undo()
    assert the_curve(panel).points_world[1].weight == 4.0
    panel.session.undo_stack.undo()
    assert the_curve(panel).points_world[1].weight == 1.0


def test_pointing_at_a_function_rings_its_point_and_the_other_way_round(qtbot):
    panel = with_docks(qtbot, curve_through(*ZIGZAG))
    panel.beside.basis.hovered.emit(3)
    settle()
    assert any(isinstance(e, Spot) and (e.x, e.y) == ZIGZAG[3] and e.size > 15 for e in panel.view.drawn())
    hover(panel, *ZIGZAG[1])
    assert panel.beside.basis.curves.lit == 1
    hover(panel, 30, 2)
    assert panel.beside.basis.curves.lit == -1


def test_u_is_dragged_in_the_plot(qtbot):
    panel = with_docks(qtbot, curve_through(*ZIGZAG))
    curves = panel.beside.basis.curves
    qtbot.mouseClick(
        curves, Qt.MouseButton.LeftButton, pos=QPoint(round(curves.x_of(0.5)), curves.height() // 2)
    )
    settle()
    assert panel.focus.u == pytest.approx(0.25, abs=0.02)
    assert "construction" in panel.focus.shown


def test_a_double_click_on_a_joint_goes_there(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, spline="bezier_path"))
    table = panel.beside.continuity
    assert len(table.model.joints) == 1
    table.joint_activated.emit(0)
    settle()
    assert panel.focus.u == pytest.approx(0.5)
    at = point_at(panel.session.sheet, the_curve(panel), panel.focus.u)
    assert at == pytest.approx(PLACES[3])


def test_the_measures_are_those_of_the_curve(qtbot):
    panel = with_docks(qtbot, curve_through((20.0, 10.0), (50.0, 10.0), spline="bezier"))
    assert "30 px" in panel.beside.insight.words.text()


def test_arrows_nudge_the_chosen_points_and_delete_removes_them(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    click(panel, *ZIGZAG[1])
    panel.canvas.setFocus()
    for _press in range(3):
        qtbot.keyClick(panel.canvas, Qt.Key.Key_Right)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    assert (the_curve(panel).points_world[1].x, the_curve(panel).points_world[1].y) == (35, 44)
    panel.delete_selected()
    assert len(the_curve(panel).points_world) == 4
    panel.session.undo_stack.undo()
    panel.session.undo_stack.undo()
    assert the_curve(panel).points_world[1].x == ZIGZAG[1][0]


def test_the_joint_of_a_path_is_changed_by_command_alone(qtbot):
    panel = opened(qtbot, curve_through(*PLACES, spline="bezier_path"))
    click(panel, *PLACES[3])
    panel.commands.joint("smooth")
    assert the_curve(panel).points_world[3].joint == "smooth"
    kept = [replace(p, id="") for p in the_curve(panel).points_world]
    send(panel, QEvent.Type.MouseButtonPress, *PLACES[2], CTRL)
    send(panel, QEvent.Type.MouseButtonRelease, *PLACES[2], CTRL)
    assert [replace(p, id="") for p in the_curve(panel).points_world] == kept


def test_the_comb_has_teeth_on_every_piece():
    from workbench.panels.curves.marks import COMB_TEETH, comb

    pieces = pieces_of(curve_through(*PLACES, spline="catmull_rom"))
    strokes = [each for each in comb(pieces, 80.0) if isinstance(each, Stroke)]
    assert len(strokes) == 2 * (len(PLACES) - 1)
    assert len(strokes[0].points) >= 3 * COMB_TEETH


def test_the_same_points_through_several_kinds_are_compared(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES))
    table = panel.beside.measured.model
    names = [kind.name for kind in table.kinds]
    assert names[0] == "B-spline"
    assert {"Natural cubic spline", "Catmull-Rom spline", "Bézier curve"} <= set(names)
    passes = {kind.name: kind.values[0] for kind in table.kinds}
    assert passes["Natural cubic spline"] is True
    assert passes["B-spline"] is False
    panel.beside.measured.kind_activated.emit(names.index("Catmull-Rom spline"))
    settle()
    assert the_curve(panel).beside == ("catmull_rom",)
    qtbot.waitUntil(lambda: not panel.beside.comparing)
    assert [kind.name for kind in table.kinds] == ["B-spline", "Catmull-Rom spline"]


@pytest.mark.parametrize("spline", SPLINES)
def test_the_functions_of_closed_curves_add_up_too(spline):
    places = PLACES[:6]
    points = tuple(CurvePoint("", x, y, weight=1.0 + k % 3) for k, (x, y) in enumerate(places))
    curve = Curve("", points, "bresenham_line", spline=spline, closed=True, alpha=0.0)
    found = basis_of(curve, 0.5)
    made = found.values @ np.array(places)[list(found.numbers)]
    assert made == pytest.approx(piece_points(pieces_of(curve), found.us), abs=1e-6)


@pytest.mark.parametrize("spline", SPLINES)
def test_the_construction_of_closed_curves_ends_on_them(qtbot, spline):
    panel = opened(qtbot, replace(curve_through(*PLACES[:6], spline=spline), closed=True))
    curve = the_curve(panel)
    for share in (0.05, 0.6, 0.97):
        last = arrived_at(panel, share)
        at = piece_points(pieces_of(curve), parameter_at(curve, share))
        assert (last.x, last.y) == pytest.approx(at)


def compared(qtbot, curve):
    """The values of each kind in the table of a curve, by the name of the kind and of the measure."""
    table = with_docks(qtbot, curve).beside.measured.model
    names = [measure.name for measure in table.measures]
    return {kind.name: dict(zip(names, kind.values, strict=True)) for kind in table.kinds}


@pytest.mark.parametrize("spline", ["cardinal", "catmull_rom", "kochanek_bartels"])
def test_ends_that_only_steer_are_not_passed(qtbot, spline):
    curve = curve_through(*PLACES, spline=spline, beside=("hermite",), ends="inner")
    own, other = compared(qtbot, curve).values()
    assert (own["through the points"], other["through the points"]) == (False, True)
    assert own["farthest point"] > 1
    around, _other = compared(qtbot, replace(curve, closed=True)).values()
    assert around["through the points"] is True


def test_kinds_with_two_ends_have_no_joint_between_these(qtbot):
    """A kind that cannot go round is measured as it is drawn, whatever is asked of the others."""
    beside = ("clamped_cubic", "periodic_cubic", "catmull_rom")
    curve = curve_through(*PLACES, spline="natural_cubic", beside=beside, closed=True)
    smooth = {name: values["smoothness"] for name, values in compared(qtbot, curve).items()}
    assert smooth == {
        "Natural cubic spline": "C2, G2",
        "Clamped cubic spline": "C2, G2",
        "Periodic cubic spline": "C2, G2",
        "Catmull-Rom spline": "C1, G1",
    }
    table = with_docks(qtbot, curve).beside.continuity
    assert len(table.model.joints) == len(PLACES) - 2
    periodic = with_docks(qtbot, replace(curve, spline="periodic_cubic", closed=False))
    assert len(periodic.beside.continuity.model.joints) == len(PLACES)


def test_kinds_in_the_table_have_the_lines_of_the_canvas(qtbot):
    panel = with_docks(qtbot, curve_through(*PLACES, beside=("nurbs", "cardinal")))
    drawn = {(stroke.ink, stroke.pattern) for stroke in panel.view.drawn() if isinstance(stroke, Stroke)}
    shown = [(kind.ink, kind.pattern) for kind in panel.beside.measured.model.kinds]
    assert len(shown) == 3
    assert set(shown) <= drawn


def test_what_is_not_compared_says_why(qtbot):
    many = [(float(k % 60), float(k % 7)) for k in range(201)]
    for drawn, said in (
        ([], "Select a curve"),
        ([curve_through(*many)], "more than 200 points"),
        ([curve_through((1.0, 1.0))], "4 are needed"),
    ):
        table = with_docks(qtbot, *drawn).beside.measured
        assert table.state.empty
        assert said in table.state.sentence.text()
    assert not with_docks(qtbot, curve_through(*many[:200])).beside.measured.state.empty


def test_a_curve_of_a_high_degree_is_not_measured(qtbot):
    places = [(float(7 * k % 61), float(5 * k % 43)) for k in range(MEASURED_DEGREE + 2)]
    for count, measured in ((MEASURED_DEGREE + 1, True), (MEASURED_DEGREE + 2, False)):
        panel = with_docks(qtbot, curve_through(*places[:count], spline="bezier", beside=("natural_cubic",)))
        bezier, other = panel.beside.measured.model.kinds
        assert bezier.values[-1] == str(count - 1)
        assert (None not in bezier.values[:3]) == measured
        assert None not in other.values[:3]
        said = [label.text() for label in panel.beside.insight.findChildren(QLabel)]
        assert any("not measured" in text for text in said) != measured


def test_crossings_of_very_many_pieces_are_not_looked_for(qtbot, monkeypatch):
    zigzag = [(10.0 + 7 * k % 41, 8.0 + 11 * k % 29) for k in range(MOST_CROSSED + 2)]
    few, many = (pieces_of(curve_through(*zigzag[:n], spline="catmull_rom")) for n in (40, len(zigzag)))
    assert len(crossings(few)) > 10
    monkeypatch.setattr(curves, "self_meetings", lambda *_given: pytest.fail("takes seconds"))
    assert crossings(many) == []


def test_a_path_that_runs_back_over_itself_is_said_once(qtbot):
    there = [(10.0, 8.0), (31.0, 29.0), (52.0, 11.0)]
    drawn = crossings(pieces_of(curve_through(*there, *there[-2::-1], spline="catmull_rom")))
    assert [type(each).__name__ for each in drawn].count("Spot") == 0
    assert [each.text for each in drawn if type(each).__name__ == "Word"] == ["runs along itself"]
    (line,) = (each for each in drawn if type(each).__name__ == "Stroke")
    assert len(line.points) == ALONG
