"""What is drawn of Liang and Barsky's clipping."""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.clipping.window_marks import edge_mark
from workbench.algorithms.marks import Mark, Spot, Stroke, Word, along
from workbench.algorithms.numerals import numeral


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The interval from u1 to u2 on the line, the edge that is looked at, where the line crosses it."""
    x0, y0, x1, y1 = (float(value) for value in arguments[:4])

    def at(u: float) -> tuple[float, float]:
        return x0 + u * (x1 - x0), y0 + u * (y1 - y0)

    yield Stroke(along((x0, y0), (x1, y1)), "muted", "thin", "dash")
    if "k" in now and not ended:
        yield edge_mark(arguments[4:], 1 << (now["k"] - 1))
    if not now and ended:
        for ax, ay, bx, by in emitted.tolist():
            yield Stroke(along((ax, ay), (bx, by)), "data1", "bold")
        return
    u1, u2 = now.get("u1", 0.0), now.get("u2", 1.0)
    if u1 <= u2:
        yield Stroke(along(at(u1), at(u2)), "data1", "bold")
    if "r" in now and not ended and _near(now["r"]):
        yield Spot(*at(now["r"]), "data2", "cross")
    for name, u, side in (("u₁", u1, -1), ("u₂", u2, 1)):
        if _near(u):
            yield Spot(*at(u), "data1", "ring")
            yield Word(f"{name} = {numeral(u)}", *at(u), "text", side if x1 >= x0 else -side, 1, True)


def _near(u: float) -> bool:
    """Whether a place on the line is near enough to be drawn."""
    return -1.0 <= u <= 2.0
