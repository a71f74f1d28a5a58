"""What is drawn of Cohen and Sutherland's clipping."""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.clipping.cutting import bits
from workbench.algorithms.clipping.window_marks import edge_mark
from workbench.algorithms.marks import Mark, Spot, Stroke, Word, along


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The line as it was and as it is now, the edge it is cut off at, the codes of the ends that were cut."""
    x0, y0, x1, y1, *window = map(float, arguments)
    first, last = (x0, y0), (x1, y1)
    rejected = ended and not len(emitted)
    if ended and not rejected:
        x0, y0, x1, y1 = emitted[-1].tolist()
    elif "x0" in now:
        x0, y0, x1, y1 = (float(now[name]) for name in ("x0", "y0", "x1", "y1"))
    start, end = (x0, y0), (x1, y1)
    yield Stroke(along(first, last), "muted", "thin", "dash")
    if "edge" in now and not ended:
        yield edge_mark(window, now["edge"])
    yield Stroke(
        along(start, end), "data4" if rejected else "data1", "medium", "dot" if rejected else "solid"
    )
    for at, other, given, code in ((start, end, first, "code_0"), (end, start, last, "code_1")):
        cut = at != given
        yield Spot(*at, "data2" if cut else "text", "ring" if cut else "dot")
        if cut and code in now:
            yield Word(bits(now[code]), *at, "text", 1 if at[0] >= other[0] else -1, 1, True, True)
