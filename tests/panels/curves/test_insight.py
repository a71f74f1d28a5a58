"""The plotted functions and the construction of a curve, and what points at what."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QPoint, Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    CTRL,
    ZIGZAG,
    click,
    curve_through,
    hover,
    opened,
    send,
    the_curve,
)
from tests.panels.curves.docked import PLACES, with_docks
from tests.widgets.plots import by_hand as plots
from workbench.algorithms import marks
from workbench.algorithms.curves import piece_points
from workbench.document.curves.pieces import parameter_at, pieces_of
from workbench.document.model import SPLINES, Curve, CurvePoint
from workbench.panels.curves.basis import MOST, basis_of
from workbench.panels.curves.insight import switches
from workbench.widgets.canvas.drawing import Marker


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


def test_pointing_at_a_function_rings_its_point_and_the_other_way_round(qtbot):
    panel = with_docks(qtbot, curve_through(*ZIGZAG))
    panel.beside.basis.hovered.emit(3)
    settle()
    assert any(isinstance(e, Marker) and (e.x, e.y) == ZIGZAG[3] and e.size > 15 for e in panel.view.drawn())
    hover(panel, *ZIGZAG[1])
    assert panel.beside.basis.curves.lit == 1
    hover(panel, 30, 2)
    assert panel.beside.basis.curves.lit == -1


def test_basis_functions_and_curvature_share_their_axis(qtbot):
    panel = with_docks(qtbot, curve_through(*ZIGZAG, spline="b_spline"))
    basis, curvature = panel.beside.basis, panel.beside.curvature
    curves = basis.curves
    qtbot.waitUntil(lambda: curves._plot is not None and curvature._plot is not None, timeout=30_000)
    assert curvature.range == curves.range == basis.knots.range
    for one, other in ((curves, curvature), (curvature, curves)):
        one.show_all()
        one.show_view(0.2 * one.whole[1], 0.6 * one.whole[1])
        settle()
        assert other.range == one.range == basis.knots.range != one.whole
        assert other.x_of(one.range[1]) - other.area.left() == pytest.approx(other.area.width())
        assert other.area.left() == one.area.left()


def test_u_is_dragged_in_the_plot(qtbot):
    panel = with_docks(qtbot, curve_through(*ZIGZAG))
    curves = panel.beside.basis.curves
    qtbot.waitUntil(lambda: curves._plot is not None, timeout=30_000)
    plots.click(qtbot, curves, QPoint(round(curves.x_of(0.5)), curves.height() // 2))
    settle()
    assert panel.focus.u == pytest.approx(0.25, abs=0.02)
    assert "construction" in panel.focus.shown


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
