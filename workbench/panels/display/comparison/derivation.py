"""Question 10 answered on a page: how both displays work, drawn and labelled, and compared in numbers."""

import itertools

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Region, Stroke, Word
from workbench.algorithms.numerals import with_minus
from workbench.algorithms.scanning.operations import JUMP, NAMES
from workbench.exchange.diagrams import Arrow, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.exchange.grids import Grid
from workbench.language import _
from workbench.panels.display.comparison.facts import Facts, features
from workbench.widgets.formulas.paper import paper_inks

_HEIGHT_PT = 165.0
_WINDOW = (0.0, 0.0, 120.0, 46.0)
_SCREEN = (80.0, 6.0, 118.0, 38.0)
_ROWS = 5
_CELLS = 8
_SHARES = (0.7, 1.0, 1.0)


def derivation(facts: Facts, image: NDArray[np.uint32]) -> Derivation:
    """The page, with the numbers of this picture."""
    title = _("Raster scan and random scan")
    blocks: list[Block] = [
        Heading(title),
        Heading(_("Raster-scan display")),
        Sentence(
            _(
                "The picture is a grid of pixels in a frame buffer. The video controller reads it row by "
                "row, and the beam sweeps the whole screen from the top left to the bottom right, brighter "
                "or darker as each pixel says. After each row it flies back dark to the left (horizontal "
                "retrace), after the last one to the top (vertical retrace), and begins anew."
            )
        ),
        _raster(image),
        Sentence(
            _("Here: {w} × {h} pixels, {n:,} bytes, a picture every {ms:.3g} ms ({hz:.3g} Hz).").format(
                w=facts.size[0],
                h=facts.size[1],
                n=facts.frame_buffer_bytes,
                ms=float(facts.raster.frame_s) * 1e3,
                hz=float(facts.raster.refresh_hz),
            )
        ),
        Heading(_("Random-scan (vector) display")),
        Sentence(
            _(
                "The picture is a list of lines, the display list, in memory. The display processor runs "
                "through it, and its vector generator moves the beam from end to end of each line, in any "
                "order, dark in between. At the end of the list it jumps to the beginning: refresh."
            )
        ),
        _random(facts),
        Sentence(
            _(
                "Here: {n:,} instructions, {b:,} bytes; the list takes {ms:.3g} ms and is refreshed at "
                "{hz:.3g} Hz, while the eye asks for {fusion:.3g} Hz."
            ).format(
                n=len(facts.program),
                b=facts.list_bytes,
                ms=facts.time.list_ps * 1e-9,
                hz=facts.time.refresh_hz,
                fusion=facts.fusion_hz,
            )
        ),
        Heading(_("Compared")),
    ]
    rows = features(facts)
    headings = _("Feature"), _("Raster scan"), _("Random scan")
    blocks.append(Grid(headings, [(row.name, row.raster, row.random) for row in rows], _SHARES))
    blocks += [Sentence(_("{name}: {but}").format(name=row.name, but=row.but)) for row in rows]
    return Derivation(title, blocks, paper_inks())


def _ring(x0: float, y0: float, x1: float, y1: float) -> NDArray[np.float64]:
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])


def _box(x0: float, y0: float, x1: float, y1: float, *words: str) -> list[Item]:
    """A part of the system, its name inside, word by word."""
    items: list[Item] = [Stroke(_ring(x0, y0, x1, y1), "text", "thin")]
    top = (y0 + y1) / 2 + 2.0 * (len(words) - 1)
    return items + [Word(word, (x0 + x1) / 2, top - 4.0 * k, "text") for k, word in enumerate(words)]


def _arrow(*places: tuple[float, float], ink: Ink = "text", dash: bool = False) -> Arrow:
    return Arrow(np.array(places), ink, "thin", "dash" if dash else "solid")


def _raster(image: NDArray[np.uint32]) -> Drawing:
    """Frame buffer, video controller, and the way of the beam over the screen."""
    x0, y0, x1, y1 = _SCREEN
    items: list[Item] = [*_box(44.0, 12.0, 66.0, 32.0, _("video"), _("controller"))]
    items += _buffer(image)
    items += [
        _arrow((34.0, 22.0), (44.0, 22.0)),
        _arrow((66.0, 22.0), (x0, 22.0)),
        Stroke(_ring(*_SCREEN), "text", "medium"),
        Word(_("monitor"), (x0 + x1) / 2, y1, "text", 0, 1),
        Word(_("scan line"), x1 - 4.0, y1 - 3.6, "data1", -1, -1),
        Word(_("horizontal retrace"), (x0 + x1) / 2, (y0 + y1) / 2, "data2", 0, 0),
        Word(_("vertical retrace"), (x0 + x1) / 2, y0, "data3", 0, -1),
    ]
    pitch = (y1 - y0 - 6) / (_ROWS - 1)
    for row in range(_ROWS):
        y = y1 - 3 - row * pitch
        items.append(_arrow((x0 + 2, y), (x1 - 2, y - 0.6), ink="data1"))
        if row < _ROWS - 1:
            items.append(_arrow((x1 - 2, y - 0.6), (x0 + 2, y - pitch), ink="data2", dash=True))
    items.append(_arrow((x1 - 2, y0 + 2.4), (x0 + 2, y1 - 3), ink="data3", dash=True))
    return Drawing(_WINDOW, items, _HEIGHT_PT)


def _buffer(image: NDArray[np.uint32]) -> list[Item]:
    """A few cells of the frame buffer, where about half of them are lit."""
    height, width = image.shape
    rows, columns = min(_ROWS + 1, height), min(_CELLS, width)
    lit = image != 0
    # Of all corners at once: the sums up to each place, from which four give that of a part
    up_to = np.zeros((height + 1, width + 1), np.int64)
    up_to[1:, 1:] = lit.cumsum(axis=0).cumsum(axis=1)
    of_rows = up_to[rows:] - up_to[:-rows]
    sums = of_rows[:, columns:] - of_rows[:, :-columns]
    away = np.abs(sums - rows * columns // 2)
    y, x = np.unravel_index(away.argmin(), away.shape)
    part = lit[y : y + rows, x : x + columns]
    items: list[Item] = [
        Stroke(_ring(4.0, 10.0, 34.0, 34.0), "text", "thin"),
        Word(_("frame buffer"), 19.0, 34.0, "text", 0, 1),
    ]
    for row, cells in enumerate(part):
        for column, on in enumerate(cells):
            place = 4.0 + (column + 0.5) * 30.0 / columns, 10.0 + (row + 0.5) * 24.0 / rows
            ink: Ink = "data1" if on else "muted"
            items.append(Word("1" if on else "0", *place, ink))
            if on:
                half_x, half_y = 15.0 / columns, 12.0 / rows
                ring = _ring(place[0] - half_x, place[1] - half_y, place[0] + half_x, place[1] + half_y)
                items.append(Region(ring[:-1], "data1"))
    return items


def _random(facts: Facts) -> Drawing:
    """Display list, display processor, vector generator, and the strokes on the screen."""
    x0, y0, x1, y1 = _SCREEN
    items: list[Item] = [
        *_box(30.0, 12.0, 50.0, 32.0, _("display"), _("processor")),
        *_box(56.0, 12.0, 74.0, 32.0, _("vector"), _("generator")),
        Stroke(_ring(2.0, 6.0, 24.0, 36.0), "text", "thin"),
        Word(_("display list"), 13.0, 36.0, "text", 0, 1),
    ]
    rows = facts.program.rows[:-1][:_ROWS].tolist()
    for k, (operation, x, y, _intensity) in enumerate(rows):
        words = with_minus(f"{NAMES[int(operation)]} {x:.3g}, {y:.3g}")
        items.append(Word(words, 3.0, 33.0 - 4.6 * k, "text", 1, 0))
    items.append(Word(f"{NAMES[JUMP]} 0", 3.0, 33.0 - 4.6 * len(rows), "data3", 1, 0))
    items += [
        _arrow((24.0, 22.0), (30.0, 22.0)),
        _arrow((50.0, 22.0), (56.0, 22.0)),
        _arrow((74.0, 22.0), (x0, 22.0)),
        Stroke(_ring(*_SCREEN), "text", "medium"),
        Word(_("monitor"), (x0 + x1) / 2, y1, "text", 0, 1),
    ]
    width, height = facts.size
    scale = min((x1 - x0 - 2) / width, (y1 - y0 - 2) / height)
    shift = np.array([(x0 + x1 - scale * (width - 1)) / 2, (y0 + y1 - scale * (height - 1)) / 2])
    ends = facts.program.strokes.ends[:300] * scale + shift
    for before, now in itertools.pairwise(ends):
        if not np.array_equal(before[1], now[0]):
            items.append(Stroke(np.stack([before[1], now[0]]), "data2", "hair", "dash"))
    items += [Stroke(each, "data1", "thin") for each in ends]
    return Drawing(_WINDOW, items, _HEIGHT_PT)
