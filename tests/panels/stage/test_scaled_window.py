"""Nudges and drags are in pixels, whatever part of the world the sheet's window shows."""

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

from tests.document.views import seen_through
from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.edits import add_figure
from workbench.document.model import Curve, CurvePoint, Line, Rectangle, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.session.session import Session

LEFT = Qt.MouseButton.LeftButton
PLAIN, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier

# A pixel is 2 units of the world wide and a quarter of one high; the viewport is not the whole sheet.
WINDOW, VIEWPORT = Rectangle(-20, 100, 80, 110), Rectangle(8, 4, 58, 44)
WIDE, HIGH = 2.0, 0.25
ENDS = ((0.0, 103.0), (40.0, 106.0))

NUDGES = [
    (Qt.Key.Key_Right, PLAIN, (1, 0)),
    (Qt.Key.Key_Left, PLAIN, (-1, 0)),
    (Qt.Key.Key_Up, PLAIN, (0, 1)),
    (Qt.Key.Key_Down, PLAIN, (0, -1)),
    (Qt.Key.Key_Right, SHIFT, (10, 0)),
    (Qt.Key.Key_Down, SHIFT, (0, -10)),
]


@pytest.fixture
def opened(qtbot):
    sessions = []

    def make(kind, figure):
        document = blank_sheet(64, 48)
        sheet = seen_through(document.sheets[0], window_world=WINDOW, viewport_device=VIEWPORT)
        document = add_figure(sheet.id, figure)(replace(document, sheets=(sheet,)))
        session = Session(document=document)
        sessions.append(session)
        panel = kind(session)
        keep_until_the_end(qtbot, panel)
        panel.resize(1000, 640)
        panel.show()
        qtbot.waitExposed(panel)
        panel.choose_tool("select")
        session.update_state(selection=(session.sheet.figures[0].id,), active=session.sheet.figures[0].id)
        panel.canvas.setFocus()
        settle()
        return panel

    yield make
    for session in sessions:
        session.close()
        session.deleteLater()


def places(panel):
    return [(point.x, point.y) for point in panel.session.sheet.figures[0].points_world]


def moved(points, by):
    return [(x + by[0] * WIDE, y + by[1] * HIGH) for x, y in points]


@pytest.mark.parametrize("kind", [DrawPanel, FillPanel, ClipPanel, CurvesPanel])
def test_an_arrow_nudges_a_figure_by_one_pixel_and_with_shift_by_ten(qtbot, opened, kind):
    panel = opened(kind, Line("", tuple(WorldPoint("", *end) for end in ENDS), "bresenham_line", 1))
    for key, modifiers, by in NUDGES:
        before = places(panel)
        qtbot.keyClick(panel.canvas, key, modifiers)
        settle()
        assert places(panel) == moved(before, by)


def test_an_arrow_nudges_a_chosen_point_of_a_curve_by_one_pixel(qtbot, opened):
    curve = Curve("", tuple(CurvePoint("", *end) for end in (*ENDS, (60.0, 102.0))), "bresenham_line", 1)
    panel = opened(CurvesPanel, curve)
    panel.focus.choose([panel.session.sheet.figures[0].points_world[1].id])
    for key, modifiers, by in NUDGES:
        before = places(panel)
        qtbot.keyClick(panel.canvas, key, modifiers)
        settle()
        assert places(panel) == [before[0], *moved(before[1:2], by), before[2]]


@pytest.mark.parametrize("kind", [DrawPanel, FillPanel, ClipPanel])
def test_a_figure_that_is_dragged_follows_the_pointer(qtbot, opened, kind):
    panel = opened(kind, Line("", tuple(WorldPoint("", *end) for end in ENDS), "bresenham_line", 1))
    before, canvas = places(panel), panel.canvas
    middle = 8 + (20 + 20) / WIDE, 4 + (104.5 - 100) / HIGH
    qtbot.mousePress(canvas, LEFT, pos=canvas.widget_position(*middle).toPoint())
    for far in (1, 3):
        pointer = canvas.widget_position(middle[0] + far, middle[1] - 2 * far).toPoint()
        qtbot.mouseMove(canvas, pointer)
        settle()
    qtbot.mouseRelease(canvas, LEFT, pos=pointer)
    settle()
    assert places(panel) == moved(before, (3, -6))
