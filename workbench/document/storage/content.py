"""What is read from outside: the content of a regular file, bounded, with progress, and ended when asked.

A pipe, a device or a folder is refused before a byte is waited for.
"""

import os
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from workbench.document.errors import DocumentError
from workbench.language import _, reason_of

# Called with the share that is done, 0 to 1, at least every few milliseconds. What it raises ends the work.
Progress = Callable[[float], None]

_CHUNK = 2**20


class Stopped(Exception):  # noqa: N818 - nothing went wrong
    """Raised by a ``Progress`` to end the work that reports to it."""


def silent(share: float) -> None:
    """The progress that nobody watches."""


def part(progress: Progress, begin: float, end: float) -> Progress:
    """The progress of a part of the work that goes from share ``begin`` to ``end`` of the whole."""
    return lambda share: progress(begin + (end - begin) * min(share, 1.0))


def read_content(path: Path | str, most: int, progress: Progress = silent) -> bytes:
    """The bytes of a regular file that has at most ``most``; raises DocumentError."""
    check_file(path, most)
    where = str(path)
    with _said_of(where), open(path, "rb", opener=_unwaiting) as file:
        size = os.fstat(file.fileno())
        _refuse_irregular(size, where, most)
        parts: list[bytes] = []
        read = 0
        while part := file.read(_CHUNK):
            parts.append(part)
            read += len(part)
            if read > most:  # it grows while it is read
                raise _too_large(where, read, most)
            progress(min(read / max(size.st_size, 1), 1.0))
        return b"".join(parts)


def check_file(path: Path | str, most: int) -> None:
    """Raise DocumentError for what is no regular file of at most ``most`` bytes: what it is, what to do."""
    with _said_of(str(path)):
        _refuse_irregular(os.stat(path), str(path), most)


@contextmanager
def _said_of(where: str) -> Iterator[None]:
    """Whatever the system refuses becomes a DocumentError that says so in a sentence."""
    try:
        yield
    except FileNotFoundError as error:
        raise DocumentError("", _("There is no file {path}; choose another.").format(path=where)) from error
    except PermissionError as error:
        sentence = _("You are not allowed to read {path}; change its permissions or choose another file.")
        raise DocumentError("", sentence.format(path=where)) from error
    except (OSError, ValueError) as error:
        if isinstance(error, DocumentError):
            raise
        reason = reason_of(error)
        sentence = _("{path} cannot be read ({reason}); choose another file.")
        raise DocumentError("", sentence.format(path=where, reason=reason)) from error


def read_text(path: Path | str, most: int, progress: Progress = silent) -> str:
    """The text of a regular file in UTF-8, with or without its mark; raises DocumentError."""
    return decoded(read_content(path, most, progress), path)


def decoded(content: bytes, path: Path | str) -> str:
    """The text of what was read of the file ``path``, as ``read_text`` gives it; raises DocumentError."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        sentence = _("{path} is not UTF-8 text; save it as UTF-8, or choose another file.")
        raise DocumentError("", sentence.format(path=path)) from error


def _refuse_irregular(status: os.stat_result, where: str, most: int) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise DocumentError("", _("{path} is a folder; choose a file in it.").format(path=where))
    if stat.S_ISFIFO(status.st_mode):
        sentence = _("{path} is a pipe; write what comes out of it to a file, and open that.")
        raise DocumentError("", sentence.format(path=where))
    if not stat.S_ISREG(status.st_mode):
        device = stat.S_ISCHR(status.st_mode) or stat.S_ISBLK(status.st_mode)
        sentence = (
            _("{path} is a device; choose a file.") if device else _("{path} is a socket; choose a file.")
        )
        raise DocumentError("", sentence.format(path=where))
    if status.st_size > most:
        raise _too_large(where, status.st_size, most)


def _too_large(where: str, size: int, most: int) -> DocumentError:
    sentence = _("{path} has {size:,} bytes, but at most {most:,} can be opened; choose another file.")
    return DocumentError("", sentence.format(path=where, size=size, most=most))


def _unwaiting(path: str, flags: int) -> int:
    """A descriptor that does not wait for the other end of a pipe that has just taken the file's place."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0), 0o666)
