"""Writes what is exported: asks for a name, works beside the window, and says what became of it."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, QObject, QTimer

from workbench.language import _, ngettext
from workbench.paths import home_folder

if TYPE_CHECKING:
    from workbench.exchange.writing import FileFormat
    from workbench.session.writer import Outcome, Writer
    from workbench.shell.window import MainWindow
    from workbench.widgets.fields.writing_card import WritingCard

# What is written within this time needs no card.
_CARD_AFTER_MS = 400


class Writing(QObject):
    """One thing is written at a time; ``writer`` and ``card`` come late."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._notes: Callable[[Any], list[str]] = lambda _content: []
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(_CARD_AFTER_MS)
        self._soon.timeout.connect(self._show_card)
        self._name = ""
        self._closes = self._failed = False

    def rest(self) -> None:
        """Put the card away, unless something is being written."""
        if "writer" not in self.__dict__ or not self.writer.busy:
            self._close_card()

    @cached_property
    def writer(self) -> Writer:
        """What writes."""
        from workbench.session.writer import Writer

        writer = Writer(self)
        writer.told.connect(self._tell)
        writer.ended.connect(self._ended)
        return writer

    @cached_property
    def card(self) -> WritingCard:
        """What shows the choices and the progress."""
        from workbench.widgets.fields.writing_card import WritingCard

        card = WritingCard(self._window, self._window.stack)
        card.cancelled.connect(self._cancel)
        return card

    def proposed(self, word: str, suffix: str) -> Path:
        """Beside the document, with its name, and a word for what it is."""
        path = self._window.session.path
        folder = path.parent if path else home_folder()
        stem = "-".join(filter(None, (self._window.files.name, word.replace(" ", "-"))))
        return folder / f"{stem}{suffix}"

    def ask(
        self,
        kind: str,
        word: str,
        make: Callable[[], Any],
        notes: Callable[[Any], list[str]] = lambda _content: [],
    ) -> None:
        """Ask for a name, and write what ``make`` gives under it; ``notes`` are said of that at the end."""
        from workbench.panels.stage.pages import formats_of
        from workbench.widgets.fields.save_dialog import SaveDialog

        if self.is_busy():
            return
        formats = formats_of(kind)
        start = self.proposed(word, formats[0].suffix)

        def then(path: Path, file_format: FileFormat) -> None:
            self._write(file_format, make, path, notes)

        SaveDialog(self._window, _("Export"), start, formats, then).open()

    def ask_pictures(
        self,
        title: str,
        word: str,
        file_format: FileFormat,
        content: Any,
        notes: Callable[[Any], list[str]] = lambda _content: [],
    ) -> None:
        """Ask for the name of pictures, ``content.parts`` of them, and write them under it."""
        from workbench.widgets.fields.save_dialog import SaveDialog

        def then(path: Path, file_format: FileFormat) -> None:
            paths = file_format.paths(path, content.parts)
            self._write_unless_there(file_format, lambda: content, path, paths, notes)

        SaveDialog(self._window, title, self.proposed(word, file_format.suffix), [file_format], then).open()

    def _write_unless_there(
        self,
        file_format: FileFormat,
        make: Callable[[], Any],
        path: Path,
        paths: list[Path],
        notes: Callable[[Any], list[str]],
    ) -> None:
        """Write; several files ask before any is replaced, since the dialog knows but one name."""
        there = [each for each in paths if os.path.exists(each)] if file_format.numbered else []
        if not there:
            self._write(file_format, make, path, notes)
            return
        self._close_card()
        sentence = ngettext(
            "{first} already exists; {all} files, {from_} to {to}, would be written.",
            "{n} of the {all} files {from_} to {to} already exist, the first of them {first}.",
            len(there),
        )
        self._window.messages.ask(
            sentence.format(
                n=len(there), all=len(paths), first=there[0].name, from_=paths[0].name, to=paths[-1].name
            ),
            [
                (_("Cancel"), lambda: None),
                (
                    ngettext("Replace it", "Replace them", len(there)),
                    lambda: self._write(file_format, make, path, notes),
                ),
            ],
        )

    def is_busy(self) -> bool:
        """Whether something is being written; then that is said."""
        if self.writer.busy:
            self._window.say_status(_("{name} is still being written.").format(name=self._name))
            return True
        return False

    def _write(
        self,
        file_format: FileFormat,
        make: Callable[[], Any],
        path: Path,
        notes: Callable[[Any], list[str]] = lambda _content: [],
    ) -> None:
        if self.is_busy():
            return
        self._name, self._notes, self._closes = path.name, notes, False
        self._window.installEventFilter(self)
        if self.card.isVisible():
            self._show_card()
        else:
            self._soon.start()
        self.writer.start(file_format, make, path)

    def _show_card(self) -> None:
        self.card.progress(_("Writing {name}").format(name=self._name))

    def _tell(self, done: int, parts: int) -> None:
        if self.card.isVisible():
            self.card.tell(done, parts)

    def _cancel(self) -> None:
        if self.writer.busy:
            self.writer.cancel()
            self.card.stop()
        else:
            self._close_card()

    def _close_card(self) -> None:
        self._soon.stop()
        if "card" in self.__dict__:
            self.card.put_away()

    def _ended(self, outcome: Outcome) -> None:
        self._window.removeEventFilter(self)
        self._close_card()
        messages = self._window.messages
        self._failed = bool(outcome.problem)
        if outcome.problem:
            messages.say(outcome.problem, "error")
        elif self._closes:
            self._window.close()
        elif outcome.cancelled:
            self._window.say_status(_("Cancelled; {name} was not written.").format(name=self._name))
        else:
            messages.say(" ".join([_written(outcome.paths), *self._notes(outcome.content)]))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """While something is being written the window does not close unasked."""
        if event.type() != QEvent.Type.Close or self._closes:
            return super().eventFilter(watched, event)
        event.ignore()
        self._window.messages.ask(
            _("{name} is still being written.").format(name=self._name),
            [
                (_("Close when it is written"), self._close_later),
                (_("Cancel it and close"), self._close_without),
                (_("Stay"), lambda: None),
            ],
        )
        return True

    def _close_later(self) -> None:
        """Close, now or at the end; what was not written is said first."""
        self._closes = True
        if not self.writer.busy and not self._failed:
            self._window.close()

    def _close_without(self) -> None:
        self.writer.cancel()
        self._closes = True
        if not self.writer.busy:
            self._window.close()


def _written(paths: tuple[Path, ...]) -> str:
    folder = paths[0].parent
    if len(paths) == 1:
        return _("{name} has been written to {folder}.").format(name=paths[0].name, folder=folder)
    sentence = _("{n} files, {first} to {last}, have been written to {folder}.")
    return sentence.format(n=len(paths), first=paths[0].name, last=paths[-1].name, folder=folder)
