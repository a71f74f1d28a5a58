"""Opening and saving: names, the question about unsaved changes, recent files, recovery after a crash."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QDropEvent

from workbench.exchange.readable import SUFFIXES, kind_of
from workbench.language import _, legible
from workbench.paths import home_folder
from workbench.shell.exports import Exports
from workbench.shell.opening import enter_where_seen
from workbench.shell.recovering import Recovering
from workbench.shell.step_messages import StepMessages
from workbench.shell.workspaces import panel_of
from workbench.widgets.fields.file_dialog import ask_for_file

if TYPE_CHECKING:
    from workbench.document.building import Edit
    from workbench.document.model import Document, Sheet
    from workbench.document.storage.files import Stored
    from workbench.session.saver import Saved
    from workbench.session.session import Session
    from workbench.session.stamps import Stamp
    from workbench.shell.window import MainWindow

PROGRAM = "Graphics Workbench"
SUFFIX = ".gwb"
_LONGEST_FOLDER = 300
_IMPORTED = ("drawing", "points", "mesh")  # what comes into a picture; another picture takes its place


class Files(QObject):
    """The commands of the File menu. Every failure is said in the window; what is open then stays open."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.exports = Exports(window)
        self._recovering = Recovering(window, self)
        self._failure = self._unsaved = ""  # what the bar may still be saying of them

    @property
    def _session(self) -> "Session":
        session: Session = self._window.session
        return session

    @property
    def name(self) -> str:
        """What the picture is called in titles."""
        path = self._session.path
        return path.stem if path else _("Untitled")

    def refresh_title(self, *_what: object) -> None:
        """Name the picture in the title, with a mark while it is not saved."""
        self._window.setWindowTitle(f"{legible(self.name).replace('[*]', '[*][*]')}[*] - {PROGRAM}")
        self._window.setWindowModified(self._session.dirty)

    def follow(self, session: "Session") -> None:
        """Show what is being read for a session, with a button that ends it, and say what was left out."""
        incoming, messages = session.incoming, self._window.messages
        name = ""

        def began(what: str) -> None:
            nonlocal name
            name = legible(what)
            progressed(0.0)

        def progressed(share: float) -> None:
            text = _("Reading {name} ... {percent} %").format(name=name, percent=round(100 * share))
            messages.work(text, (_("Cancel"), incoming.cancel))

        incoming.began.connect(began)
        incoming.progressed.connect(progressed)
        incoming.ended.connect(messages.end_work)
        session.left_out.connect(self.warn)
        session.opened.connect(messages.leave)
        self._of_steps = StepMessages(messages, session.undo_stack)

    def warn(self, sentence: str) -> None:
        """Say that unsaved work could not be kept safe, or what a file was opened without."""
        self._window.messages.say(sentence, "warn")

    def reassure(self, sentence: str) -> None:
        """Say that unsaved work is kept safe again."""
        self._window.messages.say(sentence)

    def new(self) -> None:
        """Begin an empty picture."""
        self.unless_unsaved(self._new)

    def open(self) -> None:
        """Ask for a file and open it; a drawing, a mesh or a list of points comes into the open picture."""
        self._ask_for_one(_("Open"), self.take)

    def bring_in(self) -> None:
        """Ask for a file and bring it into the open picture; of another picture, its sheets."""
        self._ask_for_one(_("Import"), self._bring_in)

    def _ask_for_one(self, title: str, then: Callable[[Path], None]) -> None:
        folder = self._session.path.parent if self._session.path else home_folder()
        chosen = ask_for_file(self._window, title, folder)
        if chosen is not None:
            then(chosen)

    def take(self, path: Path) -> None:
        """Open a picture, or bring what else it is into Curves or Space."""
        if kind_of(path) in _IMPORTED:
            self._bring_in(path)
        else:
            self.open_path(path)

    def _bring_in(self, path: Path) -> None:
        if kind_of(path) in _IMPORTED:
            mesh = kind_of(path) == "mesh"
            place, bring = ("space", self._into_space) if mesh else ("curves", self._into_curves)
            self._window.enter(place, partial(bring, path))
        else:
            from workbench.exchange.reading import Job

            take, refuse = partial(self._add_sheets, path), partial(self._not_imported, path)
            prepare = partial(_with_sheets, self._session.document)
            self._session.incoming.read(Job("picture", str(path)), path.name, take, refuse, prepare)

    def _into_curves(self, path: Path) -> None:
        from workbench.panels.curves.panel import CurvesPanel

        exchange = panel_of(self._window.panels("curves"), CurvesPanel).exchange
        exchange.take_file(path, self._of_steps.say, self._refuse)

    def _into_space(self, path: Path) -> None:
        from workbench.panels.space.panel import SpacePanel

        meshes = panel_of(self._window.panels("space"), SpacePanel).meshes
        meshes.take_file(path, self._of_steps.say, self._refuse)

    def _add_sheets(self, path: Path, edit: "Edit") -> None:
        """Do that as one step of undo, and show the first of them."""
        from workbench.document.errors import DocumentError

        session = self._session
        known = {sheet.id for sheet in session.document.sheets}
        try:
            session.apply(edit, _("Import {name}").format(name=path.name))
        except DocumentError as error:
            self._not_imported(path, error.short)
            return
        added = [sheet for sheet in session.document.sheets if sheet.id not in known]
        self.show_sheet(added[0].id)
        self.warn_of(added, self._of_steps.say)

    def _not_imported(self, path: Path, error: str) -> None:
        self._refuse(_("{name} was not imported: {error}").format(name=legible(path.name), error=error))

    def _refuse(self, sentence: str) -> None:
        self._window.messages.say(sentence, "error")

    def open_path(self, path: Path) -> None:
        """Open a file, after the question about unsaved changes."""
        self.unless_unsaved(lambda: self._open(path))

    def example(self, slug: str, then: Callable[[], object] | None = None) -> None:
        """Open a built-in picture; unsaved work stays open beside it."""
        before = self._session.sheet
        beside = self._session.dirty
        self._session.open_example(slug)
        if beside:
            self._of_steps.say(
                _("{name} stays open beside this example: View > Sheets shows it again.").format(
                    name=legible(before.name)
                )
            )
        if then:
            then()

    def show_sheet(self, sheet: str, *_what: object) -> None:
        """Show another sheet of the picture."""
        self._session.show_sheet(sheet)
        if self._window.place not in self._window.workspace_slugs:
            enter_where_seen(self._window)

    def save(self, then: Callable[[], object] | None = None) -> None:
        """Save, the first time under a name that is asked for; ``then`` follows when it was saved.

        Where a save is under way this one follows it, since the file is changing by our own hand.
        """
        if self._session.saving:
            self._session.saved.connect(
                lambda _saved: self.save(then), Qt.ConnectionType.SingleShotConnection
            )
            return
        path = self._session.path
        if path is None:
            self.save_as(then)
        elif self._session.changed_on_disk:
            self._window.messages.ask(
                _("Another program has changed {name} since it was opened here.").format(
                    name=legible(path.name)
                ),
                [
                    (_("Save under another name"), lambda: self.save_as(then)),
                    (_("Save over it"), lambda: self._save(path, then)),
                    (_("Cancel"), lambda: None),
                ],
            )
        else:
            self._save(path, then)

    def save_as(self, then: Callable[[], object] | None = None) -> None:
        """Ask for a name and save there; ``then`` follows when it was saved."""
        from workbench.exchange.written import formats
        from workbench.widgets.fields.save_dialog import SaveDialog

        start = self._session.path or self.exports.writing.proposed("", SUFFIX)
        SaveDialog(
            self._window,
            _("Save the picture"),
            start,
            formats("document"),
            lambda path, _row: self._save(path, then),
        ).open()

    def finish_saving(self) -> bool:
        """Wait for a save that is under way; False where that has just been told to have failed."""
        failed = False

        def look(saved: "Saved") -> None:
            nonlocal failed
            failed = bool(saved.problem)

        ended = self._session.saved.connect(look)
        self._session.finish_saving()
        self._session.saved.disconnect(ended)
        return not failed

    def unless_unsaved(self, then: Callable[[], object]) -> None:
        """Do ``then`` at once, or after a person has saved or given up the unsaved changes."""
        if not self._session.dirty:
            then()
            return
        self._unsaved = _("{name} has unsaved changes.").format(name=legible(self.name))
        self._window.messages.ask(
            self._unsaved,
            [
                (_("Save"), lambda: self.save(partial(self.unless_unsaved, then))),
                (_("Discard changes"), then),
                (_("Cancel"), lambda: None),
            ],
        )

    def offer_recovery(self) -> None:
        """Offer the newest of what crashed runs left behind; unanswered it is offered again next time."""
        self._recovering.offer()

    def _new(self) -> None:
        window = self._window
        self._session.new()
        window.enter(window.place if window.place in window.workspace_slugs else "draw")

    def _open(self, path: Path) -> None:
        from workbench.exchange.reading import Job
        from workbench.session.stamps import stamp

        take = partial(self._read, path, stamp(path), self._session.revision)
        self._session.incoming.read(Job("picture", str(path)), path.name, take, partial(self._unread, path))

    def _unread(self, path: Path, error: str) -> None:
        self._window.messages.say(
            _("{name} was not opened: {error}").format(name=legible(path.name), error=error), "error"
        )

    def _read(self, path: Path, on_disk: "Stamp | None", revision: int, stored: "Stored") -> None:
        """Show what was read; what was changed meanwhile is not lost unasked."""
        show = partial(self._show, path, on_disk, stored)
        if self._session.revision == revision:
            show()
        else:
            self.unless_unsaved(show)

    def _show(self, path: Path, on_disk: "Stamp | None", stored: "Stored") -> None:
        self._session.take(stored, path, on_disk)
        self._remember(path)
        enter_where_seen(self._window, stored.session.workspace)
        self.warn_of(stored.document.sheets, self._window.messages.say)

    def warn_of(self, sheets: "Sequence[Sheet]", say: Callable[[str, str], object]) -> None:
        """What serves for algorithms that a file asks for and this version lacks; pictures that are large."""
        from workbench.display.setup import too_many_pixels
        from workbench.document.stand_ins import stand_ins

        large = [too_many_pixels((sheet.width_px, sheet.height_px)) for sheet in sheets]
        if sentences := [*stand_ins(sheets), *dict.fromkeys(filter(None, large))]:
            say(" ".join(sentences), "warn")

    def _save(self, path: Path, then: Callable[[], object] | None) -> None:
        session = self._session
        session.finish_saving()
        session.saved.connect(partial(self._saved, then), Qt.ConnectionType.SingleShotConnection)
        self._window.say_status(_("Saving {name} ...").format(name=legible(path.name)))
        session.save_behind(path)

    def _saved(self, then: Callable[[], object] | None, saved: "Saved") -> None:
        name = legible(saved.path.name)
        if saved.problem:
            self._window.say_status("")
            self._failure = _("{name} was not saved: {error}").format(name=name, error=saved.problem)
            self._window.messages.say(self._failure, "error")
            return
        self._window.messages.withdraw(self._failure)
        if not self._session.dirty:
            self._window.messages.withdraw(self._unsaved)
        self._remember(saved.path)
        folder = legible(str(saved.path.absolute().parent), _LONGEST_FOLDER)
        self._window.say_status(_("Saved {name} in {folder}.").format(name=name, folder=folder))
        if then:
            then()

    def _remember(self, path: Path) -> None:
        self._window.settings.add_recent(path)
        self._window.refresh_recent()

    # Files dropped on the window

    def offer_drop(self, event: QDropEvent) -> None:
        """Take what is dragged over the window when it can be opened or brought in; else say what can."""
        if self._dropped(event) is not None:
            # Whatever the other program proposes: the file is read, and stays where it is.
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        elif event.mimeData().hasUrls():
            self._window.say_status(
                _("Drop one file here: a picture, a drawing, a mesh or a list of points ({endings}).").format(
                    endings=", ".join(SUFFIXES)
                )
            )

    def take_drop(self, event: QDropEvent) -> None:
        """Open the picture that is dropped, or bring what it is into Curves or Space."""
        self.offer_drop(event)
        path = self._dropped(event)
        if path is not None:
            self.take(path)

    @staticmethod
    def _dropped(event: QDropEvent) -> Path | None:
        """The one file that is being dropped, when it is of a kind that can be taken."""
        urls = event.mimeData().urls()
        path = Path(urls[0].toLocalFile()) if len(urls) == 1 and urls[0].isLocalFile() else None
        return path if path is not None and path.suffix.lower() in SUFFIXES else None


def _with_sheets(document: "Document", stored: "Stored") -> "Edit":
    """The edit by which the sheets of another picture come beside those of the open one."""
    from workbench.document.building import both, foreseen
    from workbench.document.sheet_edits import add_sheet

    return foreseen(both(*map(add_sheet, stored.document.sheets)), document)
