"""What the program remembers between runs, as an INI file in the settings folder."""

import os
from pathlib import Path
from typing import Any, ClassVar

from PySide6.QtCore import QByteArray, QSettings

from workbench.language import _
from workbench.paths import settings_folder, try_writing

RECENT_LIMIT = 8
_KEY = "recent_files"
_ARRANGEMENTS = "docks"
_OLDER_ARRANGEMENTS = "arrangement"
# No folder can be made below this file: what is set there is only remembered.
_NOWHERE = os.path.join(os.devnull, "settings.ini")


class Settings:
    """Choices with their defaults, recent files, and the arrangement of each workspace.

    A value that cannot be read counts as its default, so a damaged file costs choices, never a start. Where
    nothing can be written, ``problem`` is a sentence that says so, and choices hold until the program ends.
    """

    DEFAULTS: ClassVar[dict[str, Any]] = {
        "theme": "system",
        "large_text": False,
        "calm": True,
        "ask_first": False,
        "hints": True,
    }

    def __init__(self) -> None:
        self.path = settings_folder() / "settings.ini"
        reason = _refusal(self.path)
        kept = not reason or (os.access(self.path, os.R_OK) and self.path.is_file())
        self._store = QSettings(str(self.path) if kept else _NOWHERE, QSettings.Format.IniFormat)
        sentence = _(
            "Your settings will be forgotten when you quit, as {path} cannot be written ({reason}): put that "
            "right and start again."
        )
        self.problem = sentence.format(path=self.path, reason=reason) if reason else ""

    def get(self, name: str) -> Any:
        """The choice ``name``, of the type of its default."""
        default = self.DEFAULTS[name]
        found = self._store.value(name, default)
        if isinstance(default, bool):
            return {"true": True, "false": False}.get(str(found).lower(), default)
        return found if isinstance(found, type(default)) else default

    def set(self, name: str, value: Any) -> None:
        """Remember a choice."""
        assert name in self.DEFAULTS
        self._store.setValue(name, value)

    def recent(self) -> list[Path]:
        """Files opened or saved last, newest first, those that still exist."""
        found: Any = self._store.value(_KEY, [])
        texts = [found] if isinstance(found, str) else [each for each in found or [] if isinstance(each, str)]
        return [
            Path(text) for text in texts if os.path.isfile(text)
        ]  # a folder that is closed to us holds none

    def add_recent(self, path: Path) -> None:
        """Put a file at the head of the recent ones."""
        kept = [path.resolve(), *(other for other in self.recent() if other != path.resolve())]
        self._store.setValue(_KEY, [str(each) for each in kept[:RECENT_LIMIT]])

    def forget_recent(self) -> None:
        """Empty the list of recent files."""
        self._store.remove(_KEY)

    def arrangement(self, name: str) -> QByteArray | None:
        """The remembered arrangement of a workspace, or the window's geometry under ``window``."""
        kept = self._store.value(f"{_ARRANGEMENTS}/{name}")
        return kept if isinstance(kept, QByteArray) and not kept.isEmpty() else None

    def keep_arrangement(self, name: str, state: QByteArray) -> None:
        """Remember an arrangement."""
        self._store.setValue(f"{_ARRANGEMENTS}/{name}", state)

    def forget_arrangement(self, name: str) -> None:
        """Drop a remembered arrangement."""
        self._store.remove(f"{_ARRANGEMENTS}/{name}")

    def drop_older_arrangements(self) -> bool:
        """Drop what versions with one set of docks for all workspaces remembered; whether there was any."""
        self._store.beginGroup(_OLDER_ARRANGEMENTS)
        dropped = bool(self._store.childKeys())
        self._store.endGroup()
        self._store.remove(_OLDER_ARRANGEMENTS)
        return dropped

    def write(self) -> None:
        """Bring everything to the disk now."""
        self._store.sync()


def _refusal(path: Path) -> str:
    """Why nothing can be kept in this file, else ""."""
    try:
        try_writing(path.parent)
        if path.is_file() or path.is_dir():
            path.open("r+b").close()
        elif path.exists():  # to write there would replace it
            return _("it is not a regular file")
    except OSError as error:
        return error.strerror or str(error)
    return ""
