"""What is done to the keys of a session: set, dragged, scaled in time, eased, removed, copied and pasted."""

from PySide6.QtCore import QObject, Signal

from workbench.document.building import Edit
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.motion.edits import (
    CopiedKey,
    copied_keys,
    even_speed,
    insert_time,
    keep_area,
    move_keys,
    paste_keys,
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
from workbench.language import _, ngettext
from workbench.session.session import Session
from workbench.widgets.timeline.timeline import Timeline

_DRAG = "drag keys"
_EASE = "shape easing"
_MEET = "turn correspondence"


class KeyEdits(QObject):
    """Edits of the keys that are chosen on a timeline. ``said``: what was wrong, or what else has happened;
    ``done``: something was tried.
    """

    said = Signal(str)
    done = Signal()

    def __init__(self, session: Session, timeline: Timeline, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._timeline = session, timeline
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
        self._edit(move_keys(self._sheet, self._timeline.selected, by), _("Move keys"), _DRAG, self._begun)

    def scale(self, factor: float, about: int) -> None:
        """Take the chosen keys so many times as far from a frame as they were."""
        edit = scale_keys(self._sheet, self._timeline.selected, factor, about)
        self._edit(edit, _("Scale keys"), _DRAG, self._begun)

    @property
    def _begun(self) -> Document:
        """The document with which the hand began."""
        if self._before is None:
            self._before = self._session.document
        return self._before

    def drop(self) -> None:
        """The hand lets go."""
        self._before = None
        self._session.end_merge()

    def bend(self, key: Key | None, handles: tuple[float, float, float, float]) -> None:
        """Give the easing of a key handles, x1, y1, x2, y2; one of another kind becomes a Bézier easing."""
        if key is None:
            return
        if key.easing != BEZIER_NAME:
            self.said.emit(_("The easing is a Bézier easing now."))
        shape = dict(zip(("x1", "y1", "x2", "y2"), handles, strict=True))
        self._edit(set_easing(self._sheet, [key.id], BEZIER_NAME, **shape), _("Shape easing"), _EASE)

    def turn_outline(self, key: Key | None, shift: int) -> None:
        """Let vertex 0 of an outline go to another vertex of the next key."""
        if key is not None:
            self._edit(set_correspondence(self._sheet, key.id, shift), _("Turn correspondence"), _MEET)

    # By a command

    def turn_by(self, key: Key | None, turning: str) -> None:
        """Let a turn in space go on by quaternion or by Euler's angles."""
        if key is not None:
            self._edit(set_turning(self._sheet, [key.id], turning), _("Change turning"))

    def delete(self) -> None:
        """Remove the chosen keys."""
        if keys := self._timeline.selected:
            self._edit(remove_keys(self._sheet, keys), _("Delete keys"))

    def ease(self, easing: str) -> None:
        """Give the chosen keys an easing."""
        if keys := self._timeline.selected:
            self._edit(set_easing(self._sheet, keys, easing), _("Change easing"))

    def ease_interval(self, key: Key | None, easing: str) -> None:
        """Give one key an easing."""
        if key is not None:
            self._edit(set_easing(self._sheet, [key.id], easing), _("Change easing"))

    def even_speed(self, target: str) -> None:
        """Let a track take its ways in times as they are long."""
        self._edit(even_speed(self._sheet, target), _("Even the speed"))

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
        self.copied = copied_keys(self._session.document, self._sheet, self._timeline.selected)
        count = len(self.copied)
        self.said.emit(ngettext("{n} key is copied.", "{n} keys are copied.", count).format(n=count))

    def paste(self) -> None:
        """Put the keys that were copied on their tracks, the first of them in the frame that is shown."""
        if self.copied:
            edit = paste_keys(self._sheet, self.copied, self._session.frames.number)
            self._edit(edit, _("Paste keys"))
