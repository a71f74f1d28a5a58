"""Raises processes that edit and save in a loop, and kills them in the middle of it.

Run as a program. Each line read is a request, ``FOLDER SAVES+SECONDS...``: for every such life one child is
forked, which works on ``FOLDER/NUMBER/`` and is killed with SIGKILL so many seconds after so many saves. The
answer is a line with the monotonic times of the kills. What each child did, and when, is in its ``log``: a
killed process loses nothing that it has written there.
"""

import os
import signal
import sys
import time
from pathlib import Path

from workbench.document import Stored, write
from workbench.document.edits import both, duplicate_figures, move_points, rename_sheet
from workbench.document.samples import example_document
from workbench.session.recovery import DELAY_S, RecoveryFile


def work(folder: Path, hasty: bool, tell: int) -> None:
    """Edit, keep and save until killed; a hasty one saves all the time, others live by the recovery file."""
    log = os.open(folder / "log", os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_APPEND)
    file = RecoveryFile(folder, delay_s=0.002 if hasty else DELAY_S)
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
        document = edit(plain)
        os.write(log, f"edited {number} {time.monotonic()}\n".encode())
        file.keep(Stored(document))
        if hasty:
            write(Stored(document), folder / "picture.gwb")
            os.write(log, f"saved {number}\n".encode())
            os.write(tell, b".")
        else:
            time.sleep(0.02)


def raise_and_kill(folder: Path, lives: list[tuple[int, float]]) -> list[float]:
    """When each of the children was killed, in the order of ``lives``: (saves to wait for, seconds after)."""
    children = []
    for number, (saves, seconds) in enumerate(lives):
        own = folder / str(number)
        own.mkdir(parents=True, exist_ok=True)
        listen, tell = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                work(own, saves > 0, tell)
            finally:
                os._exit(1)
        os.close(tell)
        for _save in range(saves):
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
        where, *texts = line.split()
        lives = [(int(saves), float(seconds)) for saves, seconds in (text.split("+") for text in texts)]
        print(*raise_and_kill(Path(where), lives), flush=True)
