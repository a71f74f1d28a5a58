"""Names of handles and the words beside the pointer keep clear of grips and of one another."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRectF
from PySide6.QtGui import QFont

from workbench.widgets.canvas.handle_names import MOST_NAMED, handle_names, tag_box
from workbench.widgets.canvas.overlay import HANDLE, Handle, Overlay
from workbench.widgets.canvas.painter import Scene
from workbench.widgets.canvas.view import Area, CanvasView
from workbench.widgets.look.tokens import LIGHT

AREA = Area(30, 0, 730, 430)
CELL = 7.0
cells = st.tuples(st.integers(-5, 104), st.integers(-5, 66))


def scene_with(handles):
    view = CanvasView(CELL, AREA.left, AREA.bottom)
    return Scene(AREA, view, (100, 61), LIGHT, 1.0, QFont(), Overlay(handles=tuple(handles)))


def handles_at(places, selected=False):
    return [Handle(f"h{k}", f"P{k}", float(x), float(y), selected) for k, (x, y) in enumerate(places)]


def rectangle(box):
    left, top, right, bottom = box
    return QRectF(left, top, right - left, bottom - top)


def grip(scene, handle):
    x, y = scene.view.to_screen(handle.x, handle.y)
    return QRectF(x - HANDLE / 2, y - HANDLE / 2, HANDLE, HANDLE)


def meets(a, b):
    common = a.intersected(b)
    return common.width() > 1e-6 and common.height() > 1e-6


def covered(one, others):
    common = (one.intersected(each) for each in others)
    return sum(each.width() * each.height() for each in common)


@given(st.lists(cells, max_size=MOST_NAMED, unique=True))
def test_no_name_hides_another_and_all_stay_in_the_area(qapp, places):
    boxes = [rectangle(label.box) for label in handle_names(scene_with(handles_at(places)))]
    for k, box in enumerate(boxes):
        assert QRectF(AREA.left, AREA.top, AREA.width, AREA.height).contains(box)
        assert not any(meets(box, other) for other in boxes[:k])


@pytest.mark.parametrize("blocked", [1, 2, 3])
def test_a_name_moves_to_another_side_rather_than_hide_a_grip(qapp, blocked):
    corners = [(54, 32), (46, 32), (54, 28), (46, 28)]
    grips = [Handle(f"n{k}", "", float(x), float(y)) for k, (x, y) in enumerate(corners[:blocked])]
    scene = scene_with([*handles_at([(50, 30)]), *grips])
    (label,) = handle_names(scene)
    assert label.text == "P0 (50, 30)"
    assert not any(meets(rectangle(label.box), grip(scene, each)) for each in scene.overlay.handles)
    free = scene.view.to_screen(*corners[blocked])
    assert rectangle(label.box).contains(*free)


def test_without_room_for_both_the_name_of_the_selected_handle_is_shown(qapp):
    crowd = handles_at([(50 + i, 30 + j) for i in range(3) for j in range(3)])
    chosen = Handle("c", "Q", 51.0, 31.0, True)
    texts = [label.text for label in handle_names(scene_with([*crowd, chosen]))]
    assert texts[0] == "Q (51, 31)"
    assert 1 < len(texts) < len(crowd)


def test_names_have_a_true_minus_sign(qapp):
    (label,) = handle_names(scene_with([Handle("h", "P0", -0.5, 3.0)]))
    assert label.text == "P0 (−0.5, 3)"


def test_of_many_handles_those_selected_have_names(qapp):
    many = handles_at([(k, 10) for k in range(MOST_NAMED + 1)])
    chosen = Handle("c", "Q", 50.0, 30.0, True)
    assert handle_names(scene_with(many)) == ()
    assert [label.text for label in handle_names(scene_with([*many, chosen]))] == ["Q (50, 30)"]


@given(st.lists(cells, max_size=12, unique=True), st.integers(30, 729), st.integers(0, 429))
def test_the_words_beside_the_pointer_hide_least(qapp, places, x, y):
    scene = scene_with(handles_at(places))
    box = rectangle(tag_box("(12, 34) Line, Bresenham", x, y, scene))
    taken = [rectangle(label.box) for label in handle_names(scene)]
    taken += [grip(scene, each) for each in scene.overlay.handles]
    assert not box.contains(float(x), float(y))
    free = QRectF(x + 14, y - 10 - box.height(), box.width(), box.height())
    if QRectF(AREA.left + 4, AREA.top + 4, AREA.width - 8, AREA.height - 8).contains(free):
        assert covered(box, taken) <= covered(free, taken) + 1e-6


def test_with_room_the_words_stand_right_of_and_above_the_pointer(qapp):
    left, _top, _right, bottom = tag_box("(1, 2)", 200.0, 200.0, scene_with([]))
    assert (left, bottom) == pytest.approx((214.0, 190.0))
