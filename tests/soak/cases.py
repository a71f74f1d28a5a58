"""Mangled inputs for each reader, in a process of their own: what is not refused in one sentence is a fault.

``python -m tests.soak.cases KIND COUNT SEED`` prints what became of them as JSON.
"""

import contextlib
import io
import json
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path

from tests.soak.mangling import HUGE, Mangler, mangled
from workbench.__main__ import main as command
from workbench.algorithms import catalogue
from workbench.document import DocumentError
from workbench.document.samples.examples import example_document, examples
from workbench.document.storage.files import Stored, decode, encode
from workbench.exchange.point_lists import PointsError, read_points, write_points
from workbench.exchange.svg_paths import SvgError, read_svg, write_svg

ROOT = Path(__file__).resolve().parents[2]
MOST_S = 5.0
MOST_MB = 500
LONGEST_SENTENCE = 600

SHEET = example_document().sheets[0]
SVGS = [
    *(write_svg(one.document.sheets[0]).text.encode() for one in examples()),
    b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 5"><style>.a,#p{fill:none;stroke:#f00}</style>'
    b'<g class="a" transform="rotate(10) scale(2)"><path id="p" style="stroke:#123;stroke-width:2" '
    b'd="M 1,1 a 2 3 4 0 1 5 5 q 1 2 3 4 t 1 1 C1 2 3 4 5 6S3 4 5 6z"/>'
    b'<rect x="1mm" y="10%" width="5" height="4" rx="1"/><use href="#p" x="3"/><svg viewBox="0 0 1 1" '
    b'width="3" height="4"><circle r="1"/></svg><polyline points="1,2 3,4"/><text>a &amp; b</text></g></svg>',
]
TABLES = [
    b"x,y\n1,2\n3.5,-4e2\n",
    b"x;y\r\n1,5;2\r\n3;4,25\r\n# nothing\r\n",
    b"1 2 # first\n\n3\t4\n",
    write_points([(k / 3, k * k) for k in range(200)], "\t").encode(),
]
PICTURES = [encode(Stored(one.document)) for one in examples()]
NETS = [
    b'{"points": [[[0,0,0],[0,1,0],[0,2,1]],[[1,0,0],[1,1,2],[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]]}',
    b'{"points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,2]]], "degrees": [1, 1], "u_knots": [0,0,1,1], '
    b'"weights": [[1,1],[1,2]]}',
]


def _entities(chance: random.Random, data: bytes) -> bytes:
    """Entities that multiply, lie outside, or are named often."""
    text = chance.choice((b"a" * 150, b"&b;&b;&b;", b"%c;"))
    outside = chance.choice((b'SYSTEM "file:///dev/zero"', b'"' + text + b'"'))
    called = b"&a;" * chance.choice((1, 100, 5000))
    return (
        b'<!DOCTYPE svg [<!ENTITY b "'
        + b"b" * 50
        + b'"><!ENTITY a '
        + outside
        + b">]>"
        + data.replace(b'"', b'"' + called, chance.choice((1, 2)))
    )


def _uses(chance: random.Random, data: bytes) -> bytes:
    """Groups that use one another again and again."""
    depth, twice = chance.choice((3, 12, 30)), chance.choice((1, 2, 5))
    groups = (b'<g id="u%d">' % k + b'<use href="#u%d"/>' % (k + 1) * twice + b"</g>" for k in range(depth))
    return data.replace(b"</svg>", b"".join(groups) + b'<path id="u%d" d="M0 0 9 9"/></svg>' % depth, 1)


def _rules(chance: random.Random, data: bytes) -> bytes:
    """A style sheet of many rules, of none, or of one that never begins."""
    rule = chance.choice((b"a{}", b".a{fill:red}", b"*,g,.a.b{stroke:blue}", b"/*", b"aaaaaaaa", b"#p{x:y;"))
    return data.replace(b"</svg>", b"<style>" + rule * chance.choice((1, 100, 4000)) + b"</style></svg>", 1)


def _in_sentence(kind: type[Exception], read: Callable[[], object]) -> None:
    """Read, or be refused with one sentence on one line."""
    try:
        read()
    except kind as error:
        text = str(error)
        assert text.endswith("."), text[:LONGEST_SENTENCE]
        assert len(text.splitlines()) == 1, text[:LONGEST_SENTENCE]
        assert len(text) <= LONGEST_SENTENCE, text[:LONGEST_SENTENCE]


def _svg(chance: random.Random) -> None:
    special: list[Mangler] = [_entities, _uses, _rules]
    data = mangled(chance, SVGS, special)
    drawing = data if chance.random() < 0.5 else data.decode("utf-8", "replace")
    _in_sentence(SvgError, lambda: read_svg(drawing, SHEET))


def _csv(chance: random.Random) -> None:
    text = mangled(chance, TABLES).decode("utf-8", "replace")
    _in_sentence(PointsError, lambda: read_points(text))


def _gwb(chance: random.Random) -> None:
    data = mangled(chance, PICTURES)
    _in_sentence(DocumentError, lambda: decode(encode(decode(data))))


def _cli(chance: random.Random) -> None:
    """A command line of which one word, or one file, is not what it should be."""
    with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
        words = _command(chance)
        said, failed = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(failed):
            try:
                status = command(words)
            except SystemExit as leaving:  # help, and nothing else
                status = int(leaving.code or 0)
    text = failed.getvalue()
    told = f"status {status}, {text[:200]!r}, {' '.join(words)[:200]!r}"
    assert status in (0, 1, 2), told
    assert bool(text) == bool(status), told
    assert len(text.splitlines()) <= 1, told
    assert len(text) <= LONGEST_SENTENCE, told


def _command(chance: random.Random) -> list[str]:
    kinds = {"svg": SVGS, "csv": TABLES, "gwb": PICTURES, "json": NETS}
    kind = chance.choice((*kinds, "trace", "trace", "trace"))
    if kind != "trace":
        source = Path(f"in.{kind}")
        source.write_bytes(mangled(chance, kinds[kind]))
        if kind == "json":
            tolerance = chance.choice(("1", "0.1", "1e-300"))
            return ["surface", str(source), "-o", "out.obj", "--tolerance", tolerance]
        target = chance.choice(("out.svg", "out.gwb"))
        words = ["convert", str(source), "-o", target, "--tolerance", chance.choice(("1", "0.01", "nan"))]
        return ["draw", str(source), "-o", "out.png"] if kind == "gwb" and chance.random() < 0.3 else words
    entry = chance.choice(catalogue.entries())
    words = ["trace", entry.slug, *map(_word, entry.example)]
    at = chance.randrange(2, max(len(words), 3))
    damaged = mangled(chance, [words[min(at, len(words) - 1)].encode(), *HUGE])[:2000]
    text = damaged.decode("utf-8", "replace").replace("\0", "")
    if chance.random() < 0.3:
        Path("word.txt").write_bytes(damaged)
        text = "@word.txt"
    words[at : at + 1] = [text]
    return [*words, "--table", chance.choice(("hand", "pixels"))]


def _word(value: object) -> str:
    listed = getattr(value, "tolist", None)
    return repr(listed() if listed else value)


KINDS: dict[str, Callable[[random.Random], None]] = {"svg": _svg, "csv": _csv, "gwb": _gwb, "cli": _cli}


@dataclass
class Outcome:
    """What became of the cases of one kind: the slowest in seconds of the processor, the memory they took."""

    kind: str
    cases: int
    slowest_s: float = 0.0
    slowest: int = -1
    peak_mb: float = 0.0
    faults: list[str] = field(default_factory=list)


class _TooSlowError(BaseException):
    pass


def run(kind: str, count: int, seed: int) -> Outcome:
    """Read ``count`` cases, here; each has a seed of its own made of ``seed`` and its number."""

    def stop(*_how: object) -> None:
        raise _TooSlowError

    signal.signal(signal.SIGVTALRM, stop)
    outcome = Outcome(kind, count)
    KINDS[kind](random.Random(0))  # so that what is imported and kept does not count
    before = _peak_mb()
    for number in range(count):
        begun = time.process_time()
        signal.setitimer(signal.ITIMER_VIRTUAL, MOST_S)
        try:
            KINDS[kind](random.Random(f"{kind} {seed} {number}"))
        except _TooSlowError:
            outcome.faults.append(f"{number}: more than {MOST_S:g} s")
        except Exception:
            outcome.faults.append(f"{number}: {traceback.format_exc(-3)[-1500:]}")
        finally:
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        took = time.process_time() - begun
        if took > outcome.slowest_s:
            outcome.slowest_s, outcome.slowest = took, number
    outcome.peak_mb = _peak_mb() - before
    return outcome


def _peak_mb() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def soaked(kind: str, count: int, seed: int) -> Outcome:
    """The same in a fresh process, which ends when all of them together take far too long."""
    most = int(60 + count * 0.25)
    told = subprocess.run(
        [sys.executable, "-m", "tests.soak.cases", kind, str(count), str(seed)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most)),
        check=False,
    )
    assert told.returncode == 0, f"{kind}: status {told.returncode}\n{told.stderr[-2000:]}"
    return Outcome(**json.loads(told.stdout.splitlines()[-1]))


if __name__ == "__main__":
    print(json.dumps(asdict(run(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])))))
