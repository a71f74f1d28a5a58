"""The pixel canvas as a person sees and uses it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QColor, QWheelEvent
from PySide6.QtWidgets import QApplication

from workbench.algorithms.marks import Word
from workbench.geometry.conventions import round_half_up
from workbench.rendering.comparing import (
    BOTH,
    ONLY_FIRST,
    ONLY_SECOND,
    TIE_FIRST,
    TIE_SECOND,
    compare_classes,
)
from workbench.widgets.canvas.overlay import Handle, Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.view import LEVELS, Area, CanvasView, fitted, label_step
from workbench.widgets.look.tokens import DARK, LIGHT, theme

BLUE = 0x0072B2
LEFT = Qt.MouseButton.LeftButton
views = st.builds(CanvasView, st.sampled_from(LEVELS), st.integers(-3000, 3000), st.integers(-3000, 3000))


@given(views, st.floats(-500, 500), st.floats(-500, 500))
def test_screen_and_device_are_inverse(view, x, y):
    assert view.to_device(*view.to_screen(x, y)) == pytest.approx((x, y), abs=1e-6)


@given(views, st.integers(-20, 20), st.integers(0, 1000), st.integers(0, 1000))
def test_zoom_keeps_what_is_under_the_pointer(view, steps, x, y):
    before, zoomed = view.to_device(x, y), view.zoomed(steps, x, y)
    after = zoomed.to_device(x, y)
    assert abs(after[0] - before[0]) * zoomed.cell <= 0.5 + 1e-6
    assert abs(after[1] - before[1]) * zoomed.cell <= 0.5 + 1e-6
    assert zoomed.cell in LEVELS


@given(st.integers(1, 4000), st.integers(1, 4000), st.integers(40, 2000), st.integers(40, 2000))
def test_a_fitted_picture_is_whole_and_no_larger_cell_would_fit(width, height, across, down):
    area = Area(30, 0, 30 + across, down)
    view = fitted(area, width, height, 0)
    if width <= 64 * across and height <= 64 * down:
        assert width * view.cell <= across + 1e-9
        assert height * view.cell <= down + 1e-9
    if 1 <= view.cell < 160:
        assert width * (view.cell + 1) > across or height * (view.cell + 1) > down


@given(views, st.integers(1, 300), st.integers(1, 300))
def test_visible_cells_are_exactly_those_that_touch_the_area(view, width, height):
    area = Area(20, 0, 400, 300)
    seen = view.visible(area, width, height)
    columns = [
        x for x in range(width)
        if view.to_screen(x + 0.5, 0)[0] > area.left and view.to_screen(x - 0.5, 0)[0] < area.right
    ]  # fmt: skip
    rows = [
        y for y in range(height)
        if view.to_screen(0, y - 0.5)[1] > area.top and view.to_screen(0, y + 0.5)[1] < area.bottom
    ]  # fmt: skip
    if seen is None:
        assert not columns or not rows
    else:
        assert seen == (columns[0], columns[-1], rows[0], rows[-1])


@given(st.sampled_from(LEVELS), st.floats(1, 200))
def test_axis_numbers_never_come_nearer_than_asked(cell, room):
    step = label_step(cell, room)
    assert step * cell >= room
    assert str(step).strip("0") in ("1", "2", "5")


def test_classes_of_a_comparison():
    first = np.array([(0, 0), (1, 0), (2, 1), (9, 9)])
    second = np.array([(0, 0), (1, 1), (2, 0), (-1, 0)])
    ties = np.array([(2, 1), (2, 0), (0, 0)])
    classes = compare_classes((3, 2), first, second, ties)
    assert classes.tolist() == [[BOTH, ONLY_FIRST, TIE_SECOND], [0, ONLY_SECOND, TIE_FIRST]]


@pytest.fixture
def canvas(qtbot):
    made = PixelCanvas()
    qtbot.addWidget(made)
    made.resize(640, 480)
    picture = np.zeros((28, 40), np.uint32)
    picture[10, 20] = BLUE
    made.set_picture(picture, 0)
    made.show()
    QApplication.processEvents()
    return made


def at(canvas, x, y):
    return canvas.widget_position(x, y).toPoint()


def colour_at(canvas, x, y):
    image = canvas.grab().toImage()
    place = canvas.widget_position(x, y) * canvas.devicePixelRatioF()
    return QColor(image.pixelColor(round(place.x()), round(place.y()))).name().upper()


def test_a_painted_cell_is_solid_and_its_neighbours_are_canvas(canvas):
    assert colour_at(canvas, 20, 10) == "#0072B2"
    for x, y in ((19, 10), (21, 10), (20, 9), (20, 11)):
        assert colour_at(canvas, x, y) == LIGHT.canvas
    image = canvas.grab().toImage()
    left, top, side = canvas.view.cell_box(20, 10)
    inside = {
        image.pixelColor(x, y).name()
        for x in range(left + 1, left + side)
        for y in range(top + 1, top + side)
    }
    assert inside == {"#0072b2"}
    assert image.pixelColor(left, top + 3).name() != "#0072b2"


def test_a_word_is_not_struck_through_by_marks(canvas):
    word = Word("888", 20.5, 10, carded=True)
    place = canvas.widget_position(word.x, word.y).toPoint()
    seen = []
    for current in ((), ((20, 10), (21, 10))):
        canvas.set_overlay(Overlay(drawn=(word,), current=current))
        image = canvas.grab(QRect(place - QPoint(6, 4), place + QPoint(6, 4))).toImage()
        seen.append([image.pixelColor(x, y).green() for x in range(13) for y in range(9)])
    assert np.abs(np.subtract(*seen)).max() < 40  # its card lets a little through


def test_the_background_follows_the_theme(canvas):
    theme.use(DARK)
    try:
        assert colour_at(canvas, 3, 3) == DARK.canvas
        assert colour_at(canvas, 20, 10) == "#0072B2"
    finally:
        theme.use(LIGHT)


def test_y_grows_upwards(canvas):
    assert canvas.widget_position(0, 5).y() < canvas.widget_position(0, 4).y()


def test_press_move_release_are_told_in_device_coordinates(qtbot, canvas):
    told = []
    canvas.pressed.connect(lambda x, y, _m: told.append(("down", round(x), round(y))))
    canvas.moved.connect(lambda x, y, _m: told.append(("move", round(x), round(y))))
    canvas.released.connect(lambda x, y, _m: told.append(("up", round(x), round(y))))
    qtbot.mousePress(canvas, LEFT, pos=at(canvas, 3, 4))
    qtbot.mouseMove(canvas, at(canvas, 12, 20))
    qtbot.mouseRelease(canvas, LEFT, pos=at(canvas, 12, 20))
    assert told == [("down", 3, 4), ("move", 12, 20), ("up", 12, 20)]


def test_a_click_names_its_cell_and_a_drag_does_not(qtbot, canvas):
    clicked = []
    canvas.cell_clicked.connect(lambda x, y: clicked.append((x, y)))
    qtbot.mouseClick(canvas, LEFT, pos=at(canvas, 7, 8))
    qtbot.mousePress(canvas, LEFT, pos=at(canvas, 7, 8))
    qtbot.mouseRelease(canvas, LEFT, pos=at(canvas, 17, 8))
    assert clicked == [(7, 8)]


def test_a_handle_is_grabbed_within_24_pixels_and_keeps_its_offset(qtbot, canvas):
    canvas.set_overlay(Overlay(handles=(Handle("a", "P0", 20, 10), Handle("b", "P1", 30, 10))))
    told = []
    canvas.handle_pressed.connect(lambda name, _m: told.append(name))
    canvas.handle_dragged.connect(lambda name, x, y: told.append((name, round(x, 3), round(y, 3))))
    canvas.handle_released.connect(told.append)
    start = at(canvas, 20, 10) + QPoint(11, -11)
    qtbot.mousePress(canvas, LEFT, pos=start)
    moved = QPoint(3 * round(canvas.view.cell), 0)
    qtbot.mouseMove(canvas, start + moved)
    qtbot.mouseRelease(canvas, LEFT, pos=start + moved)
    assert [told[0], told[1][0], told[2]] == ["a", "a", "a"]
    assert told[1][1:] == pytest.approx((23, 10), abs=0.1)
    told.clear()
    assert canvas.pointed_cell == tuple(round_half_up(each) for each in canvas.device_position(start + moved))
    qtbot.mouseClick(canvas, LEFT, pos=at(canvas, 20, 10) + QPoint(0, 14))
    assert told == []


def test_the_wheel_zooms_at_the_pointer_and_the_middle_button_pans(qtbot, canvas):
    place = canvas.widget_position(30, 5)
    before = canvas.device_position(place)
    wheel = QWheelEvent(
        place, canvas.mapToGlobal(place), QPoint(), QPoint(0, 240), Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    cell = canvas.view.cell
    QApplication.sendEvent(canvas, wheel)
    assert canvas.view.cell > cell
    assert canvas.device_position(place) == pytest.approx(before, abs=1 / canvas.view.cell)
    left, bottom = canvas.view.left, canvas.view.bottom
    middle = Qt.MouseButton.MiddleButton
    qtbot.mousePress(canvas, middle, pos=QPoint(300, 200))
    qtbot.mouseMove(canvas, QPoint(310, 215))
    qtbot.mouseRelease(canvas, middle, pos=QPoint(310, 215))
    assert (canvas.view.left - left, canvas.view.bottom - bottom) == (10, 15)
    canvas.fit()
    assert canvas.view.cell == cell


def test_the_picture_cannot_be_panned_out_of_sight(canvas):
    canvas._show(canvas.view.moved(100_000, -100_000))
    assert canvas.view.visible(canvas.area, 40, 28) is not None


def test_hover_names_the_cell(qtbot, canvas):
    told = []
    canvas.hovered.connect(lambda x, y: told.append((x, y)))
    canvas.hover_left.connect(lambda: told.append("out"))
    qtbot.mouseMove(canvas, at(canvas, 4, 4))
    qtbot.mouseMove(canvas, at(canvas, 5, 4))
    qtbot.mouseMove(canvas, QPoint(2, 2))
    assert told == [(4, 4), (5, 4), "out"]


def test_the_keyboard_cursor_moves_speaks_and_acts(qtbot, canvas):
    canvas.set_describer(lambda x, y: f"cell {x} {y}")
    clicked, arrows = [], []
    canvas.cell_clicked.connect(lambda x, y: clicked.append((x, y)))
    canvas.arrow.connect(lambda dx, dy, _m: arrows.append((dx, dy)))
    qtbot.keyClick(canvas, Qt.Key.Key_Right)
    qtbot.keyClick(canvas, Qt.Key.Key_C)
    assert canvas.cursor_cell == (20, 14)
    qtbot.keyClick(canvas, Qt.Key.Key_Left)
    qtbot.keyClick(canvas, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert canvas.cursor_cell == (19, 4)
    assert canvas.accessibleDescription() == "cell 19 4"
    qtbot.keyClick(canvas, Qt.Key.Key_Return)
    qtbot.keyClick(canvas, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert canvas.cursor_cell == (19, 0)
    qtbot.keyClick(canvas, Qt.Key.Key_C)
    assert canvas.cursor_cell is None
    assert clicked == [(19, 4)]
    assert arrows == [(1, 0)]


def test_the_current_cell_is_ringed_twice(canvas):
    picture = np.zeros((28, 40), np.uint32)
    picture[10, 20] = BLUE
    canvas.set_picture(picture, 0)
    canvas.set_overlay(Overlay(current=((20, 10),)))
    image = canvas.grab().toImage()
    left, top, side = canvas.view.cell_box(20, 10)
    row = [image.pixelColor(left - 2 + k, top + side // 2).name().upper() for k in range(side // 2 + 2)]
    ring = [row.index(LIGHT.text), row.index(LIGHT.canvas, row.index(LIGHT.text)), row.index("#0072B2")]
    assert ring == sorted(ring)


def test_only_a_changed_canvas_paints_its_frame_again(canvas, monkeypatch):
    painted = []
    paint = canvas._paint_frame
    monkeypatch.setattr(canvas, "_paint_frame", lambda: (painted.append(1), paint()))
    canvas.update()
    QApplication.processEvents()
    assert painted == []
    canvas.set_overlay(Overlay(current=((1, 1),)))
    QApplication.processEvents()
    assert painted == [1]


def test_a_picture_of_another_size_is_fitted_and_a_point_far_out_is_harmless(canvas):
    canvas.set_picture(np.full((1000, 1000), BLUE, np.uint32), 0)
    assert canvas.view.cell < 1
    canvas.set_overlay(Overlay(ideal=(np.array([[-1e6, -1e6], [1e6, 1e6]]),), current=((5000, 5000),)))
    assert canvas.device_position(QPointF(-1e5, 0))[0] < 0
    assert colour_at(canvas, 700, 300) == "#0072B2"
