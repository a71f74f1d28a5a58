"""What every page with keys does: keys chosen, dragged and scaled in time, their menu, their commands."""

from collections.abc import Collection, Iterable

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QHelpEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QMenu, QToolTip, QWidget

from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.frames_view import FramesView
from workbench.widgets.timeline.rows import KeyShown
from workbench.widgets.timeline.scale import LABEL_PX, RULER_PX

_CTRL = Qt.KeyboardModifier.ControlModifier
_SHIFT = Qt.KeyboardModifier.ShiftModifier
_ALT = Qt.KeyboardModifier.AltModifier
_ALONG = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
_DRAGS = ("keys", "scale", "handle")
_OF_KEYS = frozenset(
    (
        *(Qt.Key.Key_K, Qt.Key.Key_Delete, Qt.Key.Key_Backspace),
        *(Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape),
    )
)


class KeyEditor(FramesView):
    """A page with keys. Which are chosen belongs to the axis.

    ``keys_dragged`` sends by how many frames the chosen keys are wanted from where they were pressed,
    ``keys_scaled`` how many times as far from which frame, ``keys_dropped`` that the hand let go,
    ``keys_put_back`` that all is wanted as before, ``key_wanted`` a target and a frame, ``easing_wanted`` the
    name of one, ``deletion_wanted``, ``copy_wanted`` and ``paste_wanted`` nothing more.
    """

    keys_dragged = Signal(int)
    keys_scaled = Signal(float, int)
    keys_dropped = Signal()
    keys_put_back = Signal()
    key_wanted = Signal(str, int)
    easing_wanted = Signal(str)
    deletion_wanted = Signal()
    copy_wanted = Signal()
    paste_wanted = Signal()

    def __init__(
        self, axis: FrameAxis, easings: Collection[tuple[str, str]], parent: QWidget | None = None
    ) -> None:
        super().__init__(axis, parent)
        self._easings = tuple(easings)
        self._still = 0

    # What a page adds

    def keys_seen(self) -> Iterable[tuple[KeyShown, QPointF]]:
        """The keys of this page, and where each is painted."""
        raise NotImplementedError

    def key_at(self, place: QPointF) -> KeyShown | None:
        """The key under a place."""
        raise NotImplementedError

    # By hand

    def take_key(self, key: KeyShown | None, event: QMouseEvent) -> None:
        """Take hold of a key and all that are chosen, or begin a box around some."""
        adding = bool(event.modifiers() & _SHIFT)
        if key is None:
            self._doing = "band" if event.position().x() > LABEL_PX else ""
            if not adding:
                self.axis.choose(())
        elif adding:
            self.axis.choose(self.selected ^ {key.id})
        else:
            self.axis.choose(self.selected if key.id in self.selected else (key.id,))
            self._still = self._far_end(key.frame)
            stretches = event.modifiers() & _CTRL and self._still != key.frame
            self._doing = "scale" if stretches else "keys"

    def _frames_chosen(self) -> list[int]:
        chosen = self.selected
        return [key.frame for track in self.shown.tracks for key in track.keys if key.id in chosen]

    def _far_end(self, frame: int) -> int:
        """The frame of the chosen key that is farthest from a frame."""
        return max(self._frames_chosen(), key=lambda other: abs(other - frame), default=frame)

    def drag(self, event: QMouseEvent) -> None:
        """Keys in time, or a box."""
        place, scale = event.position(), self.scale
        if self._doing == "scale":
            away = scale.frame(self._pressed.x()) - self._still
            if away:
                self.keys_scaled.emit((scale.frame(place.x()) - self._still) / away, self._still)
        elif self._doing == "keys":
            self.drag_keys(event)
        elif self._doing == "band":
            self._band = QRectF(self._pressed, place).normalized()
            self.axis.choose({key.id for key, at in self.keys_seen() if self._band.contains(at)})
            self.update()

    def drag_keys(self, event: QMouseEvent) -> None:
        """The hand that holds keys has moved."""
        self.keys_dragged.emit(self._frames_gone(event.position()))

    def _frames_gone(self, place: QPointF) -> int:
        """How many frames a hand is from where it was pressed."""
        return self.scale.frame(place.x()) - self.scale.frame(self._pressed.x())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if self._doing in _DRAGS:
            self.keys_dropped.emit()
        super().mouseReleaseEvent(event)

    def event(self, event: QEvent) -> bool:
        """A key tells its easing while it is pointed at."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            key = self.key_at(QPointF(event.pos()))
            if key is not None:
                words = _("Frame {frame}: {easing}").format(frame=key.frame, easing=key.words)
                QToolTip.showText(event.globalPos(), words, self)
                return True
        return super().event(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """What can be done with the chosen keys: the one under the pointer, or that of the frame shown."""
        by_key = event.reason() == QContextMenuEvent.Reason.Keyboard
        key = self.key_here if by_key else self.key_at(QPointF(event.pos()))
        if key is not None and key.id not in self.selected and not (by_key and self.selected):
            self.axis.choose((key.id,))
        if self.selected:
            here = QPointF(self.scale.x(self.shown.frame), RULER_PX)
            self.key_menu().popup(self.mapToGlobal(here.toPoint()) if by_key else event.globalPos())

    def key_menu(self) -> QMenu:
        """The easings, those of the chosen keys ticked, and what else is done with keys."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        keys = (key for track in self.shown.tracks for key in track.keys)
        ticked = {key.easing for key in keys if key.id in self.selected}
        for name, title in self._easings:
            easing = menu.addAction(title)
            easing.setCheckable(True)
            easing.setChecked(name in ticked)
            easing.triggered.connect(lambda _on, name=name: self.easing_wanted.emit(name))
        menu.addSeparator()
        menu.addAction(_("Copy keys")).triggered.connect(lambda: self.copy_wanted.emit())
        menu.addAction(_("Delete keys")).triggered.connect(lambda: self.deletion_wanted.emit())
        return menu

    # What Edit offers, while this has the focus

    def copy(self) -> bool:
        """Copy the chosen keys; False where none are."""
        if self.selected:
            self.copy_wanted.emit()
        return bool(self.selected)

    def cut(self) -> bool:
        """Copy the chosen keys and remove them; False where none are."""
        return self.copy() and self.delete_selected()

    def paste(self) -> None:
        """Paste keys in the frame that is shown."""
        self.paste_wanted.emit()

    def delete_selected(self) -> bool:
        """Remove the chosen keys, and never a figure."""
        self.deletion_wanted.emit()
        return True

    def select_all(self) -> None:
        """Choose all keys of this page."""
        self.axis.choose({key.id for key, _place in self.keys_seen()})

    # By keyboard

    def is_own(self, event: QKeyEvent) -> bool:
        """Those of the keys, too, with Ctrl the arrows and A, with Alt the arrows."""
        key = Qt.Key(event.key())
        if not is_plain(event):
            return key in _ALONG or (key == Qt.Key.Key_A and bool(event.modifiers() & _CTRL))
        return key in _OF_KEYS or super().is_own(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """With Alt the chosen keys in time, with Ctrl from key to key; set, choose and remove keys."""
        key, modifiers = Qt.Key(event.key()), event.modifiers()
        if key in _ALONG and modifiers & _ALT:
            self._shift(_ALONG[key], bool(modifiers & _SHIFT))
        elif key in _ALONG and modifiers & _CTRL:
            self._go_to_key(_ALONG[key])
        elif key == Qt.Key.Key_A and modifiers & _CTRL:
            self.select_all()
        elif not is_plain(event):
            super().keyPressEvent(event)
        elif key == Qt.Key.Key_K and self.shown.chosen:
            self.key_wanted.emit(self.shown.chosen, self.shown.frame)
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deletion_wanted.emit()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._choose_here()
        elif key == Qt.Key.Key_Escape and self._doing in _DRAGS:
            self.keys_put_back.emit()
        elif key == Qt.Key.Key_Escape and self.selected:
            self.axis.choose(())
        else:
            super().keyPressEvent(event)

    def _go_to_key(self, along: int) -> None:
        """Go to the key of the chosen track before or after the frame that is shown."""
        keys = self.track.keys if self.track is not None else ()
        ahead = [key.frame for key in keys if (key.frame - self.shown.frame) * along > 0]
        if ahead:
            self._go(min(ahead, key=lambda frame: abs(frame - self.shown.frame)))

    def _shift(self, along: int, stretching: bool) -> None:
        """Move the chosen keys by a frame, or take the last of them that much farther from the first."""
        frames = self._frames_chosen()
        if frames and not stretching:
            self.keys_dragged.emit(along)
            self.keys_dropped.emit()
        elif frames and max(frames) > min(frames):
            long = max(frames) - min(frames)
            self.keys_scaled.emit((long + along) / long, min(frames))
            self.keys_dropped.emit()

    def _choose_here(self) -> None:
        """Choose the key of the chosen track in the frame that is shown, or let it go."""
        if (key := self.key_here) is not None:
            self.axis.choose(self.selected ^ {key.id})
