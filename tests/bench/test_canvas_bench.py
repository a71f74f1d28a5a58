"""How fast the canvas answers: from a mouse event to the painted frame, and painting a million cells."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication, QMainWindow

from tests.bench.drags import MOVES, measure_drag, mouse
from workbench.document.samples.examples import blank_sheet
from workbench.panels.draw.panel import DrawPanel
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import PenStroke
from workbench.widgets.canvas.overlay import Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.view import centred


@pytest.mark.parametrize("docks", [False, True], ids=["canvas", "canvas and plot"])
def test_mouse_event_to_frame(qtbot, benchmark, docks):
    """500 moves of a line's end on a 200 x 150 sheet at 1280 x 680; the 99th of the times matters."""
    session = Session(document=blank_sheet(200, 150))
    window = QMainWindow()
    qtbot.addWidget(window)
    panel = DrawPanel(session)
    window.setCentralWidget(panel.center)
    window.resize(1280, 680)
    window.show()
    panel.plot.setParent(None if not docks else window)
    if docks:
        panel.plot.setGeometry(300, 500, 900, 160)
        panel.plot.show()
    canvas = panel.canvas
    panel.choose_tool("line")
    mouse(canvas, QEvent.Type.MouseButtonPress, 20, 10)
    mouse(canvas, QEvent.Type.MouseMove, 180, 120)
    mouse(canvas, QEvent.Type.MouseButtonRelease, 180, 120)
    QApplication.processEvents()
    panel.choose_tool("select")
    figure = session.sheet.figures[0]
    session.update_state(selection=(figure.id,), active=figure.id)
    QApplication.processEvents()
    angle = np.linspace(0, 6 * np.pi, MOVES)
    path = np.column_stack([110 + 70 * np.cos(angle), 80 + 60 * np.sin(angle)])
    measure_drag(benchmark, "event to frame", canvas, (180, 120), path.tolist())
    qtbot.waitUntil(lambda: session.run.done)  # or the next drag is measured beside it


@pytest.mark.parametrize("cell", [0.5, 1, 2, 6, 8, 16, 64])
def test_paint_a_million_cells(qtbot, benchmark, cell):
    """One repaint of 1000 x 1000 cells at 1280 x 680; the picture unchanged."""
    canvas = PixelCanvas()
    qtbot.addWidget(canvas)
    canvas.resize(1280, 680)
    canvas.show()
    QApplication.processEvents()
    values = np.random.default_rng(1).choice(np.array([0, 0, 0, 0x0072B2, 0xD55E00], np.uint32), (1000, 1000))
    canvas.set_picture(values, 0)
    canvas.set_overlay(Overlay(ideal=(np.array([[0.0, 0.0], [999.0, 999.0]]),)))
    canvas._show(centred(canvas.area, 1000, 1000, cell))
    benchmark(lambda: (canvas.repaint_soon(), canvas.repaint()))


def test_paint_a_million_new_cells(qtbot, benchmark):
    """The same with another picture each time, as while something on it is dragged."""
    canvas = PixelCanvas()
    qtbot.addWidget(canvas)
    canvas.resize(1280, 680)
    canvas.show()
    QApplication.processEvents()
    values = np.random.default_rng(1).choice(np.array([0, 0, 0, 0x0072B2, 0xD55E00], np.uint32), (1000, 1000))
    canvas.set_picture(values, 0)
    canvas._show(centred(canvas.area, 1000, 1000, 1))

    def another():
        canvas.set_picture(values, 0)
        canvas.repaint()

    benchmark(another)


@pytest.mark.parametrize("pattern", ["solid", "dash"])
def test_paint_a_thousand_grips_and_a_long_curve(qtbot, benchmark, pattern):
    """One repaint at 1280 x 680 of 1,000 handles over a stroke of 5,000 corners; 5 ms allowed."""
    canvas = PixelCanvas()
    qtbot.addWidget(canvas)
    canvas.resize(1280, 680)
    canvas.show()
    QApplication.processEvents()
    canvas.set_picture(np.zeros((170, 320), np.uint32), 0)

    def curve(count):
        t = np.linspace(0, 2 * np.pi, count)
        return np.stack([160 + 150 * np.sin(t), 85 + 80 * np.cos(2 * t)], axis=1)

    shapes = ("round", "square", "diamond")
    handles = tuple(Handle(str(k), "", x, y, k == 3, shapes[k % 3]) for k, (x, y) in enumerate(curve(1000)))
    overlay = Overlay(drawn=(PenStroke(curve(5000), "accent", pattern=pattern),), handles=handles)
    benchmark(lambda: (canvas.set_overlay(overlay), canvas.repaint()))
