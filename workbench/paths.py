"""The only place that knows where files are: the program's own resources and the user's folders.

The variable ``GRAPHICS_WORKBENCH_PROFILE`` names a folder that then holds everything the program keeps
(settings, recovery, cache), so that tests and the tour start from a fresh profile.
``GRAPHICS_WORKBENCH_CACHE`` names only the folder of the compiled readings, which are named by their content
and so serve several profiles.
"""

import errno
import os
import sys
import threading
from pathlib import Path

from platformdirs import PlatformDirs

# Of Windows.
_SYNCHRONIZE = 0x00100000
_ACCESS_DENIED = 5
_STILL_RUNNING = 0x102

CACHE = "GRAPHICS_WORKBENCH_CACHE"

_PACKAGE = Path(__file__).parent
_USER = PlatformDirs("graphics-workbench", appauthor=False)


def resource(*parts: str) -> Path:
    """Path of a file in ``resources/``: inside the package in a wheel, beside it in a checkout."""
    inside = _PACKAGE / "resources"
    return (inside if inside.is_dir() else _PACKAGE.parent / "resources").joinpath(*parts)


def _kept(name: str, kind: str) -> Path:
    profile = os.environ.get("GRAPHICS_WORKBENCH_PROFILE")
    if profile:
        return Path(profile) / name
    try:
        return Path(getattr(_USER, kind))
    except RuntimeError:  # there is no home folder, and ``make`` refuses this
        return Path("~") / name


def home_folder() -> Path:
    """Where a dialog for files begins: the home folder, or where there is none the current one."""
    try:
        return Path.home()
    except RuntimeError:
        return Path()


def make(folder: Path) -> None:
    """Make one of the folders below, with those above it, for this user alone.

    Raises OSError, also for one below ``~``, which is where they are for a user without a home folder.
    """
    if folder.parts[:1] == ("~",):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), "~")
    for each in reversed([folder, *folder.parents]):
        if not each.is_dir():
            try:
                each.mkdir(mode=0o700, exist_ok=True)
            except FileExistsError:
                raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(each)) from None


def try_writing(folder: Path) -> None:
    """Make a folder and write a page there that is gone at once; raises OSError when nothing can be kept."""
    make(folder)
    trial = folder / f".{os.getpid()}-{threading.get_ident()}.trial"
    try:
        trial.write_bytes(bytes(4096))
    finally:
        trial.unlink(missing_ok=True)


def alive(process: int) -> bool:
    """Whether a process with this number is there."""
    if sys.platform == "win32":
        import ctypes

        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.OpenProcess.restype = ctypes.c_void_p
        handle = ctypes.c_void_p(kernel.OpenProcess(_SYNCHRONIZE, False, process & 0xFFFFFFFF))
        if not handle:
            return ctypes.get_last_error() == _ACCESS_DENIED  # it is another user's
        try:
            return bool(kernel.WaitForSingleObject(handle, 0) == _STILL_RUNNING)
        finally:
            kernel.CloseHandle(handle)
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True


def settings_folder() -> Path:
    """Folder of the settings; made by who writes there first, as the others are."""
    return _kept("settings", "user_config_dir")


def recovery_folder() -> Path:
    """Folder of the recovery files and their locks."""
    return _kept("recovery", "user_state_dir")


def cache_folder() -> Path:
    """Folder of the compiled readings; may be deleted at any time."""
    shared = os.environ.get(CACHE)
    return Path(shared) if shared else _kept("cache", "user_cache_dir")
