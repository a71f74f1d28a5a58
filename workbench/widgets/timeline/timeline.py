"""The timeline: tracks with keys over the frames, to drag, choose, ease and step along.

An editor, so it paints itself. It changes nothing: it sends what a hand or the keyboard asks for.
"""

from collections.abc import Collection

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu, QWidget

from workbench.language import _, ngettext
from workbench.widgets.look.tokens import colour, theme_changed, tokens
from workbench.widgets.timeline.painting import KEY_PX, paint_frame, paint_ruler, paint_track
from workbench.widgets.timeline.rows import KeyShown, TimelineShown
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX, Scale, fitting, zoomed

_ZOOM = 1.25
_OWN_KEYS = frozenset(
    (
        *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Home, Qt.Key.Key_End),
        *(Qt.Key.Key_K, Qt.Key.Key_Delete, Qt.Key.Key_Backspace, Qt.Key.Key_Space),
        *(Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape),
    )
)


class Timeline(QWidget):
    """One row for each track. The keys that are chosen belong to this view.

    ``frame_wanted`` sends a frame, ``track_chosen`` a target, ``keys_dragged`` by how many frames the chosen
    keys are wanted from where they were pressed, ``keys_scaled`` how many times as far from which frame,
    ``keys_dropped`` that the hand let go, ``key_wanted`` a target and a frame, ``deletion_wanted`` nothing
    more, ``easing_wanted`` the name of one, ``reach_wanted`` how far the ghosts reach, ``play_wanted`` that
    it is played or stopped; ``scrolled``: other tracks are seen.
    """

    frame_wanted = Signal(int)
    track_chosen = Signal(str)
    keys_dragged = Signal(int)
    keys_scaled = Signal(float, int)
    keys_dropped = Signal()
    key_wanted = Signal(str, int)
    deletion_wanted = Signal()
    easing_wanted = Signal(str)
    reach_wanted = Signal(int)
    play_wanted = Signal()
    selection_changed = Signal()
    scrolled = Signal()

    def __init__(self, easings: Collection[tuple[str, str]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._easings = tuple(easings)
        self._shown = TimelineShown()
        self._scale = fitting(1, 640)
        self._fits = True
        self._top = 0
        self._selected: frozenset[str] = frozenset()
        self._doing = ""
        self._still = 0
        self._pressed = QPointF()
        self._band = QRectF()
        self.setAccessibleName(_("Timeline"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumHeight(RULER_PX + 3 * ROW_PX)
        self.setMouseTracking(True)
        self.setToolTip(
            _(
                "Drag the ruler to a frame, a key in time, or a box around keys; Ctrl+drag scales the chosen "
                "keys in time; double-click sets a key; "
                "arrows go from frame to frame and from track to track, Alt+arrows move keys, K sets one"
            )
        )
        theme_changed.connect(self.update)

    # What is shown

    def show_tracks(self, shown: TimelineShown) -> None:
        """Show this from now on."""
        if shown == self._shown:
            return
        before, self._shown = self._shown, shown
        if shown.tracks is not before.tracks and self._selected:
            self._choose_keys(self._selected & {key.id for track in shown.tracks for key in track.keys})
        if shown.frames != before.frames and (self._fits or shown.frames < self._scale.first):
            self.fit()
        self._top = max(min(self._top, len(shown.tracks) - 1), 0)
        self.setAccessibleDescription(self.reading)
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))
        self.update()

    @property
    def shown(self) -> TimelineShown:
        """What is shown."""
        return self._shown

    @property
    def seen(self) -> tuple[str, ...]:
        """The targets of the tracks that are seen."""
        rows = int((self.height() - RULER_PX) // ROW_PX) + 1
        return tuple(track.target for track in self._shown.tracks[self._top : self._top + rows])

    @property
    def scale(self) -> Scale:
        """Where frames lie."""
        return self._scale

    @property
    def selected(self) -> frozenset[str]:
        """The ids of the keys that are chosen."""
        return self._selected

    @property
    def reading(self) -> str:
        """The chosen track and the frame, as it is said."""
        track = next((t for t in self._shown.tracks if t.target == self._shown.chosen), None)
        frame = _("frame {frame} of {last}").format(frame=self._shown.frame, last=self._shown.frames - 1)
        if track is None:
            return frame
        key = next((key for key in track.keys if key.frame == self._shown.frame), None)
        value = self._shown.values.get(track.target, "")
        words = [f"{track.label}: {value}", frame, *([_("a key"), key.words] if key else [])]
        if self._selected:
            count = len(self._selected)
            words.append(ngettext("{n} key chosen", "{n} keys chosen", count).format(n=count))
        return ", ".join(word for word in words if word)

    def choose(self, keys: Collection[str]) -> None:
        """Choose these keys."""
        self._choose_keys(frozenset(keys))

    def _choose_keys(self, keys: frozenset[str]) -> None:
        if keys != self._selected:
            self._selected = keys
            self.setAccessibleDescription(self.reading)
            self.selection_changed.emit()
            self.update()

    def fit(self) -> None:
        """Show all frames."""
        self._fits = True
        self._scale = fitting(self._shown.frames, self.width())
        self.update()

    def zoom(self, factor: float) -> None:
        """Show frames ``factor`` times as wide, around the one that is shown."""
        self._scale = zoomed(self._scale, factor, self._shown.frame, self._shown.frames, self.width())
        self._fits = self._scale == fitting(self._shown.frames, self.width())
        self.update()

    def place_of(self, key: str) -> QPointF:
        """Where a key is painted. Raises: LookupError."""
        for number, track in enumerate(self._shown.tracks):
            for each in track.keys:
                if each.id == key:
                    return QPointF(self._scale.x(each.frame), self._row_top(number) + ROW_PX / 2)
        raise LookupError(key)

    def _row_top(self, number: int) -> float:
        return RULER_PX + (number - self._top) * ROW_PX

    def _row_at(self, y: float) -> int:
        number = int((y - RULER_PX) // ROW_PX) + self._top
        return number if y >= RULER_PX and 0 <= number < len(self._shown.tracks) else -1

    def _key_at(self, place: QPointF) -> KeyShown | None:
        row = self._row_at(place.y())
        keys = self._shown.tracks[row].keys if row >= 0 and place.x() > LABEL_PX - KEY_PX else ()
        near = min(keys, key=lambda key: abs(self._scale.x(key.frame) - place.x()), default=None)
        reach = max(KEY_PX + 2, 8)
        return near if near is not None and abs(self._scale.x(near.frame) - place.x()) <= reach else None

    # Painting

    def sizeHint(self) -> QSize:
        """The ruler and a few tracks."""
        return QSize(640, RULER_PX + 5 * ROW_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The tracks that are seen, under the ruler, and over them the frame."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        now, shown = tokens(), self._shown
        painter.fillRect(self.rect(), colour(now.surface))
        for number in range(self._top, len(shown.tracks)):
            top = self._row_top(number)
            if top > self.height():
                break
            track = shown.tracks[number]
            chosen = track.target == shown.chosen
            value = shown.values.get(track.target, "")
            paint_track(painter, self._scale, track, value, top, self.width(), chosen, self._selected)
        if not shown.tracks:
            painter.setPen(colour(now.muted))
            words = _("Nothing moves yet. Turn auto-key on, go to another frame, and move a figure.")
            painter.drawText(self.rect().adjusted(0, RULER_PX, 0, 0), Qt.AlignmentFlag.AlignCenter, words)
        paint_ruler(painter, self._scale, shown, self.width())
        paint_frame(painter, self._scale, shown, self.height())
        if not self._band.isNull():
            painter.setPen(colour(now.accent))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(self._band)
        if self.hasFocus():
            painter.setPen(colour(now.accent))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """All frames stay seen, unless somebody has zoomed."""
        super().resizeEvent(event)
        if self._fits:
            self.fit()

    # By hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A frame, an end of the ghosts, keys, or a box around some."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        place = self._pressed = event.position()
        if place.y() < RULER_PX:
            self._doing = "reach" if self._at_reach(place.x()) else "frame"
            if self._doing == "frame":
                self._ask_frame(place.x())
            return
        row, key = self._row_at(place.y()), self._key_at(place)
        if row >= 0:
            self.track_chosen.emit(self._shown.tracks[row].target)
        adding = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if key is None:
            self._doing = "band" if place.x() > LABEL_PX else ""
            if not adding:
                self._choose_keys(frozenset())
        elif adding:
            self._choose_keys(self._selected ^ {key.id})
        else:
            self._choose_keys(self._selected if key.id in self._selected else frozenset({key.id}))
            self._still = self._far_end(key.frame)
            stretches = event.modifiers() & Qt.KeyboardModifier.ControlModifier and self._still != key.frame
            self._doing = "scale" if stretches else "keys"

    def _far_end(self, frame: int) -> int:
        """The frame of the chosen key that is farthest from a frame."""
        keys = (key for track in self._shown.tracks for key in track.keys if key.id in self._selected)
        return max((key.frame for key in keys), key=lambda other: abs(other - frame), default=frame)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what was begun."""
        place = event.position()
        if self._doing == "frame":
            self._ask_frame(place.x())
        elif self._doing == "reach":
            self.reach_wanted.emit(max(abs(self._scale.frame(place.x()) - self._shown.frame), 0))
        elif self._doing == "scale":
            away = self._scale.frame(self._pressed.x()) - self._still
            self.keys_scaled.emit((self._scale.frame(place.x()) - self._still) / away, self._still)
        elif self._doing == "keys":
            self.keys_dragged.emit(self._scale.frame(place.x()) - self._scale.frame(self._pressed.x()))
        elif self._doing == "band":
            self._band = QRectF(self._pressed, place).normalized()
            self._choose_keys(frozenset(self._inside(self._band)))
            self.update()
        at_edge = place.y() < RULER_PX and self._at_reach(place.x())
        self.setCursor(Qt.CursorShape.SizeHorCursor if at_edge else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let go."""
        if self._doing in ("keys", "scale"):
            self.keys_dropped.emit()
        self._doing, self._band = "", QRectF()
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Set a key."""
        row = self._row_at(event.position().y())
        if row >= 0 and event.position().x() > LABEL_PX:
            frame = min(max(self._scale.frame(event.position().x()), 0), self._shown.frames - 1)
            self.key_wanted.emit(self._shown.tracks[row].target, frame)

    def _inside(self, band: QRectF) -> list[str]:
        return [
            key.id
            for number, track in enumerate(self._shown.tracks)
            for key in track.keys
            if band.contains(QPointF(self._scale.x(key.frame), self._row_top(number) + ROW_PX / 2))
        ]

    def _at_reach(self, x: float) -> bool:
        shown = self._shown
        ends = (shown.frame - shown.reach, shown.frame + shown.reach)
        return bool(shown.reach) and any(abs(self._scale.x(end) - x) <= 5 for end in ends)

    def _ask_frame(self, x: float) -> None:
        self.frame_wanted.emit(min(max(self._scale.frame(x), 0), self._shown.frames - 1))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll through the tracks; with Ctrl zoom."""
        turned = event.angleDelta().y()
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.zoom(_ZOOM if turned > 0 else 1 / _ZOOM)
        elif turned:
            self._top = max(min(self._top - (1 if turned > 0 else -1), len(self._shown.tracks) - 1), 0)
            self.scrolled.emit()
            self.update()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """What can be done with the chosen keys."""
        key = self._key_at(QPointF(event.pos()))
        if key is not None and key.id not in self._selected:
            self._choose_keys(frozenset({key.id}))
        if self._selected:
            self.key_menu().popup(event.globalPos())

    def key_menu(self) -> QMenu:
        """The easings, and Delete."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for name, title in self._easings:
            menu.addAction(title).triggered.connect(lambda _on, name=name: self.easing_wanted.emit(name))
        menu.addSeparator()
        menu.addAction(_("Delete keys")).triggered.connect(lambda: self.deletion_wanted.emit())
        return menu

    # By keyboard

    def event(self, event: QEvent) -> bool:
        """Its own keys are no commands of what stands around it: Delete takes keys and not figures."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            plain = not event.modifiers() & Qt.KeyboardModifier.ControlModifier
            if plain and Qt.Key(event.key()) in _OWN_KEYS:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows, Home and End, K, Delete, Space, and the menu of the chosen keys."""
        key, shown = Qt.Key(event.key()), self._shown
        moves = {
            Qt.Key.Key_Left: shown.frame - 1,
            Qt.Key.Key_Right: shown.frame + 1,
            Qt.Key.Key_Home: 0,
            Qt.Key.Key_End: shown.frames - 1,
        }
        if key in moves and event.modifiers() & Qt.KeyboardModifier.AltModifier and self._selected:
            self.keys_dragged.emit(-1 if key == Qt.Key.Key_Left else 1)
            self.keys_dropped.emit()
        elif key in moves:
            self.frame_wanted.emit(min(max(moves[key], 0), shown.frames - 1))
        elif key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self._choose_row(-1 if key == Qt.Key.Key_Up else 1)
        elif key == Qt.Key.Key_K and shown.chosen:
            self.key_wanted.emit(shown.chosen, shown.frame)
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deletion_wanted.emit()
        elif key == Qt.Key.Key_Space:
            self.play_wanted.emit()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._choose_here()
        elif key == Qt.Key.Key_Escape and self._selected:
            self._choose_keys(frozenset())
        else:
            super().keyPressEvent(event)

    def _choose_row(self, by: int) -> None:
        targets = [track.target for track in self._shown.tracks]
        if not targets:
            return
        row = targets.index(self._shown.chosen) + by if self._shown.chosen in targets else 0
        row = min(max(row, 0), len(targets) - 1)
        seen = max(int((self.height() - RULER_PX) // ROW_PX), 1)
        self._top = min(max(self._top, row - seen + 1), row)
        self.track_chosen.emit(targets[row])

    def _choose_here(self) -> None:
        """Choose the key of the chosen track in the frame that is shown, or let it go."""
        track = next((t for t in self._shown.tracks if t.target == self._shown.chosen), None)
        here = {key.id for key in track.keys if key.frame == self._shown.frame} if track else set()
        self._choose_keys(self._selected ^ here)
