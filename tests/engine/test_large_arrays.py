"""What large arrays took goes back to the system when they are gone."""

import subprocess
import sys
from pathlib import Path

import pytest

FILL_AND_LEAVE = """
import threading
import numpy as np
{before}
def resident():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS")) / 1024
start = resident()
small = []
def work():
    for _ in range(3):
        arrays = [np.ones({numbers}) for _ in range({count})]
        small.append([np.ones(1000) for _ in range(200)])  # between them, on the heap
        del arrays
for _ in range(4):
    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
print(resident() - start)
"""
GIVE_BACK = "from workbench.engine.large_arrays import give_back_large_arrays\ngive_back_large_arrays()"


@pytest.mark.skipif(sys.platform != "linux", reason="the memory of a process is read where Linux tells it")
@pytest.mark.parametrize(("numbers", "count"), [(1 << 20, 6), (1 << 15, 192)], ids=["8 MB", "256 kB"])
def test_memory_of_large_arrays_goes_back(numbers: int, count: int) -> None:
    text = FILL_AND_LEAVE.format(before=GIVE_BACK, numbers=numbers, count=count)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert float(done.stdout) < 40  # of which 19 are still held


COUNT_HEAPS = """
import ctypes, sys, threading
{before}
together, kept = threading.Barrier(8), []
def work():
    together.wait()
    kept.append([bytes(2000) for _ in range(500)])
    together.wait()
threads = [threading.Thread(target=work) for _ in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
libc = ctypes.CDLL(None)
libc.fopen.restype = ctypes.c_void_p
file = ctypes.c_void_p(libc.fopen(sys.argv[1].encode(), b"w"))
libc.malloc_info(0, file)
libc.fclose(file)
print(open(sys.argv[1]).read().count("<heap nr="))
"""


@pytest.mark.skipif(
    sys.platform != "linux", reason="the heaps of a process are counted by the library of GNU"
)
def test_threads_share_two_heaps(tmp_path: Path) -> None:
    counts = []
    for before in ("", GIVE_BACK):
        text = COUNT_HEAPS.format(before=before)
        command = [sys.executable, "-c", text, str(tmp_path / "heaps.xml")]
        counts.append(int(subprocess.run(command, capture_output=True, text=True, check=True).stdout))
    assert counts[1] <= 2 < counts[0]
