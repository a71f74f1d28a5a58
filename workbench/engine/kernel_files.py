"""Where compiled readings are kept: one folder per text, named by everything that went into it.

A folder that cannot be written, or that holds rubbish, only costs time: another one in the temporary folder
of the system serves this process.
"""

import functools
import hashlib
import importlib.metadata
import importlib.util
import os
import platform
import shutil
import sys
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from workbench import paths

_ENGINE = ("sinks.py", "compiled.py")


@functools.cache
def _surroundings() -> str:
    """What a kernel depends on beside its own text: the sinks, the compiler, the processor."""
    texts = [(Path(__file__).parent / name).read_text(encoding="utf-8") for name in _ENGINE]
    versions = [f"{name} {_version(name)}" for name in ("numba", "llvmlite", "numpy")]
    return "\0".join([*texts, *versions, sys.version, _processor()])


def _version(name: str) -> str:
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


def folder(text: str, flavour: str) -> Path:
    """The folder for a text; it need not exist."""
    key = hashlib.sha256("\0".join([text, flavour, _surroundings()]).encode()).hexdigest()
    return paths.cache_folder() / key[:2] / key[2:34]


def write(text: str, wanted: Path) -> Path:
    """Put ``text`` into ``kernel.py`` under ``wanted``, else under a temporary folder; its path."""
    target = wanted / "kernel.py"
    try:
        if target.is_file() and target.read_text(encoding="utf-8") == text:
            _try_writing(wanted)
            return target
        _replace(target, text)
        _try_writing(wanted)
    except (OSError, UnicodeDecodeError):
        target = _temporary() / wanted.name / "kernel.py"
        _replace(target, text)
    return target


def _replace(target: Path, text: str) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=target.parent, suffix=".tmp")
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(name, target)


def _try_writing(place: Path) -> None:
    """The compiler writes beside the text, so the folder must let it."""
    inside = place / "__pycache__"
    inside.mkdir(exist_ok=True)
    if not os.access(inside, os.W_OK):
        raise PermissionError(str(inside))


@functools.cache
def _temporary() -> Path:
    return Path(tempfile.mkdtemp(prefix="graphics-workbench-"))


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


def mark(place: Path, use: str) -> None:
    """Note that this use of a kernel has been compiled here."""
    try:
        (place / f"{use}.ready").touch()
    except OSError:
        return


def marked(place: Path, use: str) -> bool:
    """Whether this use of a kernel was compiled here before."""
    return (place / f"{use}.ready").is_file()


def marks(place: Path) -> set[str]:
    """All uses of a kernel that were compiled here before."""
    try:
        return {path.stem for path in place.glob("*.ready")}
    except OSError:
        return set()


@contextmanager
def alone(place: Path) -> Iterator[None]:
    """Compile into a folder while no other process does: two would give one number to different code.

    Where nothing can be locked nothing can be kept, either.
    """
    from filelock import FileLock  # slow to import

    lock = FileLock(place.with_suffix(".lock"))
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except (OSError, NotImplementedError):
        yield
        return
    try:
        yield
    finally:
        lock.release()


def discard(place: Path) -> None:
    """Throw a folder away that holds rubbish, as far as that can be."""
    shutil.rmtree(place, ignore_errors=True)


def came_from_cache(error: BaseException) -> bool:
    """Whether reading a kept kernel raised this, so that nothing has run yet."""
    frames = traceback.extract_tb(error.__traceback__)
    return any(Path(frame.filename).name == "caching.py" for frame in frames)
