"""Compiles ahead, in a process of its own at low priority, what a workspace is about to need.

The parent starts ``Warming`` and reads its progress; it then only loads what lies in the cache. The child
prints one line per kernel, ``done total slug use``, or per module that has several, and one with ``failed``
first where a text was refused. It keeps kernels where its parent does, and ends with ``full`` and the reason
when nothing more can be written there; the parent then goes on elsewhere, if there is anywhere (see
``kernel_files``).
"""

import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from workbench import paths
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine import batches, compiled, counts, kernel_files, touches
from workbench.engine.arguments import kinds, only_numbers
from workbench.engine.at_hand import at_hand
from workbench.engine.drivers import PAINTING, takes_batches
from workbench.engine.turns import interface

# In the order in which they are felt: a drag, the step bar, a question about a pixel.
PICTURES = ("paint_batch", "collect_many", "collect")
"""What a picture is drawn by, where it is at hand."""

USES = ("paint_batch", "collect_many", "paint", "collect", "count", "probe", "hits")


@dataclass(frozen=True, slots=True)
class Progress:
    """How far the child has come; ``slug`` and ``use`` name what it has just finished."""

    done: int
    total: int
    slug: str
    use: str


class Warming:
    """A child process that compiles the entries named, most used first.

    ``uses`` are those of ``USES`` that are wanted. ``modules`` have texts that are in no entry, as ``TEXTS``,
    and a function ``compile_all``; they come first, since what runs all the time stands on them. Without a
    compiler, or without anything to do, no process is started and ``finished`` holds at once.
    """

    def __init__(self, slugs: Sequence[str], uses: Sequence[str] = USES, modules: Sequence[str] = ()) -> None:
        self._process: subprocess.Popen[str] | None = None
        self._starting = threading.Lock()
        self._stopped = False
        self._words = [",".join(uses), *slugs, *modules]
        cold = any(not warm(slug, use) for slug, use in work(slugs, uses))
        if compiled.available() and (cold or not all(map(module_is_warm, modules))):
            self._start()

    def _start(self) -> None:
        """Start a child, if there is a folder in which it can leave what it compiles."""
        folder = kernel_files.room().folder
        with self._starting:
            if folder is None or self._stopped:
                return
            self._process = subprocess.Popen(
                [sys.executable, "-m", "workbench.engine.warm", *self._words],
                cwd=Path(__file__).parents[2],
                env={**os.environ, paths.CACHE: str(folder)},
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
            )

    @property
    def finished(self) -> bool:
        """Whether the child has ended, or was not needed."""
        return self._process is None or self._process.poll() is not None

    def follow(self, report: Callable[[Progress], None]) -> None:
        """Report each kernel as it is finished; returns when the child ends. For a thread of its own."""
        while self._followed(report):
            self._start()

    def _followed(self, report: Callable[[Progress], None]) -> bool:
        """Report what one child does; whether it ended because nothing more could be kept."""
        child, full = self._process, False
        if child is None or child.stdout is None:
            return False
        for line in child.stdout:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                report(Progress(int(words[0]), int(words[1]), words[2], words[3]))
            elif words[0] == "full":
                kernel_files.leave(line.partition(" ")[2].strip())
                full = True
        child.wait()
        if full:
            child.stdout.close()
            self._process = None
        return full

    def stop(self) -> None:
        """End the child; what it has finished stays."""
        with self._starting:
            self._stopped = True
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()
            self._process.wait()
        if self._process is not None and self._process.stdout is not None:
            self._process.stdout.close()


def warm(slug: str, use: str) -> bool:
    """Whether this use of an entry needs no compilation any more."""
    entry = catalogue.get(slug)
    beside = entry.beside if use == "paint" else ()
    return compiled.ready(entry.function, use) and all(
        compiled.ready_on(b.function, *b.example) for b in beside
    )


def module_is_warm(module: str) -> bool:
    """Whether the texts of a module need no compilation any more."""
    return all(compiled.ready(text, "run") for text in import_module(module).TEXTS)


def load_module(module: str, stopped: Callable[[], bool]) -> None:
    """Have the texts of a module at hand in this process, if they were compiled before; as ``load``."""
    interface.wait()
    if not stopped() and module_is_warm(module):
        import_module(module).compile_all()


def work(slugs: Sequence[str], uses: Sequence[str] = USES) -> list[tuple[str, str]]:
    """What there is to do: the first use of every entry, then the second."""
    entries = [catalogue.get(slug) for slug in slugs]
    return [(entry.slug, use) for use in uses for entry in entries if not entry.compiles and _has(entry, use)]


def _has(entry: Entry, use: str) -> bool:
    match use:
        case "paint":
            return bool(entry.writes) or entry.emits in PAINTING
        case "paint_batch":
            return entry.emits in PAINTING and takes_batches(kinds(entry.function))
        case "collect_many":
            return entry.emits == "segments" and only_numbers(kinds(entry.function))
        case "hits":
            return entry.emits in ("pixels", "coverage", "spans", "fragments")
    return True


def load(slug: str, stopped: Callable[[], bool]) -> None:
    """Have at hand in this process what an entry's pictures are drawn by and was compiled before.

    For a thread, which waits while the interface works, and leaves off as soon as ``stopped()`` is true.
    """
    entry = catalogue.get(slug)
    for _slug, use in work([slug], PICTURES):
        interface.wait()
        if stopped():
            return
        if not at_hand(entry.function, use) and warm(slug, use):
            compile_use(entry, use)


def compile_use(entry: Entry, use: str) -> None:
    """Run one use of an entry on its example, which compiles it."""
    function, example = entry.function, _screen_example(entry)
    image = np.zeros((4, 4), np.uint32)
    match use:
        case "paint":
            for beside in entry.beside:
                compiled.paint(beside.function, beside.example[0], 1, *beside.example)
            compiled.paint(function, image, 1, *example)
        case "paint_batch":
            batches.load(function, example)
        case "collect_many":
            compiled.collect_many(function, [example])
        case "collect":
            compiled.collect(function, *example)
        case "count":
            counts.counts(function, *example)
        case "probe":
            touches.touches(function, 0, 0, *example)
        case "hits":
            compiled.hits(function, 0, 0, *example)


def _screen_example(entry: Entry) -> tuple[Any, ...]:
    """The entry's example, its picture in the form of a frame buffer."""
    return tuple(
        np.asarray(value, np.uint32) if parameter.kind == "image" else value
        for parameter, value in zip(entry.parameters, entry.example, strict=True)
    )


def main(arguments: Sequence[str]) -> int:
    """The child: ``USES SLUG... MODULE...``; the name of a module has a dot."""
    if hasattr(os, "nice"):
        os.nice(15)
    uses, *names = arguments
    slugs = [name for name in names if "." not in name]
    wanted = [(name, "run") for name in names if "." in name] + work(slugs, uses.split(","))
    for number, (slug, use) in enumerate(wanted, 1):
        try:
            if "." in slug:
                import_module(slug).compile_all()
            else:
                compile_use(catalogue.get(slug), use)
        except ValueError as error:
            print("failed", slug, use, str(error), flush=True)
        if reason := kernel_files.room().reason:
            print("full", reason, flush=True)
            return 1
        print(number, len(wanted), slug, use, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
