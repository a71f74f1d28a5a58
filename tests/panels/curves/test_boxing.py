"""The box around chosen points of a curve: they go where its matrix takes them, with what hangs on them."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, Qt

from tests.panels.by_hand import settle
from tests.panels.curves.by_hand import ZIGZAG, curve_through, opened, send
from workbench.document.model import Curve, CurvePoint
from workbench.document.transforms.links import Rotate, Scale
from workbench.geometry.transform_box import TURN
from workbench.panels.curves.shape import device_points

PATH = ((10, 10), (12, 20), (20, 30), (30, 30), (40, 30), (50, 20), (52, 10))


def chosen(panel, *numbers):
    points = panel.session.sheet.figures[0].points_world
    panel.focus.choose(points[k].id for k in numbers)
    panel.toggle_box()
    settle()
    told = []
    panel.boxing.box.changed.connect(lambda matrix, *_rest: told.append(matrix))
    return told


def seen(panel):
    return device_points(panel.session.sheet, panel.session.sheet.figures[0])


def drag(panel, handle, way, release=True):
    box = panel.boxing.box
    start = box.places().get(handle) or (box.box.x + 1.3, box.box.y + 1.3)
    send(panel, QEvent.Type.MouseButtonPress, *start)
    for share in (0.5, 1.0):
        place = (a + share * b for a, b in zip(start, way, strict=True))
        send(panel, QEvent.Type.MouseMove, *place)
    if release:
        send(panel, QEvent.Type.MouseButtonRelease, *np.add(start, way).tolist())
    settle()


def under(matrix, points):
    return points @ matrix[:2, :2].T + matrix[:2, 2]


@pytest.mark.parametrize("chain", [(), (Rotate("", angle=25.0), Scale("", sx=1.2, sy=0.8))])
@pytest.mark.parametrize(
    ("handle", "way"), [("move", (4.3, 2.2)), (TURN, (6, -4)), ("top right", (3, 5)), ("left", (40, 0))]
)
def test_chosen_points_alone_go_where_the_matrix_takes_them(qtbot, handle, way, chain):
    panel = opened(qtbot, curve_through(*ZIGZAG, transforms=chain))
    told = chosen(panel, 1, 2, 4)
    document, before = panel.session.document, seen(panel)
    drag(panel, handle, way)
    expected = before.copy()
    expected[[1, 2, 4]] = under(told[-1], before[[1, 2, 4]])
    np.testing.assert_allclose(seen(panel), expected, atol=1e-6)
    assert panel.session.undo_stack.count() == 1
    panel.session.undo_stack.undo()
    assert panel.session.document == document


def test_one_point_or_none_means_the_whole_curve(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    told = chosen(panel, 2)
    before = seen(panel)
    drag(panel, TURN, (6, -4))
    np.testing.assert_allclose(seen(panel), under(told[-1], before), atol=1e-6)


def test_handles_go_with_the_points_of_a_path(qtbot):
    panel = opened(qtbot, curve_through(*PATH, spline="bezier_path"))
    told = chosen(panel, 0, 3)
    before = seen(panel)
    drag(panel, TURN, (6, -4))
    np.testing.assert_allclose(seen(panel)[:5], under(told[-1], before[:5]), atol=1e-6)
    np.testing.assert_allclose(seen(panel)[5:], before[5:], atol=1e-9)


def test_tangents_turn_with_their_points_and_are_not_moved(qtbot):
    points = tuple(CurvePoint("", x, y, tangent_x=6.0, tangent_y=2.0) for x, y in ZIGZAG)
    panel = opened(qtbot, Curve("", points, "bresenham_line", 1, spline="hermite"))
    told = chosen(panel, 0, 1)
    drag(panel, TURN, (6, -4))
    made = panel.session.sheet.figures[0].points_world
    tangents = np.array([(p.tangent_x, p.tangent_y) for p in made])
    np.testing.assert_allclose(tangents[:2], [told[-1][:2, :2] @ (6.0, 2.0)] * 2, atol=1e-9)
    np.testing.assert_allclose(tangents[2:], [(6.0, 2.0)] * 3)


def test_a_thousand_points_follow_when_they_are_let_go(qtbot):
    across = np.linspace(5, 58, 1000)
    places = np.stack([across, 20 + 10 * np.sin(across)], 1).tolist()
    panel = opened(qtbot, curve_through(*places))
    told = chosen(panel, *range(1000))
    document, before = panel.session.document, seen(panel)
    drag(panel, TURN, (6, -4), release=False)
    assert panel.session.document is document
    np.testing.assert_allclose(panel.canvas.overlay.outlined[0], under(told[-1], before), atol=1e-9)
    send(panel, QEvent.Type.MouseButtonRelease, 30, 30)
    np.testing.assert_allclose(seen(panel), under(told[-1], before), atol=1e-6)
    panel.session.undo_stack.undo()
    assert panel.session.document == document


def test_escape_takes_a_drag_back_and_then_lays_the_box_down_with_the_points_still_chosen(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    chosen(panel, 1, 2)
    document = panel.session.document
    drag(panel, TURN, (6, -4), release=False)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    assert panel.session.document == document
    send(panel, QEvent.Type.MouseButtonRelease, 30, 30)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    assert not panel.boxing.on
    assert len(panel.focus.points) == 2


def test_the_keys_of_the_degree_turn_while_the_box_is_there(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG))
    panel.canvas.setFocus()
    before, degree = seen(panel), panel.session.sheet.figures[0].degree
    panel.toggle_box()
    settle()
    qtbot.keyClick(panel.canvas, "]")
    settle()
    assert panel.session.sheet.figures[0].degree == degree
    assert len(panel.session.sheet.figures[0].points_world) == len(ZIGZAG)
    assert not np.allclose(seen(panel), before)
    panel.session.undo_stack.undo()
    panel.toggle_box()
    settle()
    qtbot.keyClick(panel.canvas, "]")
    settle()
    assert panel.session.sheet.figures[0].degree == degree + 1


def test_a_curve_with_a_chain_is_flipped_as_it_is_seen(qtbot):
    panel = opened(qtbot, curve_through(*ZIGZAG, transforms=(Rotate("", angle=40.0, x_pivot=30.0),)))
    before = seen(panel)
    panel.boxing.flip("x")
    settle()
    after = seen(panel)
    np.testing.assert_allclose(after[:, 1], before[:, 1], atol=1e-6)
    sums = after[:, 0] + before[:, 0]
    np.testing.assert_allclose(sums, sums[0], atol=1e-6)


@pytest.mark.parametrize("axis", ["x", "y"])
@pytest.mark.parametrize("nodes", [(0, 3), (3, 6), (0, 3, 6)])
def test_mirrored_nodes_take_their_handles_along(qtbot, axis, nodes):
    """Each handle becomes its mirror image about the middle of the nodes; twice is as before."""
    panel = opened(qtbot, curve_through(*PATH, spline="bezier_path"))
    points = panel.session.sheet.figures[0].points_world
    panel.focus.choose(points[k].id for k in nodes)
    before = seen(panel)
    panel.boxing.flip(axis)
    settle()
    after = seen(panel)
    gone = sorted({k for node in nodes for k in (node - 1, node, node + 1) if 0 <= k < len(PATH)})
    moved = 0 if np.abs(after - before)[gone, 0].max() > 0 else 1
    low, high = before[list(nodes), moved].min(), before[list(nodes), moved].max()
    expected = before.copy()
    expected[gone, moved] = low + high - before[gone, moved]
    np.testing.assert_allclose(after, expected, atol=1e-9)
    panel.boxing.flip(axis)
    np.testing.assert_allclose(seen(panel), before, atol=1e-9)
