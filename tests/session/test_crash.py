"""A program killed in the middle of saving loses nothing older than five seconds, and no file breaks."""

import os
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbench.document import load, save
from workbench.document.samples import blank_sheet
from workbench.session.recovery import recoverable

pytestmark = [
    pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are forked and killed as POSIX does"),
    pytest.mark.xdist_group("processes"),
]

ROOT = Path(__file__).parents[2]
HASTY, PATIENT = 180, 20


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

    def ask(self, folder: Path, *lives: tuple[int, float]) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{folder} {' '.join(f'{saves}+{seconds}' for saves, seconds in lives)}\n")
        self.process.stdin.flush()

    def killed(self) -> list[float]:
        assert self.process.stdout is not None
        return [float(text) for text in self.process.stdout.readline().split()]


@pytest.fixture
def nurseries() -> Iterator[tuple[Nursery, Nursery]]:
    both = Nursery(), Nursery()
    yield both
    for nursery in both:
        nursery.process.communicate()
        assert nursery.process.returncode == 0


def number_in(path: Path) -> int:
    """The number of the edit that a file holds, found in all its places."""
    (sheet,) = load(path).sheets
    number = int(sheet.name)
    assert len(sheet.figures) == 1 + number % 20
    assert sheet.figures[0].points_world[0].x == number % 40
    return number


def judge(folder: Path, killed: float) -> tuple[int, int]:
    """Judge what a killed child left; returns how many of its edits it saved and kept, 0 for none."""
    edited: dict[int, float] = {}
    acknowledged = 0
    recovery = ""
    for line in (folder / "log").read_text().splitlines() if (folder / "log").exists() else ():
        word, *rest = line.split()
        if word == "edited":
            edited[int(rest[0])] = float(rest[1])
        elif word == "saved":
            acknowledged = int(rest[0])
        else:
            recovery = rest[0]
    picture = folder / "picture.gwb"
    saved = number_in(picture) if picture.exists() else 0
    kept = number_in(folder / recovery) if recovery and (folder / recovery).exists() else 0
    assert saved >= acknowledged
    assert max(saved, kept) <= max(edited, default=0)
    old = [number for number, when in edited.items() if when < killed - 5]
    assert max(saved, kept) >= max(old, default=0)
    if kept:
        assert [work.path.name for work in recoverable(folder)] == [recovery]
    return saved, kept


def test_two_hundred_kills(tmp_path: Path, nurseries: tuple[Nursery, Nursery]) -> None:
    patient, hasty = nurseries
    chance = random.Random(1)
    patient.ask(tmp_path / "patient", *[(0, chance.uniform(5.2, 9.0)) for _ in range(PATIENT)])

    keeps = temporaries = 0
    folder = tmp_path / "hasty" / "0"
    for _turn in range(HASTY):
        for name in ("picture.gwb", "log"):
            (folder / name).unlink(missing_ok=True)
        hasty.ask(folder.parent, (chance.randint(1, 4), chance.uniform(0.0, 0.01)))
        (killed,) = hasty.killed()
        saved, kept = judge(folder, killed)
        assert saved > 0
        keeps += kept > 0
        left = list(folder.glob("*.saving"))
        assert len(left) <= 2
        temporaries += len(left)
        for work in recoverable(folder):
            work.discard()
    # The kills did come in the middle of saves of both kinds.
    assert keeps > 0
    assert temporaries > 0

    for number, killed in enumerate(patient.killed()):
        _saved, kept = judge(tmp_path / "patient" / str(number), killed)
        assert kept > 0

    save(blank_sheet(), folder / "picture.gwb")
    recoverable(folder)
    assert sorted(file.name for file in folder.iterdir()) == ["log", "picture.gwb"]
