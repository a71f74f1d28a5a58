"""What tells one state of a file on the disk from another."""

import os
from contextlib import suppress
from pathlib import Path

# Nanoseconds of its last change, its size, its number on the disk.
Stamp = tuple[int, int, int]


def stamp(path: Path) -> Stamp | None:
    """The state in which the file is now; None when there is no such file."""
    with suppress(OSError):
        status = os.stat(path)
        return status.st_mtime_ns, status.st_size, status.st_ino
    return None
