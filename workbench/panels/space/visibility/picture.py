"""What the Visibility canvas shows of a run: colours, depths as greys, how often each pixel was touched."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QColor

from workbench.algorithms.numerals import with_minus
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.panels.stage.heat import heated
from workbench.panels.stage.picture import Pixels, data_colours, packed
from workbench.rendering.scene.fragments import NOTHING, Index
from workbench.widgets.canvas.drawing import Drawn, PenStroke
from workbench.widgets.canvas.lens import SIDE, LensCells
from workbench.widgets.canvas.overlay import Cell
from workbench.widgets.canvas.row_depths import RowOfDepths
from workbench.widgets.look.tokens import Tokens

Shown = Literal["colour", "depth", "tests", "writes"]
_PALE = 0.3
_NEAREST, _FARTHEST = 0xF0, 0x30


def surface_colours(run: DepthRun, now: Tokens) -> NDArray[np.uint32]:
    """The colour of each triangle (t,), 0xRRGGBB; the data colours are those of the theme."""
    themed = data_colours(now)
    return np.array([themed.get(colour, colour) for colour in run.device.colours.tolist()], np.uint32)


def picture(run: DepthRun, shown: Shown, now: Tokens) -> Pixels:
    """The picture (h, w), 0xRRGGBB, as far as the run has come."""
    paper = np.full(run.size[::-1], packed(now.canvas), np.uint32)
    so_far = run.so_far
    if shown == "tests":
        return heated(paper, so_far.tests(run.size), now)
    if shown == "writes":
        return heated(paper, so_far.writes(run.size), now)
    if shown == "depth":
        return _greys(run, paper)
    colours = surface_colours(run, now)
    paint_surfaces(paper, _first_to_come(run), colours, _PALE)
    paint_surfaces(paper, so_far.seen(run.size), colours, 1.0)
    return paper


def paint_surfaces(paper: Pixels, surfaces: Index, colours: NDArray[np.uint32], share: float) -> None:
    """Paint the surfaces (h, w), but NOTHING, over ``paper`` with a share of their colours."""
    covered = surfaces != NOTHING
    under, over = paper[covered], colours[surfaces[covered]]
    mixed = np.zeros(len(under), np.uint32)
    for shift in (16, 8, 0):
        low, high = ((each >> np.uint32(shift)) & np.uint32(0xFF) for each in (under, over))
        mixed |= np.round(low + share * (high.astype(float) - low)).astype(np.uint32) << np.uint32(shift)
    paper[covered] = mixed


def _first_to_come(run: DepthRun) -> Index:
    """(h, w) the triangle that will come first to each pixel."""
    later, size = run.fragments, run.size
    surfaces = np.full(size[::-1], NOTHING)
    # Of several writes to one pixel NumPy keeps the last.
    back = slice(len(later), run.reached - 1 if run.reached else None, -1)
    surfaces[later.y[back], later.x[back]] = later.surface[back]
    return surfaces


def _greys(run: DepthRun, paper: Pixels) -> Pixels:
    """Near is light, far is dark; the scene's own depths take the whole scale."""
    depths = run.so_far.depths(run.size, run.farthest)
    written = run.so_far.writes(run.size) > 0
    low, high = float(run.fragments.z.min()), float(run.fragments.z.max())
    share = np.clip((depths[written] - low) / max(high - low, 1e-12 * run.farthest), 0.0, 1.0)
    grey = np.round(_NEAREST + share * (_FARTHEST - _NEAREST)).astype(np.uint32)
    paper[written] = grey << np.uint32(16) | grey << np.uint32(8) | grey
    return paper


def row_frame(run: DepthRun, y: int) -> Drawn:
    """The frame of the current row."""
    left, right = -0.5, run.size[0] - 0.5
    corners = [(left, y - 0.5), (right, y - 0.5), (right, y + 0.5), (left, y + 0.5), (left, y - 0.5)]
    return PenStroke(np.array(corners), "accent", 1.5)


def down_to_plot(x: int, y: int) -> Drawn:
    """The dotted line from the current pixel down to where the plot goes on with it."""
    return PenStroke(np.array([(x, y - 0.5), (x, -0.5)], np.float64), "text", 1.0, "dot")


def row_of_depths(run: DepthRun, now: Tokens) -> RowOfDepths | None:
    """The current row for the plot; None before the first fragment."""
    number = run.now
    if number is None:
        return None
    fragments = run.fragments
    y, surface = int(fragments.y[number]), int(fragments.surface[number])
    own = np.flatnonzero((fragments.surface == surface) & (fragments.y == y))
    before = fragments.upto(int(own[0]))
    stored = before.depths(run.size, run.farthest)[y]
    stored[before.writes(run.size)[y] == 0] = np.nan
    came, won = own <= number, fragments.won[own]
    points = np.stack([fragments.x[own], fragments.z[own]], axis=1).astype(np.float64)
    A, B, C, D = run.plane_of(surface)
    return RowOfDepths(
        y,
        stored,
        points[came & won],
        points[came & ~won],
        points[~came],
        QColor(0xFF000000 | int(surface_colours(run, now)[surface])),
        int(fragments.x[number]),
        f"−A/C = {_plain(-A / C)}",
        f"{run.name_of(surface)}: A {_plain(A)}  B {_plain(B)}  C {_plain(C)}  D {_plain(D)}",
    )


def lens_cells(run: DepthRun, middle: Cell, title: str, now: Tokens) -> LensCells:
    """The depth buffer round a pixel."""
    so_far, number = run.so_far, run.now
    depths, seen = so_far.depths(run.size, run.farthest), so_far.seen(run.size)
    colours = surface_colours(run, now)
    half = SIDE // 2
    inks = np.full((SIDE, SIDE), -1)
    notched = np.zeros((SIDE, SIDE), bool)
    texts: list[tuple[str | None, ...]] = []
    for row in range(SIDE):
        line: list[str | None] = []
        for column in range(SIDE):
            x, y = middle[0] - half + column, middle[1] - half + row
            if not (0 <= x < run.size[0] and 0 <= y < run.size[1]):
                line.append(None)
                continue
            line.append(_short(depths[y, x], run))
            if seen[y, x] != NOTHING:
                inks[row, column] = int(colours[seen[y, x]])
                notched[row, column] = number is not None and seen[y, x] == run.fragments.surface[number]
        texts.append(tuple(line))
    current = None if number is None else (int(run.fragments.x[number]), int(run.fragments.y[number]))
    return LensCells(title, middle, tuple(texts), inks, notched, current)


def _short(z: float, run: DepthRun) -> str:
    return f"{z:.0f}" if run.bits else f"{z:.3f}"


def _plain(value: float) -> str:
    return with_minus(f"{value:.5g}")
