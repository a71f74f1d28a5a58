"""The dialogs in which files are chosen: they name and show what is there, and open nothing of it."""

from functools import cache
from pathlib import Path

from PySide6.QtCore import QFileInfo
from PySide6.QtGui import QAbstractFileIconProvider, QIcon
from PySide6.QtWidgets import QFileDialog, QFileIconProvider, QWidget

from workbench.exchange.readable import READABLE
from workbench.language import _


class NamedIcons(QFileIconProvider):
    """Icons and kinds by name alone: Qt's own opens what has no ending, which in /proc may never end."""

    def __init__(self) -> None:
        super().__init__()
        kinds = QAbstractFileIconProvider.IconType
        self._file, self._folder = (QFileIconProvider.icon(self, kind) for kind in (kinds.File, kinds.Folder))

    def icon(self, of: QFileInfo | QAbstractFileIconProvider.IconType) -> QIcon:
        """That of a folder or of a file; the dialog asks on a thread of its own."""
        if isinstance(of, QFileInfo):
            return self._folder if of.isDir() else self._file
        return QFileIconProvider.icon(self, of)

    def type(self, of: QFileInfo) -> str:
        """The kind that the ending names. No class of Qt is met here for the first time, on that thread."""
        if of.isDir():
            return _("Folder")
        return _("{ending} file").format(ending=of.suffix().lower()) if of.suffix() else _("File")


@cache
def _icons() -> NamedIcons:
    """One for as long as the program runs: a dialog does not own it."""
    return NamedIcons()


class FileDialog(QFileDialog):
    """A dialog of the program, which begins in ``folder``."""

    def __init__(self, owner: QWidget, title: str, folder: Path) -> None:
        super().__init__(owner, title)
        self.setIconProvider(_icons())
        self.setDirectory(str(folder))  # only now: a folder is looked at as soon as it is shown


def ask_for_file(owner: QWidget, title: str, folder: Path) -> Path | None:
    """Ask for one file that can be opened or brought in; None where none was chosen."""
    dialog = FileDialog(owner, title, folder)
    dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
    dialog.setNameFilters(_kinds())
    chosen = dialog.selectedFiles() if dialog.exec() else []
    dialog.deleteLater()
    return Path(chosen[0]) if chosen else None


def _kinds() -> list[str]:
    """What can be opened or brought in, for the list of a dialog."""
    each = [(readable.title, readable.suffixes) for readable in READABLE]
    everything = (
        _("Everything that can be opened"),
        tuple(suffix for _title, suffixes in each for suffix in suffixes),
    )
    return [f"{title} ({' '.join('*' + suffix for suffix in kinds)})" for title, kinds in (everything, *each)]
