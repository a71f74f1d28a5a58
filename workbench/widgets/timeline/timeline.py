"""The timeline: tracks with keys over the frames, to drag, choose, ease and step along."""

from collections.abc import Collection, Iterator

from PySide6.QtCore import QPointF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.key_editor import KeyEditor
from workbench.widgets.timeline.painting import (
    KEY_PX,
    nothing_moves,
    paint_end,
    paint_frame,
    paint_ruler,
    paint_track,
)
from workbench.widgets.timeline.rows import KeyShown, TimelineShown
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX


class Timeline(KeyEditor):
    """One row for each track. ``scrolled``: other tracks are seen."""

    scrolled = Signal()

    def __init__(
        self, axis: FrameAxis, easings: Collection[tuple[str, str]], parent: QWidget | None = None
    ) -> None:
        super().__init__(axis, easings, parent)
        self._top = 0
        self.setAccessibleName(_("Timeline"))
        self.setMinimumHeight(RULER_PX + 3 * ROW_PX)
        self.setToolTip(
            _(
                "Drag the ruler to a frame, a key in time, or a box around keys; Ctrl+drag scales the chosen "
                "keys in time; double-click sets a key, and on a name opens its curve; Ctrl+wheel zooms, "
                "Shift+wheel goes along; arrows go from frame to frame and from track to track, Alt+arrows "
                "move keys, K sets one"
            )
        )

    def show_tracks(self, shown: TimelineShown) -> None:
        """Show this from now on; the chosen track stays in sight."""
        before = self.shown
        super().show_tracks(shown)
        self._top = max(min(self._top, len(shown.tracks) - 1), 0)
        if shown.chosen != before.chosen:
            self._reveal_chosen()

    @property
    def seen(self) -> tuple[str, ...]:
        """The targets of the tracks that are seen."""
        rows = int((self.height() - RULER_PX) // ROW_PX) + 1
        return tuple(track.target for track in self.shown.tracks[self._top : self._top + rows])

    def place_of(self, key: str) -> QPointF:
        """Where a key is painted. Raises: LookupError."""
        for each, place in self.keys_seen():
            if each.id == key:
                return place
        raise LookupError(key)

    def keys_seen(self) -> Iterator[tuple[KeyShown, QPointF]]:
        """The keys of all tracks, also of those that are scrolled away."""
        for number, track in enumerate(self.shown.tracks):
            y = self._row_top(number) + ROW_PX / 2
            for key in track.keys:
                yield key, QPointF(self.scale.x(key.frame), y)

    def _row_top(self, number: int) -> float:
        return RULER_PX + (number - self._top) * ROW_PX

    def _row_at(self, y: float) -> int:
        number = int((y - RULER_PX) // ROW_PX) + self._top
        return number if y >= RULER_PX and 0 <= number < len(self.shown.tracks) else -1

    def key_at(self, place: QPointF) -> KeyShown | None:
        """The key under a place, in its row."""
        row = self._row_at(place.y())
        keys = self.shown.tracks[row].keys if row >= 0 and place.x() > LABEL_PX - KEY_PX else ()
        near = min(keys, key=lambda key: abs(self.scale.x(key.frame) - place.x()), default=None)
        reach = max(KEY_PX + 2, 8)
        return near if near is not None and abs(self.scale.x(near.frame) - place.x()) <= reach else None

    def sizeHint(self) -> QSize:
        """The ruler and a few tracks."""
        return QSize(640, RULER_PX + 5 * ROW_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The tracks that are seen, under the ruler, and over them the frame."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        now, shown = tokens(), self.shown
        painter.fillRect(self.rect(), colour(now.surface))
        paint_end(painter, self.scale, shown, self.width(), self.height())
        for number in range(self._top, len(shown.tracks)):
            top = self._row_top(number)
            if top > self.height():
                break
            track = shown.tracks[number]
            chosen = track.target == shown.chosen
            value = shown.values.get(track.target, "")
            paint_track(painter, self.scale, track, value, top, self.width(), chosen, self.selected)
        if not shown.tracks:
            painter.setPen(colour(now.muted))
            page = self.rect().adjusted(0, RULER_PX, 0, 0)
            painter.drawText(page, Qt.AlignmentFlag.AlignCenter, nothing_moves())
        paint_ruler(painter, self.scale, shown, self.width())
        paint_frame(painter, self.scale, shown, self.height())
        self.paint_edges(painter)

    def press(self, event: QMouseEvent) -> None:
        """Choose the track, and take hold of keys or of a box around some."""
        row, key = self._row_at(event.position().y()), self.key_at(event.position())
        if row >= 0:
            self.track_chosen.emit(self.shown.tracks[row].target)
        self.take_key(key, event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Set a key; on the name of a track show its curve."""
        row, x = self._row_at(event.position().y()), event.position().x()
        if row >= 0 and x > LABEL_PX:
            self.key_wanted.emit(self.shown.tracks[row].target, self._frame_near(x))
        elif row >= 0:
            self.page_wanted.emit()

    def turn(self, turned: int, _place: QPointF) -> None:
        """Scroll through the tracks."""
        self._scroll_to(max(min(self._top - (1 if turned > 0 else -1), len(self.shown.tracks) - 1), 0))

    def _scroll_to(self, top: int) -> None:
        if top != self._top:
            self._top = top
            self.scrolled.emit()
            self.update()

    def _reveal_chosen(self) -> None:
        targets = [track.target for track in self.shown.tracks]
        if self.shown.chosen in targets:
            row = targets.index(self.shown.chosen)
            seen = max(int((self.height() - RULER_PX) // ROW_PX), 1)
            self._scroll_to(min(max(self._top, row - seen + 1), row))
