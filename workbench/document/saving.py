"""Replacing a file atomically: whatever happens, the old text or the new one is there whole."""

import os
import stat
import sys
import zlib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from workbench.document.errors import DocumentError
from workbench.language import _

_ENDING = ".saving"


def replace_file(path: Path, data: bytes, verify: Callable[[bytes], None]) -> None:
    """Make ``data`` the content of ``path``, keeping its permissions and following symbolic links.

    ``verify`` is given what was read back from the disk before the old file is replaced, and raises what it
    finds wrong. Raises DocumentError when the file system refuses; then the old file is as it was.
    """
    try:
        target = Path(os.path.realpath(path))
        old = target.stat() if target.exists() else None
        if old is not None and not stat.S_ISREG(old.st_mode):
            raise DocumentError("", _("{path} is not a file; choose another name.").format(path=path))
        if old is not None and not os.access(target, os.W_OK):
            raise DocumentError(
                "", _("{path} may not be changed; save under another name.").format(path=path)
            )
        sweep(target.parent, _prefix(target))
        temporary = target.with_name(f"{_prefix(target)}{os.getpid()}{_ENDING}")
        try:
            _put(temporary, data, old)
            verify(temporary.read_bytes())
            os.replace(temporary, target)
        except BaseException:
            with suppress(OSError):
                temporary.unlink()
            raise
        _sync_folder(target.parent)
    except (OSError, ValueError) as error:
        if isinstance(error, DocumentError):
            raise
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        sentence = _("{path} cannot be saved ({reason}); choose another folder, or make room.")
        raise DocumentError("", sentence.format(path=path, reason=reason)) from error


def _prefix(target: Path) -> str:
    return f".{target.name[:40]}-{zlib.crc32(os.fsencode(target.name)):08x}."


def _put(temporary: Path, data: bytes, old: os.stat_result | None) -> None:
    descriptor = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0), 0o666)
    with open(descriptor, "wb") as file:
        if old is not None and sys.platform != "win32":
            with suppress(PermissionError):
                os.fchown(descriptor, old.st_uid, old.st_gid)
            os.fchmod(descriptor, stat.S_IMODE(old.st_mode))
        file.write(data)
        file.flush()
        os.fsync(descriptor)


def _sync_folder(folder: Path) -> None:
    """Let the new name itself reach the disk; some file systems cannot, and lose nothing by it."""
    if sys.platform == "win32":
        return
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def sweep(folder: Path, prefix: str = ".") -> None:
    """Remove what processes that died while saving left in ``folder``, under names with ``prefix``."""
    with os.scandir(folder) as entries:
        left = [entry for entry in entries if entry.name.startswith(prefix) and entry.name.endswith(_ENDING)]
    for entry in left:
        number = entry.name.removesuffix(_ENDING).rpartition(".")[2]
        if number.isdecimal() and not _alive(int(number)):
            with suppress(OSError):
                os.unlink(entry.path)


def _alive(process: int) -> bool:
    if sys.platform == "win32":
        # An open file cannot be unlinked there, so that trying is the test.
        return process == os.getpid()
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True
