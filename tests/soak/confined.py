"""Code run in a process that may take five seconds of the processor, and tells how much memory it took.

What the code imports is imported once, by a process that has a child for each call.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_S = 5
MOST_MB = 500

_PARENT = f"""
import json, os, resource, sys, traceback, warnings
warnings.simplefilter("error")
exec(sys.argv[1])

def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024

def answer(call):
    resource.setrlimit(resource.RLIMIT_CPU, ({MOST_S}, {MOST_S}))
    before, said, fault = peak(), "read", ""
    try:
        eval(call)
    except ValueError as error:
        said = str(error)
    except BaseException:
        fault = traceback.format_exc(-3)
    print(json.dumps([said, peak() - before, fault]), flush=True)

for line in sys.stdin:
    if not os.fork():
        answer(json.loads(line))
        os._exit(0)
    if status := os.wait()[1]:
        print(json.dumps(["", 0, f"status {{os.waitstatus_to_exitcode(status)}}"]), flush=True)
"""


class Confined:
    """Says of a call, an expression over what ``imports`` has: "read", or the sentence of its ValueError.

    It fails where more than ``MOST_S`` or, above what the imports take, ``MOST_MB`` are needed.
    """

    def __init__(self, imports: str) -> None:
        self._parent = subprocess.Popen(
            [sys.executable, "-c", _PARENT, imports],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def __call__(self, call: str) -> str:
        assert self._parent.stdin is not None
        assert self._parent.stdout is not None
        print(json.dumps(call), file=self._parent.stdin, flush=True)
        said, grown, fault = json.loads(self._parent.stdout.readline())
        assert fault == ""
        assert grown < MOST_MB, f"{grown} MB: {said}"
        return str(said)

    def close(self) -> None:
        """End the process."""
        self._parent.communicate()
