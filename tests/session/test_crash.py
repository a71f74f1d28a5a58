"""A program killed in the middle of saving loses nothing older than five seconds, and no file breaks."""

import os
import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.session.kills import Nursery, judge, kill_in_the_middle
from workbench.document import save
from workbench.document.samples.examples import blank_sheet
from workbench.session.recovery import recoverable

pytestmark = [
    pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are forked and killed as POSIX does"),
    pytest.mark.xdist_group("processes"),
]

SAVING, KEEPING, PATIENT = 110, 70, 20
BLOB_BYTES = 40_000


@pytest.fixture
def nurseries() -> Iterator[tuple[Nursery, Nursery]]:
    both = Nursery(), Nursery()
    yield both
    for nursery in both:
        nursery.end()


def test_two_hundred_kills(tmp_path: Path, nurseries: tuple[Nursery, Nursery]) -> None:
    patient, hasty = nurseries
    chance = random.Random(1)
    patient.ask(
        tmp_path / "patient", "live", BLOB_BYTES, *[(0, chance.uniform(5.2, 9.0)) for _ in range(PATIENT)]
    )
    kill_in_the_middle(hasty, tmp_path / "save", "save", SAVING, BLOB_BYTES, chance)
    kill_in_the_middle(hasty, tmp_path / "keep", "keep", KEEPING, BLOB_BYTES, chance)
    for number, killed in enumerate(patient.killed()):
        _saved, kept = judge(tmp_path / "patient" / str(number), killed, BLOB_BYTES)
        assert kept > 0

    folder = tmp_path / "save" / "0"
    save(blank_sheet(), folder / "picture.gwb")
    recoverable(folder)
    assert sorted(file.name for file in folder.iterdir()) == ["log", "picture.gwb"]
