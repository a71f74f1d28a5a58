"""Raises processes that edit and save in a loop, and kills them in the middle of it.

Run as a program. Each line read is a request, ``FOLDER WAY BLOB_BYTES TIMES+SECONDS...``: for every such life
one child is forked, which works on ``FOLDER/NUMBER/`` and is killed with SIGKILL so many seconds after it has
saved (way ``save``) or kept its work safe (``keep``) so many times; by the way ``live`` it does so now and
then. The answer is a line with the monotonic times of the kills. What each child did, and when, is in its
``log``: a killed process loses nothing that it has written there.
"""

import os
import random
import signal
import sys
import time
from functools import cache
from pathlib import Path

from workbench.document import Stored, write
from workbench.document.edits import both, duplicate_figures, move_points, rename_sheet
from workbench.document.samples.examples import example_document
from workbench.document.storage.blobs import Blob
from workbench.session.recovery import DELAY_S, RecoveryFile


class Logged(RecoveryFile):
    """Tells in the log how long each writing took."""

    log = -1

    def _write(self, wanted: Stored | None) -> None:
        began = time.monotonic()
        super()._write(wanted)
        os.write(self.log, f"wrote {time.monotonic() - began}\n".encode())


@cache
def blob(number: int, size: int) -> Blob:
    """One of a few blobs that an edit may have."""
    return Blob(random.Random(number % 5).randbytes(size))


def blobs_of(number: int, size: int) -> dict[str, bytes]:
    """The blobs of the picture after edit ``number``: none, one or two."""
    chosen = [blob(number + k, size) for k in range(number % 3 if size else 0)]
    return {each.digest: each for each in chosen}


def work(folder: Path, way: str, blob_bytes: int, tell: int) -> None:
    """Edit, keep and save until killed."""
    log = os.open(folder / "log", os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_APPEND)
    Logged.log = log
    file = Logged(folder, delay_s=DELAY_S if way == "live" else 0.002)
    os.write(log, f"recovery {file.path.name}\n".encode())
    plain = example_document()
    number = 0
    while True:
        number += 1
        edit = both(
            move_points({"s1/f1/p1/x": (number % 40, 3)}),
            rename_sheet("s1", str(number)),
            *[duplicate_figures(["f1"])] * (number % 20),
        )
        stored = Stored(edit(plain), blobs=blobs_of(number, blob_bytes))
        os.write(log, f"edited {number} {time.monotonic()}\n".encode())
        file.keep(stored)
        if way == "save":
            write(stored, folder / "picture.gwb")
            os.write(log, f"saved {number}\n".encode())
            os.write(tell, b".")
        elif way == "keep":
            if file.flush():
                os.write(log, f"kept {number}\n".encode())
                os.write(tell, b".")
        else:
            time.sleep(0.02)


def raise_and_kill(folder: Path, way: str, blob_bytes: int, lives: list[tuple[int, float]]) -> list[float]:
    """When each of the children was killed, in the order of ``lives``: (times to wait for, seconds after)."""
    children = []
    for number, (times, seconds) in enumerate(lives):
        own = folder / str(number)
        own.mkdir(parents=True, exist_ok=True)
        listen, tell = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                work(own, way, blob_bytes, tell)
            finally:
                os._exit(1)
        os.close(tell)
        for _time in range(times):
            os.read(listen, 1)
        children.append((time.monotonic() + seconds, child, number, listen))
    killed = [0.0] * len(lives)
    for when, child, number, listen in sorted(children):
        time.sleep(max(0.0, when - time.monotonic()))
        os.kill(child, signal.SIGKILL)
        killed[number] = time.monotonic()
        _pid, status = os.waitpid(child, 0)
        os.close(listen)
        if not os.WIFSIGNALED(status) or os.WTERMSIG(status) != signal.SIGKILL:
            sys.exit(f"A child ended by itself, with status {status}.")
    return killed


if __name__ == "__main__":
    for line in sys.stdin:
        where, which, size, *texts = line.split()
        asked = [(int(times), float(seconds)) for times, seconds in (text.split("+") for text in texts)]
        print(*raise_and_kill(Path(where), which, int(size), asked), flush=True)
