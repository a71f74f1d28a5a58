"""Of thousands of lines only those are painted that the canvas has not painted before in the same view."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.widgets.canvas import line_layers
from workbench.widgets.canvas.drawing import PenStroke
from workbench.widgets.canvas.overlay import Overlay, Still
from workbench.widgets.canvas.pixel_canvas import PixelCanvas


def segments(count):
    places = np.random.default_rng(5).uniform(1, 38, (count, 2, 2))
    return tuple(places[k] for k in range(count))


@pytest.fixture
def canvas(qtbot: QtBot):
    shown = PixelCanvas()
    qtbot.addWidget(shown)
    shown.resize(300, 220)
    shown.set_picture(np.zeros((28, 40), np.uint32), 0)
    shown.show()
    QApplication.processEvents()
    return shown


@pytest.fixture
def counts(monkeypatch: pytest.MonkeyPatch):
    """How many lines are painted each time."""
    painted, really = [], line_layers.paint_lines

    def counted(painter, scene, lines, pen):
        painted.append(len(lines))
        really(painter, scene, lines, pen)

    monkeypatch.setattr(line_layers, "paint_lines", counted)
    return painted


def shown_lines(canvas, lines, **more):
    canvas.set_overlay(Overlay(ideal=tuple(lines), **more))
    settle()


def settle():
    for _turn in range(8):
        QApplication.processEvents()


def frame(canvas):
    image = canvas._frame
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4).astype(int)


def test_a_pointer_that_moves_paints_no_line(canvas, counts):
    shown_lines(canvas, segments(2000))
    assert sum(counts) == 2000
    counts.clear()
    QTest.mouseMove(canvas, QPoint(120, 80))
    QTest.mouseMove(canvas, QPoint(125, 80))
    canvas.repaint_soon()
    settle()
    assert sum(counts) == 0


def test_a_line_that_moves_is_painted_alone(canvas, counts):
    lines = list(segments(2000))
    shown_lines(canvas, lines)
    lines[7] = lines[7] + 1.0
    shown_lines(canvas, lines)
    counts.clear()
    for _move in range(3):
        lines[7] = lines[7] + 0.5
        shown_lines(canvas, lines)
    assert sum(counts) == 3


@pytest.mark.parametrize("change", ["none", "one", "many", "all", "fewer", "zoomed", "moved"])
def test_layers_look_as_if_all_were_painted(canvas, change):
    lines = list(segments(1500))
    shown_lines(canvas, lines)
    if change == "one":
        lines[3] = lines[3] + 1.0
    elif change == "many":
        lines[:700] = [line + 1.0 for line in lines[:700]]
    elif change == "all":
        lines = [line + 1.0 for line in lines]
    elif change == "fewer":
        lines = lines[200:]
    elif change == "zoomed":
        canvas.zoom(1, QPointF(90, 90))
    elif change == "moved":
        canvas.pan(11, -7)
    shown_lines(canvas, lines)
    by_layers = frame(canvas)
    canvas._layers.paint = lambda painter, scene, lines, pen: line_layers.paint_lines(
        painter, scene, lines, pen
    )
    canvas.repaint_soon()
    settle()
    assert np.abs(by_layers - frame(canvas)).max() <= 12


def test_a_layer_grows_over_frames_and_the_one_before_is_seen_meanwhile(canvas, counts, monkeypatch):
    monkeypatch.setattr(line_layers, "CORNERS_A_FRAME", 1000)
    canvas._layers = line_layers.LineLayers()
    lines = segments(2000)
    shown_lines(canvas, lines)
    assert max(counts) == 500
    assert sum(counts) == 2000
    counts.clear()
    canvas.zoom(1)
    canvas.repaint()
    assert sum(counts) == 500
    meanwhile = inked(canvas)
    settle()
    assert meanwhile > 0.7 * inked(canvas)
    assert sum(counts) == 2000


def inked(canvas):
    """How many pixels are not as bright as the ground."""
    return int((frame(canvas)[:180, 60:, :3].sum(axis=2) < 3 * 200).sum())


def test_strokes_of_one_style_share_a_layer_and_few_need_none(canvas, counts):
    lines = segments(1200)
    strokes = tuple(PenStroke(line, "muted", 1.25) for line in lines)
    canvas.set_overlay(Overlay(drawn=strokes))
    settle()
    counts.clear()
    canvas.repaint_soon()
    settle()
    assert sum(counts) == 0
    canvas.set_overlay(Overlay(drawn=strokes[:20]))
    settle()
    counts.clear()
    canvas.repaint_soon()
    settle()
    assert sum(counts) == 20
    assert not canvas._layers._before


def test_two_pens_grow_in_turn(canvas, counts, monkeypatch):
    monkeypatch.setattr(line_layers, "CORNERS_A_FRAME", 3000)
    canvas._layers = line_layers.LineLayers()
    lines = segments(1200)
    canvas.setFocus(Qt.FocusReason.OtherFocusReason)
    canvas.set_overlay(Overlay(ideal=lines, outlined=lines))
    canvas.repaint()
    assert sum(counts) == 1500
    settle()
    assert sum(counts) == 2400


def test_what_stays_during_a_drag_comes_to_be_whole(canvas, counts, monkeypatch):
    monkeypatch.setattr(line_layers, "CORNERS_A_FRAME", 1000)
    canvas._layers = line_layers.LineLayers()
    lines = segments(2000)
    strokes = tuple(PenStroke(line, "muted", 1.25) for line in lines)
    canvas.set_overlay(Overlay(still=Still(strokes)))
    settle()
    while_dragged = frame(canvas)
    assert sum(counts) == 2000
    for x in range(5):
        canvas.set_overlay(Overlay(still=canvas.overlay.still, chosen=((x, 3),)))
        settle()
    assert sum(counts) == 2000
    canvas.set_overlay(Overlay(drawn=strokes))
    settle()
    assert sum(counts) == 2000
    assert np.abs(while_dragged - frame(canvas)).max() == 0
