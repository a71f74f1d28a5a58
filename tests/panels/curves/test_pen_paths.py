"""Paths drawn by the pen: whatever is clicked, pulled and taken back, every point belongs to a piece."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import click, drag, opened, places, send, the_curve
from workbench.document.curves.paths import joints_of
from workbench.document.curves.pieces import fault_of, pieces_of

LEFT_END, RIGHT_END = (14.0, 20.0), (50.0, 20.0)


def with_path_pen(qtbot, spline="bezier_path"):
    panel = opened(qtbot)
    panel.pen.model = replace(panel.pen.model, spline=spline)
    return panel


@pytest.mark.parametrize("pulled", [(0,), (1,), (0, 1)])
@pytest.mark.parametrize("spline", ["bezier_path", "hermite"])
def test_a_lens_of_two_nodes_is_closed_by_a_click_on_the_first(qtbot, spline, pulled):
    panel = with_path_pen(qtbot, spline)
    for k, (node, way) in enumerate(((LEFT_END, (0, 9)), (RIGHT_END, (0, -9)))):
        far = tuple(np.add(node, way).tolist())
        drag(panel, node, far) if k in pulled else click(panel, *node)
    send(panel, QEvent.Type.MouseMove, *LEFT_END)
    assert "close" in panel.tool.tag
    click(panel, *LEFT_END)
    assert not panel.gesturing
    curve = the_curve(panel)
    assert curve.closed
    assert len(curve.points_world) == (6 if spline == "bezier_path" else 2)
    controls = pieces_of(curve).controls
    assert controls[:, 0].tolist() == [[*LEFT_END], [*RIGHT_END]]
    assert panel.session.undo_stack.count() == 1


def test_two_corners_are_not_closed_into_a_line(qtbot):
    panel = with_path_pen(qtbot)
    for node in (LEFT_END, RIGHT_END, LEFT_END):
        click(panel, *node)
    assert not the_curve(panel).closed
    assert panel.gesturing


def test_a_lens_of_two_nodes_is_closed_by_the_command(qtbot):
    panel = with_path_pen(qtbot)
    drag(panel, LEFT_END, (14, 30))
    drag(panel, RIGHT_END, (50, 10))
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    panel.commands.toggle_closed()
    curve = the_curve(panel)
    assert (curve.closed, len(curve.points_world)) == (True, 6)
    assert pieces_of(curve).controls[1].tolist() == [[50, 20], [50, 10], [14, 10], [14, 20]]


@pytest.mark.parametrize("seed", range(10))
def test_no_point_is_left_without_a_piece(qtbot, seed):
    """Clicks, pulls, moves and Backspace by chance, then an end by Enter, by a click, or by another edit."""
    chance = np.random.default_rng(seed)
    panel = with_path_pen(qtbot)
    nodes = []
    for k in range(9):
        place = (float(4 + 6 * k), float(chance.integers(6, 42)))
        match chance.integers(0, 4):
            case 0 if len(nodes) > 1:
                qtbot.keyClick(panel.canvas, Qt.Key.Key_Backspace)
                nodes.pop()
            case 1:
                drag(panel, place, (place[0] + 2, place[1] + 3))
                nodes.append(place)
            case _:
                click(panel, *place)
                nodes.append(place)
        send(panel, QEvent.Type.MouseMove, place[0] + 3, place[1] + 1)
    if seed % 3 == 0:
        click(panel, *nodes[-1])
    elif seed % 3 == 1:
        panel.pen.back() if len(nodes) > 2 and nodes.pop() else None
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    settle()
    curve = the_curve(panel)
    joints, waiting = joints_of(curve)
    assert waiting == ()
    assert fault_of(curve) == ""
    assert [(joint.at.x, joint.at.y) for joint in joints] == nodes
    assert places(panel)[::3] == nodes
