"""The checkout that run.py is taken from, and the system on which it looks for libraries."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

linux_only = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="it looks for libraries on Linux only"
)
