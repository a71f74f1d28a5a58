"""The box around what is selected, dragged by a real mouse: points and radii are under its matrix."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, QPointF, Qt

from tests.panels.stage.boxed import (
    CIRCLE,
    ELLIPSE,
    LEFT,
    LINE,
    MIXED,
    POLYGON,
    SEED,
    SHIFT,
    at,
    choose,
    drag,
    ids,
    moved,
    press,
    same_places,
    seen,
    settle,
    watch,
)
from workbench.document.model import (
    Circle,
    Line,
    Rectangle,
)
from workbench.document.transforms.links import Rotate
from workbench.document.view_edits import set_window
from workbench.geometry.transform_box import TURN, Box
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.panels.stage import boxing
from workbench.widgets.canvas.drawing import Marker


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


@pytest.fixture
def restless(monkeypatch):
    """The hand never rests."""
    monkeypatch.setattr(boxing, "REST_MS", 1_000_000)


def test_many_figures_follow_where_the_hand_rests_and_the_drag_goes_on(qtbot, opened):
    panel = opened(*[LINE] * 40)
    session, matrices = panel.session, watch(panel)
    before = session.document
    old = seen(session.sheet, session.sheet.figures[0])
    end = press(qtbot, panel, TURN, (9, -7))
    qtbot.waitUntil(lambda: session.document is not before)
    settle()
    assert panel.boxing.box.dragging
    assert not panel.canvas.overlay.outlined or panel.boxing.moving is None
    assert np.allclose(seen(session.sheet, session.sheet.figures[0]), moved(matrices[-1], old), atol=1e-9)
    qtbot.mouseMove(panel.canvas, end + QPoint(15, 10))
    qtbot.mouseRelease(panel.canvas, LEFT, pos=end + QPoint(15, 10))
    settle()
    assert np.allclose(seen(session.sheet, session.sheet.figures[0]), moved(matrices[-1], old), atol=1e-9)
    session.undo_stack.undo()
    assert session.document == before


@pytest.mark.usefixtures("restless")
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


@pytest.mark.usefixtures("restless")
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
    assert said == ["Select something visible first."]


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
