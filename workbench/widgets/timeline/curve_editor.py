"""The curve editor: the numbers of the chosen track over the frames, with keys and handles to drag."""

from collections.abc import Collection, Iterator
from itertools import pairwise

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.timeline.curve_painting import (
    paint_curves,
    paint_handles,
    paint_key,
    paint_numbers,
    paint_title,
    paint_values,
)
from workbench.widgets.timeline.easing_curve import stays_between
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.frames_view import ZOOM
from workbench.widgets.timeline.key_editor import KeyEditor
from workbench.widgets.timeline.painting import KEY_PX, nothing_moves, paint_end, paint_frame, paint_ruler
from workbench.widgets.timeline.rows import CurveKey, CurveShown, Handles, KeyShown
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX
from workbench.widgets.timeline.value_scale import fitting_values, zoomed_values

Grip = tuple[str, int]
_GRAB_PX = 9
_SAMPLES = 400
_NUDGE = 0.02
_STEEPEST = 10.0
_OWN_KEYS = frozenset((Qt.Key.Key_H, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown))
_WITH_ALT = (Qt.Key.Key_Up, Qt.Key.Key_Down)


class CurveEditor(KeyEditor):
    """One line for each number of the chosen track. One number is chosen: its keys go up and down by hand.

    ``keys_moved`` sends by how many frames the chosen keys are wanted from where they were pressed, the place
    of the number, and by how much. ``handles_wanted`` sends handles, x1, y1, x2, y2, by the ids of keys;
    ``said`` why a handle goes no farther.
    """

    keys_moved = Signal(int, int, float)
    handles_wanted = Signal(object)
    said = Signal(str)

    def __init__(
        self, axis: FrameAxis, easings: Collection[tuple[str, str]], parent: QWidget | None = None
    ) -> None:
        self._curve = CurveShown()
        self._target = ""
        self._number = 0
        self._values = fitting_values(0.0, 1.0, RULER_PX, RULER_PX + 100)
        self._values_fit = True
        self._held: Grip | None = None
        self._begun: dict[str, Handles] = {}
        super().__init__(axis, easings, parent)
        self.setAccessibleName(_("Curve editor"))
        self.setMinimumHeight(RULER_PX + 3 * ROW_PX)
        self.setToolTip(
            _(
                "Drag a key in time and in value, a handle to ease, or a box around keys; the wheel zooms "
                "values, with Ctrl frames; the middle button moves the page; Alt+arrows move the chosen "
                "keys, H takes hold of a handle, Page Up and Page Down choose a number, F shows all"
            )
        )

    # What is shown

    def show_curve(self, target: str, curve: CurveShown) -> None:
        """Show the curve of a track from now on; values stay where they are while something is dragged."""
        if target != self._target:
            self._target, self._number, self._values_fit, self._held = target, 0, True, None
            self.axis.choose(self.selected & {key.id for key in curve.keys})
        if curve is not self._curve:
            self._curve = curve
            self._number = min(self._number, max(len(curve.names) - 1, 0))
            if self._held is not None and self._ends(self._held) is None:
                self._held = None
            self._keep_values()
            self._tell()

    @property
    def number(self) -> int:
        """The place of the chosen number."""
        return self._number

    def choose_number(self, number: int) -> None:
        """Choose the number whose keys go up and down."""
        self._number = min(max(number, 0), max(len(self._curve.names) - 1, 0))
        self._held = None
        self._tell()

    @property
    def reading(self) -> str:
        """The frame and the key, the number, and the handle that is held."""
        if not self._curve.names:
            return super().reading
        words = [super().reading, _("number {name}").format(name=self._curve.names[self._number])]
        if self._held is not None and (key := self._key(self._held[0])) is not None and key.handles:
            x, y = key.handles[2 * self._held[1] : 2 * self._held[1] + 2]
            side = _("first handle") if self._held[1] == 0 else _("second handle")
            words.append(_("{side} at {x:.3g}, {y:.3g}").format(side=side, x=x, y=y))
        return ", ".join(words)

    def _keep_values(self) -> None:
        if self._values_fit and not self._doing:
            self.fit_values()

    def fit_values(self) -> None:
        """Show all values of the track."""
        keys = self._curve.keys
        self._values_fit = True
        if keys and self._curve.names:
            frames = np.linspace(keys[0].frame, keys[-1].frame, _SAMPLES)
            values = np.concatenate([self._curve.sampled(frames), [key.values for key in keys]])
            ends = float(values.min()), float(values.max())
            self._values = fitting_values(*ends, RULER_PX, self.height())
        self.update()

    def fit_all(self) -> None:
        """Show all frames and all values."""
        self.axis.fit()
        self.fit_values()

    def _key(self, name: str) -> CurveKey | None:
        return next((key for key in self._curve.keys if key.id == name), None)

    def _ends(self, grip: Grip) -> tuple[CurveKey, CurveKey] | None:
        """The keys between which a handle eases; None where it is no longer there."""
        ways = pairwise(self._curve.keys)
        return next((way for way in ways if way[0].id == grip[0] and way[0].handles is not None), None)

    def place(self, key: CurveKey, number: int) -> QPointF:
        """Where a key is painted on the line of a number."""
        return QPointF(self.scale.x(key.frame), self._values.y(key.values[number]))

    def place_of(self, key: str) -> QPointF:
        """Where a key is painted on the line of the chosen number. Raises: LookupError."""
        own = self._key(key)
        if own is None:
            raise LookupError(key)
        return self.place(own, self._number)

    def keys_seen(self) -> Iterator[tuple[KeyShown, QPointF]]:
        """The keys on every line."""
        if self.track is not None:
            for shown, key in zip(self.track.keys, self._curve.keys, strict=False):
                for number in range(len(self._curve.names)):
                    yield shown, self.place(key, number)

    def handles_seen(self) -> dict[Grip, tuple[QPointF, QPointF]]:
        """The handles of the chosen keys, or else of the key before the frame: where its key is, and it."""
        keys = self._curve.keys
        here = [key.id for key in keys if key.frame <= self.shown.frame][-1:]
        chosen = self.selected or frozenset(here)
        grips: dict[Grip, tuple[QPointF, QPointF]] = {}
        for key, following in pairwise(keys):
            if key.id in chosen and key.handles is not None and self._curve.names:
                ends = self.place(key, self._number), self.place(following, self._number)
                for side, end in enumerate(ends):
                    grips[key.id, side] = end, self._handle_place(key, following, key.handles, side)
        return grips

    def _handle_place(self, key: CurveKey, following: CurveKey, handles: Handles, side: int) -> QPointF:
        x, y = handles[2 * side : 2 * side + 2]
        first, second = key.values[self._number], following.values[self._number]
        frame = key.frame + x * (following.frame - key.frame)
        return QPointF(self.scale.x(frame), self._values.y(first + y * (second - first)))

    # Painting

    def sizeHint(self) -> QSize:
        """Room for the curve of a few numbers."""
        return QSize(640, RULER_PX + 8 * ROW_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The lines with keys and handles, under the ruler, and over them the frame."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        now, curve, shown = tokens(), self._curve, self.shown
        painter.fillRect(self.rect(), colour(now.surface))
        plot = QRectF(LABEL_PX - KEY_PX, RULER_PX, self.width(), self.height() - RULER_PX)
        if curve.names and self.track is not None:
            paint_values(painter, self._values, self.width(), self.height())
            here = curve.sampled(np.array([float(shown.frame)]))[0].tolist()
            paint_numbers(painter, curve, tuple(here), self._number)
            painter.save()
            painter.setClipRect(plot)
            paint_end(painter, self.scale, shown, self.width(), self.height())
            paint_curves(painter, self.scale, self._values, curve, self.width(), self._number)
            for number in sorted(range(len(curve.names)), key=lambda each: each == self._number):
                for key, own in zip(self.track.keys, curve.keys, strict=False):
                    place, selected = self.place(own, number), key.id in self.selected
                    paint_key(painter, key, place, selected, number != self._number)
            paint_handles(painter, self.handles_seen(), self._held)
            painter.setPen(colour(now.text))
            painter.setBrush(colour(now.canvas))
            painter.drawEllipse(QPointF(self.scale.x(shown.frame), self._values.y(here[self._number])), 4, 4)
            painter.restore()
        else:
            painter.setPen(colour(now.muted))
            page = self.rect().adjusted(0, RULER_PX, 0, 0)
            painter.drawText(page, Qt.AlignmentFlag.AlignCenter, curve.note or nothing_moves())
        paint_ruler(painter, self.scale, shown, self.width())
        if self.track is not None:
            paint_title(painter, self.track.label)
        paint_frame(painter, self.scale, shown, self.height())
        self.paint_edges(painter)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """All values stay seen, unless somebody has zoomed."""
        super().resizeEvent(event)
        self._keep_values()

    def showEvent(self, event: QShowEvent) -> None:
        """Only keys that are seen here stay chosen."""
        super().showEvent(event)
        self.axis.choose(self.selected & {key.id for key in self._curve.keys})

    # By hand

    def _near(self, place: QPointF) -> tuple[KeyShown, int] | None:
        """The key under a place, and on the line of which number: of the chosen one where several are."""
        near: list[tuple[float, KeyShown, int]] = []
        shown = self.track.keys if self.track is not None and place.x() > LABEL_PX - KEY_PX else ()
        for key, own in zip(shown, self._curve.keys, strict=False):
            for number in range(len(self._curve.names)):
                away = (self.place(own, number) - place).manhattanLength()
                if away <= _GRAB_PX + KEY_PX:
                    near.append((away - (number == self._number) * _GRAB_PX, key, number))
        if not near:
            return None
        _away, key, number = min(near, key=lambda each: each[0])
        return key, number

    def key_at(self, place: QPointF) -> KeyShown | None:
        """The key under a place, on any line."""
        near = self._near(place)
        return None if near is None else near[0]

    def _grip_at(self, place: QPointF) -> Grip | None:
        away = {grip: (at - place).manhattanLength() for grip, (_key, at) in self.handles_seen().items()}
        grip = min(away, key=lambda each: away[each], default=None)
        return grip if grip is not None and away[grip] <= _GRAB_PX else None

    def press(self, event: QMouseEvent) -> None:
        """Take hold of a handle or of keys, choose a number, or begin a box around keys."""
        place = event.position()
        row = int((place.y() - RULER_PX) // ROW_PX)
        if place.x() < LABEL_PX - KEY_PX:
            self.choose_number(row if row < len(self._curve.names) else self._number)
        elif (grip := self._grip_at(place)) is not None:
            self._doing = "handle"
            self._hold(grip)
        else:
            self._held = None
            near = self._near(place)
            if near is not None:
                self._number = near[1]
            self.take_key(None if near is None else near[0], event)
            self._tell()

    def drag_keys(self, event: QMouseEvent) -> None:
        """Ask for the chosen keys where the hand is; with Shift only along, or only up and down."""
        place = event.position()
        by, up = self._frames_gone(place), (self._pressed.y() - place.y()) * self._values.by_pixel
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            way = place - self._pressed
            by, up = (by, 0.0) if abs(way.x()) > abs(way.y()) else (0, up)
        self.keys_moved.emit(by, self._number, self._rounded(up) if self._curve.raised else 0.0)

    def _rounded(self, value: float) -> float:
        step = self._values.rounding
        return round(round(value / step) * step, 12)

    def drag(self, event: QMouseEvent) -> None:
        """A handle, as long as it is there, or as elsewhere."""
        if self._doing != "handle":
            super().drag(event)
        elif self._held is not None and (ends := self._ends(self._held)) is not None:
            self._drag_handle(self._held[1], *ends, event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The page goes up and down with the hand, too."""
        if self._doing == "pan":
            self._values_fit = False
            lifted = (event.position().y() - self._pressed.y()) * self._values.by_pixel
            self._values = self._values._replace(middle=self._values.middle + lifted)
            self._pressed = event.position()
            self.update()
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go; what a drag has made larger is shown whole."""
        super().mouseReleaseEvent(event)
        self._keep_values()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Set a key."""
        if event.position().x() > LABEL_PX and event.position().y() > RULER_PX and self._target:
            self.key_wanted.emit(self._target, self._frame_near(event.position().x()))

    def _hold(self, grip: Grip | None) -> None:
        """Take hold of a handle; those of all chosen keys go with it."""
        self._held = grip
        names = self.selected if grip is not None and grip[0] in self.selected else (grip[0],) if grip else ()
        keys = (self._key(name) for name in names)
        self._begun = {key.id: key.handles for key in keys if key is not None and key.handles is not None}
        self._tell()

    def _drag_handle(self, side: int, key: CurveKey, following: CurveKey, place: QPointF) -> None:
        first, second = key.values[self._number], following.values[self._number]
        x_was, y_was = self._begun[key.id][2 * side : 2 * side + 2]
        scale = self.scale
        x = (place.x() - scale.x(key.frame)) / ((following.frame - key.frame) * scale.pixels)
        y = (self._values.value(place.y()) - first) / (second - first) if second != first else y_was
        self._bend(x - x_was, y - y_was)

    def _bend(self, dx: float, dy: float) -> None:
        """Ask for the handle that is held, and those that go with it, so far from where they were."""
        assert self._held is not None
        side = 2 * self._held[1]
        wanted: dict[str, Handles] = {}
        for name, begun in self._begun.items():
            handles = list(begun)
            x, y = begun[side] + dx, begun[side + 1] + dy
            if name == self._held[0] and not 0.0 <= x <= 1.0:
                self.said.emit(stays_between())
            handles[side] = round(min(max(x, 0.0), 1.0), 3)
            handles[side + 1] = round(min(max(y, -_STEEPEST), _STEEPEST), 3)
            wanted[name] = (handles[0], handles[1], handles[2], handles[3])
        self.handles_wanted.emit(wanted)

    def turn(self, turned: int, place: QPointF) -> None:
        """Zoom values where the pointer is."""
        self._zoom_values(ZOOM if turned > 0 else 1 / ZOOM, place.y())

    def _zoom_values(self, factor: float, y: float) -> None:
        self._values_fit = False
        self._values = zoomed_values(self._values, factor, y)
        self.update()

    # By keyboard

    def is_own(self, event: QKeyEvent) -> bool:
        """Its own, too."""
        alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        own = _OWN_KEYS if is_plain(event) else _WITH_ALT if alt else ()
        return super().is_own(event) or Qt.Key(event.key()) in own

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """As on the timeline; Alt with arrows moves keys up and down, too, or the handle that is held."""
        key, modifiers = Qt.Key(event.key()), event.modifiers()
        alt = bool(modifiers & Qt.KeyboardModifier.AltModifier)
        shift = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        across = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(key, 0)
        up = {Qt.Key.Key_Down: -1, Qt.Key.Key_Up: 1}.get(key, 0)
        if alt and (across or up) and self._held is not None:
            self._hold(self._held)
            self._bend(across * _NUDGE, up * _NUDGE)
            self.keys_dropped.emit()
        elif alt and up:
            if self.selected and self._curve.raised:
                by = up * self._values.rounding * (100 if shift else 10)
                self.keys_moved.emit(0, self._number, round(by, 12))
                self.keys_dropped.emit()
        elif not is_plain(event):
            super().keyPressEvent(event)
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            down = key == Qt.Key.Key_PageDown
            if shift:
                self._zoom_values(1 / ZOOM if down else ZOOM, (RULER_PX + self.height()) / 2)
            else:
                self.choose_number(self._number + (1 if down else -1))
        elif key == Qt.Key.Key_H:
            self._hold_next()
        elif key == Qt.Key.Key_Escape and self._held is not None and not self._doing:
            self._hold(None)
        else:
            super().keyPressEvent(event)

    def _hold_next(self) -> None:
        """Take hold of the next handle that is seen, after the last one of none."""
        grips = [*self.handles_seen(), None]
        at = grips.index(self._held) if self._held in grips else -1
        self._hold(grips[(at + 1) % len(grips)])
