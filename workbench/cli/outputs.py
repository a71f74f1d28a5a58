"""Where the commands write: by the table of what can be written, with sentences for a command line."""

from pathlib import Path
from typing import Any

from workbench.cli.failure import BadInputError, WorkError
from workbench.document.storage.saving import SavingError
from workbench.exchange import writing, written


def format_for(*kinds: str, path: Path) -> writing.FileFormat:
    """How ``path`` asks for one of ``kinds`` to be written. Raises BadInputError, naming all endings."""
    try:
        return writing.format_for([each for kind in kinds for each in written.formats(kind)], path)
    except writing.SuffixError as error:
        raise BadInputError(str(error)) from None


def write(chosen: writing.FileFormat, content: Any, path: Path) -> None:
    """Write ``content``. Raises WorkError where the disk refuses, BadInputError for wrong content."""
    try:
        writing.write(chosen, content, path)
    except SavingError as error:
        raise WorkError(str(error)) from None
    except ValueError as error:
        raise BadInputError(str(error)) from None
