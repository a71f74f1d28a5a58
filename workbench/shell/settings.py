"""What the program remembers between runs, as an INI file in the settings folder."""

import os
import stat
from contextlib import suppress
from pathlib import Path
from typing import Any, ClassVar

from PySide6.QtCore import QByteArray, QLockFile, QSettings

from workbench.language import _
from workbench.paths import settings_folder, try_writing

RECENT_LIMIT = 8
_KEY = "recent_files"
_MOST_BYTES = 1_000_000
_PATIENCE_MS = 100
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
        obstacle = _obstacle(self.path)
        reason = obstacle or _refusal(self.path)
        kept = not reason or (not obstacle and os.access(self.path, os.R_OK) and self.path.is_file())
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


def _obstacle(path: Path) -> str:
    """Why this file is better not touched, else "": QSettings reads it whole, and waits long for its lock."""
    lock = Path(f"{path}.lock")
    with suppress(OSError):  # that is for _refusal to say
        if os.path.isfile(path) and path.stat().st_size > _MOST_BYTES:
            return _("it has over {most:,} bytes").format(most=_MOST_BYTES)
        if os.path.lexists(lock):
            if not stat.S_ISREG(lock.lstat().st_mode):
                return _("{lock} is in the way").format(lock=lock.name)
            trial = QLockFile(str(lock))
            if not trial.tryLock(_PATIENCE_MS):
                return _("another program holds {lock}").format(lock=lock.name)
            trial.unlock()
    return ""


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
