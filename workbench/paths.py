"""The only place that knows where files are: the program's own resources and the user's folders.

The variable ``GRAPHICS_WORKBENCH_PROFILE`` names a folder that then holds everything the program keeps
(settings, recovery, cache), so that tests and the tour start from a fresh profile.
``GRAPHICS_WORKBENCH_CACHE`` names only the folder of the compiled readings, which are named by their content
and so serve several profiles.
"""

import errno
import os
import threading
from pathlib import Path

from platformdirs import PlatformDirs

CACHE = "GRAPHICS_WORKBENCH_CACHE"

_PACKAGE = Path(__file__).parent
_USER = PlatformDirs("graphics-workbench", appauthor=False)


def resource(*parts: str) -> Path:
    """Path of a file in ``resources/``: inside the package in a wheel, beside it in a checkout."""
    inside = _PACKAGE / "resources"
    return (inside if inside.is_dir() else _PACKAGE.parent / "resources").joinpath(*parts)


def _kept(name: str, default: str) -> Path:
    profile = os.environ.get("GRAPHICS_WORKBENCH_PROFILE")
    return Path(profile) / name if profile else Path(default)


def home_folder() -> Path:
    """Where a dialog for files begins: the home folder, or where there is none the current one."""
    try:
        return Path.home()
    except RuntimeError:
        return Path()


def make(folder: Path) -> None:
    """Make one of the folders below, with those above it, for this user alone; raises OSError.

    Without a home folder the system names them from ``~``, which nobody means as a folder here.
    """
    if folder.parts[:1] == ("~",):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), "~")
    for each in reversed([folder, *folder.parents]):
        if not each.is_dir():
            each.mkdir(mode=0o700, exist_ok=True)


def try_writing(folder: Path) -> None:
    """Make a folder and write a page there that is gone at once; raises OSError when nothing can be kept."""
    make(folder)
    trial = folder / f".{os.getpid()}-{threading.get_ident()}.trial"
    try:
        trial.write_bytes(bytes(4096))
    finally:
        trial.unlink(missing_ok=True)


def settings_folder() -> Path:
    """Folder of the settings; made by who writes there first, as the others are."""
    return _kept("settings", _USER.user_config_dir)


def recovery_folder() -> Path:
    """Folder of the recovery files and their locks."""
    return _kept("recovery", _USER.user_state_dir)


def cache_folder() -> Path:
    """Folder of the compiled readings; may be deleted at any time."""
    shared = os.environ.get(CACHE)
    return Path(shared) if shared else _kept("cache", _USER.user_cache_dir)
