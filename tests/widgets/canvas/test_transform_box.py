"""The box around what is selected, as a hand and as keys use it on a real canvas."""

import itertools
import math

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QAccessible, QColor, QMouseEvent
from PySide6.QtWidgets import QApplication

from workbench.algorithms.marks import Word
from workbench.geometry.transform_box import MOVE, PIVOT, SIDES, TURN, Box, Keys, motion
from workbench.widgets.canvas.drawing import PenStroke
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.canvas.transform_box import TransformBox
from workbench.widgets.canvas.transform_words import described
from workbench.widgets.look.tokens import DARK, LIGHT, theme

Mod, Key = Qt.KeyboardModifier, Qt.Key
NONE, SHIFT, CTRL, ALT = Mod.NoModifier, Mod.ShiftModifier, Mod.ControlModifier, Mod.AltModifier
BOX = Box(100, 75, 60, 40)


class Owner:
    """Keeps what a box tells, and puts it back on the canvas as a panel does."""

    def __init__(self, canvas):
        self.canvas, self.box = canvas, TransformBox(canvas)
        self.told, self.motions = [], []
        self.box.began.connect(lambda handle: self.told.append(f"began {handle}"))
        self.box.changed.connect(self._take)
        self.box.ended.connect(lambda: self.told.append("ended"))
        self.box.cancelled.connect(lambda: self.told.append("cancelled"))
        self.box.pivot_moved.connect(lambda x, y: self.told.append(("pivot", x, y)))
        self.box.looks_changed.connect(self.refresh)

    def _take(self, matrix, kind, numbers):
        self.told.append(kind)
        self.motions.append((matrix, numbers))

    def refresh(self):
        self.canvas.set_overlay(self.box.over(Overlay()))

    def at(self, handle):
        if handle == MOVE:
            return self.canvas.widget_position(BOX.x + 12, BOX.y + 9)
        return self.canvas.widget_position(*self.box.places()[handle])

    def send(self, kind, position, modifiers=NONE):
        move = kind == QEvent.Type.MouseMove
        down = (
            Qt.MouseButton.LeftButton if kind != QEvent.Type.MouseButtonRelease else Qt.MouseButton.NoButton
        )
        button = Qt.MouseButton.NoButton if move else Qt.MouseButton.LeftButton
        where = self.canvas.mapToGlobal(position)
        QApplication.sendEvent(self.canvas, QMouseEvent(kind, position, where, button, down, modifiers))

    def drag(self, handle, to, modifiers=NONE, release=True, off=None):
        """From a handle to a device point, in some steps."""
        off = off or QPointF()
        start, end = self.at(handle) + off, self.canvas.widget_position(*to) + off
        self.send(QEvent.Type.MouseButtonPress, start, modifiers)
        for k in (1, 2, 3, 4):
            self.send(QEvent.Type.MouseMove, start + (end - start) * (k / 4), modifiers)
        if release:
            self.send(QEvent.Type.MouseButtonRelease, end, modifiers)


@pytest.fixture
def owner(qtbot):
    canvas = PixelCanvas()
    qtbot.addWidget(canvas)
    canvas.set_picture(np.zeros((150, 200), np.uint32), 0)
    canvas.resize(900, 700)
    with qtbot.waitActive(canvas):
        canvas.show()
        canvas.activateWindow()
    made = Owner(canvas)
    made.box.set_box(BOX)
    canvas.setFocus()
    yield made
    theme.use(LIGHT)


def place_after(owner, point):
    return (owner.motions[-1][0] @ [*point, 1.0])[:2].tolist()


@pytest.mark.parametrize("handle", list(SIDES))
@pytest.mark.parametrize("off", [QPointF(0, 0), QPointF(5, -4), QPointF(-6, 5)])
def test_a_handle_is_taken_from_eight_pixels_around_and_follows_by_as_much(owner, handle, off):
    across, up = SIDES[handle]
    grip = BOX.place(across, up)
    to = grip[0] + 11, grip[1] + 7
    owner.drag(handle, to, off=off)
    assert owner.told == [f"began {handle}", *["scale"] * 4, "ended"]
    expected = (to[0] if across else grip[0], to[1] if up else grip[1])
    assert place_after(owner, grip) == pytest.approx(expected)
    assert place_after(owner, BOX.place(-across, -up)) == pytest.approx(BOX.place(-across, -up))


def test_the_round_handle_turns_about_the_pivot_and_shift_keeps_to_steps(owner):
    owner.drag(TURN, (BOX.x + 40, BOX.y + 41))
    assert owner.told == ["began turn", *["rotate"] * 4, "ended"]
    assert math.degrees(owner.motions[-1][1]["angle"]) == pytest.approx(-math.degrees(math.atan2(40, 41)))
    owner.drag(TURN, (BOX.x + 40, BOX.y + 41), SHIFT)
    assert math.degrees(owner.motions[-1][1]["angle"]) == pytest.approx(-45)
    assert place_after(owner, BOX.centre) == pytest.approx(BOX.centre)


def test_the_pivot_is_dragged_keeps_to_corners_and_is_turned_about(owner):
    corner = BOX.place(-1, -1)
    owner.drag(PIVOT, (corner[0] + 1, corner[1] - 1))
    assert owner.told[-1] == ("pivot", *corner)
    assert "ended" not in owner.told
    owner.drag(TURN, (30, 60))
    assert place_after(owner, corner) == pytest.approx(corner)
    assert owner.motions[-1][1]["angle"] != 0
    owner.drag(PIVOT, (20, 20))
    assert owner.box.pivot == pytest.approx((20, 20))
    before = owner.motions[-1]
    owner.drag("right", (150, 75), CTRL)
    assert owner.motions[-1] is not before
    assert place_after(owner, (20, 20)) == pytest.approx((20, 20))


def test_the_inside_moves_and_shift_keeps_to_an_axis(owner):
    owner.drag(MOVE, (BOX.x + 32, BOX.y + 19))
    assert owner.motions[-1][1] == pytest.approx({"dx": 20, "dy": 10})
    owner.drag(MOVE, (BOX.x + 32, BOX.y + 19), SHIFT)
    assert owner.motions[-1][1] == pytest.approx({"dx": 20, "dy": 0})


def test_a_side_shears_with_alt_and_after_a_click_inside(owner):
    owner.drag("top", (BOX.x + 20, 95), ALT)
    assert owner.motions[-1][1]["factor"] == pytest.approx(0.5)
    shapes = {h.id: h.shape for h in owner.canvas.overlay.handles}
    assert shapes["box/top"] == "square"
    owner.drag(MOVE, (BOX.x + 12, BOX.y + 9))
    shapes = {h.id: h.shape for h in owner.canvas.overlay.handles}
    assert (shapes["box/top"], shapes["box/top left"]) == ("diamond", "square")
    owner.drag("right", (130, 95))
    assert owner.told[-2:] == ["shear", "ended"]
    assert owner.motions[-1][1]["across"] == 0


def test_dragging_a_side_through_the_other_mirrors(owner):
    owner.drag("right", (10, 75), release=False)
    assert owner.motions[-1][1]["sx"] == pytest.approx(-1)
    (word,) = (each for each in owner.canvas.overlay.drawn if isinstance(each, Word))
    assert word.text == "mirror and scale −1 × 1 about (70, 75)"


def test_escape_takes_a_drag_back(qtbot, owner):
    owner.drag("top right", (190, 140), release=False)
    assert owner.box.dragging
    qtbot.keyClick(owner.canvas, Key.Key_Escape)
    assert owner.told[-1] == "cancelled"
    assert not owner.box.dragging
    count = len(owner.told)
    owner.send(QEvent.Type.MouseMove, owner.canvas.widget_position(20, 20))
    owner.send(QEvent.Type.MouseButtonRelease, owner.canvas.widget_position(20, 20))
    assert len(owner.told) == count
    corners = next(each for each in owner.canvas.overlay.drawn if isinstance(each, PenStroke)).points
    np.testing.assert_allclose(corners[:4], BOX.corners())
    owner.drag(PIVOT, (20, 20), release=False)
    qtbot.keyClick(owner.canvas, Key.Key_Escape)
    assert owner.box.pivot == BOX.centre


def test_what_is_outside_the_box_is_the_canvas_s(qtbot, owner):
    with qtbot.waitSignal(owner.canvas.pressed):
        owner.send(QEvent.Type.MouseButtonPress, owner.canvas.widget_position(10, 140))
    owner.send(QEvent.Type.MouseButtonRelease, owner.canvas.widget_position(10, 140))
    assert owner.told == []
    owner.box.set_box(None)
    with qtbot.waitSignal(owner.canvas.pressed):
        owner.send(QEvent.Type.MouseButtonPress, owner.canvas.widget_position(*BOX.centre))
    assert owner.canvas.overlay.handles == ()


@pytest.mark.parametrize(
    ("key", "modifiers", "kind", "numbers"),
    [
        (Key.Key_Right, NONE, "move", {"dx": 1, "dy": 0}),
        (Key.Key_Down, SHIFT, "move", {"dx": 0, "dy": -10}),
        (Key.Key_Right, CTRL, "scale", {"sx": 31 / 30, "sy": 1, "x": 100, "y": 75, "axis": 0}),
        (Key.Key_Down, CTRL, "scale", {"sx": 1, "sy": 19 / 20, "x": 100, "y": 75, "axis": 0}),
        (Key.Key_Left, ALT, "rotate", {"angle": math.radians(1), "x": 100, "y": 75}),
        (Key.Key_Right, ALT | SHIFT, "rotate", {"angle": math.radians(-15), "x": 100, "y": 75}),
        (Key.Key_BracketLeft, NONE, "rotate", {"angle": math.radians(1), "x": 100, "y": 75}),
        (Key.Key_BracketRight, NONE, "rotate", {"angle": math.radians(-1), "x": 100, "y": 75}),
    ],
)
def test_keys_do_what_a_drag_does_and_say_so(qtbot, owner, key, modifiers, kind, numbers):
    with qtbot.assertNotEmitted(owner.canvas.arrow):
        qtbot.keyClick(owner.canvas, key, modifiers)
    assert owner.told[1:] == [kind, "ended"]
    assert owner.motions[-1][1] == pytest.approx(numbers)
    interface = QAccessible.queryAccessibleInterface(owner.canvas)
    told = interface.text(QAccessible.Text.Description)
    assert told.startswith(kind)


def test_tab_walks_through_the_handles_and_arrows_drag_the_one_chosen(qtbot, owner):
    names = []
    for _number in range(len(owner.box.places())):
        qtbot.keyClick(owner.canvas, Key.Key_Tab)
        names.append(owner.canvas.accessibleDescription())
    assert len(set(names)) == len(owner.box.places()) == 10
    assert owner.canvas.hasFocus()
    qtbot.keyClick(owner.canvas, Key.Key_Up)
    assert owner.told == [("pivot", 100, 76)]
    for _number in range(3):
        qtbot.keyClick(owner.canvas, Key.Key_Backtab)
    assert owner.canvas.accessibleDescription().startswith("top left corner")
    assert [each.id for each in owner.canvas.overlay.handles if each.selected] == ["box/top left"]
    qtbot.keyClick(owner.canvas, Key.Key_Up)
    assert owner.told[-2:] == ["scale", "ended"]


def test_a_small_box_leaves_room_to_take_hold_of_its_inside(owner):
    unit = owner.canvas.widget_position(1, 0).x() - owner.canvas.widget_position(0, 0).x()
    for size, thick in itertools.product((0, 8, 20, 33, 40, 60, 400), (0, 0.5, 1)):
        small = Box(100, 75, size / unit, size * thick / unit)
        owner.box.set_box(small)
        places = [owner.canvas.widget_position(*place) for place in owner.box.places().values()]
        apart = [(a - b).manhattanLength() for k, a in enumerate(places) for b in places[:k]]
        assert min(apart) >= 16
        inside = owner.canvas.widget_position(small.x, small.y)
        assert owner.box.handle_at(inside) in (MOVE, PIVOT)
        for name, place in owner.box.places().items():
            assert owner.box.handle_at(owner.canvas.widget_position(*place) + QPointF(4, 4)) == name


@pytest.mark.parametrize("look", [LIGHT, DARK], ids=lambda each: each.name)
def test_the_box_is_seen_in_both_themes(owner, look):
    theme.use(look)
    image = owner.canvas.grab().toImage()
    accent, handle = QColor(look.accent), QColor(look.surface).name()
    for name in SIDES:
        at = owner.at(name).toPoint()
        around = [image.pixelColor(at.x() + dx, at.y()) for dx in range(-6, 7)]
        parts = [(each.red(), each.green(), each.blue()) for each in around]
        edge = (accent.red(), accent.green(), accent.blue())
        assert min(np.abs(np.subtract(part, edge)).max() for part in parts) < 80
        assert handle in [each.name() for each in around]


def test_a_turned_box_scales_in_its_own_directions(owner):
    turned = Box(100, 75, 60, 40, math.radians(30))
    owner.box.set_box(turned)
    grip = turned.place(1, 0)
    along = math.cos(math.radians(30)), math.sin(math.radians(30))
    owner.drag("right", (grip[0] + 30 * along[0], grip[1] + 30 * along[1]))
    assert owner.motions[-1][1]["sx"] == pytest.approx(1.5)
    assert owner.motions[-1][1]["sy"] == 1


@pytest.mark.parametrize(
    ("handle", "start", "now", "keys", "words"),
    [
        (TURN, (14, 8), (12, 8 + 2), Keys(), "rotate 90° about (12, 8)"),
        (MOVE, (0, 0), (3, -4.5), Keys(), "move by (3, −4.5)"),
        ("right", (14, 8), (16, 8), Keys(), "scale 1.5 × 1 about (10, 8)"),
        ("top right", (14, 10), (16, 12), Keys(constrained=True), "scale 1.5 about (10, 6)"),
        ("left", (10, 8), (18, 8), Keys(), "mirror and scale −1 × 1 about (14, 8)"),
        ("top", (12, 10), (14, 10), Keys(shearing=True), "shear 0.5, 26.6°, about (12, 6)"),
    ],
)
def test_what_a_drag_does_is_said_with_its_numbers(handle, start, now, keys, words):
    assert described(motion(Box(12, 8, 4, 4), (12, 8), handle, start, now, keys)) == words


@pytest.mark.parametrize(("room", "way", "long"), [(60, 1, 28), (25, 1, 18), (12, -1, 28)])
def test_the_round_handle_stays_in_sight_at_the_upper_edge(owner, room, way, long):
    canvas = owner.canvas
    top = canvas.device_position(QPointF(canvas.width() / 2, room))[1]
    box = Box(100, top - 10, 30, 20)
    owner.box.set_box(box)
    place = canvas.widget_position(*owner.box.places()[TURN])
    foot = canvas.widget_position(*box.place(0, way))
    assert foot.y() - place.y() == pytest.approx(way * long, abs=0.5)
    assert canvas.rect().contains(place.toPoint())
    owner.drag(TURN, (130, top - 8))
    assert "rotate" in owner.told
