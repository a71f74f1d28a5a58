"""The session: the one holder of the open document, of undo, of what is selected and where the run stands.

Three kinds of state: the document (undone, saved), the session's (saved, not undone), the view's (settings).
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QObject, Qt, QTimer, Signal

from workbench.document.addresses import changed as changed_addresses
from workbench.document.check import check
from workbench.document.edits import Edit, add_apart
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure, Document, Sheet
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.state import SessionState, at_the_start, check_state, cleaned, with_changes
from workbench.document.storage.files import Stored, read, write
from workbench.document.subjects import Position, Subject
from workbench.language import _
from workbench.memory import forget
from workbench.rendering.subjects.registry import checked, kind_of
from workbench.session.ahead import Ahead
from workbench.session.following import Following
from workbench.session.frames import Frames
from workbench.session.incoming import Incoming
from workbench.session.merging import Merging
from workbench.session.origins import text_of
from workbench.session.recovery import Recoverable, RecoveryFile
from workbench.session.recovery_watch import RecoveryWatch
from workbench.session.remembered import runnable
from workbench.session.run import Run
from workbench.session.saver import Saved, Saver
from workbench.session.shown_sheets import ShownSheets
from workbench.session.stamps import Stamp, stamp
from workbench.session.undo import UndoStack
from workbench.session.unfolding import Unfolding


class Session(QObject):
    """Owns the document. Panels read it here, change it by ``apply``, and keep no truth of their own.

    ``changed(old, new, addresses)`` and ``state_changed(old, new)`` come once per turn of the event loop, in
    this order, with everything that happened since the last time. ``revision`` counts every change at once:
    a worker answers with the revision it was given, and stale answers are dropped. ``saved(Saved)``: a save
    has ended, well or not. ``opened``: another document or sheet is. ``storing``: a save is about to begin;
    what belongs into the session's state is to be put there now. ``left_out(sentence)``: what a file was
    opened without. ``why_asked``: somebody asks why ``state.pixel`` is as it is, also when it is the same
    pixel again, of which ``state_changed`` does not tell. ``run`` leads, ``followers`` do the same under
    other entries; ``ahead`` works on large sheets.
    """

    changed = Signal(object, object, object)
    state_changed = Signal(object, object)
    opened = Signal()
    path_changed = Signal(object)
    dirty_changed = Signal(bool)
    saved = Signal(object)
    storing = Signal()
    autosave_failed = Signal(str)
    autosave_mended = Signal(str)
    left_out = Signal(str)
    why_asked = Signal()
    _due = Signal()

    def __init__(self, parent: QObject | None = None, document: Document | None = None) -> None:
        super().__init__(parent)
        self.document = blank_sheet() if document is None else check(document)
        self.revision = 0
        self.path: Path | None = None
        self.undo_stack = UndoStack(self._show, self)
        self._merging = Merging(self.undo_stack)
        self.state = cleaned(SessionState(), self.document)
        self._blobs: dict[str, bytes] = {}
        self._told = (self.document, self.state)
        self._waiting = False
        self._recovery: RecoveryFile | None = None
        self._on_disk: Stamp | None = None
        self._saver = Saver(self)
        self._saver.saved.connect(self._take_saved)
        self.incoming = Incoming(self)
        self.ahead = Ahead(self)
        self.run = Run(self)
        self.followers = (Run(self),)
        self._following = Following(self, self.run, self.followers)
        self.unfolding = Unfolding(self)
        self.frames = Frames(self)
        self._shown_sheets = ShownSheets(self)
        self._due.connect(self.flush, Qt.ConnectionType.QueuedConnection)
        self._entering = QTimer(self, singleShot=True)
        self._entering.timeout.connect(self._due)
        self.undo_stack.cleanChanged.connect(self._clean_changed)

    @property
    def dirty(self) -> bool:
        """Whether the document differs from what was opened or saved last."""
        return not self.undo_stack.isClean()

    @property
    def sheet(self) -> Sheet:
        """The current sheet."""
        return next((s for s in self.document.sheets if s.id == self.state.sheet), self.document.sheets[0])

    @property
    def shown(self) -> Sheet:
        """The current sheet in its frame as it is painted: all of it, or what a large one has unfolded to.

        Edits, runs and what leaves the program are of ``sheet``.
        """
        return self.unfolding.shown

    @property
    def active_figure(self) -> AnyFigure | None:
        """The active figure of the current sheet, or else the front one: the one that is worked on."""
        figures = self.sheet.figures
        return next((f for f in figures if f.id == self.state.active), figures[-1] if figures else None)

    @property
    def shown_figure(self) -> AnyFigure | None:
        """The active figure as it is painted; None where it is not."""
        sheet, active = self.shown, self.active_figure
        if sheet is self.sheet or active is None:
            return active
        return next((figure for figure in sheet.figures if figure.id == active.id), None)

    @property
    def subject(self) -> Subject:
        """What is stepped in the present workspace; of a subject without ids, the active figure's."""
        subject, figure = self.state.subject, self.active_figure
        return subject if subject.ids or figure is None else replace(subject, ids=(figure.id,))

    @property
    def stored(self) -> Stored:
        """What a file of this session holds."""
        return Stored(self.document, self.state, self._blobs)

    def apply(self, edit: Edit, name: str, merge: str = "", on: Document | None = None) -> None:
        """Do ``edit`` in the frame that is shown, as one step of undo called ``name``.

        It is done to the document, or to ``on``, the one with which a drag began. Edits with the same
        ``merge`` token become one step, until ``end_merge`` or any other edit. Raises DocumentError with
        everything untouched.
        """
        old = self.document
        new = self.frames.edited(edit)(on or old)
        if new != old:
            self._merging.push(name, old, new, merge)

    def end_merge(self, merge: str = "") -> None:
        """End a drag: the next edit is a step of its own. A drag back to its start leaves none.

        With ``merge`` only edits that were merged under this token are ended.
        """
        self._merging.end(merge)

    def update_state(self, **changes: Any) -> None:
        """Change fields of the session's state; raises DocumentError when they refer to nothing.

        ``subject``, ``step`` and ``detail`` are those of the workspace that is stepped in. Where another
        figure becomes the active one, its runs begin at step 0, here unless ``step`` is given too.
        """
        if "subject" in changes:
            checked(changes["subject"])
        state = check_state(with_changes(self.state, **changes), self.document)
        if state != self.state:
            figure, workspace = self.active_figure, self.state.workspace
            self.state = state
            other = self._another_figure(figure, changes.get("step"))
            self._following.switch("step" not in changes and not other and state.workspace == workspace)
            self._tell_later()

    def visit(self, workspace: str, usual: Subject) -> None:
        """Step in this workspace from now on, where it was left, or the first time its ``usual`` subject."""
        self.update_state(workspace=workspace, positions={workspace: Position(usual), **self.state.positions})

    def choices_of(self, subject: Subject | None = None) -> tuple[str, ...]:
        """The slugs that the subject, or another one, can be run under, its own first."""
        subject = subject or self.subject
        return kind_of(subject).choices(self.sheet, subject)

    def choose(self, slug: str, subject: Subject | None = None) -> None:
        """Run the subject, or another one, under this entry, where it has that choice.

        The document says so where it can, else the subject. Raises DocumentError.
        """
        subject = subject or self.subject
        choices = self.choices_of(subject)
        if edit := kind_of(subject).choose(self.sheet, subject, slug):
            self.apply(edit, _("Change algorithm"))
        elif slug in choices:
            entry = "" if slug == choices[0] else slug
            self.update_state(subject=replace(self.state.subject, entry=entry), step=0)

    def flush(self) -> None:
        """Tell now what changed since the last time, rather than in the next turn of the event loop.

        The runs follow first. Whoever is told shows it and writes nothing back.
        """
        self._following.update()
        self._waiting = False
        (old, old_state), self._told = self._told, (self.document, self.state)
        addresses = changed_addresses(old, self.document)
        if addresses:
            self.changed.emit(old, self.document, addresses)
        if self.state != old_state:
            self.state_changed.emit(old_state, self.state)
        if self.dirty:
            self._keep_safe()

    def hold_runs(self, on: bool) -> None:
        """Let the runs wait, as while something is drawn or dragged, or go on."""
        for run in (self.run, *self.followers):
            run.hold() if on else run.go_on()

    def new(self, document: Document | None = None) -> None:
        """Begin anew with a blank sheet or with ``document``, which then has no file and is not dirty."""
        self._begin(Stored(document or blank_sheet(), SessionState()))

    def open_example(self, slug: str) -> None:
        """Open a built-in example: as a document of its own, or as a sheet beside unsaved work."""
        chosen = example(slug)
        before = self.document.sheets if self.dirty else ()
        if self.dirty:
            self.apply(add_apart(chosen.document.sheets[0]), _("Open example"))
        else:
            self.new(chosen.document)
        self.show_sheet(next(sheet.id for sheet in self.document.sheets if sheet not in before))
        if chosen.frame:
            self.frames.show(chosen.frame)

    def show_sheet(self, sheet: str) -> None:
        """Make the sheet with this id the current one; raises DocumentError when there is none.

        The figure that is stepped is selected, so that its handles and its parameters are seen at once.
        """
        self.update_state(sheet=sheet, active="", selection=(), step=0)
        self.opened.emit()
        stepped = self.active_figure
        self.update_state(selection=self.sheet.together((stepped.id,)) if stepped else ())

    def open(self, path: Path | str) -> None:
        """Read a file and open it, here and now; raises DocumentError, and what is open stays."""
        now = stamp(Path(path))  # what another program writes from now on is a change
        self.take(read(path), Path(path), now)

    def take(self, stored: Stored, path: Path, on_disk: Stamp | None) -> None:
        """Open what was read from the file ``path`` when its stamp was ``on_disk``."""
        self._begin(stored, path, on_disk)

    def save(self) -> None:
        """Save to the file it came from; raises DocumentError."""
        if self.path is None:
            raise DocumentError("", _("This picture has no file yet; choose a name and a folder for it."))
        self.save_as(self.path)

    def save_as(self, path: Path | str) -> None:
        """Save to ``path``, which is its file from now on; raises DocumentError."""
        self.finish_saving()
        self.end_merge()
        self.storing.emit()
        write(self.stored, path)
        self._take_saved(Saved(self.stored, Path(path), stamp(Path(path))))

    def save_behind(self, path: Path) -> None:
        """As ``save_as``, but come back at once; ``saved`` tells how it ended."""
        self.end_merge()
        self.storing.emit()
        self._saver.start(self.stored, path)

    @property
    def saving(self) -> bool:
        """Whether a save is under way."""
        return self._saver.busy

    def finish_saving(self) -> None:
        """Wait for the save that is under way, if any."""
        self._saver.wait()

    @property
    def changed_on_disk(self) -> bool:
        """Whether another program has changed the file since it was opened or saved here."""
        now = stamp(self.path) if self.path is not None else None
        return now is not None and now != self._on_disk

    def _take_saved(self, saved: Saved) -> None:
        """The document has a file now; what was changed meanwhile is not in it."""
        if not saved.problem:
            self.path, self._on_disk = saved.path, saved.stamp
            if self.document == saved.stored.document:
                self.undo_stack.setClean()
            self.path_changed.emit(self.path)
        elif saved.path == self.path:  # what that file holds now, nobody knows
            self.undo_stack.resetClean()
        self.saved.emit(saved)

    def start_autosave(self, folder: Path | None = None) -> None:
        """Keep unsaved work in a recovery file until ``close``.

        ``autosave_failed`` tells of trouble, ``autosave_mended`` of its end.
        """
        if self._recovery is None:
            self._recovery = RecoveryFile(folder)
            RecoveryWatch(self._recovery, self.autosave_failed.emit, self.autosave_mended.emit, self)
            self._keep_safe()

    def recover(self, work: Recoverable) -> None:
        """Read and open what a dead process left; raises DocumentError, and what is open stays."""
        self.take_recovered(work, work.read())

    def take_recovered(self, work: Recoverable, stored: Stored) -> None:
        """Open what was read of the work of a dead process, as unsaved work.

        Where the file it came from is another by now, it counts as changed on the disk. The work is discarded
        once it is kept here.
        """
        on_disk = work.origin_stamp if work.origin is None or work.origin_changed else stamp(work.origin)
        self._begin(stored, work.origin, on_disk)
        self.undo_stack.resetClean()
        if self._recovery is not None:
            self._keep_safe(work.discard)

    def abandon(self) -> None:
        """End at once: unsaved work stays in its recovery file, which is offered at the next start."""
        self.finish_saving()
        if self.dirty and self._recovery is not None:
            self.flush()
            self._recovery.flush()
        else:
            self.close()

    def close(self) -> None:
        """End the session: nothing unsaved is kept any longer."""
        self.incoming.cancel()
        self.finish_saving()
        for run in (self.run, *self.followers):
            run.clear()
        if self._recovery is not None:
            self._recovery.close()
            self._recovery = None

    def _begin(self, stored: Stored, path: Path | None = None, on_disk: Stamp | None = None) -> None:
        self.incoming.cancel()
        self.finish_saving()
        self.undo_stack.clear()
        forget()
        self.ahead.forget()
        self._blobs = stored.blobs
        self.path, self._on_disk = path, on_disk
        self._show(stored.document)
        state, sentences = runnable(stored.session)
        self.state = cleaned(state, stored.document)
        self._following.begin_anew()
        self.opened.emit()
        self.path_changed.emit(path)
        if sentences:
            self.left_out.emit(" ".join(sentences))

    def _clean_changed(self, clean: bool) -> None:
        self._keep_safe()
        self.dirty_changed.emit(not clean)

    def _keep_safe(self, then: Callable[[], object] | None = None) -> None:
        if self._recovery is not None:
            origin = "" if self.path is None else text_of(self.path)
            kept = replace(self.stored, origin=origin, origin_stamp=self._on_disk)
            self._recovery.keep(kept if self.dirty else None, then)

    def _show(self, document: Document) -> None:
        figure = self.active_figure
        self.document = document
        self.state = cleaned(self.state, document)
        self._another_figure(figure)
        self.revision += 1
        self._tell_later()

    def _another_figure(self, before: AnyFigure | None, step: int | None = None) -> bool:
        """Whether another figure is active than before: its runs begin at the start, here at ``step``."""
        now = self.active_figure
        if (now and now.id) == (before and before.id):
            return False
        self.state = at_the_start(self.state)
        if step is not None:
            self.state = with_changes(self.state, step=step)
        return True

    def _tell_later(self) -> None:
        if not self._waiting:
            self._waiting = True
            entered = self.state.workspace != self._told[1].workspace  # it is painted before its runs follow
            self._entering.start() if entered else self._due.emit()
