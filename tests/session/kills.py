"""Kills programs in the middle of saving, and judges what they leave."""

import random
import subprocess
import sys
from pathlib import Path

from tests.session.crash_nursery import blobs_of
from workbench.document import Stored, read
from workbench.session.recovery import REST, recoverable

ROOT = Path(__file__).parents[2]


class Nursery:
    """The program that raises children and kills them."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.session.crash_nursery"],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def ask(self, folder: Path, way: str, blob_bytes: int, *lives: tuple[int, float]) -> None:
        assert self.process.stdin is not None
        texts = " ".join(f"{times}+{seconds}" for times, seconds in lives)
        self.process.stdin.write(f"{folder} {way} {blob_bytes} {texts}\n")
        self.process.stdin.flush()

    def killed(self) -> list[float]:
        assert self.process.stdout is not None
        return [float(text) for text in self.process.stdout.readline().split()]

    def end(self) -> None:
        self.process.communicate()
        assert self.process.returncode == 0


def judge(folder: Path, killed: float, blob_bytes: int) -> tuple[int, int]:
    """Judge what a killed child left; returns how many of its edits it saved and kept, 0 for none."""
    edited: dict[int, float] = {}
    acknowledged = {"saved": 0, "kept": 0}
    longest = 0.0
    recovery = ""
    for line in (folder / "log").read_text().splitlines() if (folder / "log").exists() else ():
        word, *rest = line.split()
        if word == "edited":
            edited[int(rest[0])] = float(rest[1])
        elif word == "wrote":
            longest = max(longest, float(rest[0]))
        elif word == "recovery":
            recovery = rest[0]
        else:
            acknowledged[word] = int(rest[0])

    def number_in(stored: Stored) -> int:
        (sheet,) = stored.document.sheets
        number = int(sheet.name)
        assert len(sheet.figures) == 1 + number % 20
        assert sheet.figures[0].points_world[0].x == number % 40
        assert stored.blobs == blobs_of(number, blob_bytes)
        return number

    picture = folder / "picture.gwb"
    saved = number_in(read(picture)) if picture.exists() else 0
    left = recoverable(folder)
    kept = 0
    if recovery and (folder / recovery).exists():
        assert [work.path.name for work in left] == [recovery]
        kept = number_in(left[0].read())
    assert saved >= acknowledged["saved"]
    assert kept >= acknowledged["kept"]
    assert max(saved, kept) <= max(edited, default=0)
    # The one before rested so long, and the next one took its time.
    patience = max(5.0, (REST + 2) * longest)
    old = [number for number, when in edited.items() if when < killed - patience]
    assert max(saved, kept) >= max(old, default=0)
    return saved, kept


def kill_in_the_middle(
    nursery: Nursery, folder: Path, way: str, count: int, blob_bytes: int, chance: random.Random
) -> None:
    """Kill ``count`` children that all the time save or keep safe, each a moment after it did, and judge."""
    keeps = temporaries = 0
    here = folder / "0"
    for _turn in range(count):
        for name in ("picture.gwb", "log"):
            (here / name).unlink(missing_ok=True)
        nursery.ask(folder, way, blob_bytes, (chance.randint(1, 4), chance.uniform(0.0, 0.012)))
        (killed,) = nursery.killed()
        temporaries += len(list(here.glob("*.saving")))
        saved, kept = judge(here, killed, blob_bytes)
        assert saved > 0 or way == "keep"
        assert kept > 0 or way == "save"
        keeps += kept > 0
        for work in recoverable(here):
            work.discard()
        assert {file.name for file in here.iterdir()} <= {"log", "picture.gwb", *_young(here)}
    # The kills did come in the middle of saves of both kinds.
    assert keeps > 0
    assert temporaries > count // 20


def _young(folder: Path) -> set[str]:
    """What the next save into this folder clears away."""
    return {file.name for file in folder.glob(".*.saving")}
