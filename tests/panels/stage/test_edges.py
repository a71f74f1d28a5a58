"""Dragging to the edge of the view scrolls what lies beyond it, and no zoom loses the picture."""

import pytest

from tests.panels.by_hand import LEFT, at, points, settle
from workbench.document.samples.examples import example_document
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session


@pytest.fixture
def panel(qtbot):
    """Draw with the example, magnified about its line so that the sheet reaches beyond the view."""
    session = Session(document=example_document())
    made = DrawPanel(session)
    qtbot.addWidget(made)
    made.resize(850, 600)
    made.show()
    made.choose_tool("select")
    settle()
    made.canvas.zoom(4, made.canvas.widget_position(25, 14))
    settle()
    yield made
    session.close()


def hold_at_the_right(qtbot, panel, start):
    """Press at a device point and drag to the right edge; where that edge is when it has scrolled a while."""
    canvas = panel.canvas
    before = canvas.view.left
    edge = canvas.rect().center()
    edge.setX(canvas.width() - 3)
    qtbot.mousePress(canvas, LEFT, pos=at(panel, *start))
    qtbot.mouseMove(canvas, edge)
    qtbot.waitUntil(lambda: canvas.view.left < before - 200, timeout=5000)
    x, _y = canvas.device_position(edge.toPointF())
    qtbot.mouseRelease(canvas, LEFT, pos=edge)
    left = canvas.view.left
    qtbot.wait(100)
    assert canvas.view.left == left
    return x


def test_a_figure_is_moved_beyond_the_edge(qtbot, panel):
    before = points(panel.session.sheet.figures[0])
    end = hold_at_the_right(qtbot, panel, (25, 14))
    after = points(panel.session.sheet.figures[0])
    assert after[0][0] - before[0][0] == pytest.approx(end - 25, abs=3)
    assert panel.session.undo_stack.count() == 1


def test_a_handle_goes_beyond_the_edge(qtbot, panel):
    panel.session.update_state(selection=("f1",))
    settle()
    end = hold_at_the_right(qtbot, panel, (30, 18))
    assert points(panel.session.sheet.figures[0])[1][0] == pytest.approx(end, abs=3)


def test_so_do_a_new_line_and_a_band(qtbot, panel):
    panel.choose_tool("line")
    end = hold_at_the_right(qtbot, panel, (26, 8))
    assert points(panel.session.sheet.figures[-1])[1][0] == pytest.approx(end, abs=3)
    panel.choose_tool("select")
    panel.canvas.zoom(-1)
    panel.canvas.zoom(1)
    hold_at_the_right(qtbot, panel, (35, 1))


def test_scrolling_ends_where_the_picture_does_and_a_press_at_the_edge_scrolls_nothing(qtbot, panel):
    canvas = panel.canvas
    canvas.fit()
    fitted, edge = canvas.view, canvas.rect().center()
    edge.setX(canvas.width() - 3)
    qtbot.mousePress(canvas, LEFT, pos=at(panel, 40, 40))
    qtbot.mouseMove(canvas, edge)
    qtbot.wait(150)
    assert canvas.view == fitted
    qtbot.mouseRelease(canvas, LEFT, pos=edge)
    canvas.zoom(4)
    view = canvas.view
    qtbot.mousePress(canvas, LEFT, pos=edge)
    qtbot.wait(150)
    assert canvas.view == view
    qtbot.mouseRelease(canvas, LEFT, pos=edge)


def test_the_box_of_what_is_transformed_scrolls_too(qtbot, panel):
    panel.session.update_state(selection=("f1",))
    panel._actions["box"].trigger()
    settle()
    before = points(panel.session.sheet.figures[0])
    end = hold_at_the_right(qtbot, panel, (26, 14))
    after = points(panel.session.sheet.figures[0])
    assert after[0][0] - before[0][0] == pytest.approx(end - 26, abs=3)


def test_zooming_out_ends_at_a_tenth_of_the_view(panel):
    canvas = panel.canvas
    for _time in range(60):
        canvas.zoom(-1)
    width, height = canvas.picture_size
    share = max(width * canvas.view.cell / canvas.area.width, height * canvas.view.cell / canvas.area.height)
    assert 0.1 <= share < 0.25
    farthest = canvas.view
    canvas.zoom(-1)
    assert canvas.view == farthest
    canvas.zoom(1)
    assert canvas.view.cell > farthest.cell
