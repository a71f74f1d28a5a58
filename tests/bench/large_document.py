"""What one edit of a large document costs: 10,000 curves of 7 points each, on one sheet.

Run it by hand: ``python tests/bench/large_document.py``. Times are the least of several, in milliseconds of
this thread. The last lines tell how long a thread that saves keeps this one from running.
"""

import gc
import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path.insert(0, str(Path(__file__).parents[2]))

from msgspec.structs import replace
from PySide6.QtCore import QCoreApplication

from workbench.document import Stored, edits
from workbench.document.addresses import changed, new_ids
from workbench.document.model import Curve, CurvePoint, Document
from workbench.document.samples.examples import blank_sheet
from workbench.document.state import SessionState, cleaned
from workbench.document.storage.blobs import Blob
from workbench.document.storage.files import decode, encode, write
from workbench.session import Session

CURVES, POINTS = 10_000, 7


def large(curves: int = CURVES) -> Document:
    """A sheet full of curves."""
    document = blank_sheet()
    sheet = document.sheets[0]
    figures = tuple(
        Curve(
            f"f{number * (POINTS + 1) + 1}",
            tuple(
                CurvePoint(f"p{number * (POINTS + 1) + 2 + k}", number % 200 + k * 1.5, number % 150 + k % 3)
                for k in range(POINTS)
            ),
            "bresenham_line",
        )
        for number in range(curves)
    )
    return replace(document, sheets=(replace(sheet, figures=figures),))


def least(act: Callable[[], object], before: Callable[[], object] = lambda: None, turns: int = 7) -> float:
    """The shortest of some times that ``act`` takes, in milliseconds."""
    times = []
    for _turn in range(turns):
        before()
        start = time.thread_time()
        act()
        times.append(time.thread_time() - start)
    return min(times) * 1e3


def held(act: Callable[[], object]) -> tuple[float, float]:
    """How long ``act`` takes on a thread, and the longest that this one could not run meanwhile, in ms."""
    thread = threading.Thread(target=act)
    start = last = time.perf_counter()
    longest = 0.0
    thread.start()
    while thread.is_alive():
        time.sleep(0.0005)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    return (time.perf_counter() - start) * 1e3, longest * 1e3


def main() -> None:
    """Measure, and print a table."""
    application = QCoreApplication([])
    gc.freeze()
    document = large()
    session = Session(document=document)
    application.processEvents()
    middle = document.sheets[0].figures[CURVES // 2]
    last = document.sheets[0].figures[-1]
    sheet = document.sheets[0].id
    count = iter(range(1, 10**6))

    def bare() -> Curve:
        return replace(middle, id="", points_world=tuple(replace(p, id="") for p in middle.points_world))

    print("\none edit, as apply does it; and telling of it (flush)")
    all_edits: dict[str, Callable[[], edits.Edit]] = {
        "add a curve": lambda: edits.add_figure(sheet, bare()),
        "add a curve at the back": lambda: edits.add_figure(sheet, bare(), 0),
        "add 100 curves": lambda: edits.add_figures(sheet, [bare()] * 100),
        "duplicate a curve": lambda: edits.duplicate_figures([middle.id]),
        "remove a curve": lambda: edits.remove_figures([session.sheet.figures[next(count)].id]),
        "move a point": lambda: edits.move_points(
            {f"{sheet}/{last.id}/{last.points_world[0].id}/x": (next(count) % 100, 3.0)}
        ),
        "move a curve": lambda: edits.move_figures([middle.id], 1.0, 0.0),
        "reorder": lambda: edits.reorder(middle.id, next(count) % CURVES),
        "set the colour": lambda: edits.set_attribute(f"{sheet}/{middle.id}/colour", next(count) % 2),
        "rename the sheet": lambda: edits.rename_sheet(sheet, str(next(count))),
        "set the window": lambda: edits.set_attribute(
            f"{sheet}/{session.sheet.first_view.id}/window_world.xmin", -next(count)
        ),
        "a longer palette": lambda: edits.set_palette(sheet, (*session.sheet.palette, *range(9))),
        "add a sheet": lambda: edits.add_sheet(replace(blank_sheet().sheets[0], id="")),
        "a shorter palette": lambda: edits.set_palette(sheet, session.sheet.palette[:-1]),
    }
    for name, make in all_edits.items():
        apply = least(lambda make=make: session.apply(make(), "Edit"), session.flush)
        flush = least(session.flush, lambda make=make: session.apply(make(), "Edit"))
        undo = least(session.undo_stack.undo, lambda make=make: session.apply(make(), "Edit"))
        print(f"  {name:28}{apply:9.2f}{flush:9.2f}   undo{undo:8.2f}")

    print("\nparts")
    moved = edits.move_figures([middle.id], 1.0, 0.0)(document)
    added = edits.add_figure(sheet, bare())(document)
    parts: dict[str, Callable[[], object]] = {
        "new ids": lambda: new_ids(document, "f", 8),
        "new == old, one moved": lambda: moved == document,
        "new == old, one added": lambda: added == document,
        "addresses, one moved": lambda: changed(document, moved),
        "addresses, one added": lambda: changed(document, added),
        "addresses, one removed": lambda: changed(added, document),
        "cleaned state": lambda: cleaned(session.state, moved),
        "update of the state": lambda: session.update_state(step=next(count)),
        "cleaned state, all selected": lambda: cleaned(everything, moved),
        "encode": lambda: encode(Stored(document)),
        "decode": lambda: decode(text),
    }
    text = encode(Stored(document))
    everything = SessionState(selection=tuple(figure.id for figure in document.sheets[0].figures))
    for name, part in parts.items():
        print(f"  {name:28}{least(part):9.2f}")
    print(f"  {'size of the file':28}{len(text) / 2**20:9.2f} MiB")

    print("\nsaving on a thread: time, and the longest hold of the interface")
    took, hold = held(lambda: time.sleep(1))
    print(f"  {'nothing':28}{took:9.1f}{hold:9.1f}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "large.gwb"
        for name, stored in stored_things(document):
            took, hold = held(lambda stored=stored: write(stored, path))
            print(f"  {name:28}{took:9.1f}{hold:9.1f}")


def stored_things(document: Document) -> list[tuple[str, Stored]]:
    """What is saved: many curves, and few curves with a large blob."""
    blob = Blob(os.urandom(50 * 2**20))
    return [
        ("10,000 curves", Stored(document)),
        ("a blob of 50 MiB", Stored(blank_sheet(), blobs={blob.digest: blob})),
    ]


if __name__ == "__main__":
    main()
