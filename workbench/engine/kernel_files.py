"""Where compiled readings are kept: one folder per text, named by everything that went into it.

So are the lowered texts (see ``lowered_files``).

What is kept is unpickled by the compiler, and so could do anything: it is read only from a folder that is the
user's own and nobody else's to write (see ``ownership``), and that holds nothing of anybody else. A checksum
would say nothing more, as who can write a reading can write its checksum. Where the chosen folder is not like
that, or cannot be written, a private one in the temporary folder of the system serves this process and its
children until it ends; where that cannot be either, nothing is kept. All this only costs time, and ``room``
says it.
"""

import atexit
import functools
import hashlib
import importlib.util
import os
import platform
import shutil
import sys
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from workbench import paths
from workbench.engine.ownership import owned, sealed
from workbench.language import _

_PRIVATE = "graphics-workbench-kernels-"
_ENGINE = tuple(
    f"{name}.py" for name in ("arguments", "choices", "compiled", "overloads", "places", "processor", "sinks")
)


@dataclass(frozen=True, slots=True)
class Room:
    """The folder in which kernels are kept, None for nowhere; and why it is not the chosen one, else ""."""

    folder: Path | None
    reason: str = ""


_rooms: dict[Path, Room] = {}


def room() -> Room:
    """Where this process keeps kernels."""
    chosen = paths.cache_folder()
    if chosen not in _rooms:
        reason = _refusal(chosen)
        _rooms[chosen] = _private(reason) if reason else Room(chosen.absolute())
    return _rooms[chosen]


def leave(reason: str) -> None:
    """Go on in a private folder, or without any, as nothing more can be written where kernels are kept."""
    chosen = paths.cache_folder()
    _rooms[chosen] = Room(None, reason) if room().reason else _private(reason)


def _refusal(chosen: Path) -> str:
    try:
        paths.try_writing(chosen)
    except OSError as error:
        return error.strerror or str(error)
    return "" if owned(chosen) else _others_write()


def _others_write() -> str:
    return _("others may write there")


def _private(reason: str) -> Room:
    try:
        folder = Path(tempfile.mkdtemp(prefix=f"{_PRIVATE}{os.getpid()}-")).absolute()
    except OSError:
        return Room(None, reason)
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    _sweep(folder.parent)
    return Room(folder if owned(folder) else None, reason)


def _sweep(temporary: Path) -> None:
    """Remove the private folders of processes that were killed before they could."""
    for folder in temporary.glob(f"{_PRIVATE}*"):
        process = folder.name.removeprefix(_PRIVATE).partition("-")[0]
        if process.isdecimal() and not paths.alive(int(process)) and sealed(folder):
            shutil.rmtree(folder, ignore_errors=True)


@functools.cache
def _surroundings() -> str:
    """What a kernel depends on beside its own text: the sinks, the compiler, the processor."""
    texts = [(Path(__file__).parent / name).read_text(encoding="utf-8") for name in _ENGINE]
    versions = [f"{name} {_version(name)}" for name in ("numba", "llvmlite", "numpy")]
    return "\0".join([*texts, *versions, sys.version, _processor()])


def _version(name: str) -> str:
    import importlib.metadata

    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return ""


def _processor() -> str:
    """Distinguishes processors that share a home folder: code is compiled for one of them."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return f"{platform.machine()} {platform.processor()}"
    return "\n".join(
        next((line for line in lines if line.startswith(field)), "")
        for field in ("model name", "flags", "Features")
    )


def key(text: str, flavour: str) -> str:
    """The name of what is compiled from a text: the same for the same text, compiler and processor."""
    return hashlib.sha256("\0".join([text, flavour, _surroundings()]).encode()).hexdigest()[:32]


def place(name: str) -> Path | None:
    """The folder for what has this key, which need not exist; None when nothing is kept."""
    folder = room().folder
    return None if folder is None else folder / name


def read(name: str, file: str) -> str | None:
    """What ``file`` in this place says, None where there is none or others may have written it."""
    folder = place(name)
    try:
        return (folder / file).read_text(encoding="utf-8") if folder is not None and sealed(folder) else None
    except (OSError, UnicodeDecodeError):
        return None


def write(text: str, name: str, file: str = "kernel.py") -> Path | None:
    """Put ``text`` into ``file`` in its place; its path, or None when nothing can be kept."""
    while (folder := place(name)) is not None:
        target = folder / file
        try:
            if not sealed(folder):
                discard(name)
            paths.try_writing(folder / "__pycache__")  # the compiler writes there
            if not sealed(folder):
                leave(_others_write())
            elif _reads(target, text):
                return target
            else:
                _replace(target, text)
        except OSError as error:
            leave(error.strerror or str(error))
    return None


def _reads(target: Path, text: str) -> bool:
    try:
        return target.read_text(encoding="utf-8") == text
    except (FileNotFoundError, UnicodeDecodeError):
        return False


def _replace(target: Path, text: str) -> None:
    handle, name = tempfile.mkstemp(dir=target.parent, suffix=".tmp")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(name, target)
    except OSError:
        os.unlink(name)
        raise


def load(target: Path, marks: dict[str, Any]) -> ModuleType:
    """Import the text at ``target``; its decorators are what is given here by name."""
    name = f"workbench_kernel_{target.parent.name}"
    specification = importlib.util.spec_from_file_location(name, target)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    vars(module).update(marks)
    sys.modules[name] = module
    specification.loader.exec_module(module)
    return module


def mark(name: str, use: str) -> None:
    """Note that this use of a kernel has been compiled here."""
    folder = place(name)
    if folder is not None:
        with suppress(OSError):
            (folder / f"{use}.ready").touch()


def marked(name: str, use: str) -> bool:
    """Whether this use of a kernel was compiled here before."""
    folder = place(name)
    return folder is not None and (folder / f"{use}.ready").is_file()


def marks(name: str) -> set[str]:
    """All uses of a kernel that were compiled here before."""
    folder = place(name)
    try:
        return set() if folder is None else {path.stem for path in folder.glob("*.ready")}
    except OSError:
        return set()


@contextmanager
def alone(name: str, unless: bool = False) -> Iterator[None]:
    """Compile what has this key while no other process does: two would give one number to different code.

    ``unless`` it is only to be read. Where nothing can be locked nothing can be kept, either.
    """
    folder = None if unless else place(name)
    if folder is None:
        yield
        return
    from filelock import FileLock  # slow to import

    lock = FileLock(folder.with_suffix(".lock"))
    with suppress(OSError, NotImplementedError):
        lock.acquire()
    try:
        yield
    finally:
        lock.release()


def discard(name: str) -> None:
    """Throw away what is kept under this key, as far as that can be."""
    folder = place(name)
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)


def given_up(name: str, error: Exception, again: bool) -> bool:
    """Whether reading or writing what is kept raised ``error``, so that nothing has run yet.

    It is then thrown away, or left where that did not help or where the disk refuses.
    """
    frames = traceback.extract_tb(error.__traceback__)
    if not any(Path(frame.filename).name == "caching.py" for frame in frames):
        return False
    if again or isinstance(error, OSError):
        leave(getattr(error, "strerror", None) or str(error))
    else:
        discard(name)
    return True
