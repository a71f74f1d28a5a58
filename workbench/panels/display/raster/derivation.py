"""The raster-scan system as a page: the labelled drawing with its numbers, the timing, and the sums."""

from collections.abc import Collection, Sequence

import numpy as np

from workbench.algorithms.marks import Region, Stroke, Word, closed
from workbench.display.beam_path import Segment, frame_segments, line_segments
from workbench.display.scan import Scan
from workbench.exchange.diagrams import Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.exchange.tables import plain
from workbench.language import _
from workbench.panels.display.raster.sums import Sum
from workbench.panels.display.raster.system import Numbers, drawing
from workbench.widgets.formulas.paper import paper_inks
from workbench.widgets.look.spans import time_text
from workbench.widgets.tube.timing_diagram import kind_title

_INKS = {"active": "data1", "front_porch": "data5", "sync": "data2", "back_porch": "data4"}
_WIDE, _HIGH, _PT = 400.0, 20.0, 60.0


def derivation(
    scan: Scan | None, now: Numbers, changed: Collection[str], sums: Sequence[Sum]
) -> Derivation | None:
    """The page; None where nothing can be scanned."""
    if scan is None:
        return None
    title = _("Raster-scan system")
    timing = scan.timing
    blocks: list[Block] = [Heading(title), drawing(scan, now, changed)]
    blocks.append(Heading(_("One line, {time}").format(time=time_text(float(timing.line_s)))))
    blocks += _strip(line_segments(timing), float(timing.pixel_s), _("clocks"))
    blocks.append(Heading(_("One frame, {time}").format(time=time_text(float(timing.frame_s)))))
    blocks += _strip(frame_segments(timing), float(timing.line_s), _("lines"))
    if sums:
        blocks.append(Heading(_("Sums")))
        blocks += [
            Sentence(f"{s.title}: ${s.formula}$ = {plain(s.numbers)} = {s.result or s.fault}") for s in sums
        ]
    return Derivation(title, blocks, paper_inks())


def _strip(segments: Sequence[Segment], each_s: float, unit: str) -> list[Block]:
    """The parts to scale, and their numbers in words."""
    scale = _WIDE / sum(segment.length for segment in segments)
    items: list[Item] = []
    for segment in segments:
        left, right = segment.start * scale, (segment.start + segment.length) * scale
        if right <= left:
            continue
        height = _HIGH * (1.0 if segment.kind == "active" else 0.2 if segment.kind == "sync" else 0.45)
        ring = np.array([(left, 0.0), (right, 0.0), (right, height), (left, height)])
        ink = _INKS[segment.kind]
        items += [Region(ring, ink), Stroke(closed(ring), ink, "thin")]  # type: ignore[arg-type]
        if segment.kind == "active":
            items.append(Word(kind_title("active"), (left + right) / 2, height / 2))
    said = "; ".join(
        f"{kind_title(s.kind)} {s.length:g} {unit}, {time_text(s.length * each_s)}" for s in segments
    )
    return [Drawing((0.0, 0.0, _WIDE, _HIGH), items, _PT), Sentence(f"{said}.")]
