"""The path of a file as a text that every file can hold, and back, whatever bytes its name has."""

import os
from pathlib import Path
from urllib.parse import quote_from_bytes, unquote_to_bytes

_QUOTED = "bytes:"  # no absolute path begins so


def text_of(path: Path) -> str:
    """The absolute path; one that is not UTF-8 with its bytes quoted."""
    name = str(path.absolute())
    try:
        name.encode()
    except UnicodeEncodeError:
        return _QUOTED + quote_from_bytes(os.fsencode(name))
    return name


def path_of(text: str | None) -> Path | None:
    """The path that ``text_of`` made a text of; None for a text that is none."""
    name = text or ""
    if name.startswith(_QUOTED):
        name = os.fsdecode(unquote_to_bytes(name.removeprefix(_QUOTED)))
    return Path(name) if name and "\0" not in name else None
