"""The parts of a random-scan system as a drawing, and which of them work in a step."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Region, Spot, Stroke, Word
from workbench.algorithms.numerals import with_minus
from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE, NAMES
from workbench.exchange.diagrams import Arrow, Drawing, Item
from workbench.language import _

_WINDOW = (0.0, 4.0, 122.0, 50.0)
_LISTED = 5
_SCREEN = (94.0, 17.0, 120.0, 41.0)
_BUS_Y = 11.0
_LINE = 4.0

Box = tuple[float, float, float, float]


class Working(NamedTuple):
    """What is seen of a step: its operation and address, -1 while nothing is stepped; the place of the beam;
    what the frame has drawn so far (n, 2, 2) and all that it will; the size of the picture in pixels.
    """

    operation: int
    address: int
    beam: tuple[float, float]
    drawn: NDArray[np.float64]
    whole: NDArray[np.float64]
    size: tuple[int, int]
    program: NDArray[np.float64]


PARTS: Mapping[str, tuple[Box, str]] = {
    "cpu": ((2.0, 37.0, 20.0, 47.0), _("CPU")),
    "memory": ((2.0, 14.0, 34.0, 31.0), _("system memory")),
    "processor": ((43.0, 16.0, 63.0, 42.0), _("display processor")),
    "generator": ((69.0, 16.0, 87.0, 42.0), _("vector generator")),
}
_LIT: Mapping[int, tuple[str, ...]] = {
    MOVE: ("memory", "bus", "processor", "generator", "deflection"),
    DRAW: ("memory", "bus", "processor", "generator", "deflection", "intensity"),
    JUMP: ("processor",),
}


def lit_parts(operation: int) -> tuple[str, ...]:
    """The parts that work in an instruction; none while nothing is stepped."""
    return _LIT.get(operation, ())


def architecture(now: Working, height: float) -> Drawing:
    """The drawing, at most ``height`` points high."""
    lit = lit_parts(now.operation)
    items: list[Item] = []
    for name in PARTS:
        items += _boxed(name, name in lit)
    items += _bus("bus" in lit)
    items += _wires(lit)
    items += _listing(now)
    items += _counter(now)
    items += _screen(now)
    return Drawing(_WINDOW, items, height)


def told(now: Working) -> str:
    """The same in words."""
    if now.address < 0:
        return _("CPU and display processor share the memory in which the display list is; nothing runs.")
    names = {**{name: title for name, (_box, title) in PARTS.items()}}
    names |= {"bus": _("system bus"), "deflection": _("deflection"), "intensity": _("beam current")}
    said = _("Counter {address}, {operation}: {parts} at work.")
    parts = ", ".join(names[part] for part in lit_parts(now.operation))
    return said.format(address=now.address, operation=NAMES[now.operation], parts=parts)


def _ring(box: Box) -> NDArray[np.float64]:
    x0, y0, x1, y1 = box
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])


def _boxed(name: str, lit: bool) -> list[Item]:
    """A part with its title: over the memory, which is full of instructions, in the others word by word."""
    box, title = PARTS[name]
    x0, y0, x1, y1 = box
    ink: Ink = "accent" if lit else "text"
    items: list[Item] = [Region(_ring(box)[:-1], "accent")] if lit else []
    items.append(Stroke(_ring(box), ink, "bold" if lit else "thin"))
    middle = (x0 + x1) / 2
    if name == "memory":
        return [*items, Word(title, middle, y1, ink, 0, 1, strong=lit)]
    words = title.split()
    top = (y0 + y1) / 2 if len(words) == 1 else y1 - 2.5
    return [
        *items,
        *(Word(word, middle, top - _LINE * k, ink, strong=lit) for k, word in enumerate(words)),
    ]


def _arrow(places: Sequence[tuple[float, float]], lit: bool) -> Arrow:
    return Arrow(np.array(places), "accent" if lit else "muted", "medium" if lit else "thin")


def _bus(lit: bool) -> list[Item]:
    """The system bus below, and what hangs on it."""
    ink: Ink = "accent" if lit else "muted"
    items: list[Item] = [Stroke(np.array([(2.0, _BUS_Y), (63.0, _BUS_Y)]), ink, "heavy" if lit else "bold")]
    items.append(Word(_("system bus"), 38.0, _BUS_Y, ink, 0, -1))
    items.append(_arrow([(18.0, 14.0), (18.0, _BUS_Y)], lit))
    items.append(_arrow([(53.0, _BUS_Y), (53.0, 16.0)], lit))
    items.append(Stroke(np.array([(38.5, _BUS_Y), (38.5, 42.0), (20.0, 42.0)]), "muted", "thin"))
    return items


def _wires(lit: Sequence[str]) -> list[Item]:
    """From the processor through the generator to the tube."""
    x0, y0, _x1, y1 = _SCREEN
    deflection, intensity = "deflection" in lit, "intensity" in lit
    high, middle, low = y1 - 3.0, (y0 + y1) / 2, y0 + 3.0
    return [
        _arrow([(63.0, middle), (69.0, middle)], "generator" in lit),
        _arrow([(87.0, high), (x0, high)], deflection),
        Word("x", 90.5, high, "muted", 0, 1),
        _arrow([(87.0, middle), (x0, middle)], deflection),
        Word("y", 90.5, middle, "muted", 0, 1),
        _arrow([(87.0, low), (x0, low)], intensity),
        Word("I", 90.5, low, "muted", 0, 1),
    ]


def _listing(now: Working) -> list[Item]:
    """The instructions around the counter, as they lie in memory."""
    (x0, y0, x1, y1), _title = PARTS["memory"]
    if not len(now.program):
        return [Word(_("empty"), (x0 + x1) / 2, (y0 + y1) / 2, "muted")]
    first = min(max(now.address - _LISTED // 2, 0), max(len(now.program) - _LISTED, 0))
    rows = now.program[first : first + _LISTED].tolist()
    pitch = (y1 - y0) / _LISTED
    items: list[Item] = []
    for k, (operation, x, y, _intensity) in enumerate(rows):
        address, at = first + k, y1 - (k + 0.5) * pitch
        current = address == now.address
        if current:
            box = x0, at - pitch / 2, x1, at + pitch / 2
            items.append(Region(_ring(box)[:-1], "data2"))
        place = with_minus(f"{x:.3g}, {y:.3g}") if operation != JUMP else "0"
        ink: Ink = "text" if current else "muted"
        word = f"{address}:  {NAMES[int(operation)]}  {place}"
        items.append(Word(word, x0 + 1.0, at, ink, 1, 0, strong=current))
    return items


def _counter(now: Working) -> list[Item]:
    """What the display processor holds."""
    (x0, y0, x1, _y1), _title = PARTS["processor"]
    middle = (x0 + x1) / 2
    counter = str(now.address) if now.address >= 0 else "0"
    held = NAMES[now.operation] if now.address >= 0 else "\N{EN DASH}"
    lit = now.address >= 0
    ink: Ink = "text" if lit else "muted"
    rows = ((_("counter"), "muted", False), (counter, ink, lit), (_("instruction"), "muted", False))
    return [
        Word(text, middle, y0 + 14.5 - _LINE * k, each, strong=strong)  # type: ignore[arg-type]
        for k, (text, each, strong) in enumerate((*rows, (held, ink, lit)))
    ]


def _screen(now: Working) -> list[Item]:
    """The monitor with its picture, as far as the frame has come."""
    x0, y0, x1, y1 = _SCREEN
    width, height = now.size
    scale = min((x1 - x0 - 2) / width, (y1 - y0 - 2) / height)
    shift = np.array([(x0 + x1 - scale * (width - 1)) / 2, (y0 + y1 - scale * (height - 1)) / 2])
    items: list[Item] = [
        Stroke(_ring(_SCREEN), "text", "medium"),
        Word(_("monitor"), (x0 + x1) / 2, y1, "text", 0, 1),
    ]
    items += [Stroke(ends * scale + shift, "muted", "hair", "dot") for ends in now.whole[:400]]
    items += [Stroke(ends * scale + shift, "data1", "medium") for ends in now.drawn[-400:]]
    if now.address >= 0:
        x, y = (np.array(now.beam) * scale + shift).tolist()
        items.append(Spot(x, y, "accent", "dot" if now.operation == DRAW else "ring", "medium"))
    return items
