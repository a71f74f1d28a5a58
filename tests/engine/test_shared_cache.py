"""Several processes keep their compiled readings in one folder, and each gets what is right."""

import os
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from tests.engine import written_texts as texts
from workbench.engine import compiled, kernel_files

pytestmark = pytest.mark.xdist_group("processes")

ROOT = Path(__file__).parents[2]
STAIRS = [[1, 0, 0, 0, 0], [1, 1, 0, 0, 0], [1, 1, 1, 0, 0], [1, 1, 1, 1, 0]]

# Compiles for pictures of the type named, once it is told to begin. It takes its time between looking which
# files of the compiler there are, naming a new one, and writing that.
CHILD = """
import sys, time
import numpy as np
from numba.core.caching import IndexDataCacheFile
from tests.engine import written_texts as texts
from workbench.engine import compiled, kernel_files

kind, naming, writing = sys.argv[1], *map(float, sys.argv[2:])

def slowly(method, seconds):
    def slow(*arguments):
        time.sleep(seconds)
        method(*arguments)
    return slow

IndexDataCacheFile._save_index = slowly(IndexDataCacheFile._save_index, naming)
IndexDataCacheFile._save_data = slowly(IndexDataCacheFile._save_data, writing)
compiled._numba()
print("here", flush=True)
sys.stdin.readline()
image = np.zeros((4, 5), kind)
compiled.paint(texts.spans, image, 1, 6)
print(image.tolist(), flush=True)
"""


def child(kind: str, naming: float, writing: float) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", CHILD, kind, str(naming), str(writing)],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )


def test_two_processes_that_compile_one_kernel_at_once_both_get_right_results(own_cache: Path) -> None:
    children = [child("uint8", 0.3, 0.5), child("int64", 0.5, 0.0)]
    for one in children:
        assert one.stdout is not None
        assert one.stdout.readline() == "here\n"
    answers = []
    for one in children:
        assert one.stdin is not None
        one.stdin.write("begin\n")
        one.stdin.flush()
    answers = [one.communicate(timeout=300)[0] for one in children]
    assert answers == [f"{STAIRS}\n"] * 2
    assert {path.stem for path in own_cache.rglob("*.ready")} == {"paint-u1", "paint-i8"}
    for kind in ("uint8", "int64"):
        image = np.zeros((4, 5), kind)
        compiled.paint(texts.spans, image, 1, 6)
        assert image.tolist() == STAIRS
    # Nothing had to be compiled for this: all of it was there.
    driver = compiled.kernel(texts.spans)._module(True)._paint
    assert sum(driver.stats.cache_hits.values()) == 2
    assert not driver.stats.cache_misses


def test_who_compiles_waits_for_another_and_who_only_loads_does_not(own_cache: Path) -> None:
    key = compiled.kernel(texts.spans).key
    compiled.paint(texts.spans, np.zeros((4, 5), np.uint8), 1, 6)
    compiled._kernel.cache_clear()
    begun = threading.Event()
    image = np.zeros((4, 5), np.int64)

    def compile_another() -> None:
        begun.set()
        compiled.paint(texts.spans, image, 1, 6)

    thread = threading.Thread(target=compile_another, daemon=True)
    with kernel_files.alone(key):
        loaded = np.zeros((4, 5), np.uint8)
        compiled.paint(texts.spans, loaded, 1, 6)
        assert loaded.tolist() == STAIRS
        thread.start()
        begun.wait()
        thread.join(0.3)
        assert thread.is_alive()
        assert not image.any()
    thread.join(60)
    assert image.tolist() == STAIRS
