"""Asks under which name something is written: the name is complete before the person is asked about it."""

import os
from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from workbench.document.storage.saving import refusal
from workbench.exchange.writing import FileFormat, SuffixError, completed
from workbench.language import _, legible
from workbench.widgets.fields.file_dialog import FileDialog


class SaveDialog(FileDialog):
    """``then(path, file_format)`` follows when a name was given; it ends in the suffix of one of ``formats``.

    The dialog begins at ``start``, and asks before a file is replaced; of ``numbered`` formats the files have
    other names, so that who writes them asks.
    """

    def __init__(
        self,
        owner: QWidget,
        title: str,
        start: Path,
        formats: Sequence[FileFormat],
        then: Callable[[Path, FileFormat], object],
    ) -> None:
        super().__init__(owner, title, start.parent)
        self._owner, self._formats, self._then = owner, list(formats), then
        self._suffixes = {file_format.suffix for file_format in formats}
        self._filters = [f"{file_format.title} (*{file_format.suffix})" for file_format in formats]
        self.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        self.setFileMode(QFileDialog.FileMode.AnyFile)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setNameFilters(self._filters)
        self.setOption(QFileDialog.Option.DontConfirmOverwrite)  # asked here, about the completed name
        first = next(
            (file_format for file_format in formats if file_format.suffix == start.suffix.lower()), formats[0]
        )
        self.selectNameFilter(self._filters[self._formats.index(first)])
        self._follow(self.selectedNameFilter())
        self.selectFile(start.name)
        self.filterSelected.connect(self._rename)

    @property
    def file_format(self) -> FileFormat:
        """The way of writing that is chosen in the list of kinds."""
        return self._formats[self._filters.index(self.selectedNameFilter())]

    def _follow(self, name_filter: str) -> None:
        self.setDefaultSuffix(self._formats[self._filters.index(name_filter)].suffix)

    def _rename(self, name_filter: str) -> None:
        """Another kind is chosen: the name ends accordingly."""
        self._follow(name_filter)
        path = Path(self.selectedFiles()[0])
        if path.suffix.lower() in self._suffixes:
            self.selectFile(path.with_suffix(self.file_format.suffix).name)

    def accept(self) -> None:
        """Take the name, completed. One that ends wrongly, or is not to be replaced, is asked for again."""
        typed = Path(self.selectedFiles()[0])
        try:
            if _is_there(typed) and typed.is_dir():
                if typed.suffix.lower() in self._suffixes:  # it was to be a file
                    sentence = _("{name} is a folder; choose another name.")
                    self._refuse(typed, sentence.format(name=legible(typed.name)))
                else:
                    super().accept()
                return
            path, file_format = completed(self._formats, typed, self.file_format)
            there = _is_there(path)
        except SuffixError as problem:
            self._refuse(typed, str(problem))
            return
        except (OSError, ValueError) as error:  # too long, for example
            self._refuse(typed, str(refusal(typed, error)))
            return
        if there and not file_format.numbered and not self._may_replace(path):
            self._ask_again(path)
            return
        super().accept()
        self._then(path, file_format)

    def _refuse(self, typed: Path, sentence: str) -> None:
        self._box(sentence, QMessageBox.Icon.Warning).exec()
        self._ask_again(typed)

    def _ask_again(self, path: Path) -> None:
        """The system's own dialog, which has no parts here, is closed by now."""
        if self.layout() is None:
            self.reject()
            SaveDialog(self._owner, self.windowTitle(), path, self._formats, self._then).open()

    def _may_replace(self, path: Path) -> bool:
        question = _("{name} already exists. Replace it?").format(name=legible(path.name))
        buttons = QMessageBox.StandardButton
        box = self._box(question, QMessageBox.Icon.Question, buttons.Yes | buttons.No)
        box.setDefaultButton(buttons.No)
        return box.exec() == buttons.Yes

    def _box(
        self,
        text: str,
        icon: QMessageBox.Icon,
        buttons: QMessageBox.StandardButton = QMessageBox.StandardButton.Ok,
    ) -> QMessageBox:
        box = QMessageBox(icon, self.windowTitle(), text, buttons, self)
        box.setTextFormat(Qt.TextFormat.PlainText)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        return box


def _is_there(path: Path) -> bool:
    """Raises OSError or ValueError for what no file can be called, or may not be looked at."""
    try:
        os.stat(path)
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True
