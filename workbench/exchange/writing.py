"""How everything that leaves the program is written: a format says how, and one writer does it.

A format encodes what it is given; the writer puts the result beside its place, and there only when it is
whole. Whoever cancels, or whatever fails, leaves the disk as it was.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbench.document.storage.saving import Replacement
from workbench.language import _

Progress = Callable[[int, int], None]
Put = Callable[[bytes | Iterable[bytes]], None]
Encode = Callable[[Any, Put, Progress], object]

# What stands behind the last point of a name is an ending when it looks like one: "lab 2.3" has none.
_ENDING = re.compile(r"\.[a-z][a-z0-9]{0,7}", re.IGNORECASE)


class SuffixError(ValueError):
    """A file is named as nothing of its kind is; the sentence says which endings there are."""


class Cancelled(Exception):  # noqa: N818 (nothing is wrong)
    """Raised by a ``Progress`` to end a writing that is under way; then nothing is written."""


@dataclass(frozen=True, slots=True)
class FileFormat:
    """How one kind of content is written under one suffix.

    ``encode(content, put, told)`` gives every whole file to ``put`` and tells how many of its parts are done,
    which may raise Cancelled. ``numbered`` formats put a file for each part.
    """

    kind: str
    suffix: str
    title: str
    encode: Encode
    numbered: bool = False

    def paths(self, path: Path, parts: int) -> list[Path]:
        """The files that are written under the name ``path`` for content of so many parts."""
        if not self.numbered:
            return [path]
        digits = max(3, len(str(parts - 1)))
        return [path.with_stem(f"{path.stem}-{number:0{digits}d}") for number in range(parts)]


def whole(make: Callable[[Any], bytes | Iterable[bytes]]) -> Encode:
    """The ``encode`` of a format whose content becomes one file in one go."""

    def encode(content: Any, put: Put, _told: Progress) -> None:
        put(make(content))

    return encode


def of_kind(formats: Sequence[FileFormat], kind: str) -> tuple[FileFormat, ...]:
    """The ways in which one kind of content is written, the proposed one first."""
    return tuple(file_format for file_format in formats if file_format.kind == kind)


def format_for(formats: Sequence[FileFormat], path: Path) -> FileFormat:
    """The format that the name ``path`` asks for. Raises SuffixError, naming all there are."""
    for file_format in formats:
        if path.suffix.lower() == file_format.suffix:
            return file_format
    endings = [file_format.suffix for file_format in formats]
    listed = _(" or ").join(filter(None, (", ".join(endings[:-1]), endings[-1])))
    sentence = _("{name}: choose a name that ends in {endings}.")
    raise SuffixError(sentence.format(name=path.name or path, endings=listed))


def completed(formats: Sequence[FileFormat], path: Path, chosen: FileFormat) -> tuple[Path, FileFormat]:
    """``path`` with the suffix of ``chosen`` where it has none, and its format. Raises SuffixError."""
    known = path.suffix.lower() in {file_format.suffix for file_format in formats}
    if not known and not _ENDING.fullmatch(path.suffix):
        path = path.with_name(path.name.rstrip(".") + chosen.suffix)
    return path, format_for(formats, path)


def write(
    file_format: FileFormat, content: Any, path: Path, told: Progress = lambda _done, _parts: None
) -> list[Path]:
    """Write ``content`` under the name ``path``; the files that were written.

    ``told`` is called with how many parts are done, of how many, and may raise Cancelled. Raises SavingError
    when the file system refuses, and what the encoding raises; then every file is as it was before.
    """
    parts = getattr(content, "parts", 1)
    paths = file_format.paths(path, parts)
    waiting = iter(paths)
    with Replacement() as replacement:
        file_format.encode(content, lambda data: replacement.put(next(waiting), data), told)
        told(parts, parts)
        replacement.commit()
    return paths
