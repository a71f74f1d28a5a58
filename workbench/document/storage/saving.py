"""Replacing files atomically: whatever happens, the old content or the new one is there whole."""

import errno
import os
import secrets
import shutil
import stat
import sys
import zlib
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import NamedTuple

from workbench.document.errors import DocumentError
from workbench.language import _, legible, reason_of
from workbench.paths import alive

_ENDING = ".saving"
_CHUNK = 2**18
_LONGEST_FOLDER = 300
_EXCLUSIVE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)


class SavingError(DocumentError):
    """A file could not be put on the disk; the sentence names it, and what was there is untouched."""

    def __init__(self, message: str) -> None:
        super().__init__("", message)


class _Staged(NamedTuple):
    path: Path
    target: Path
    temporary: Path
    existed: bool


class Replacement:
    """Files that take the places of those of their names together, in ``commit``, or not at all.

    Until then they stand beside them, under names that nobody can guess; leaving the ``with`` block without
    ``commit`` removes them.
    """

    def __init__(self) -> None:
        self._staged: list[_Staged] = []

    def __enter__(self) -> "Replacement":
        return self

    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        for staged in self._staged:
            with suppress(OSError):
                staged.temporary.unlink()
        self._staged.clear()

    def put(self, path: Path, data: bytes | Iterable[bytes]) -> None:
        """Let ``data`` be the content of ``path``, which keeps its permissions; links are followed.

        What comes in pieces is never held as a whole; what making them raises is passed on.
        Raises SavingError when the file system refuses, or gives back other bytes.
        """
        try:
            target = Path(os.path.realpath(path))
            old = _replaceable(path, target)
            sweep(target.parent, _prefix(target))
            temporary = _beside(target)
            descriptor = os.open(temporary, _EXCLUSIVE, 0o666)
            self._staged.append(_Staged(path, target, temporary, old is not None))
            written = _fill(descriptor, (data,) if isinstance(data, bytes) else data, old)
            back = _read_back(temporary)
        except DocumentError:
            raise
        except (OSError, ValueError) as error:
            raise refusal(path, error) from error
        if back != written:
            raise SavingError(
                _("{path} does not read back from the disk the same; save under another name.").format(
                    path=path
                )
            )

    def commit(self) -> None:
        """Let every file take its place. Raises SavingError, and then those before it have theirs back."""
        done: list[tuple[_Staged, Path | None]] = []
        alone = len(self._staged) == 1
        try:
            for staged in self._staged:
                kept = None
                try:
                    kept = _kept(staged.target) if staged.existed and not alone else None
                    done.append((staged, kept))
                    os.replace(staged.temporary, staged.target)
                except OSError as error:
                    raise refusal(staged.path, error) from error
        except BaseException:
            for staged, kept in reversed(done):
                _give_back(staged, kept)
            raise
        finally:
            for _each, kept in done:
                if kept is not None:
                    with suppress(OSError):
                        kept.unlink()
        for folder in {staged.target.parent for staged in self._staged}:
            _sync_folder(folder)


def replace_file(path: Path, data: bytes | Iterable[bytes]) -> None:
    """Make ``data`` the content of ``path``, keeping its permissions and following symbolic links.

    ``data`` is as in ``Replacement.put``. Raises SavingError when the file system refuses;
    then the old file is as it was.
    """
    with Replacement() as replacement:
        replacement.put(path, data)
        replacement.commit()


def _replaceable(path: Path, target: Path) -> os.stat_result | None:
    """What is at ``target`` now; None when nothing is. Raises SavingError when it is to be left alone."""
    try:
        old = os.stat(target)
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(old.st_mode):
        raise SavingError(_("{path} is a folder; choose another name.").format(path=path))
    if not stat.S_ISREG(old.st_mode):
        raise SavingError(_("{path} is a device, not a file; choose another name.").format(path=path))
    if not os.access(target, os.W_OK):
        raise SavingError(_("{path} may not be changed; save under another name.").format(path=path))
    return old


def refusal(path: Path, error: OSError | ValueError) -> SavingError:
    """The sentence that says why ``path`` cannot be written."""
    number = error.errno if isinstance(error, OSError) else None
    match number:
        case errno.ENOENT | errno.ENOTDIR if os.path.islink(path):
            sentence = _("{path} is a link to {target}, whose folder does not exist; choose another name.")
        case errno.ENOENT | errno.ENOTDIR if not os.path.isdir(path.parent):
            sentence = _("There is no folder {folder} for {name}; choose another folder.")
        case errno.EACCES | errno.EPERM:
            sentence = _("You are not allowed to write {name} in the folder {folder}; choose another folder.")
        case errno.EROFS:
            sentence = _("The disk of {path} is read-only; choose a folder on another disk.")
        case errno.ENOSPC | errno.EDQUOT:
            sentence = _("{path} cannot be written ({reason}); make room, or choose another disk.")
        case errno.EFBIG:
            sentence = _("{path} would be larger than a file may be here; choose another disk.")
        case errno.ENAMETOOLONG:
            sentence = _("The name {longest} is too long; choose a shorter one.")
        case errno.ELOOP:
            sentence = _("{path} is a link that leads back to itself; choose another name.")
        case _:
            sentence = _("{path} cannot be written ({reason}); choose another folder.")
    reason = reason_of(error)
    name, folder = legible(path.name), legible(str(path.parent), _LONGEST_FOLDER)
    whole = legible(str(path), _LONGEST_FOLDER) if len(str(path)) <= _LONGEST_FOLDER else name
    longest = legible(max(path.parts, key=len, default=""))
    target = legible(os.readlink(path), _LONGEST_FOLDER) if os.path.islink(path) else ""
    return SavingError(
        sentence.format(path=whole, name=name, folder=folder, reason=reason, longest=longest, target=target)
    )


def _prefix(target: Path) -> str:
    return f".{target.name[:40]}-{zlib.crc32(os.fsencode(target.name)):08x}."


def _beside(target: Path) -> Path:
    """A name beside ``target`` that nobody can guess, and that tells which process it belongs to."""
    return target.with_name(f"{_prefix(target)}{secrets.token_hex(8)}.{os.getpid()}{_ENDING}")


def _fill(descriptor: int, pieces: Iterable[bytes], old: os.stat_result | None) -> tuple[int, int]:
    """Write ``pieces``; how many bytes these are, and their checksum."""
    written = (0, 0)
    with open(descriptor, "wb") as file:
        if old is not None and sys.platform != "win32":
            with suppress(PermissionError):
                os.fchown(descriptor, old.st_uid, old.st_gid)
            os.fchmod(descriptor, stat.S_IMODE(old.st_mode))
        for piece in pieces:
            file.write(piece)
            written = _counted(written, piece)
        file.flush()
        os.fsync(descriptor)
    return written


def _read_back(path: Path) -> tuple[int, int]:
    """As many bytes as are there, and their checksum."""
    back = (0, 0)
    with open(path, "rb") as file:
        while chunk := file.read(_CHUNK):
            back = _counted(back, chunk)
    return back


def _counted(before: tuple[int, int], piece: bytes) -> tuple[int, int]:
    return before[0] + len(piece), zlib.crc32(piece, before[1])


def _kept(target: Path) -> Path:
    """What is at ``target``, once more beside it."""
    kept = _beside(target)
    try:
        os.link(target, kept)
    except OSError:  # a file system without links
        try:
            with open(os.open(kept, _EXCLUSIVE, 0o600), "wb") as copy, open(target, "rb") as original:
                shutil.copyfileobj(original, copy)
            shutil.copystat(target, kept)
        except OSError:
            with suppress(OSError):
                kept.unlink()
            raise
    return kept


def _give_back(staged: _Staged, kept: Path | None) -> None:
    """Let ``staged.target`` be as before; what was new is removed, unless it never came there."""
    with suppress(OSError):
        if kept is not None:
            os.replace(kept, staged.target)
        elif not staged.temporary.exists() and not staged.existed:
            staged.target.unlink()


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
        if number.isdecimal() and not alive(int(number)):
            with suppress(OSError):
                os.unlink(entry.path)
