"""What large arrays took goes back to the system when they are gone."""

import subprocess
import sys

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
        arrays = [np.ones(1 << 20) for _ in range(6)]
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
def test_memory_of_large_arrays_goes_back() -> None:
    text = FILL_AND_LEAVE.format(before=GIVE_BACK)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert float(done.stdout) < 40  # of which 19 are still held
