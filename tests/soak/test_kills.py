"""A thousand kills in the middle of saves and of keeping safe, with blobs of several sizes.

Run by hand: ``python3 run.py test tests/soak/test_kills.py``. It takes some minutes.
"""

import os
import random
from pathlib import Path

import pytest

from tests.session.kills import Nursery, judge, kill_in_the_middle

pytestmark = pytest.mark.skipif(
    not hasattr(os, "fork"), reason="processes are forked and killed as POSIX does"
)


@pytest.mark.parametrize("blob_bytes", [0, 10_000, 300_000, 2_000_000])
@pytest.mark.parametrize("way", ["save", "keep"])
def test_kills_in_the_middle(tmp_path: Path, way: str, blob_bytes: int) -> None:
    nursery = Nursery()
    kill_in_the_middle(nursery, tmp_path, way, 115, blob_bytes, random.Random(blob_bytes))
    nursery.end()


@pytest.mark.parametrize("blob_bytes", [0, 2_000_000])
def test_kills_of_programs_that_keep_safe_now_and_then(tmp_path: Path, blob_bytes: int) -> None:
    nursery = Nursery()
    chance = random.Random(blob_bytes)
    for turn in range(4):
        folder = tmp_path / str(turn)
        nursery.ask(folder, "live", blob_bytes, *[(0, chance.uniform(5.2, 15.0)) for _ in range(10)])
        for number, killed in enumerate(nursery.killed()):
            _saved, kept = judge(folder / str(number), killed, blob_bytes)
            assert kept > 0
    nursery.end()
