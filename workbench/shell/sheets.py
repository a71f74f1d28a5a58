"""The sheets of a picture: new ones, their names, copies, and what is seen when one goes."""

from functools import partial
from itertools import count
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QInputDialog

from workbench.document.errors import DocumentError
from workbench.document.names import first_free, name_of_copy
from workbench.document.samples.examples import blank_sheet
from workbench.document.sheet_edits import add_sheet, remove_sheet, rename_sheet
from workbench.language import _, legible
from workbench.shell.actions import Command

if TYPE_CHECKING:
    from workbench.document.model import Sheet
    from workbench.shell.window import MainWindow


def sheet_commands() -> tuple[Command, ...]:
    """What can be done with a sheet as a whole."""
    return (
        Command(
            "new_sheet",
            _("New sheet"),
            _add_empty,
            tooltip=_("Add an empty sheet to this picture, as large as this one"),
            menu="sheets",
            needs="document",
        ),
        Command(
            "rename_sheet",
            _("Rename sheet..."),
            _ask_for_name,
            tooltip=_("Give this sheet another name"),
            menu="sheets",
            needs="document",
        ),
        Command(
            "duplicate_sheet",
            _("Duplicate sheet"),
            _duplicate,
            tooltip=_("Make a copy of this sheet and show it"),
            menu="sheets",
            needs="document",
        ),
        Command(
            "remove_sheet",
            _("Remove sheet"),
            _remove,
            tooltip=_("Close this sheet and remove it from the picture; Undo brings it back"),
            menu="sheets",
            needs="document",
        ),
    )


def _add_empty(window: "MainWindow") -> None:
    sheets, here = window.session.document.sheets, window.session.sheet
    numbered = (_("Sheet {n}").format(n=number) for number in count(len(sheets) + 1))
    name = first_free(numbered, _names(window))
    blank = blank_sheet(here.width_px, here.height_px, name).sheets[0]
    _add(window, blank, len(sheets), _("New sheet"))


def _duplicate(window: "MainWindow") -> None:
    here = window.session.sheet
    copy = replace(here, id="", name=name_of_copy(here.name, _names(window)))
    _add(window, copy, window.session.document.sheets.index(here) + 1, _("Duplicate sheet"))


def _names(window: "MainWindow") -> set[str]:
    return {sheet.name for sheet in window.session.document.sheets}


def _add(window: "MainWindow", sheet: "Sheet", index: int, name: str) -> None:
    session = window.session
    try:
        session.apply(add_sheet(sheet, index), name)
    except DocumentError as problem:
        window.messages.say(problem.short, "error")
        return
    window.files.show_sheet(session.document.sheets[index].id)


def _remove(window: "MainWindow") -> None:
    session = window.session
    sheets, gone = session.document.sheets, session.sheet
    if len(sheets) == 1:
        window.messages.say(_("This is the only sheet, and a picture needs one; add a new sheet first."))
        return
    at = sheets.index(gone)
    session.apply(remove_sheet(gone.id), _("Remove sheet"))
    window.files.show_sheet(sheets[at + 1 if at + 1 < len(sheets) else at - 1].id)
    window.say_status(_("{name} was removed; Undo brings it back.").format(name=legible(gone.name)))


def _ask_for_name(window: "MainWindow") -> None:
    sheet = window.session.sheet
    dialog = QInputDialog(window)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.setWindowTitle(_("Rename sheet"))
    dialog.setLabelText(_("Name of this sheet"))
    dialog.setTextValue(sheet.name)
    dialog.textValueSelected.connect(partial(_rename, window, sheet.id))
    dialog.open()


def _rename(window: "MainWindow", sheet: str, text: str) -> None:
    name = text.strip()
    if not name:
        window.messages.say(_("A sheet needs a name, so the old one was kept."))
        return
    try:
        window.session.apply(rename_sheet(sheet, name), _("Rename sheet"))
    except DocumentError as problem:
        window.messages.say(problem.short, "error")
