"""Polylines and grips painted in batches look as if the painter had been given them one by one."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from workbench.algorithms.curves import bernstein
from workbench.widgets.canvas.drawing import Marker, PenStroke, Tint, paint_drawn
from workbench.widgets.canvas.lines import paint_lines
from workbench.widgets.canvas.overlay import GRAB, Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.tokens import DARK, LIGHT, theme

LEFT = Qt.MouseButton.LeftButton
SIZE = 300, 220
INK = QColor("#000000")
places = st.tuples(st.floats(-5, 45), st.floats(-5, 33))
patterns = st.sampled_from([Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine])


@pytest.fixture(scope="module")
def scene(qapp: QApplication):
    canvas = PixelCanvas()
    canvas.resize(*SIZE)
    canvas.set_picture(np.zeros((28, 40), np.uint32), 0)
    canvas.show()
    qapp.processEvents()
    yield canvas.scene()
    canvas.deleteLater()


def painted(scene, points, width=1.5, pattern=Qt.PenStyle.SolidLine, whole=False):
    """How dark each pixel becomes, (h, w), 0 to 1; ``whole`` leaves all to the painter."""
    return painted_in([[np.array(points, float).reshape(-1, 2)]], scene, width, pattern, whole)


def painted_in(batches, scene, width=1.5, pattern=Qt.PenStyle.SolidLine, whole=False):
    """The same for lines that are painted so many at a time."""
    image = QImage(*SIZE, QImage.Format.Format_RGB32)
    image.fill(QColor("white"))
    painter = QPainter(image)
    area = scene.area
    painter.setClipRect(area.left, area.top, area.width, area.height)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    pen = QPen(INK, width, pattern, Qt.PenCapStyle.FlatCap)
    for lines in batches:
        paint_lines(painter, replace(scene, vector=whole), lines, pen)
    painter.end()
    shades = np.frombuffer(image.constBits(), np.uint8).reshape(SIZE[1], -1, 4)[:, : SIZE[0], 0]
    return 1 - shades / 255.0


def near(dark: np.ndarray) -> np.ndarray:
    """Each pixel as dark as the darkest of it and its eight neighbours."""
    wide = np.pad(dark, 1)
    height, width = dark.shape
    return np.max([wide[j : j + height, i : i + width] for i in range(3) for j in range(3)], axis=0)


def alike(one: np.ndarray, other: np.ndarray) -> bool:
    """Nowhere is one dark and the other bright nearby, but for a pixel or two at a sharp corner."""
    odd = (one > near(other) + 0.35).sum() + (other > near(one) + 0.35).sum()
    return bool(odd <= 3 + 0.02 * (one > 0.35).sum())


@given(st.lists(places, min_size=2, max_size=7), patterns, st.sampled_from([1.5, 2.0]))
def test_a_curve_of_5000_corners_looks_as_the_painters_own(scene, points, pattern, width):
    curve = bernstein(len(points) - 1, np.linspace(0, 1, 5000)) @ np.array(points)
    assume(np.ptp(points, axis=0).max() > 0.1)
    assert alike(painted(scene, curve, width, pattern), painted(scene, curve, width, pattern, whole=True))


@given(
    st.lists(st.tuples(st.floats(0, 39), st.floats(0, 27)), min_size=2, max_size=6),
    st.sampled_from([Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine]),
)
def test_so_does_a_polygon_of_long_sides(scene, points, pattern):
    """Thin, for at sharp corners the painter cuts off what would stick out."""
    assume(np.hypot(*np.diff(points, axis=0).T).min() > 1)
    assert alike(painted(scene, points, 1.5, pattern), painted(scene, points, 1.5, pattern, whole=True))


@given(places, st.floats(0, 2 * math.pi), st.sampled_from([1e3, 1e6, 1e9]), patterns)
def test_a_side_that_ends_far_away_keeps_its_direction(scene, start, angle, far, pattern):
    towards = np.array([math.cos(angle), math.sin(angle)])
    near_end, far_end = (np.array(start) + length * towards for length in (200.0, far))
    seen = painted(scene, [start, far_end], pattern=pattern)
    assert alike(seen, painted(scene, [start, near_end], pattern=pattern))


@pytest.mark.parametrize(
    "points",
    [[], [(3, 3)], [(3, 3), (3, 3)], [(-900, 5), (-800, 9)], [(3, 3)] * 500, [(1e300, 1e300), (1e305, 0)]],
)
def test_what_has_no_length_or_is_out_of_sight_paints_nothing(scene, points):
    assert not painted(scene, points).any()


def test_repeated_corners_change_nothing(scene):
    corners = np.array([(2, 3), (30, 20), (35, 4)], float)
    assert alike(painted(scene, np.repeat(corners, 40, axis=0)), painted(scene, corners))


@given(st.lists(st.lists(places, min_size=1, max_size=5), min_size=1, max_size=6), patterns, st.data())
def test_lines_painted_at_once_look_as_one_after_the_other(scene, lines, pattern, data):
    lines = [np.array(line) for line in lines]
    long = data.draw(st.integers(0, len(lines) - 1))
    lines[long] = bernstein(len(lines[long]) - 1, np.linspace(0, 1, 300)) @ lines[long]
    one_by_one = painted_in([[line] for line in lines], scene, pattern=pattern)
    assert alike(painted_in([lines], scene, pattern=pattern), one_by_one)


# Grips


@pytest.fixture
def canvas(qtbot: QtBot):
    made = PixelCanvas()
    qtbot.addWidget(made)
    made.resize(640, 480)
    made.set_picture(np.zeros((28, 40), np.uint32), 0)
    made.show()
    QApplication.processEvents()
    return made


def around(canvas, x, y, reach=7):
    """The colours near a device point."""
    image = canvas.grab().toImage()
    place = canvas.widget_position(x, y)
    column, row = round(place.x()), round(place.y())
    return [
        [QColor(image.pixelColor(column + i, row + j)).name().upper() for i in range(-reach, reach + 1)]
        for j in range(-reach, reach + 1)
    ]


def test_each_shape_of_grip_is_told_from_the_others(canvas):
    seen = []
    for shape in ("round", "square", "diamond"):
        canvas.set_overlay(Overlay(handles=(Handle("a", "", 20, 10, shape=shape),)))
        seen.append(around(canvas, 20, 10))
        assert seen[-1][7][7] == LIGHT.surface
    assert seen[0] != seen[1] != seen[2] != seen[0]


@pytest.mark.parametrize("tokens", [LIGHT, DARK])
def test_a_grip_has_its_ink_and_is_filled_when_selected(canvas, tokens):
    theme.use(tokens)
    try:
        for ink, value in (("accent", tokens.accent), ("data2", tokens.data[1])):
            handle = Handle("a", "", 20, 10, selected=True, ink=ink)
            canvas.set_overlay(Overlay(handles=(handle,)))
            assert around(canvas, 20, 10)[7][7] == value
            canvas.set_overlay(Overlay(handles=(replace(handle, selected=False),)))
            assert around(canvas, 20, 10)[7][7] == tokens.surface
    finally:
        theme.use(LIGHT)


def test_a_grip_outside_the_picture_is_seen_and_grabbed(qtbot: QtBot, canvas):
    canvas.zoom(-1)
    canvas.set_overlay(Overlay(handles=(Handle("out", "", -2, 29, selected=True),)))
    assert around(canvas, -2, 29)[7][7] == LIGHT.accent
    told = []
    canvas.handle_pressed.connect(lambda name, _modifiers: told.append(name))
    qtbot.mouseClick(canvas, LEFT, pos=canvas.widget_position(-2, 29).toPoint())
    assert told == ["out"]


@given(
    st.lists(st.tuples(st.floats(-9, 49), st.floats(-9, 37)), max_size=30),
    st.tuples(st.floats(0, 300), st.floats(0, 220)),
)
def test_the_handle_grabbed_is_the_nearest_within_reach(scene, qapp, points, pointer):
    canvas = PixelCanvas()
    canvas.resize(*SIZE)
    canvas.set_picture(np.zeros((28, 40), np.uint32), 0)
    canvas.set_overlay(Overlay(handles=tuple(Handle(str(k), "", x, y) for k, (x, y) in enumerate(points))))
    away = [
        max(abs(place.x() - pointer[0]), abs(place.y() - pointer[1]))
        for place in (canvas.widget_position(x, y) for x, y in points)
    ]
    found = canvas.handle_at(QPointF(*pointer))
    if found is None:
        assert min(away, default=math.inf) >= GRAB / 2 - 1e-9
    else:
        assert away[int(found.id)] <= min(min(away), GRAB / 2) + 1e-9


def test_of_handles_on_one_place_the_one_on_top_is_taken(canvas):
    canvas.set_overlay(Overlay(handles=(Handle("below", "", 20, 10), Handle("top", "", 20, 10))))
    found = canvas.handle_at(canvas.widget_position(20, 10))
    assert found is not None
    assert found.id == "top"


def test_of_many_handles_only_the_selected_bear_their_names(canvas):
    def ink(handles):
        canvas.set_overlay(Overlay(handles=handles))
        image = canvas.grab().toImage()
        shades = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)
        dark = QColor(LIGHT.line)
        return int((shades[:, :, :3] == (dark.blue(), dark.green(), dark.red())).all(axis=2).sum())

    many = tuple(Handle(str(k), f"P{k}", k % 20 * 2, k // 20 * 3) for k in range(100))
    assert ink(many) == ink(tuple(replace(handle, name="") for handle in many))
    assert ink((replace(many[55], selected=True), *many[56:])) > ink(many)


def test_a_stroke_lies_over_what_was_drawn_before_it(canvas):
    across, up = np.array([(0, 14), (39, 14)], float), np.array([(20, 0), (20, 27)], float)
    for first, second in (("data1", "data2"), ("data2", "data1")):
        higher = across + np.array([0, 5])
        strokes = (PenStroke(across, first, 5.0), PenStroke(higher, first, 5.0), PenStroke(up, second, 5.0))
        canvas.set_overlay(Overlay(drawn=strokes))
        wanted = LIGHT.data[int(second[-1]) - 1]
        assert around(canvas, 20, 14)[7][7] == around(canvas, 20, 19)[7][7] == wanted
        assert around(canvas, 10, 19)[7][7] == LIGHT.data[int(first[-1]) - 1]


@pytest.mark.parametrize("shape", ["dot", "ring", "square", "cross"])
@given(st.floats(1, 38), st.floats(1, 26), st.sampled_from([6.0, 8.0, 13.0]))
def test_a_spot_is_where_the_painter_would_put_it(scene, shape, x, y, size):
    def seen(vector):
        image = QImage(*SIZE, QImage.Format.Format_RGB32)
        image.fill(QColor("white"))
        painter = QPainter(image)
        paint_drawn(painter, replace(scene, vector=vector), (Marker(x, y, "text", shape, size),))
        painter.end()
        shades = np.frombuffer(image.constBits(), np.uint8).reshape(SIZE[1], -1, 4)[:, :, 0]
        return shades.astype(float)

    once, anew = seen(False), seen(True)
    # Placed to a quarter of a pixel, a side may be an eighth of a pixel off.
    assert np.abs(once - anew).max() <= 0.3 * 255
    assert (once < 128).any()


def test_strokes_and_regions_reach_the_picture(canvas):
    canvas.set_overlay(
        Overlay(
            drawn=(
                Tint(np.array([(10, 5), (30, 5), (30, 20), (10, 20)], float), "data1", 255),
                PenStroke(np.array([(0, 14), (39, 14)], float), "error", 6.0, haloed=True),
            )
        )
    )
    assert around(canvas, 20, 8)[7][7] == LIGHT.data[0]
    column = [row[7] for row in around(canvas, 20, 14)]
    assert column[7] == LIGHT.error
    assert LIGHT.canvas in column


@pytest.mark.parametrize("pattern", [Qt.PenStyle.DashLine, Qt.PenStyle.DotLine])
def test_a_line_that_ends_where_a_dash_would_begin_has_none_of_no_length(scene, pattern):
    width, cell = 1.25, scene.view.cell
    period = width * (6 if pattern == Qt.PenStyle.DashLine else 3)
    for angle in np.linspace(0.1, 6.2, 80).tolist():
        for length in (np.nextafter(k * period, np.inf) / cell for k in (2, 3, 5, 7)):
            end = 20 + length * math.cos(angle), 14 + length * math.sin(angle)
            shades = painted(scene, [(20.0, 14.0), end], width, pattern)
            assert np.isfinite(shades).all()
            assert shades.sum() > 0
