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
    keep_area,
    move_keys,
    paste_keys,
    raise_keys,
    remove_keys,
    remove_time,
    scale_keys,
    set_correspondence,
    set_easing,
    set_key,
    set_motion,
    set_turning,
)
from workbench.document.motion.model import BEZIER_NAME, Key
from workbench.document.motion.tracks import motion_of
from workbench.language import _, ngettext
from workbench.panels.stage.gesture import Gesture
from workbench.session.session import Session
from workbench.widgets.timeline.frame_axis import FrameAxis
from workbench.widgets.timeline.rows import Handles


class KeyEdits(QObject):
    """Edits of the keys that are chosen on a timeline. ``said``: what was wrong, or what else has happened;
    ``done``: something was tried.
    """

    said = Signal(str)
    done = Signal()

    def __init__(self, session: Session, axis: FrameAxis, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._axis = session, axis
        self._gesture = Gesture(session)
        self._gesture.failed.connect(self.said)
        self._begun: Document | None = None
        self.copied: tuple[CopiedKey, ...] = ()

    @property
    def _sheet(self) -> str:
        return self._session.sheet.id

    def _edit(self, edit: Edit, name: str) -> None:
        try:
            self._session.apply(edit, name)
        except DocumentError as problem:
            self.said.emit(problem.short)
        self.done.emit()

    def set(self, target: str, frame: int) -> None:
        """Set a key with what is seen in a frame."""
        self._edit(set_key(self._sheet, target, frame), _("Set key"))

    # By hand, as one step of undo until it lets go

    def _show(self, edit: Edit, name: str) -> None:
        """Do an edit to the document with which the hand began, unless something else was done meanwhile."""
        if self._begun is None:
            self._begun = self._session.document
            self._gesture.begin()
        self._gesture.show(edit, name)
        self.done.emit()

    def drag(self, by: int) -> None:
        """Move the chosen keys by so many frames from where they were."""
        self._show(move_keys(self._sheet, self._axis.selected, by), _("Move keys"))

    def move(self, target: str, by: int, place: int, amount: float) -> None:
        """Move the chosen keys of a track by so many frames, and one of their numbers by an amount."""
        moved = move_keys(self._sheet, self._axis.selected, by)
        raised = raise_keys(self._sheet, target, self._axis.selected, place, amount)
        self._show(both(raised, moved) if amount else moved, _("Move keys"))

    def scale(self, factor: float, about: int) -> None:
        """Take the chosen keys so many times as far from a frame as they were."""
        self._show(scale_keys(self._sheet, self._axis.selected, factor, about), _("Scale keys"))

    def bend(self, key: Key | None, handles: Handles) -> None:
        """Give the easing of a key handles, x1, y1, x2, y2; one of another kind becomes a Bézier easing."""
        if key is not None:
            self.bend_all({key.id: handles})

    def bend_all(self, handles: Mapping[str, Handles]) -> None:
        """Give the easings of keys handles, by their ids."""
        keys = (key for track in motion_of(self._session.sheet).tracks for key in track.keys)
        if any(key.id in handles and key.easing != BEZIER_NAME for key in keys):
            self.said.emit(_("The easing is a Bézier easing now."))
        self._show(bend_keys(self._sheet, handles), _("Shape easing"))

    def drop(self) -> None:
        """The hand lets go; keys whose places were taken are told of."""
        if self._begun is not None and self._gesture.busy and not self._gesture.overtaken:
            self._tell_of_taken(self._begun)
        self._gesture.commit()
        self._begun = None

    def take_back(self) -> None:
        """Escape: all is as when the hand began."""
        self._gesture.cancel()
        self.done.emit()

    def _tell_of_taken(self, before: Document) -> None:
        count = len(_keys(before, self._sheet) - _keys(self._session.document, self._sheet))
        if count:
            sentence = ngettext(
                "{n} key was in the way and is replaced; undo brings it back.",
                "{n} keys were in the way and are replaced; undo brings them back.",
                count,
            )
            self.said.emit(sentence.format(n=count))

    def turn_outline(self, key: Key | None, shift: int) -> None:
        """Let vertex 0 of an outline go to another vertex of the next key."""
        if key is not None:
            self._show(set_correspondence(self._sheet, key.id, shift), _("Shift correspondence"))

    # By a command

    def turn_by(self, key: Key | None, turning: str) -> None:
        """Let a turn in space go on by quaternion or by Euler's angles."""
        if key is not None:
            self._edit(set_turning(self._sheet, [key.id], turning), _("Change rotation method"))

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
        self._edit(even_speed(self._sheet, target), _("Make the speed constant"))

    def keep_area(self, figure: str) -> None:
        """Let a figure that is squashed become as much wider."""
        self._edit(keep_area(self._sheet, figure), _("Keep the area"))

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
            self.said.emit(_("No keys have been copied; choose some and copy them."))
            return
        before = self._session.document
        self._edit(paste_keys(self._sheet, self.copied, self._session.frames.number), _("Paste keys"))
        self._tell_of_taken(before)


def _keys(document: Document, sheet: str) -> set[str]:
    """The ids of all keys on a sheet."""
    on = next((each for each in document.sheets if each.id == sheet), None)
    return {key.id for track in motion_of(on).tracks for key in track.keys} if on is not None else set()
