"""Code run in a process that may take five seconds of the processor, and tells how much memory it took."""

import resource
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_S = 5
MOST_MB = 500

_AROUND = """
import warnings
warnings.simplefilter("error")
import resource
def peak(): return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
{imports}
before = peak()
try:
    {call}
    said = "read"
except ValueError as error:
    said = str(error)
print(said)
print(peak() - before)
"""


def confined(imports: str, call: str, *words: str) -> str:
    """What is said by ``call``, an expression: "read", or the sentence of the ValueError that it raises.

    It fails where more than ``MOST_S`` or, above what the imports take, ``MOST_MB`` are needed.
    """
    told = subprocess.run(
        [sys.executable, "-c", _AROUND.format(imports=imports, call=call), *words],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (MOST_S, MOST_S)),
    )
    assert told.returncode == 0, f"status {told.returncode}: {told.stderr[-500:]}"
    said, grown = told.stdout.splitlines()
    assert int(grown) < MOST_MB, f"{grown} MB: {said}"
    return said
