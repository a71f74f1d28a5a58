"""Points of a curve are chosen, dragged and typed."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import (
    CTRL,
    SHIFT,
    ZIGZAG,
    click,
    curve_through,
    drag,
    opened,
    places,
    send,
    the_curve,
)


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


def test_with_snap_points_go_to_pixels_and_it_is_seen(zigzag):
    zigzag._toggle_snap()
    send(zigzag, QEvent.Type.MouseButtonPress, *ZIGZAG[1])
    send(zigzag, QEvent.Type.MouseMove, 35.3, 30.8)
    assert places(zigzag)[1] == (35, 31)
    assert zigzag.canvas.overlay.snap == (35, 31)
    send(zigzag, QEvent.Type.MouseButtonRelease, 35.3, 30.8)
    assert zigzag.canvas.overlay.snap is None
