"""The sheet of a document that a command is told to take."""

from pathlib import Path

from workbench.cli.failure import BadInputError
from workbench.document.model import Document, Sheet
from workbench.language import ngettext


def sheet_of(document: Document, file: Path, number: int) -> Sheet:
    """The sheet with this number, counted from 1. Raises BadInputError."""
    sheets = document.sheets
    if not 1 <= number <= len(sheets):
        sentence = ngettext(
            "{file} has one sheet, so there is no sheet {number}.",
            "{file} has {count} sheets, so there is no sheet {number}.",
            len(sheets),
        )
        raise BadInputError(sentence.format(file=file, count=len(sheets), number=number))
    return sheets[number - 1]
