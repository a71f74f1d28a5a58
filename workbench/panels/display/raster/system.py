"""The architecture of a raster-scan system, as a drawing: its parts, what they pass on, and their numbers.

Each part names the variables of the text whose numbers it holds; a part is lit where one of these has just
changed. Places are in units of the drawing, y upwards.
"""

from collections.abc import Collection, Mapping
from typing import Any, NamedTuple

import numpy as np

from workbench.algorithms.marks import Region, Stroke, Word, closed
from workbench.algorithms.numerals import numeral
from workbench.algorithms.scanning.raster_marks import hexadecimal
from workbench.display.colour_table import DIRECT
from workbench.display.raster_sums import frame_buffer_bytes
from workbench.display.scan import Scan
from workbench.exchange.diagrams import Arrow, Drawing, Item
from workbench.language import _

Point = tuple[float, float]
Numbers = Mapping[str, Any]

WIDTH, HEIGHT = 400.0, 320.0
BUS_NAME = 60.0, 250.0
"""Where the name of the bus begins, above it."""

_DASH = "\N{EN DASH}"


class Part(NamedTuple):
    """A box (left, bottom, right, top); ``holds`` are the variables whose numbers it shows."""

    key: str
    title: str
    box: tuple[float, float, float, float]
    holds: tuple[str, ...] = ()
    encloses: bool = False

    def lit(self, changed: Collection[str]) -> bool:
        """Whether it has just worked."""
        return any(name in changed for name in self.holds)


class Wire(NamedTuple):
    """What goes from a part to another one, along ``way``; lit with the part ``of``."""

    way: tuple[Point, ...]
    of: str = ""
    arrow: bool = True


def parts() -> tuple[Part, ...]:
    """From back to front."""
    return (
        Part("cpu", _("CPU"), (8, 266, 98, 312)),
        Part("memory", _("System memory"), (118, 266, 238, 312)),
        Part("controller", _("Display controller"), (258, 266, 392, 312)),
        Part("buffer", _("Frame buffer"), (258, 156, 392, 226), ("address",)),
        Part("video", _("Video controller"), (8, 8, 232, 226), encloses=True),
        Part("x", _("x register"), (18, 156, 112, 194), ("x",)),
        Part("y", _("y register"), (128, 156, 222, 194), ("y",)),
        Part("bits", _("pixel's bits"), (128, 100, 222, 140), ("bits",)),
        Part("table", _("colour table"), (18, 100, 112, 140), ("colour",)),
        Part("dac", _("DAC: red, green, blue"), (18, 24, 222, 72), ("red", "green", "blue")),
        Part("monitor", _("Monitor"), (262, 24, 388, 112), ("x_mm", "y_mm")),
    )


def wires() -> tuple[Wire, ...]:
    """The bus, and the way of a pixel."""
    return (
        Wire(((8, 246), (392, 246)), arrow=False),
        Wire(((53, 246), (53, 266)), arrow=False),
        Wire(((178, 246), (178, 266)), arrow=False),
        Wire(((325, 246), (325, 266)), arrow=False),
        Wire(((325, 246), (325, 226))),
        Wire(((65, 194), (65, 202), (258, 202)), "buffer"),
        Wire(((175, 194), (175, 202)), "buffer", arrow=False),
        Wire(((258, 176), (242, 176), (242, 120), (222, 120)), "bits"),
        Wire(((128, 120), (112, 120)), "table"),
        Wire(((65, 100), (65, 72)), "dac"),
        Wire(((222, 48), (262, 48)), "monitor"),
    )


def told(part: Part, scan: Scan | None, now: Numbers) -> tuple[str, ...]:
    """The lines of numbers that stand in a part; none is known of one that has not worked yet."""
    value = {name: now[name] for name in part.holds if name in now}
    match part.key:
        case "buffer" if scan is not None:
            timing, depth = scan.timing, scan.buffer.depth
            size = frame_buffer_bytes(timing.h_active, timing.v_active, depth)
            first = f"{timing.h_active} \u00d7 {timing.v_active} \u00d7 {depth} b"
            second = _("{size:,.10g} B").format(size=float(size))
            address = value.get("address")
            return first, second, "" if address is None else _("address {n}").format(n=address)
        case "bits":
            return (_binary(value["bits"], scan) if value else _DASH,)
        case "table":
            if scan is not None and scan.buffer.depth >= DIRECT:
                return (_("direct"),)
            return (hexadecimal(value["colour"]) if value else _DASH,)
        case "dac":
            return (", ".join(str(value[name]) for name in part.holds) if value else _DASH,)
        case "monitor":
            if len(value) < 2:
                return (_DASH,)
            on = now.get("colour", 0) != 0
            x, y = (f"{numeral(round(value[name], 1))} mm" for name in part.holds)
            return _("beam on") if on else _("beam off"), f"x {x}", f"y {y}"
        case "x" | "y":
            return (str(value[part.key]) if value else _DASH,)
    return ()


def _binary(bits: int, scan: Scan | None) -> str:
    """The bits as they stand in the buffer, those of a direct colour in hexadecimal digits."""
    depth = DIRECT if scan is None else scan.buffer.depth
    return f"{int(bits):06X} hex" if depth >= DIRECT else f"{int(bits):0{depth}b} = {int(bits)}"


def drawing(scan: Scan | None, now: Numbers, changed: Collection[str]) -> Drawing:
    """All of it as the drawing of a page."""
    items: list[Item] = []
    lit = {part.key for part in parts() if part.lit(changed)}
    for part in parts():
        left, bottom, right, top = part.box
        ring = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
        if part.key in lit:
            items.append(Region(ring, "accent"))
        items.append(
            Stroke(
                closed(ring), "accent" if part.key in lit else "text", "medium" if part.key in lit else "thin"
            )
        )
        middle = (left + right) / 2
        lines = (part.title, *filter(None, told(part, scan, now)))
        step = min(15.0, (top - bottom) / (len(lines) + 0.4))
        for number, line in enumerate(lines):
            y = top - step * (number + 0.75) if part.encloses or len(lines) > 1 else (top + bottom) / 2
            items.append(Word(line, middle, y, "text", 0, 0, strong=number > 0))
    for wire in wires():
        ink = "accent" if wire.of in lit else "muted"
        way = np.array(wire.way)
        items.append(Arrow(way, ink, "medium") if wire.arrow else Stroke(way, ink, "medium"))  # type: ignore[arg-type]
    items.append(Word(_("system bus"), *BUS_NAME, "muted", 1, 1))
    return Drawing((0.0, 0.0, WIDTH, HEIGHT), items, 360.0)
