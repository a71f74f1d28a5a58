"""How fast the Curves panel answers, from a mouse event to the painted frame, with a thousand points."""

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication, QMainWindow, QVBoxLayout, QWidget

from tests.bench.drags import MOVES, measure_drag
from workbench.document.edits import add_figure
from workbench.document.model import Curve, CurvePoint
from workbench.document.samples.examples import blank_sheet
from workbench.panels.curves.panel import CurvesPanel
from workbench.session.session import Session

POINTS = 1000


def spiral(count):
    """Control points of a curve that winds over a sheet of 200 x 150 pixels."""
    turn = np.linspace(0, 24 * np.pi, count)
    reach = np.linspace(4, 70, count)
    places = np.column_stack([100 + reach * np.cos(turn), 75 + reach * np.sin(turn)])
    return [CurvePoint("", x, y) for x, y in places.tolist()]


@pytest.mark.parametrize("spline", ["b_spline", "natural_cubic", "bezier_path"])
@pytest.mark.parametrize("docks", [False, True], ids=["canvas", "canvas and docks"])
def test_one_of_a_thousand_points_is_dragged(qtbot, benchmark, spline, docks):
    """500 moves of one control point at 1280 x 680; the 99th of the times matters."""
    session = Session(document=blank_sheet(200, 150))
    curve = Curve("", tuple(spiral(POINTS)), "bresenham_line", 1, spline=spline)
    session.apply(add_figure(session.sheet.id, curve), "Draw")
    window = QMainWindow()
    qtbot.addWidget(window)
    panel = CurvesPanel(session)
    window.setCentralWidget(panel.center)
    beside = QWidget()
    qtbot.addWidget(beside)
    column = QVBoxLayout(beside)
    beside.resize(360, 1200)
    if docks:
        for _name, _title, widget, _area in panel.docks():
            column.addWidget(widget)
    window.resize(1280, 680)
    window.show()
    beside.setVisible(docks)
    figure = session.sheet.figures[0]
    panel.choose_tool("select")
    session.update_state(selection=(figure.id,), active=figure.id)
    for _turn in range(10):
        QApplication.processEvents()
    point = figure.points_world[POINTS - 100]
    angle = np.linspace(0, 6 * np.pi, MOVES)
    path = np.column_stack([point.x + 9 * np.sin(angle), point.y + 9 - 9 * np.cos(angle)])
    measure_drag(benchmark, spline, panel.canvas, (point.x, point.y), path.tolist())
