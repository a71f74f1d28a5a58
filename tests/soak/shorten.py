"""Finds the fewest events of a log that bring its fault up again."""

import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LONGEST_S = 600


def fewest(numbers: Sequence[int], fails: Callable[[Sequence[int]], bool]) -> list[int]:
    """Leave out halves, quarters and so on as long as what is left fails still; ``numbers`` must fail."""
    kept, parts = list(numbers), 2
    while len(kept) > 1:
        size = -(-len(kept) // parts)
        fewer = (kept[:at] + kept[at + size :] for at in range(0, len(kept), size))
        shorter = next((each for each in fewer if each and fails(each)), None)
        if shorter is not None:
            kept, parts = shorter, max(parts - 1, 2)
        elif size == 1:
            break
        else:
            parts = min(2 * parts, len(kept))
    return kept


def shorten(seed: int, log: Path, without: str, within: str) -> list[int]:
    """The numbers of the events that are needed. The fault is known by its last line."""
    numbers = [int(line.split()[0]) for line in log.read_text().splitlines() if line[:1].isdigit()]

    def fault(kept: Sequence[int]) -> str:
        command = [sys.executable, "-m", "tests.soak.monkey", "--seed", str(seed), "--without", without]
        command += ["--within", within, "--only", ",".join(map(str, kept))]
        done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST_S, cwd=ROOT)
        if done.returncode < 0:
            return f"signal {-done.returncode}"
        return done.stderr.strip().splitlines()[-1] if done.returncode else ""

    first = fault(numbers)
    if not first:
        raise SystemExit("These events bring no fault up this time.")
    return fewest(numbers, lambda kept: fault(kept) == first)
