"""Every reader against tens of thousands of mangled inputs; run by hand.

SOAK_SHARE (1 by default) says how many of the cases are read, SOAK_SEED (0) which.
"""

import os

import pytest

from tests.soak.cases import MOST_MB, MOST_S, soaked

CASES = {"svg": 20_000, "csv": 10_000, "gwb": 25_000, "cli": 5_000}


@pytest.mark.parametrize("kind", CASES)
def test_nothing_hangs_grows_or_breaks(kind: str) -> None:
    count = max(round(CASES[kind] * float(os.environ.get("SOAK_SHARE", "1"))), 1)
    outcome = soaked(kind, count, int(os.environ.get("SOAK_SEED", "0")))
    print(
        f"\n{kind}: {count:,} cases, the slowest (number {outcome.slowest}) {outcome.slowest_s:.2f} s, "
        f"{outcome.peak_mb:.0f} MB at most, {len(outcome.faults)} faults"
    )
    assert outcome.faults == [], "\n".join(outcome.faults[:5])
    assert outcome.slowest_s < MOST_S
    assert outcome.peak_mb < MOST_MB
