"""What is under the pointer, at any zoom: points, handles, tangents, the curve itself."""

import math

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QPointF
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import LEFT, NONE, PLAIN, curve_through, opened, places, the_curve
from workbench.algorithms.curves import derivatives, piece_points
from workbench.document.curves.pieces import pieces_of
from workbench.document.edits import add_figure
from workbench.document.model import SPLINES, Polyline, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session
from workbench.widgets.canvas.view import LEVELS

PRESS, MOVE, RELEASE, DOUBLE = (
    QEvent.Type.MouseButtonPress,
    QEvent.Type.MouseMove,
    QEvent.Type.MouseButtonRelease,
    QEvent.Type.MouseButtonDblClick,
)
CUSP = ((10, 10), (10, 10), (20, 30), (30, 30), (30, 30), (44, 12), (50, 10))


def send(canvas, kind, place):
    """A mouse event at a place of the widget, a part of a pixel counts."""
    button = NONE if kind == MOVE else LEFT
    held = NONE if kind == RELEASE else LEFT
    QApplication.sendEvent(canvas, QMouseEvent(kind, place, canvas.mapToGlobal(place), button, held, PLAIN))
    settle()


def drag(canvas, start, way):
    """Press at a place of the widget, move by so many screen pixels, let go."""
    send(canvas, PRESS, start)
    for share in (0.25, 1.0):
        send(canvas, MOVE, start + share * QPointF(*way))
    send(canvas, RELEASE, start + QPointF(*way))


def click(canvas, place):
    send(canvas, PRESS, place)
    send(canvas, RELEASE, place)


def double_click(canvas, place):
    click(canvas, place)
    send(canvas, DOUBLE, place)
    send(canvas, RELEASE, place)


def zoomed(canvas, cell, x, y):
    """Zoom to so many pixels for a cell, with a device point in the middle of the widget."""
    middle = QPointF(canvas.width() / 2, canvas.height() / 2)
    canvas._show(canvas.view.at_scale(cell, 0, 0))
    now = canvas.widget_position(x, y)
    canvas._show(canvas.view.moved(round(middle.x() - now.x()), round(middle.y() - now.y())))
    settle()
    return canvas.widget_position(x, y)


def in_draw(qtbot, figure):
    """A Draw panel with one figure, which is selected."""
    session = Session(document=blank_sheet(64, 48))
    session.apply(add_figure(session.sheet.id, figure), "Draw")
    session.undo_stack.clear()
    panel = DrawPanel(session)
    session.setParent(panel)
    qtbot.addWidget(panel)
    panel.resize(1000, 640)
    panel.show()
    qtbot.waitExposed(panel)
    (figure,) = session.sheet.figures
    session.update_state(active=figure.id, selection=(figure.id,))
    panel.choose_tool("select")
    settle()
    return panel


def beside(panel, curve, u, cell, pixels):
    """A place of the widget so many pixels beside the curve at u, at this zoom."""
    pieces = pieces_of(curve)
    x, y = piece_points(pieces, u).tolist()
    _point, (dx, dy) = derivatives(pieces, u, 1)
    length = math.hypot(dx, dy)
    at = zoomed(panel.canvas, cell, x, y)
    return at + pixels / length * QPointF(dy, dx)  # on the screen y goes down


@pytest.mark.parametrize(("node", "handle"), [(0, 1), (3, 4)])
def test_a_node_under_its_own_handle_is_the_node(qtbot, node, handle):
    """Also when it is the handle that is chosen, as it is after it was dragged there."""
    panel = opened(qtbot, curve_through(*CUSP, spline="bezier_path"))
    points = the_curve(panel).points_world
    for cell in (4.0, 16.0, 32.0, 160.0):
        for chosen in ((), (points[handle].id,)):
            panel.focus.choose(chosen)
            drag(panel.canvas, zoomed(panel.canvas, cell, *CUSP[node]), (60, 0))
            moved = np.array(places(panel)) - CUSP
            assert moved[[node, handle]] == pytest.approx(np.full((2, 2), [60 / cell, 0]), abs=0.26)
            assert panel.focus.points == {points[node].id}
            panel.session.undo_stack.undo()


def test_a_handle_that_can_be_told_from_its_node_is_dragged(qtbot):
    near = (CUSP[0], (10.3, 10.0), *CUSP[2:])
    for cell, moves_node in ((8.0, True), (160.0, False)):
        panel = opened(qtbot, curve_through(*near, spline="bezier_path"))
        drag(panel.canvas, zoomed(panel.canvas, cell, *near[1]), (0, -40))
        moved = np.array(places(panel)) - near
        assert moved[1, 1] == pytest.approx(40 / cell, abs=0.1)
        assert bool(moved[0].any()) == moves_node


def test_in_draw_too_a_node_lies_over_its_own_handle(qtbot):
    panel = in_draw(qtbot, curve_through(*CUSP, spline="bezier_path"))
    at = panel.canvas.widget_position(*CUSP[3])
    drag(panel.canvas, at, (4 * panel.canvas.view.cell, 0))
    moved = np.array([(p.x, p.y) for p in panel.session.sheet.figures[0].points_world]) - CUSP
    assert moved[2:5].tolist() == [[4, 0]] * 3


def test_of_a_tangent_and_a_point_the_nearer_is_dragged(qtbot):
    curve = curve_through((28, 20), (52, 20), spline="hermite")
    points = tuple(replace(p, tangent_x=3.0, tangent_y=0.0) for p in curve.points_world)
    panel = opened(qtbot, replace(curve, points_world=points))
    drag(panel.canvas, zoomed(panel.canvas, 8.0, 29, 20), (0, -24))
    assert the_curve(panel).points_world[0].tangent_y == pytest.approx(9)
    assert places(panel)[0] == (28, 20)
    bare = replace(curve, points_world=tuple(replace(p, tangent_x=0.0) for p in points))
    panel = opened(qtbot, bare)
    drag(panel.canvas, zoomed(panel.canvas, 8.0, 28, 20), (0, -24))
    assert places(panel)[0] == (28, 23)


@pytest.mark.parametrize("spline", SPLINES)
def test_a_curve_is_found_within_six_pixels_at_any_zoom(qtbot, spline):
    """Each place is clicked beside a curve that is not selected, and looked at on it when it is."""
    chance = np.random.default_rng(SPLINES.index(spline))
    curve = curve_through(*chance.uniform(2, 46, (7, 2)).round(1).tolist(), spline=spline)
    panel = opened(qtbot, curve)
    curve, session = the_curve(panel), panel.session
    knots = pieces_of(curve).knots
    for cell in (0.25, 1.0, 4.0, 16.0, 32.0, 160.0):
        assert cell in LEVELS
        u = float(chance.uniform(knots[0], knots[-1]))
        at = beside(panel, curve, u, cell, chance.uniform(-6, 6))
        session.update_state(selection=())
        click(panel.canvas, at)
        assert session.state.selection == (curve.id,), (cell, u)
        assert panel.select.over(*panel.canvas.device_position(at)) in ("curve", "grip"), (cell, u)
    assert session.undo_stack.count() == 0


@pytest.mark.parametrize("spline", ["bezier_path", "b_spline", "nurbs"])
def test_a_double_click_within_six_pixels_of_a_curve_puts_a_point_there(qtbot, spline):
    panel = opened(qtbot, curve_through((6, 8), (14, 60), (44, -30), (58, 30), spline=spline))
    for cell in (8.0, 16.0, 32.0, 80.0):
        for u, pixels in ((0.3, 6), (0.5, -6), (0.71, 5.9)):
            double_click(panel.canvas, beside(panel, the_curve(panel), u, cell, pixels))
            assert len(places(panel)) > 4, (cell, u)
            assert panel.session.undo_stack.count() == 1
            panel.session.undo_stack.undo()
            panel.focus.choose(())


def test_of_two_curves_side_by_side_the_nearer_is_found(qtbot):
    one, other = (curve_through((4, 10 + y), (20, 40 + y), (40, 40 + y), (50, 12 + y)) for y in (0.0, 0.4))
    panel = opened(qtbot, one, other)
    for number, curve in enumerate(panel.session.sheet.figures):
        panel.session.update_state(selection=())
        click(panel.canvas, beside(panel, curve, 0.5, 32.0, 0))
        assert panel.session.state.selection == (panel.session.sheet.figures[number].id,)


def test_of_a_curve_that_leaves_the_sheet_the_rest_is_found_too(qtbot):
    panel = opened(qtbot, curve_through((4, 10), (30, 90), (40, 90), (60, 12)))
    curve = the_curve(panel)
    panel.session.update_state(selection=())
    click(panel.canvas, beside(panel, curve, 0.5, 8.0, 5))
    assert panel.session.state.selection == (curve.id,)


@pytest.mark.parametrize("spline", SPLINES)
def test_a_press_that_trembles_moves_nothing(qtbot, spline):
    """On points, on the curve, at u and beside it all, whatever the zoom."""
    chance = np.random.default_rng(SPLINES.index(spline))
    panel = opened(qtbot, curve_through(*chance.uniform(3, 45, (7, 2)).round(2).tolist(), spline=spline))
    document, u = panel.session.document, panel.focus.u
    curve = the_curve(panel)
    middle = piece_points(pieces_of(curve), 0.37 * pieces_of(curve).knots[-1]).tolist()
    for cell, jitter in ((1.0, (1, 0)), (16.0, (0, -1)), (80.0, (-1, 1))):
        for x, y in (*places(panel)[:3], middle):
            drag(panel.canvas, zoomed(panel.canvas, cell, x, y), jitter)
    assert panel.session.document is document
    assert panel.session.undo_stack.count() == 0
    assert panel.focus.u == u


def test_a_press_that_trembles_moves_nothing_in_draw(qtbot):
    line = Polyline("", (WorldPoint("", 10.3, 10.4), WorldPoint("", 30.6, 20.2)), "bresenham_line", 1)
    panel = in_draw(qtbot, line)
    document = panel.session.document
    for tool in ("select", "line", "circle"):
        panel.choose_tool(tool)
        for x, y in ((10.3, 10.4), (20.45, 15.3), (40.5, 3.5)):
            drag(panel.canvas, panel.canvas.widget_position(x, y), (1, -1))
            panel.let_go()
    assert panel.session.document == document
