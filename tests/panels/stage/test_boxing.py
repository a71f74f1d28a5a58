"""The box around what is selected, dragged by a real mouse: points and radii are under its matrix."""

import math

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication, QMenu

from workbench.document.edits import add_figures
from workbench.document.model import (
    Circle,
    Curve,
    CurvePoint,
    Ellipse,
    Line,
    Polygon,
    Rectangle,
    SeedFill,
    WorldPoint,
)
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms.links import Rotate, Scale, Shear
from workbench.document.view_edits import set_window
from workbench.geometry.transform_box import TURN, Box
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.rendering import figure_map
from workbench.rendering.rounds import pieces_of_round
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Marker

LEFT, SHIFT = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier


def at(*places):
    return tuple(WorldPoint("", float(x), float(y)) for x, y in places)


LINE = Line("", at((20, 10), (35, 18)), "bresenham_line", 1)
CIRCLE = Circle("", at((40, 30)), "midpoint_circle", 2, radius_world=6.0)
ELLIPSE = Ellipse("", at((28, 30)), "midpoint_ellipse", 3, radius_x_world=8.0, radius_y_world=4.0)
TURNED = Ellipse(
    "",
    at((30, 34)),
    "midpoint_ellipse",
    3,
    radius_x_world=8.0,
    radius_y_world=3.0,
    transforms=(Rotate("", angle=30.0, x_pivot=30.0, y_pivot=34.0),),
)
POLYGON = Polygon("", at((22, 22), (34, 22), (28, 29)), "scan_line_fill", 1)
CURVE = Curve(
    "",
    tuple(CurvePoint("", *place) for place in ((20.0, 40.0), (26.0, 44.0), (36.0, 38.0))),
    "bresenham_line",
    1,
    spline="bezier",
)
SEED = SeedFill("", at((45, 12)), "boundary_fill_4", 2, boundary=1)
MIXED = (LINE, CIRCLE, TURNED, SEED, CURVE, POLYGON)


def settle():
    for _turn in range(4):
        QApplication.processEvents()


@pytest.fixture
def opened(qtbot):
    sessions = []

    def make(*figures, kind=DrawPanel):
        session = Session(document=add_figures("s1", figures)(blank_sheet(64, 48)))
        sessions.append(session)
        panel = kind(session)
        qtbot.addWidget(panel)
        panel.resize(1000, 640)
        panel.show()
        qtbot.waitExposed(panel)
        panel.choose_tool("select")
        panel.select_all()
        panel.canvas.setFocus()
        settle()
        panel.toggle_box()
        settle()
        return panel

    yield make
    for session in sessions:
        session.close()


def ids(panel):
    return [figure.id for figure in panel.session.sheet.figures]


def choose(panel, number):
    identity = ids(panel)[number]
    panel.session.update_state(selection=(identity,), active=identity)
    settle()


def press(qtbot, panel, handle, way, modifiers=Qt.KeyboardModifier.NoModifier):
    """Drag a handle, or the inside, by ``way`` device units, without letting go."""
    box, canvas = panel.boxing.box, panel.canvas
    start = box.places().get(handle) or (box.box.x + 2.0, box.box.y + 2.0)
    begin, end = (canvas.widget_position(*place) for place in (start, np.add(start, way).tolist()))
    qtbot.mousePress(canvas, LEFT, modifiers, begin.toPoint())
    for share in (0.3, 0.7, 1.0):
        qtbot.mouseMove(canvas, (begin + (end - begin) * share).toPoint())
        settle()
    return (begin + (end - begin)).toPoint()


def drag(qtbot, panel, handle, way, modifiers=Qt.KeyboardModifier.NoModifier):
    end = press(qtbot, panel, handle, way, modifiers)
    qtbot.mouseRelease(panel.canvas, LEFT, modifiers, end)
    settle()


def watch(panel):
    """The matrices, device, that the box tells."""
    matrices = []
    panel.boxing.box.changed.connect(lambda matrix, _kind, _numbers: matrices.append(matrix))
    return matrices


def seen(sheet, figure):
    """Points (n, 2) where the first view shows them; of a circle or ellipse of its exact curve."""
    if isinstance(figure, Circle | Ellipse):
        local = pieces_of_round(figure).controls[:, ::2].reshape(-1, 2)
    else:
        local = np.array([(point.x, point.y) for point in figure.points_world])
    return figure_map(sheet, figure).points(local)


def moved(matrix, points):
    return points @ matrix[:2, :2].T + matrix[:2, 2]


def same_places(figure, one, other):
    """Whether two sets of points are one; of round figures, which may begin elsewhere, as ellipses."""
    if isinstance(figure, Circle | Ellipse):
        one, other = (each - each.mean(axis=0) for each in (one, other))
        return np.allclose(one.T @ one, other.T @ other, atol=1e-6)
    return np.allclose(one, other, atol=1e-6)


@pytest.mark.parametrize("kind", [DrawPanel, FillPanel, ClipPanel])
@pytest.mark.parametrize(
    ("handle", "way"), [("move", (5.2, -3.4)), (TURN, (9, -7)), ("top right", (6, 4)), ("right", (-50, 0))]
)
def test_a_drag_of_the_box_is_its_matrix_on_everything_in_one_step_of_undo(qtbot, opened, kind, handle, way):
    panel = opened(*MIXED, kind=kind)
    session, matrices = panel.session, watch(panel)
    before, steps = session.document, session.undo_stack.count()
    old = {figure.id: seen(session.sheet, figure) for figure in session.sheet.figures}
    drag(qtbot, panel, handle, way)
    assert session.undo_stack.count() == steps + 1
    for figure in session.sheet.figures:
        expected = moved(matrices[-1], old[figure.id])
        assert same_places(figure, seen(session.sheet, figure), expected), figure
        middle = seen(session.sheet, figure).mean(axis=0)
        assert np.allclose(middle, expected.mean(axis=0), atol=1e-6)
    after = session.document
    session.undo_stack.undo()
    assert session.document == before
    session.undo_stack.redo()
    assert session.document == after


def test_what_is_only_moved_moves_by_whole_pixels(qtbot, opened):
    panel = opened(LINE)
    drag(qtbot, panel, "move", (5.3, -2.4))
    assert [(p.x, p.y) for p in panel.session.sheet.figures[0].points_world] == [(25.0, 8.0), (40.0, 16.0)]


def test_escape_brings_everything_back_and_leaves_no_step(qtbot, opened):
    panel = opened(*MIXED)
    session = panel.session
    before, steps = session.document, session.undo_stack.count()
    end = press(qtbot, panel, TURN, (12, -9))
    assert session.document != before
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    assert session.document == before
    qtbot.mouseRelease(panel.canvas, LEFT, pos=end)
    settle()
    assert session.document == before
    assert session.undo_stack.count() == steps
    assert panel.boxing.on
    assert not panel.gesturing


def test_many_figures_follow_when_they_are_let_go_and_their_outlines_before(qtbot, opened):
    lines = [
        Line("", at((20 + k % 7, 10 + k % 5), (30 + k % 11, 20 + k % 13)), "bresenham_line", 1)
        for k in range(40)
    ]
    panel = opened(*lines)
    session, matrices = panel.session, watch(panel)
    before = session.document
    old = {figure.id: seen(session.sheet, figure) for figure in session.sheet.figures}
    end = press(qtbot, panel, TURN, (9, -7))
    assert session.document is before
    outlines = panel.canvas.overlay.outlined
    assert len(outlines) == len(lines)
    assert np.allclose(outlines[0], moved(matrices[-1], old[ids(panel)[0]]))
    qtbot.mouseRelease(panel.canvas, LEFT, pos=end)
    settle()
    for figure in session.sheet.figures:
        assert np.allclose(seen(session.sheet, figure), moved(matrices[-1], old[figure.id]), atol=1e-9)
    session.undo_stack.undo()
    assert session.document == before


def test_many_figures_stay_when_the_drag_is_taken_back(qtbot, opened):
    panel = opened(*[LINE] * 40)
    before = panel.session.document
    press(qtbot, panel, TURN, (9, -7))
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    settle()
    assert panel.session.document is before
    assert panel.boxing.moving is None


def test_what_points_cannot_express_goes_to_the_chain_once_and_is_said(qtbot, opened):
    panel = opened(ELLIPSE)
    said = []
    panel.hover_text.connect(said.append)
    for _turn in range(3):
        qtbot.keyClick(panel.canvas, "[")
    settle()
    (figure,) = panel.session.sheet.figures
    (link,) = figure.transforms
    assert isinstance(link, Rotate)
    assert link.angle == pytest.approx(3.0)
    assert any("would turn" in sentence for sentence in said)
    assert panel.card.chain.isVisibleTo(panel.card)
    assert panel.card.chain.links.text() == "Transforms: Rotate"
    assert "exact curve" in panel.card.chain.reasons.text()


def test_the_pivot_stays_under_turns_and_is_in_the_middle_after_undo(qtbot, opened):
    panel = opened(POLYGON)
    pivot = panel.boxing.box.pivot
    qtbot.keyClick(panel.canvas, "]")
    settle()
    assert panel.boxing.box.pivot == pytest.approx(pivot)
    panel.session.undo_stack.undo()
    settle()
    assert panel.boxing.box.pivot == panel.boxing.box.box.centre


def test_the_box_is_there_instead_of_handles_and_other_tools_lay_it_down(qtbot, opened):
    panel = opened(LINE, CIRCLE)
    names = {handle.id for handle in panel.canvas.overlay.handles}
    assert names
    assert all(name.startswith("box/") for name in names)
    assert panel._actions["box"].isChecked()
    assert not panel._actions["select"].isChecked()
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    settle()
    assert list(panel.session.state.selection) == ids(panel)
    assert not panel.boxing.on
    assert all(handle.id.startswith("s1/") for handle in panel.canvas.overlay.handles)
    panel._actions["box"].trigger()
    settle()
    assert panel.boxing.box.box is not None
    panel.choose_tool("line")
    settle()
    assert panel.boxing.box.box is None


def test_a_click_beside_the_box_selects_as_before(qtbot, opened):
    panel = opened(LINE, POLYGON)
    choose(panel, 0)
    assert panel.boxing.box.box == Box(27.5, 14.0, 15.0, 8.0)
    qtbot.mouseClick(panel.canvas, LEFT, pos=panel.canvas.widget_position(28, 26).toPoint())
    settle()
    assert panel.session.state.selection == (ids(panel)[1],)
    assert panel.boxing.box.box == Box(28.0, 25.5, 12.0, 7.0)


@pytest.mark.parametrize(
    ("figure", "size"),
    [
        (SEED, (0, 0)),
        (Line("", at((20, 20), (20, 20)), "bresenham_line", 1), (0, 0)),
        (Line("", at((20, 20), (40, 20)), "bresenham_line", 1), (20, 0)),
        (Circle("", at((30, 20)), "midpoint_circle", 1, radius_world=0.0), (0, 0)),
    ],
)
def test_a_box_without_extent_still_moves_and_never_makes_anything_infinite(qtbot, opened, figure, size):
    panel = opened(figure)
    session = panel.session
    box = panel.boxing.box.box
    assert (box.width, box.height) == size
    old = seen(session.sheet, session.sheet.figures[0])
    drag(qtbot, panel, "top right", (8, 8))
    drag(qtbot, panel, TURN, (8, -8))
    while session.undo_stack.canUndo():
        session.undo_stack.undo()
    settle()
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Up):
        qtbot.keyClick(panel.canvas, key, SHIFT)
    settle()
    assert np.allclose(seen(session.sheet, session.sheet.figures[0]), old + 10)


def test_what_is_not_seen_has_no_box_and_is_said(qtbot, opened):

    panel = opened(replace(LINE, visible=False))
    said = []
    panel.hover_text.connect(said.append)
    assert panel.boxing.box.box is None
    before = panel.session.document
    panel.boxing.turn(True)
    assert panel.session.document is before
    assert said == ["Select something that is seen first."]


def test_four_quarter_turns_are_none_and_two_flips_are_none_bit_for_bit(opened):
    panel = opened(LINE, ELLIPSE, POLYGON)
    session = panel.session
    before, names = session.document, set()
    for left in (True, True, True, True, False, True):
        panel.boxing.turn(left)
        names.add(session.undo_stack.undoText())
        for figure in session.sheet.figures:
            assert all(p.x.is_integer() and p.y.is_integer() for p in figure.points_world)
    assert session.document == before
    for axis in ("x", "y"):
        panel.boxing.flip(axis)
        assert session.document != before
        names.add(session.undo_stack.undoText())
        panel.boxing.flip(axis)
        assert session.document == before
    assert names == {"Rotate 90°", "Flip horizontally", "Flip vertically"}


def test_commands_are_there_without_the_box_in_menus_and_for_keys(qtbot, opened):
    panel = opened(LINE)
    panel.choose_tool("select")
    settle()
    menus = [action.menu() for action in panel.canvas.actions() if isinstance(action.menu(), QMenu)]
    assert [action.objectName() for action in menus[0].actions()] == [
        action.objectName() for action in panel.transforming()
    ]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_H, SHIFT)
    settle()
    assert [(p.x, p.y) for p in panel.session.sheet.figures[0].points_world] == [(35.0, 10.0), (20.0, 18.0)]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_T, Qt.KeyboardModifier.ControlModifier)
    settle()
    assert panel.boxing.on


def test_numbers_that_are_typed_act_once_about_the_pivot(qtbot, opened):
    panel = opened(POLYGON)
    form, session = panel.card.form, panel.session
    assert form.isVisibleTo(panel.card)
    old = seen(session.sheet, session.sheet.figures[0])
    x, y = panel.boxing.pivot_world
    cos, sin = math.cos(math.radians(30)), math.sin(math.radians(30))
    matrices = {
        "tx": ("3", np.array([[1, 0, 3], [0, 1, 0]])),
        "angle": ("30", np.array([[cos, -sin, x - cos * x + sin * y], [sin, cos, y - sin * x - cos * y]])),
        "sy": ("-2", np.array([[1, 0, 0], [0, -2, 3 * y]])),
        "sh_x": ("0.5", np.array([[1, 0.5, -0.5 * y], [0, 1, 0]])),
    }
    for name, (text, matrix) in matrices.items():
        field = form.fields[name]
        neutral = field.value()
        field.field.setFocus()
        field.field.selectAll()
        qtbot.keyClicks(field.field, text)
        qtbot.keyClick(field.field, Qt.Key.Key_Return)
        settle()
        assert np.allclose(seen(session.sheet, session.sheet.figures[0]), moved(matrix, old)), name
        assert field.value() == neutral
        assert session.undo_stack.count() == 1
        session.undo_stack.undo()
        settle()


def test_a_number_that_is_scrubbed_is_one_step_about_one_pivot(opened):
    panel = opened(POLYGON)
    session = panel.session
    old = seen(session.sheet, session.sheet.figures[0])
    x, y = panel.boxing.pivot_world
    field = panel.card.form.fields["sx"]
    for factor in (1.1, 1.5, 2.0):
        field.set_value(factor)
        field.scrubbed.emit(factor)
        settle()
    field.scrub_ended.emit()
    settle()
    assert session.undo_stack.count() == 1
    assert np.allclose(
        seen(session.sheet, session.sheet.figures[0]), (old - (x, y)) * (2, 1) + (x, y), atol=1e-9
    )
    assert field.value() == 1.0
    assert y == panel.boxing.pivot_world[1]


def test_the_card_bakes_and_removes_chains_or_says_why_not(qtbot, opened):
    chain = (Rotate("", angle=90.0), Scale("", sx=2.0, on=False))
    panel = opened(LINE, TURNED)
    session = panel.session
    panel.choose_tool("select")
    choose(panel, 1)
    said = []
    panel.hover_text.connect(said.append)
    before = session.document
    qtbot.mouseClick(panel.card.chain.bake, LEFT)
    assert session.document == before
    assert "its transforms stay" in said[-1]
    qtbot.mouseClick(panel.card.chain.removal, LEFT)
    settle()
    assert session.sheet.figures[1].transforms == ()
    assert session.undo_stack.undoText() == "Remove transforms"
    assert not panel.card.chain.isVisibleTo(panel.card)

    line = opened(replace(LINE, transforms=chain))
    line.choose_tool("select")
    settle()
    assert line.card.chain.links.text() == "Transforms: Rotate, Scale (off)"
    old = seen(line.session.sheet, line.session.sheet.figures[0])
    line._actions["bake"].trigger()
    settle()
    (figure,) = line.session.sheet.figures
    assert np.allclose(seen(line.session.sheet, figure), old)
    assert [type(link) for link in figure.transforms] == [Scale]
    assert line.session.undo_stack.undoText() == "Bake transforms"


def test_a_flattened_figure_says_so_on_its_card(opened):

    flat = replace(LINE, transforms=(Scale("", sx=0.0), Shear("", sh_y=1.0)))
    panel = opened(flat)
    panel.choose_tool("select")
    settle()
    assert panel.card.chain.flat.isVisibleTo(panel.card)
    assert "flatten" in panel.card.chain.flat.text()


def test_the_frame_is_drawn_where_the_figures_have_come_to(qtbot, opened):
    panel = opened(LINE)
    drag(qtbot, panel, "top right", (5, 4))
    box = panel.boxing.box
    points = seen(panel.session.sheet, panel.session.sheet.figures[0])
    low, high = points.min(axis=0), points.max(axis=0)
    assert np.allclose([box.box.width, box.box.height], high - low)
    assert box.handle_at(panel.canvas.widget_position(*high.tolist()) + QPointF(1, 1)) == "top right"


def test_the_pivot_is_seen_to_go_with_what_is_moved_and_no_cell_is_pointed_at(qtbot, opened):
    panel = opened(POLYGON)
    canvas = panel.canvas

    def ring():
        return next((m.x, m.y) for m in canvas.overlay.drawn if isinstance(m, Marker) and m.shape == "ring")

    cells = []
    canvas.hovered.connect(lambda x, y: cells.append((x, y)))
    canvas.hover_left.connect(lambda: cells.append(None))
    qtbot.mouseMove(canvas, canvas.widget_position(30.0, 27.0).toPoint())
    assert cells[-1] == (30, 27)
    pivot = ring()
    press(qtbot, panel, "move", (5, -4))
    assert cells[-1] is None
    assert ring() == pytest.approx(np.add(pivot, (5, -4)).tolist())
    qtbot.keyClick(canvas, Qt.Key.Key_Escape)
    settle()
    assert ring() == pytest.approx(pivot)


@pytest.mark.parametrize(("handle", "way"), [(TURN, (9, -7)), ("top right", (6, 4)), ("move", (5, -4))])
def test_a_drag_is_its_matrix_on_the_device_where_the_world_is_of_another_scale(qtbot, opened, handle, way):
    panel = opened(*MIXED)
    session = panel.session
    session.apply(set_window(session.sheet.first_view.id, Rectangle(5.0, -10.0, 90.0, 60.0)), "Window")
    settle()
    matrices = watch(panel)
    old = {figure.id: seen(session.sheet, figure) for figure in session.sheet.figures}
    drag(qtbot, panel, handle, way)
    for figure in session.sheet.figures:
        assert same_places(figure, seen(session.sheet, figure), moved(matrices[-1], old[figure.id]))
