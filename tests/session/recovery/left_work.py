"""Work that a dead process has left."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

from workbench.document import edits

ROOT = Path(__file__).parents[3]

MOVE = edits.move_points({"s1/f1/p1/x": (3.0, 4.0)})


def left_by_a_dead_process(folder: Path, origin: str = "", blobs: dict[str, bytes] | None = None) -> Path:
    """The recovery file of a process that kept the example, moved, and was killed."""
    texts = [text for digest, content in (blobs or {}).items() for text in (digest, os.fsdecode(content))]
    code = (
        "import os, sys; from pathlib import Path; from workbench.session.recovery import RecoveryFile;"
        "from workbench.document import Stored, edits;"
        "from workbench.document.samples.examples import example_document;"
        "file = RecoveryFile(Path(sys.argv[1]));"
        "document = edits.move_points({'s1/f1/p1/x': (3.0, 4.0)})(example_document());"
        "blobs = dict(zip(sys.argv[3::2], map(os.fsencode, sys.argv[4::2])));"
        "file.keep(Stored(document, blobs=blobs, origin=sys.argv[2])); file.flush();"
        "print(file.path, flush=True); os._exit(9)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(folder), origin, *texts],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 9, done.stderr
    return Path(done.stdout.strip())


def names(folder: Path) -> list[str]:
    return sorted(file.suffix for file in folder.iterdir())


# No zeros, and no more than fits on a command line.
BLOBS = {hashlib.sha256(content).hexdigest(): content for content in (b"a mesh" * 1000, b"a picture" * 999)}
