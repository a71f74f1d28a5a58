"""What the program remembers between runs, as an INI file in the settings folder."""

from pathlib import Path
from typing import Any, ClassVar

from PySide6.QtCore import QByteArray, QSettings

from workbench.paths import settings_folder

RECENT_LIMIT = 8
_KEY = "recent_files"
_ARRANGEMENTS = "docks"
_OLDER_ARRANGEMENTS = "arrangement"


class Settings:
    """Choices with their defaults, recent files, and the arrangement of each workspace.

    A value that cannot be read counts as its default, so a damaged file costs choices, never a start.
    """

    DEFAULTS: ClassVar[dict[str, Any]] = {
        "theme": "system",
        "large_text": False,
        "calm": True,
        "ask_first": False,
        "hints": True,
    }

    def __init__(self) -> None:
        folder = settings_folder()
        folder.mkdir(parents=True, exist_ok=True)
        self._store = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)

    @property
    def path(self) -> Path:
        """The file."""
        return Path(self._store.fileName())

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
        return [path for path in map(Path, texts) if path.is_file()]

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
