"""What a crash has left is offered, until it is recovered or discarded, here or in another window."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QFileSystemWatcher, QObject

from workbench.language import _
from workbench.shell.opening import enter_where_seen

if TYPE_CHECKING:
    from workbench.document.storage.files import Stored
    from workbench.session.recovery import Recoverable
    from workbench.shell.files import Files
    from workbench.shell.window import MainWindow


class Recovering(QObject):
    """Asks in the window about one lost picture at a time."""

    def __init__(self, window: "MainWindow", files: "Files") -> None:
        super().__init__(files)
        self._window, self._files = window, files
        self._watch: QFileSystemWatcher | None = None

    def offer(self) -> None:
        """Offer the newest of what crashed runs left behind; unanswered it is offered again next time."""
        from workbench.session.recovery import recoverable

        for lost in recoverable():
            question = _("The program ended before {name} was saved; its last state was kept.").format(
                name=lost.name
            )
            self._window.messages.ask(
                question,
                [(_("Recover"), partial(self._begin, lost)), (_("Discard"), partial(self._discard, lost))],
                self._end_watch,
            )
            self._end_watch()
            self._watch = QFileSystemWatcher([str(lost.path)], self)
            self._watch.fileChanged.connect(partial(self._look, lost, question))
            return

    def _end_watch(self) -> None:
        if self._watch is not None:
            self._watch.deleteLater()
            self._watch = None

    def _look(self, lost: "Recoverable", question: str, _path: str) -> None:
        """Another window may have taken what is offered here."""
        if self._watch is not None and not lost.path.exists():
            self._end_watch()
            if self._window.messages.text == question:
                self._window.messages.withdraw(question)
                self._say_gone(lost)

    def _begin(self, lost: "Recoverable") -> None:
        self._end_watch()
        if lost.path.exists():
            self._files.unless_unsaved(partial(self._recover, lost))
        else:
            self._say_gone(lost)

    def _discard(self, lost: "Recoverable") -> None:
        self._end_watch()
        lost.discard()

    def _recover(self, lost: "Recoverable") -> None:
        from workbench.exchange.reading import Job

        def refuse(error: str) -> None:
            if lost.path.exists():
                sentence = _("Nothing could be recovered: {error}").format(error=error)
                self._window.messages.say(sentence, "error")
            else:
                self._say_gone(lost)

        job, take = Job("picture", str(lost.path)), partial(self._recovered, lost)
        self._window.session.incoming.read(job, lost.name, take, refuse, lost.completed)

    def _say_gone(self, lost: "Recoverable") -> None:
        sentence = _("Another window has already recovered or discarded {name}.")
        self._window.messages.say(sentence.format(name=lost.name))

    def _recovered(self, lost: "Recoverable", stored: "Stored") -> None:
        session, say = self._window.session, self._window.messages.say
        session.take_recovered(lost, stored)
        enter_where_seen(self._window, stored.session.workspace)
        self._files.warn_of(stored.document.sheets, say)
        if session.changed_on_disk:
            sentence = _(
                "{name} was changed after this work was kept; you will be asked before it is replaced."
            )
            say(sentence.format(name=lost.name), "warn")
