"""What tests of the engine share."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from workbench.engine import compiled


@pytest.fixture
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder for kernels in which there is none yet."""
    monkeypatch.setenv("GRAPHICS_WORKBENCH_CACHE", str(tmp_path / "cache"))
    compiled._kernel.cache_clear()
    yield tmp_path / "cache"
    compiled._kernel.cache_clear()
