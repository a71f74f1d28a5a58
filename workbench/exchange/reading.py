"""Reading beside the program: a child process that reads one thing, tells how far it is, and can be stopped.

What is short is read at once by ``read_now``. Whatever is in a file, the child alone pays for it: the parent
is given only what was read and checked, in parts so small that none of them holds it up.
"""

import os
import subprocess
import sys
import time
import traceback
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import IO, Literal, NamedTuple

import msgspec
import numpy as np
from msgspec.structs import replace

from workbench.document.model import AnyFigure, Curve, Document, Sheet
from workbench.document.motion.model import Motion
from workbench.document.state import SessionState
from workbench.document.storage.content import Progress, Stopped, part, read_content, silent
from workbench.document.storage.embedding import as_text, blobs_of, from_text, with_contents
from workbench.document.storage.files import MAX_BYTES, Stored, all_blobs, decode
from workbench.exchange import mesh_reading
from workbench.exchange.figures import read_figures
from workbench.exchange.fitted_curve import fitted
from workbench.exchange.mesh_pieces import Piece, pieces_of, whole
from workbench.exchange.mesh_reading import ImportedMesh
from workbench.exchange.point_lists import MOST_CHARACTERS, Array, read_points, text_of
from workbench.exchange.svg_reading import Imported, read_svg
from workbench.exchange.svg_tree import MOST_BYTES
from workbench.language import _
from workbench.rendering.mapping import device_map

AT_ONCE = 50_000  # bytes that may be read without a child
_AT_ONCE_S = 0.05  # of the processor, after which a child is asked after all
_POINTS_IN_A_PART = 5_000
_BLOB_IN_A_PART = 2**20
_CHILD_BYTES = 4 * 2**30  # of addresses, far above what any limit of a reader lets it use
LIMITS = {
    "picture": MAX_BYTES,
    "figures": MAX_BYTES,
    "drawing": MOST_BYTES,
    "points": MOST_CHARACTERS,
    "fit": MOST_CHARACTERS,
    "mesh": mesh_reading.MOST_BYTES,
}


class ReadingError(ValueError):
    """What was to be read was refused: one sentence."""


class ReadingFailure(Exception):  # noqa: N818 - nothing is wrong with what was to be read
    """The program itself failed in the child: the traceback from there."""


class Job(msgspec.Struct, frozen=True):
    """What is read: a file, or with an empty path the ``content``.

    A picture becomes Stored, a drawing (SVG, placed on ``sheet``) Imported, and so do figures as the
    clipboard has them, whose numbers are unchecked; points an (n, 2) array, world; fit becomes Fitted: a path
    in ``colour`` that passes the points within ``tolerance_px``; a mesh, of the kind that ``path`` ends in,
    ImportedMesh.
    """

    kind: Literal["picture", "figures", "drawing", "points", "fit", "mesh"]
    path: str = ""
    content: bytes = b""
    sheet: Sheet | None = None
    tolerance_px: float = 1.0
    colour: int = 1

    @property
    def size(self) -> int:
        """Bytes to be read; 0 where that is not known."""
        try:
            return os.stat(self.path).st_size if self.path else len(self.content)
        except (OSError, ValueError):
            return 0


class Fitted(NamedTuple):
    """A curve fitted to so many ``points``, none of which is farther than ``error`` pixels from it."""

    curve: Curve
    points: int
    error: float


Result = Stored | Imported | Array | Fitted | ImportedMesh


def read_now(job: Job, progress: Progress = silent) -> Result:
    """What the job asks for. Raises: ValueError with one sentence."""
    content = job.content
    if job.path:
        content = read_content(job.path, LIMITS[job.kind], part(progress, 0.0, 0.1))
    progress(0.1)
    rest = part(progress, 0.1, 1.0)
    if job.kind == "picture":
        return decode(content)
    if job.kind == "figures":
        copied = read_figures(content)
        return Imported(copied.figures, (), (), motion=copied.motion)
    if job.kind == "drawing":
        assert job.sheet is not None
        return read_svg(content if job.path else content.decode("utf-8", "replace"), job.sheet, progress=rest)
    if job.kind == "mesh":
        return mesh_reading.read_mesh(content, Path(job.path).suffix, rest, to_keep=True)
    text = text_of(content, job.path)
    if job.kind == "points":
        return read_points(text, rest)
    assert job.sheet is not None
    points = device_map(job.sheet).points(read_points(text, part(progress, 0.1, 0.3)))
    curve, error = fitted(job.sheet, points, job.tolerance_px, job.colour, part(progress, 0.3, 1.0))
    return Fitted(curve, len(points), error)


def read_at_once(job: Job) -> Result | None:
    """As ``read_now`` where that is a matter of milliseconds; None where it would take longer.

    Raises: ValueError with one sentence.
    """
    if not job.path and job.size > LIMITS[job.kind]:
        sentence = _("The text has {size:,} bytes, but at most {most:,} can be read; choose less of it.")
        raise ReadingError(sentence.format(size=job.size, most=LIMITS[job.kind]))
    if job.size > AT_ONCE:
        return None
    end = time.thread_time() + _AT_ONCE_S

    def watch(_share: float) -> None:
        if time.thread_time() > end:
            raise Stopped

    try:
        return read_now(job, watch)
    except Stopped:
        return None


# What the child says, one after the other.


class _Share(msgspec.Struct, tag=True):
    share: float


class _Refused(msgspec.Struct, tag=True):
    sentence: str


class _Failed(msgspec.Struct, tag=True):
    traceback: str


class _Frame(msgspec.Struct, tag=True):
    """A picture without its figures and blobs."""

    sheets: list[Sheet]
    last_id: int
    session: SessionState
    origin: str | None
    origin_stamp: tuple[int, int, int] | None
    blobs_beside: tuple[str, ...]


class _Figures(msgspec.Struct, tag=True):
    sheet: int
    figures: list[AnyFigure]


class _Blob(msgspec.Struct, tag=True):
    name: str
    content: bytes


class _Drawn(msgspec.Struct, tag=True):
    approximated: list[tuple[str, float]]
    notes: list[str]
    palette: list[int]
    motion: Motion | None
    scale: float


class _Points(msgspec.Struct, tag=True):
    content: bytes


class _Fit(msgspec.Struct, tag=True):
    points: int
    error: float


class _Meshed(msgspec.Struct, tag=True):
    notes: list[str]


_Part = _Share | _Refused | _Failed | _Frame | _Figures | _Blob | _Drawn | _Points | _Fit | Piece | _Meshed

_encoder = msgspec.msgpack.Encoder(enc_hook=as_text)
_part_decoder = msgspec.msgpack.Decoder(_Part, dec_hook=from_text)
_job_decoder = msgspec.msgpack.Decoder(Job, dec_hook=from_text)


def _parts(result: Result) -> Iterator[_Part]:
    """The result in parts, each quickly decoded."""
    match result:
        case Stored(document=document, session=session):
            bare = [replace(sheet, figures=()) for sheet in document.sheets]
            yield _Frame(
                bare, document.last_id, session, result.origin, result.origin_stamp, result.blobs_beside
            )
            for number, sheet in enumerate(document.sheets):
                yield from _batches(number, sheet.figures)
            for name, content in all_blobs(result).items():
                for at in range(0, max(len(content), 1), _BLOB_IN_A_PART):
                    yield _Blob(name, content[at : at + _BLOB_IN_A_PART])
        case Imported(figures=figures, approximated=approximated, notes=notes, palette=palette):
            yield from _batches(0, figures)
            yield _Drawn(list(approximated), list(notes), list(palette), result.motion, result.scale)
        case Fitted(curve=curve, points=points, error=error):
            yield from _batches(0, [curve])
            yield _Fit(points, error)
        case ImportedMesh(mesh=mesh, notes=notes):
            yield from pieces_of(mesh)
            yield _Meshed(list(notes))
        case _:
            yield _Points(np.ascontiguousarray(result, np.float64).tobytes())


def _batches(sheet: int, figures: Iterable[AnyFigure]) -> Iterator[_Figures]:
    batch: list[AnyFigure] = []
    points = 0
    for figure in figures:
        batch.append(figure)
        points += len(figure.points_world) + 1
        if points > _POINTS_IN_A_PART:
            yield _Figures(sheet, batch)
            batch, points = [], 0
    yield _Figures(sheet, batch)


def _joined(parts: list[_Part]) -> Result:
    """The result again."""
    figures: dict[int, list[AnyFigure]] = {}
    blobs: dict[str, list[bytes]] = {}
    for each in parts:
        if isinstance(each, _Figures):
            figures.setdefault(each.sheet, []).extend(each.figures)
        elif isinstance(each, _Blob):
            blobs.setdefault(each.name, []).append(each.content)
    for each in parts:
        match each:
            case _Frame(sheets=bare, last_id=last_id, session=session):
                sheets = (replace(s, figures=tuple(figures[k])) for k, s in enumerate(bare))
                contents = {name: b"".join(content) for name, content in blobs.items()}
                bare_one = Document(tuple(sheets), last_id)
                document = with_contents(bare_one, contents, frozenset(each.blobs_beside))
                for digest in blobs_of(document):
                    del contents[digest]
                return Stored(document, session, contents, each.origin, each.origin_stamp, each.blobs_beside)
            case _Drawn(approximated=approximated, notes=notes, palette=palette, motion=motion):
                drawn = tuple(figures[0])
                inexact = tuple(approximated)
                return Imported(drawn, inexact, tuple(notes), tuple(palette), motion, each.scale)
            case _Fit(points=points, error=error):
                (curve,) = figures[0]
                assert isinstance(curve, Curve)
                return Fitted(curve, points, error)
            case _Meshed(notes=notes):
                pieces = (part for part in parts if isinstance(part, Piece))
                return ImportedMesh(whole(pieces), tuple(notes))
            case _Points(content=content):
                return np.frombuffer(content, np.float64).reshape(-1, 2)
    raise ReadingError(_("Reading stopped before the end of the file; try again, or choose a smaller file."))


class Reading:
    """A child process that does ``job``. It is begun by ``follow``, on a thread that may wait."""

    def __init__(self, job: Job) -> None:
        bare = None if job.sheet is None else replace(job.sheet, figures=(), scene=None)
        path = str(Path(job.path).absolute()) if job.path else ""  # the child has another current folder
        self._job = replace(job, path=path, sheet=bare)
        self._process: subprocess.Popen[bytes] | None = None
        self._stopped = False

    def follow(self, progress: Progress = silent) -> Result:
        """The result, once it is there.

        Raises: ReadingError with one sentence; ReadingFailure; Stopped after ``stop``.
        """
        self._process = subprocess.Popen(
            [sys.executable, "-m", "workbench.exchange.reading"],
            cwd=Path(__file__).parents[2],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        if self._stopped:
            self._process.kill()
        parts: list[_Part] = []
        try:
            _send(self._process.stdin, self._job)
            self._process.stdin.close()
            for said in _received(self._process.stdout):
                if isinstance(said, _Share):
                    progress(said.share)
                elif isinstance(said, _Refused):
                    raise ReadingError(said.sentence)
                elif isinstance(said, _Failed):
                    raise ReadingFailure(said.traceback)
                else:
                    parts.append(said)
        except BrokenPipeError:
            pass  # it has ended: what is missing is said below
        finally:
            self._process.kill()
            self._process.wait()
            with suppress(OSError):
                self._process.stdin.close()
            self._process.stdout.close()
        if self._stopped:
            raise Stopped
        return _joined(parts)

    def stop(self) -> None:
        """End the child; from any thread."""
        self._stopped = True
        if self._process is not None:
            self._process.kill()


def _send(stream: IO[bytes], message: object) -> None:
    data = _encoder.encode(message)
    stream.write(len(data).to_bytes(8, "little") + data)
    stream.flush()


def _received(stream: IO[bytes]) -> Iterator[_Part]:
    while len(head := stream.read(8)) == 8:
        data = stream.read(int.from_bytes(head, "little"))
        if len(data) < int.from_bytes(head, "little"):
            return
        yield _part_decoder.decode(data)


def main() -> int:
    """The child: a job on standard input, parts of what it gives on standard output."""
    out = sys.stdout.buffer
    told = -1.0

    def tell(share: float) -> None:
        nonlocal told
        if share - told >= 0.01:
            told = share
            _send(out, _Share(share))

    try:
        _bound_memory()
        size = int.from_bytes(sys.stdin.buffer.read(8), "little")
        result = read_now(_job_decoder.decode(sys.stdin.buffer.read(size)), tell)
        for each in _parts(result):
            _send(out, each)
    except ValueError as error:
        _send(out, _Refused(str(error)))
    except MemoryError:
        _send(out, _Refused(_("There is not enough memory for it; choose a smaller file.")))
    except Exception:
        _send(out, _Failed(traceback.format_exc()))
    return 0


def _bound_memory() -> None:
    if sys.platform != "win32":
        import resource

        bounds = [each for each in resource.getrlimit(resource.RLIMIT_AS) if each != resource.RLIM_INFINITY]
        most = min([_CHILD_BYTES, *bounds])
        with suppress(OSError, ValueError):  # some systems bound nothing so
            resource.setrlimit(resource.RLIMIT_AS, (most, most))


if __name__ == "__main__":
    sys.exit(main())
