"""The commands of the menu Edit: they act on what has the focus."""

from workbench.language import _
from workbench.shell import clipboard
from workbench.shell.actions import Command


def edit_commands() -> tuple[Command, ...]:
    """Undo and redo, then what is done to a selection."""
    return (
        Command(
            "undo",
            _("Undo"),
            lambda w: w.undo(),
            ("Ctrl+Z",),
            "arrow-u-up-left",
            _("Take the last edit back"),
            "edit",
            "document",
        ),
        Command(
            "redo",
            _("Redo"),
            lambda w: w.redo(),
            ("Ctrl+Shift+Z", "Ctrl+Y"),
            "arrow-u-up-right",
            _("Make the edit again"),
            "edit",
            "document",
        ),
        Command(
            "cut",
            _("Cut"),
            clipboard.cut,
            ("Ctrl+X",),
            "scissors",
            _("Copy what is selected, and remove it"),
            "edit",
            "document",
            separated=True,
        ),
        Command(
            "copy",
            _("Copy"),
            clipboard.copy,
            ("Ctrl+C",),
            "copy",
            _("Copy what has the focus: figures, the picture, or a table"),
            "edit",
            "document",
        ),
        Command(
            "paste",
            _("Paste"),
            clipboard.paste,
            ("Ctrl+V",),
            "clipboard-text",
            _("Paste figures, points or SVG"),
            "edit",
            "document",
        ),
        Command(
            "duplicate",
            _("Duplicate"),
            clipboard.duplicate,
            (),
            "copy-simple",
            _("Copy the selected figures beside themselves"),
            "edit",
            "document",
            separated=True,
            focused_key="Ctrl+D",
        ),
        Command(
            "delete",
            _("Delete"),
            clipboard.delete,
            (),
            "trash",
            _("Remove what is selected"),
            "edit",
            "document",
            focused_key="Del",
        ),
        Command(
            "select_all",
            _("Select all"),
            clipboard.select_all,
            (),
            "selection-all",
            _("Select all figures, points or words where the focus is"),
            "edit",
            "document",
            focused_key="Ctrl+A",
        ),
    )
