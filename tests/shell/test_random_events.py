"""A short run of random events over the real window; ``tests/soak`` has the long ones."""

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.soak.shorten import fewest

ROOT = Path(__file__).resolve().parents[2]


def test_a_few_hundred_random_events_bring_up_no_fault(tmp_path: Path) -> None:
    log = tmp_path / "log"
    command = [sys.executable, "-m", "tests.soak.monkey", "--seed", "7", "--events", "120"]
    command += ["--log", str(log), "--without", "dock,dock_tab"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, ""), log.read_text()[-600:]
    assert len([line for line in log.read_text().splitlines() if line[0].isdigit()]) == 120


@pytest.mark.parametrize("needed", [{0}, {99}, {3, 50}, {10, 11, 12}, {0, 33, 66, 99}])
def test_the_fewest_events_that_fail_are_those_that_are_needed(needed: set[int]) -> None:
    tried = []

    def fails(numbers: Sequence[int]) -> bool:
        tried.append(numbers)
        return needed <= set(numbers)

    assert fewest(range(100), fails) == sorted(needed)
    assert len(tried) < 100
