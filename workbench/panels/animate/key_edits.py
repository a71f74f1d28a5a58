"""What is done to the keys of a session: set, dragged, scaled in time, eased, removed, copied and pasted."""

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal

from workbench.document.building import Edit, both
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.motion.edits import (
    CopiedKey,
    bend_keys,
    copied_keys,
    even_speed,
    insert_time,
    move_keys,
    paste_keys,
    raise_keys,
    remove_keys,
    remove_time,
    scale_keys,
    set_easing,
    set_key,
    set_motion,
)
from workbench.document.motion.model import BEZIER_NAME, Key
from workbench.document.motion.tracks import motion_of
from workbench.language import _, ngettext
from workbench.session.session import Session
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.rows import Handles

_DRAG = "drag keys"
_EASE = "shape easing"
_BEZIER_NOW = _("The easing is a Bézier easing now.")


class KeyEdits(QObject):
    """Edits of the keys that are chosen on a timeline. ``said``: what was wrong, or what else has happened;
    ``done``: something was tried.
    """

    said = Signal(str)
    done = Signal()

    def __init__(self, session: Session, axis: FrameAxis, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._axis = session, axis
        self._before: Document | None = None
        self.copied: tuple[CopiedKey, ...] = ()

    @property
    def _sheet(self) -> str:
        return self._session.sheet.id

    def _edit(self, edit: Edit, name: str, merge: str = "", on: Document | None = None) -> None:
        try:
            self._session.apply(edit, name, merge, on)
        except DocumentError as problem:
            self.said.emit(problem.short)
        self.done.emit()

    def set(self, target: str, frame: int) -> None:
        """Set a key with what is seen in a frame."""
        self._edit(set_key(self._sheet, target, frame), _("Set key"))

    # By hand, as one step of undo until it lets go

    def drag(self, by: int) -> None:
        """Move the chosen keys by so many frames from where they were."""
        self._edit(move_keys(self._sheet, self._axis.selected, by), _("Move keys"), _DRAG, self._begun)

    def move(self, target: str, by: int, place: int, amount: float) -> None:
        """Move the chosen keys of a track by so many frames, and one of their numbers by an amount."""
        moved = move_keys(self._sheet, self._axis.selected, by)
        raised = raise_keys(self._sheet, target, self._axis.selected, place, amount)
        self._edit(both(raised, moved) if amount else moved, _("Move keys"), _DRAG, self._begun)

    def scale(self, factor: float, about: int) -> None:
        """Take the chosen keys so many times as far from a frame as they were."""
        edit = scale_keys(self._sheet, self._axis.selected, factor, about)
        self._edit(edit, _("Scale keys"), _DRAG, self._begun)

    @property
    def _begun(self) -> Document:
        """The document with which the hand began."""
        if self._before is None:
            self._before = self._session.document
        return self._before

    def drop(self) -> None:
        """The hand lets go; keys whose places were taken are told of."""
        if self._before is not None:
            self._tell_of_taken(self._before)
        self._before = None
        self._session.end_merge()

    def _tell_of_taken(self, before: Document) -> None:
        count = len(_keys(before, self._sheet) - _keys(self._session.document, self._sheet))
        if count:
            sentence = ngettext(
                "{n} key was in the way and is replaced; undo brings it back.",
                "{n} keys were in the way and are replaced; undo brings them back.",
                count,
            )
            self.said.emit(sentence.format(n=count))

    def bend_all(self, handles: Mapping[str, Handles]) -> None:
        """Give the easings of keys handles, x1, y1, x2, y2, by their ids."""
        track_keys = (key for track in motion_of(self._session.sheet).tracks for key in track.keys)
        if any(key.id in handles and key.easing != BEZIER_NAME for key in track_keys):
            self.said.emit(_BEZIER_NOW)
        self._edit(bend_keys(self._sheet, handles), _("Shape easing"), _EASE, self._begun)

    def bend(self, key: Key | None, handles: tuple[float, float, float, float]) -> None:
        """Give the easing of a key handles, x1, y1, x2, y2; one of another kind becomes a Bézier easing."""
        if key is None:
            return
        if key.easing != BEZIER_NAME:
            self.said.emit(_BEZIER_NOW)
        shape = dict(zip(("x1", "y1", "x2", "y2"), handles, strict=True))
        self._edit(set_easing(self._sheet, [key.id], BEZIER_NAME, **shape), _("Shape easing"), _EASE)

    # By a command

    def delete(self) -> None:
        """Remove the chosen keys."""
        if keys := self._axis.selected:
            self._edit(remove_keys(self._sheet, keys), _("Delete keys"))

    def ease(self, easing: str) -> None:
        """Give the chosen keys an easing."""
        if keys := self._axis.selected:
            self._edit(set_easing(self._sheet, keys, easing), _("Change easing"))

    def ease_interval(self, key: Key | None, easing: str) -> None:
        """Give one key an easing."""
        if key is not None:
            self._edit(set_easing(self._sheet, [key.id], easing), _("Change easing"))

    def even_speed(self, target: str) -> None:
        """Let a track take its ways in times as they are long."""
        self._edit(even_speed(self._sheet, target), _("Even the speed"))

    def insert_time(self) -> None:
        """Put one frame before the one that is shown."""
        self._edit(insert_time(self._sheet, self._session.frames.number, 1), _("Insert a frame"))

    def remove_time(self) -> None:
        """Take the frame that is shown away, with its keys."""
        self._edit(remove_time(self._sheet, self._session.frames.number, 1), _("Remove a frame"))

    def set_motion(self, frames: int | None = None, rate: float | None = None) -> None:
        """Change how many frames there are, or how many a second has."""
        self._edit(set_motion(self._sheet, frames, rate), _("Change length or rate"))

    def copy(self) -> None:
        """Keep the chosen keys for pasting."""
        self.copied = copied_keys(self._session.document, self._sheet, self._axis.selected)
        count = len(self.copied)
        self.said.emit(ngettext("{n} key is copied.", "{n} keys are copied.", count).format(n=count))

    def paste(self) -> None:
        """Put the keys that were copied on their tracks, the first of them in the frame that is shown."""
        if not self.copied:
            self.said.emit(_("No keys are copied; choose some and copy them."))
            return
        before = self._session.document
        self._edit(paste_keys(self._sheet, self.copied, self._session.frames.number), _("Paste keys"))
        self._tell_of_taken(before)


def _keys(document: Document, sheet: str) -> set[str]:
    """The ids of all keys on a sheet."""
    on = next((each for each in document.sheets if each.id == sheet), None)
    return {key.id for track in motion_of(on).tracks for key in track.keys} if on is not None else set()
