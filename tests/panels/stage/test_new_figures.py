"""What a new figure is drawn in: the colour of the front figure, or the one chosen in the card of Fill."""

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.edits import add_figure
from workbench.document.model import Line, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.draw.panel import DrawPanel
from workbench.panels.fill.panel import FillPanel
from workbench.session.session import Session

LEFT = Qt.MouseButton.LeftButton
PLACES = ((8, 8), (24, 10), (20, 24))
FRONT = 5
BOUNDARY, FILL = 1, 2  # what Fill begins with

# How each tool is used: by one drag, by a click on each place and Enter, or by one click.
BY_FRONT = [
    *((DrawPanel, name, "drag") for name in ("line", "circle", "ellipse")),
    (DrawPanel, "polyline", "clicks"),
    (ClipPanel, "line", "drag"),
    (ClipPanel, "polygon", "clicks"),
    (ClipPanel, "point", "click"),
    (CurvesPanel, "pen", "clicks"),
    (CurvesPanel, "freehand", "drag"),
]
BY_CARD = [
    (FillPanel, "polygon", "clicks"),
    *((FillPanel, name, "drag") for name in ("circle", "ellipse", "line", "brush")),
    (FillPanel, "seed", "click"),
]


@pytest.fixture
def opened(qtbot):
    sessions = []

    def make(kind, document):
        session = Session(document=document)
        sessions.append(session)
        panel = kind(session)
        keep_until_the_end(qtbot, panel)
        panel.resize(1000, 640)
        panel.show()
        qtbot.waitExposed(panel)
        settle()
        return panel

    yield make
    for session in sessions:
        session.close()
        session.deleteLater()


def draw(qtbot, panel, tool, how):
    """Use a tool by hand; the figure that it has drawn."""
    known = {figure.id for figure in panel.session.sheet.figures}
    canvas = panel.canvas
    panel.choose_tool(tool)
    settle()
    places = [canvas.widget_position(*place).toPoint() for place in PLACES]
    if how == "drag":
        qtbot.mousePress(canvas, LEFT, pos=places[0])
        for place in places[1:]:
            qtbot.mouseMove(canvas, place)
            settle()
        qtbot.mouseRelease(canvas, LEFT, pos=places[-1])
    else:
        for place in places if how == "clicks" else places[:1]:
            qtbot.mouseClick(canvas, LEFT, pos=place)
            settle()
        if how == "clicks":
            qtbot.keyClick(canvas, Qt.Key.Key_Return)
    settle()
    (figure,) = (figure for figure in panel.session.sheet.figures if figure.id not in known)
    return figure


def sheet_with_a_line(background=0):
    document = blank_sheet(64, 48)
    document = replace(document, sheets=(replace(document.sheets[0], background=background),))
    sheet = document.sheets[0].id
    for colour in (2, FRONT):
        line = Line("", (WorldPoint("", 40, 40), WorldPoint("", 60, 44)), "bresenham_line", colour)
        document = add_figure(sheet, line)(document)
    return document


@pytest.mark.parametrize(("panel", "tool", "how"), BY_FRONT)
def test_a_new_figure_has_the_colour_of_the_front_one(qtbot, opened, panel, tool, how):
    assert draw(qtbot, opened(panel, sheet_with_a_line()), tool, how).colour == FRONT


@pytest.mark.parametrize(("background", "first"), [(0, 1), (1, 0), (3, 0)])
def test_the_first_figure_has_the_first_colour_that_is_not_the_papers(qtbot, opened, background, first):
    document = blank_sheet(64, 48)
    sheet = replace(document.sheets[0], background=background)
    panel = opened(DrawPanel, replace(document, sheets=(sheet,)))
    assert draw(qtbot, panel, "line", "drag").colour == first


@pytest.mark.parametrize(("panel", "tool", "how"), BY_CARD)
def test_in_fill_a_new_figure_has_the_colour_chosen_in_the_card(qtbot, opened, panel, tool, how):
    view = opened(panel, sheet_with_a_line())
    usual = FILL if tool == "seed" else BOUNDARY
    first = draw(qtbot, view, tool, how)
    assert first.colour == usual
    view.session.undo_stack.undo()
    view.choose_tool(tool)
    view.session.update_state(selection=())
    settle()
    other = next(colour for colour in (4, 6) if colour != usual)
    qtbot.mouseClick(view.card.colours._buttons[other], LEFT)
    settle()
    assert draw(qtbot, view, tool, how).colour == other
