"""Figures with chains on the canvas: grabbed where they are seen, written through the inverse."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import keep_until_the_end
from workbench.document.edits import add_figure
from workbench.document.model import Circle, Curve, CurvePoint, Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms.links import Rotate, Scale, Shear, Translate
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.stage.outline import figure_at, handles, outline
from workbench.rendering import figure_map
from workbench.session.session import Session

LEFT = Qt.MouseButton.LeftButton
CHAIN = (Rotate("", angle=90.0, x_pivot=20.0, y_pivot=20.0), Shear("", sh_x=0.5, y_ref=20.0))
FLAT = (Scale("", sx=0.0, x_pivot=30.0), Translate("", tx=2.0))


def settle():
    for _turn in range(4):
        QApplication.processEvents()


@pytest.fixture
def opened(qtbot):
    sessions = []

    def make(kind, figure):
        session = Session(document=add_figure("s1", figure)(blank_sheet(64, 48)))
        sessions.append(session)
        panel = kind(session)
        keep_until_the_end(qtbot, panel)
        panel.resize(1000, 640)
        panel.show()
        qtbot.waitExposed(panel)
        panel.choose_tool("select")
        identity = session.sheet.figures[0].id
        session.update_state(selection=(identity,), active=identity)
        settle()
        return panel

    yield make
    for session in sessions:
        session.close()
        session.deleteLater()


def line(chain):
    ends = (WorldPoint("", 10.0, 14.0), WorldPoint("", 25.0, 18.0))
    return Line("", ends, "bresenham_line", 1, transforms=chain)


def drag(qtbot, canvas, start, end):
    qtbot.mousePress(canvas, LEFT, pos=canvas.widget_position(*start).toPoint())
    for share in (0.5, 1.0):
        at = [a + share * (b - a) for a, b in zip(start, end, strict=True)]
        qtbot.mouseMove(canvas, canvas.widget_position(*at).toPoint())
        settle()
    qtbot.mouseRelease(canvas, LEFT, pos=canvas.widget_position(*end).toPoint())
    settle()


def seen(panel, number):
    figure = panel.session.sheet.figures[0]
    point = figure.points_world[number]
    return figure_map(panel.session.sheet, figure).point(point.x, point.y)


def test_a_handle_is_where_the_point_is_seen_and_goes_where_it_is_dragged(qtbot, opened):
    panel = opened(DrawPanel, line(CHAIN))
    other = seen(panel, 1)
    start = seen(panel, 0)
    assert figure_at(panel.session.sheet, *start, 1.0) is panel.session.sheet.figures[0]
    assert np.allclose(
        [(h.x, h.y) for h in handles(panel.session.sheet, panel.session.sheet.figures[0])], [start, other]
    )
    assert np.allclose(outline(panel.session.sheet, panel.session.sheet.figures[0])[0], [start, other])
    drag(qtbot, panel.canvas, start, (40.0, 30.0))
    assert np.allclose(seen(panel, 0), (40.0, 30.0), atol=1e-6)
    assert np.allclose(seen(panel, 1), other)
    panel.session.undo_stack.undo()
    assert np.allclose(seen(panel, 0), start)


def test_a_radius_is_measured_before_the_chain(qtbot, opened):
    circle = Circle(
        "", (WorldPoint("", 30.0, 20.0),), "midpoint_circle", 1, transforms=CHAIN, radius_world=6.0
    )
    panel = opened(DrawPanel, circle)
    grip = handles(panel.session.sheet, panel.session.sheet.figures[0])[1]
    middle = seen(panel, 0)
    way = np.array([grip.x, grip.y]) - middle
    drag(qtbot, panel.canvas, (grip.x, grip.y), tuple((middle + 2 * way).tolist()))
    assert panel.session.sheet.figures[0].radius_world == pytest.approx(12.0, abs=0.6)


@pytest.mark.parametrize("kind", [DrawPanel, CurvesPanel])
def test_a_flattened_figure_is_read_only_and_says_so(qtbot, opened, kind):
    figure = line(FLAT)
    if kind is CurvesPanel:
        points = tuple(CurvePoint("", p.x, p.y) for p in figure.points_world)
        figure = Curve("", points, "bresenham_line", 1, transforms=FLAT)
    panel = opened(kind, figure)
    before = panel.session.document
    said = []
    for source in (panel.tool, panel.handle_drag) if kind is DrawPanel else (panel.tool,):
        source.failed.connect(said.append)
    start = seen(panel, 0)
    drag(qtbot, panel.canvas, start, (start[0] + 5.0, start[1] + 4.0))
    assert panel.session.document is before
    assert said
    assert all("flatten" in sentence for sentence in said)


def test_a_figure_that_is_dragged_follows_the_pointer_through_its_chain(qtbot, opened):
    panel = opened(DrawPanel, line(CHAIN))
    ends = np.array([seen(panel, 0), seen(panel, 1)])
    middle = ends.mean(axis=0)
    drag(qtbot, panel.canvas, tuple(middle.tolist()), tuple((middle + np.array([4, -6])).tolist()))
    assert np.allclose([seen(panel, 0), seen(panel, 1)], ends + np.array([4, -6]), atol=1e-6)


@pytest.mark.parametrize("chain", [CHAIN, (Rotate("", angle=30.0, on=False), Translate("", tx=3.0))])
def test_a_copy_keeps_the_chain_and_lies_beside_what_is_seen(qtbot, opened, chain):
    panel = opened(DrawPanel, line(chain))
    session = panel.session
    ends = np.array([seen(panel, 0), seen(panel, 1)])
    assert panel.copy()
    assert panel.paste()
    qtbot.waitUntil(lambda: len(session.sheet.figures) == 2, timeout=5000)
    first, copy = session.sheet.figures
    assert [replace(link, id="") for link in copy.transforms] == [
        replace(link, id="") for link in first.transforms
    ]
    assert not {link.id for link in copy.transforms} & {link.id for link in first.transforms}
    scale = figure_map(session.sheet, copy)
    assert np.allclose([scale.point(p.x, p.y) for p in copy.points_world], np.add(ends, (1, -1)))
