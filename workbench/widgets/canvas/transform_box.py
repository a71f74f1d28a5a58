"""The box around what is selected on a canvas: it is moved, turned, scaled, sheared and mirrored by it.

It changes nothing itself: it tells what a drag makes of the plane.
"""

import math

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QKeyEvent, QMouseEvent

from workbench.geometry.conventions import round_half_up
from workbench.geometry.transform_box import (
    MOVE,
    PIVOT,
    SIDES,
    STEP,
    TURN,
    Keys,
    Motion,
    Point,
    motion,
    turned_about,
)
from workbench.widgets.canvas.pixel_canvas import ARROWS, CLICK_SLACK, PixelCanvas
from workbench.widgets.canvas.transform_frame import PIVOT_REACH_PX, TransformFrame
from workbench.widgets.canvas.transform_words import handle_name
from workbench.widgets.look.plain_keys import is_plain

_FAR = 10
_DEGREE = math.radians(1)
_ORDER = (MOVE, *SIDES, TURN, PIVOT)
_Mods = Qt.KeyboardModifier


class TransformBox(TransformFrame):
    """A box on ``canvas``, in device coordinates. Handles at corners and sides scale, the round one turns
    about the pivot, the inside moves. Shift keeps to 15 degrees, to the ratio, to one axis; Ctrl scales and
    shears about the pivot; with Alt, or after a click inside, the sides shear; Escape takes a drag back.

    ``began`` and ``ended`` or ``cancelled`` enclose ``changed``, which sends the matrix (3, 3) of what has
    happened since ``began``, its kind and its numbers (``geometry.transform_box.Motion``). ``pivot_moved``
    sends where the pivot is put.

    On the canvas's keys arrows move by one unit, Shift by ten; with Ctrl they scale about the pivot, with Alt
    or as ``[`` and ``]`` they turn by a degree, Shift by 15; Tab goes from handle to handle, which then is
    what arrows drag.
    """

    began = Signal(str)
    changed = Signal(object, str, object)
    ended = Signal()
    cancelled = Signal()
    pivot_moved = Signal(float, float)

    def __init__(self, canvas: PixelCanvas, whole_moves: bool = False) -> None:
        """``whole_moves``: it moves by whole units only, as pixels do."""
        super().__init__(canvas)
        self._whole_moves = whole_moves
        self._pressed_at = QPointF()
        self._pivot_before: Point = (0.0, 0.0)
        canvas.installEventFilter(self)

    # The pointer

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take the pointer and the keys of the canvas where they are the box's."""
        if self._box is None:
            return False
        match event:
            case QMouseEvent():
                return self._mouse(event)
            case QKeyEvent() if event.type() == QEvent.Type.KeyPress:
                return self._key(event)
            case QKeyEvent() if event.type() == QEvent.Type.ShortcutOverride and self._turns(event):
                event.accept()  # a command may have the same key while there is no box
                return True
        if event.type() in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self.looks_changed.emit()
        return False

    def _mouse(self, event: QMouseEvent) -> bool:
        left = event.button() == Qt.MouseButton.LeftButton
        match event.type():
            case QEvent.Type.MouseButtonPress if left:
                return self._press(event)
            case QEvent.Type.MouseMove if self._held:
                self._drag(event)
                return True
            case QEvent.Type.MouseMove if event.buttons() == Qt.MouseButton.NoButton:
                return self._hover(event.position())
            case QEvent.Type.MouseButtonRelease if left and self._held:
                self._release()
                return True
        return False

    def _press(self, event: QMouseEvent) -> bool:
        handle = self.handle_at(event.position())
        if not handle:
            return False
        self._canvas.setFocus(Qt.FocusReason.MouseFocusReason)
        self._canvas.forget_hover()  # what is beside the pointer now is how far it has come
        self._pressed_at = event.position()
        self._chosen = MOVE
        self._begin(handle, self._canvas.device_position(event.position()))
        return True

    def _begin(self, handle: str, start: Point) -> None:
        self._held = handle
        self._start = self._now = start
        self._moved = False
        self._pivot_before = self._pivot
        if handle != PIVOT:
            self.began.emit(handle)

    def _drag(self, event: QMouseEvent) -> None:
        away = (event.position() - self._pressed_at).manhattanLength()
        if not self._moved and away <= CLICK_SLACK:
            return
        self._moved = True
        self._canvas.edge.follow(event)
        self._to(self._canvas.device_position(event.position()), self._keys(event.modifiers()))

    def _to(self, now: Point, keys: Keys) -> None:
        """The handle held is at another place."""
        assert self._box is not None
        if self._whole_moves and self._held == MOVE:
            x, y = self._start
            now = x + round_half_up(now[0] - x), y + round_half_up(now[1] - y)
        self._now = now
        if self._held == PIVOT:
            self._put_pivot(now, keys)
            return
        self._tell(motion(self._box, self._pivot, self._held, self._start, now, keys))

    def _tell(self, made: Motion) -> None:
        self._motion = made
        self.changed.emit(made.matrix, made.kind, made.numbers)
        self.looks_changed.emit()  # last, so that what follows from the change is shown along with it

    def _put_pivot(self, now: Point, keys: Keys) -> None:
        """The pivot keeps to corners, sides and middle where it comes near, unless Ctrl is held."""
        assert self._box is not None
        x, y = (p + b - a for p, a, b in zip(self._pivot_before, self._start, now, strict=True))
        if not keys.about_pivot:
            snaps = [self._box.place(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
            nearest = min(snaps, key=lambda place: math.dist(place, (x, y)))
            if math.dist(nearest, (x, y)) <= PIVOT_REACH_PX * self._unit:
                x, y = nearest
        self._pivot = (x, y)
        self.pivot_moved.emit(x, y)
        self.looks_changed.emit()

    def _keys(self, modifiers: Qt.KeyboardModifier) -> Keys:
        return Keys(
            bool(modifiers & _Mods.ShiftModifier),
            bool(modifiers & _Mods.ControlModifier),
            self._shears or bool(modifiers & _Mods.AltModifier),
        )

    def _release(self) -> None:
        if self._held == MOVE and not self._moved:
            self._shears = not self._shears
        self._end()

    def _end(self) -> None:
        held, self._held = self._held, ""
        self._motion = None
        self._canvas.edge.stop()
        if held != PIVOT:
            self.ended.emit()
        self.looks_changed.emit()

    def _cancel(self) -> None:
        held, self._held = self._held, ""
        self._motion = None
        if held == PIVOT:
            self._pivot = self._pivot_before
            self.pivot_moved.emit(*self._pivot)
        else:
            self.cancelled.emit()
        self.looks_changed.emit()

    def _hover(self, position: QPointF) -> bool:
        handle = self.handle_at(position)
        if not handle:
            return False
        self._canvas.hover_at(*self._canvas.device_position(position))
        self._canvas.setCursor(self._cursor(handle))
        return True

    # The keys

    def _key(self, event: QKeyEvent) -> bool:
        if self._held:
            if event.key() == Qt.Key.Key_Escape:
                self._cancel()
            return True
        if self._canvas.cursor_cell is not None:
            return False
        shift = bool(event.modifiers() & _Mods.ShiftModifier)
        if event.key() in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            return self._choose_next(-1 if event.key() == Qt.Key.Key_Backtab or shift else 1)
        if self._turns(event):
            self._turn(_DEGREE if event.text() == "[" else -_DEGREE)
            return True
        if event.key() in ARROWS:
            self._arrow(*ARROWS[Qt.Key(event.key())], event.modifiers())
            return True
        return False

    def _turns(self, event: QKeyEvent) -> bool:
        """Whether a key turns by a degree."""
        return is_plain(event) and event.text() in ("[", "]") and self._canvas.cursor_cell is None

    def _choose_next(self, step: int) -> bool:
        """Go to the next handle; past the last one the key is the window's."""
        places = self.places()
        order = [name for name in _ORDER if name == MOVE or name in places]
        at = (order.index(self._chosen) if self._chosen in order else 0) + step
        if not 0 <= at < len(order):
            self._chosen = MOVE
            self.looks_changed.emit()
            return False
        self._chosen = order[at]
        self._announce(handle_name(self._chosen))
        self.looks_changed.emit()
        return True

    def _arrow(self, dx: int, dy: int, modifiers: Qt.KeyboardModifier) -> None:
        far = bool(modifiers & _Mods.ShiftModifier)
        if modifiers & _Mods.AltModifier and self._chosen == MOVE:
            self._turn((STEP if far else _DEGREE) * (-1 if dx > 0 or dy < 0 else 1))
            return
        handle, keys = self._chosen, Keys(shearing=self._shears or bool(modifiers & _Mods.AltModifier))
        if modifiers & _Mods.ControlModifier or handle == PIVOT:
            keys = keys._replace(about_pivot=True)  # for the pivot itself: it goes by single steps
            if handle == MOVE:
                handle = "right" if dx else "top"
        place = self.places().get(handle, self._pivot)
        by = _FAR if far else 1
        self._begin(handle, place)
        self._to((place[0] + by * dx, place[1] + by * dy), keys)
        self._finish_key()

    def _turn(self, angle: float) -> None:
        self._begin(TURN, self._pivot)
        self._tell(turned_about(self._pivot, angle))
        self._finish_key()

    def _finish_key(self) -> None:
        """A key is a drag that is over at once; what it did is announced."""
        moved = self._motion
        self._announce(self.words(moved) if moved is not None else self.pivot_words(*self._pivot))
        self._end()

    def _announce(self, text: str) -> None:
        self._canvas.setAccessibleDescription(text)
        QAccessible.updateAccessibility(QAccessibleEvent(self._canvas, QAccessible.Event.DescriptionChanged))
