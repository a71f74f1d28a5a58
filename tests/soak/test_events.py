"""Hours of random events, by hand: ``python3 run.py test tests/soak``, ``-k offscreen`` for a half."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.smoke.test_real_window import MISSING
from tests.smoke.test_real_window import environment as environment
from tests.smoke.test_real_window import screen as screen

ROOT = Path(__file__).resolve().parents[2]
EVENTS, SEEDS = 20_000, (1, 2, 3, 4, 5)
LONGEST_S = 4 * 3600


def soak(seed: int, log: Path, environment: dict[str, str]) -> None:
    command = [sys.executable, "-m", "tests.soak.monkey", "--seed", str(seed), "--events", str(EVENTS)]
    command += ["--log", str(log), "--without", os.environ.get("SOAK_WITHOUT", "")]
    done = subprocess.run(
        command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=LONGEST_S
    )
    last = log.read_text().splitlines()[-3:]
    assert done.returncode == 0, "\n".join([*last, done.stderr, f"python -m tests.soak.monkey: seed {seed}"])


@pytest.fixture
def offscreen() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}


@pytest.mark.parametrize("seed", SEEDS)
def test_a_seed_offscreen(seed: int, offscreen: dict[str, str], tmp_path: Path) -> None:
    soak(seed, tmp_path / "log", offscreen)


@pytest.mark.skipif(bool(MISSING), reason=f"no real window here: {', '.join(MISSING)} not installed")
@pytest.mark.parametrize("seed", SEEDS)
def test_a_seed_in_a_real_window(seed: int, environment: dict[str, str], tmp_path: Path) -> None:
    soak(seed, tmp_path / "log", environment)
