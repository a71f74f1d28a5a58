"""What every page over the frames does: the ruler, the frame that is shown, how far ghosts reach, zoom.

An editor, so it paints itself. It changes nothing: it sends what a hand or the keyboard asks for.
"""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QResizeEvent,
    QShowEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from workbench.language import _, ngettext
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, theme_changed, tokens
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.rows import KeyShown, TimelineShown, TrackShown
from workbench.widgets.timeline.scale import RULER_PX, Scale

ZOOM = 1.25
_PAN_SHARE = 8
_CTRL = Qt.KeyboardModifier.ControlModifier
_SHIFT = Qt.KeyboardModifier.ShiftModifier


class FramesView(QWidget):
    """A page over the frames of an ``axis``, which it shares with other pages.

    ``frame_wanted`` sends a frame, ``track_chosen`` a target, ``reach_wanted`` how far the ghosts reach,
    ``play_wanted`` that it is played or stopped, ``page_wanted`` that the other page is.
    """

    frame_wanted = Signal(int)
    track_chosen = Signal(str)
    reach_wanted = Signal(int)
    play_wanted = Signal()
    page_wanted = Signal()

    def __init__(self, axis: FrameAxis, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.axis = axis
        self._shown = TimelineShown()
        self._doing = ""
        self._pressed = QPointF()
        self._panned = 0
        self._band = QRectF()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        axis.scaled.connect(self.update)
        axis.chosen.connect(self._tell)
        theme_changed.connect(self.update)

    # What a page adds

    def press(self, event: QMouseEvent) -> None:
        """The left button went down below the ruler."""
        raise NotImplementedError

    def drag(self, event: QMouseEvent) -> None:
        """A hand that has taken hold of something below the ruler has moved."""
        raise NotImplementedError

    def turn(self, turned: int, place: QPointF) -> None:
        """The wheel was turned, up (> 0) or down, at a place."""
        raise NotImplementedError

    # What is shown

    def show_tracks(self, shown: TimelineShown) -> None:
        """Show this from now on."""
        if shown == self._shown:
            return
        before, self._shown = self._shown, shown
        if shown.tracks is not before.tracks and self.axis.selected:
            self.axis.choose(self.axis.selected & {key.id for track in shown.tracks for key in track.keys})
        if shown.tracks is not before.tracks or shown.frames != before.frames:
            last = max((track.keys[-1].frame for track in shown.tracks if track.keys), default=0)
            self.axis.set_extent(max(shown.frames, last + 1))
        if shown.frame != before.frame and not self._doing:
            self.axis.reveal(shown.frame)
        self._tell()

    def _tell(self) -> None:
        self.setAccessibleDescription(self.reading)
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))
        self.update()

    @property
    def shown(self) -> TimelineShown:
        """What is shown."""
        return self._shown

    @property
    def scale(self) -> Scale:
        """Where frames lie."""
        return self.axis.scale

    @property
    def selected(self) -> frozenset[str]:
        """The ids of the keys that are chosen."""
        return self.axis.selected

    @property
    def track(self) -> TrackShown | None:
        """The chosen track."""
        return next((t for t in self._shown.tracks if t.target == self._shown.chosen), None)

    @property
    def key_here(self) -> KeyShown | None:
        """The key of the chosen track in the frame that is shown."""
        keys = self.track.keys if self.track is not None else ()
        return next((key for key in keys if key.frame == self._shown.frame), None)

    @property
    def reading(self) -> str:
        """The chosen track and the frame, as it is said."""
        track, key = self.track, self.key_here
        frame = _("frame {frame} of {last}").format(frame=self._shown.frame, last=self._shown.frames - 1)
        if track is None:
            return frame
        value = self._shown.values.get(track.target, "")
        words = [f"{track.label}: {value}", frame, *([_("a key"), key.words] if key else [])]
        if self.selected:
            count = len(self.selected)
            words.append(ngettext("{n} key chosen", "{n} keys chosen", count).format(n=count))
        return ", ".join(word for word in words if word)

    # Painting

    def paint_edges(self, painter: QPainter) -> None:
        """What lies over the page: the box that chooses, and that it has the focus."""
        painter.setPen(colour(tokens().accent))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if not self._band.isNull():
            painter.drawRect(self._band)
        if self.hasFocus():
            painter.drawRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """All frames stay seen, unless somebody has zoomed."""
        super().resizeEvent(event)
        self._take_width()

    def showEvent(self, event: QShowEvent) -> None:
        """The page that is seen says how wide the axis is."""
        super().showEvent(event)
        self._take_width()

    def _take_width(self) -> None:
        if self.isVisible():
            self.axis.set_width(self.width())

    # By hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A frame, an end of the ghosts, what the page has there; the middle button moves the page."""
        place = self._pressed = event.position()
        if event.button() == Qt.MouseButton.MiddleButton:
            self._doing, self._panned = "pan", self.scale.frame(place.x())
        elif event.button() != Qt.MouseButton.LeftButton:
            return
        elif place.y() < RULER_PX:
            self._doing = "reach" if self._at_reach(place.x()) else "frame"
            if self._doing == "frame":
                self._ask_frame(place.x())
        else:
            self.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what was begun."""
        place, scale = event.position(), self.scale
        if self._doing == "frame":
            self._ask_frame(place.x())
        elif self._doing == "reach":
            self.reach_wanted.emit(abs(scale.frame(place.x()) - self._shown.frame))
        elif self._doing == "pan":
            self.axis.pan(self._panned - scale.frame(place.x()))
        elif self._doing:
            self.drag(event)
        at_edge = place.y() < RULER_PX and self._at_reach(place.x())
        self.setCursor(Qt.CursorShape.SizeHorCursor if at_edge else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let go."""
        self._doing, self._band = "", QRectF()
        self.update()

    def _at_reach(self, x: float) -> bool:
        shown = self._shown
        ends = (shown.frame - shown.reach, shown.frame + shown.reach)
        return bool(shown.reach) and any(abs(self.scale.x(end) - x) <= 5 for end in ends)

    def _ask_frame(self, x: float) -> None:
        self.frame_wanted.emit(self._frame_near(x))

    def _frame_near(self, x: float) -> int:
        return min(max(self.scale.frame(x), 0), self._shown.frames - 1)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """With Ctrl zoom where the pointer is, with Shift, or sideways, go along the frames."""
        across, turned = event.angleDelta().x(), event.angleDelta().y()
        if event.modifiers() & _CTRL and turned:
            self.axis.zoom(ZOOM if turned > 0 else 1 / ZOOM, self._frame_near(event.position().x()))
        elif across or event.modifiers() & _SHIFT:
            seen = self.scale.last(self.width()) - self.scale.first
            far = max(seen // _PAN_SHARE, 1)
            self.axis.pan(-far if (across or turned) > 0 else far)
        elif turned:
            self.turn(turned, event.position())

    # By keyboard

    def event(self, event: QEvent) -> bool:
        """Its own keys are no commands of what stands around it: Delete takes keys and not figures."""
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and self.is_own(event):
            event.accept()
            return True
        return super().event(event)

    def is_own(self, event: QKeyEvent) -> bool:
        """Whether a key is for this page, whatever command has it elsewhere."""
        return is_plain(event) and (Qt.Key(event.key()) in _MOVES or Qt.Key(event.key()) in self._others())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go from frame to frame and from track to track, play, zoom, let the ghosts reach farther."""
        key, shown = Qt.Key(event.key()), self._shown
        if not is_plain(event):
            super().keyPressEvent(event)
        elif key in _MOVES:
            across, down = _MOVES[key]
            if down:
                self.choose_row(down)
            else:
                self._go(shown.frame + across * (10 if event.modifiers() & _SHIFT else 1))
        elif (do := self._others().get(key)) is not None:
            do()
        else:
            super().keyPressEvent(event)

    def _others(self) -> dict[Qt.Key, Callable[[], object]]:
        frame, reach = self._shown.frame, self._shown.reach
        return {
            Qt.Key.Key_Home: lambda: self._go(0),
            Qt.Key.Key_End: lambda: self._go(self._shown.frames - 1),
            Qt.Key.Key_Space: self.play_wanted.emit,
            Qt.Key.Key_C: self.page_wanted.emit,
            Qt.Key.Key_Plus: lambda: self.axis.zoom(ZOOM, frame),
            Qt.Key.Key_Minus: lambda: self.axis.zoom(1 / ZOOM, frame),
            Qt.Key.Key_F: self.fit_all,
            Qt.Key.Key_BracketLeft: lambda: self.reach_wanted.emit(max(reach - 1, 0)),
            Qt.Key.Key_BracketRight: lambda: self.reach_wanted.emit(reach + 1),
        }

    def fit_all(self) -> None:
        """Show all frames."""
        self.axis.fit()

    def _go(self, frame: int) -> None:
        self.frame_wanted.emit(min(max(frame, 0), self._shown.frames - 1))

    def choose_row(self, by: int) -> None:
        """Choose the track so many below the chosen one."""
        targets = [track.target for track in self._shown.tracks]
        if targets:
            row = targets.index(self._shown.chosen) + by if self._shown.chosen in targets else 0
            self.track_chosen.emit(targets[min(max(row, 0), len(targets) - 1)])


_MOVES = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
