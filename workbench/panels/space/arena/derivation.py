"""Object space against image space as a page: pictures of the scene, the table, and how the time grows."""

import re
from itertools import pairwise

import numpy as np

from workbench.algorithms.marks import Region, Spot, Stroke, Word
from workbench.exchange.diagrams import Arrow, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.language import _
from workbench.rendering.scene.arena import TRUTH, MethodRun, space_of
from workbench.rendering.scene.growth import Growth
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.scene.spaces import Measures, space_rows, title_of
from workbench.widgets.formulas.paper import paper_inks

_PICTURE_PT, _PLOT_PT = 130.0, 170.0
_POWER = re.compile(r"\b([np])\^(−?[\d.]*\d)")


def derivation(device: DeviceTriangles | None, measures: Measures) -> Derivation:
    """The page of what is measured by now; pictures come with the triangles of the scene."""
    title = _("Object space and image space")
    blocks: list[Block] = [Heading(title)]
    for run in measures.runs.values():
        if device is not None and (run.method == TRUTH or run.different.any()):
            blocks += [Sentence(_told(run)), _picture(run, device)]
    for row in space_rows(measures):
        blocks.append(Heading(row.feature))
        for said, text in (
            (_("Object space: {text}."), row.object_space),
            (_("Image space: {text}."), row.image_space),
        ):
            blocks.append(Sentence(said.format(text=_POWER.sub(r"$\1^{\2}$", text))))
        if row.but:
            blocks.append(Sentence(_("But: {text}").format(text=row.but)))
    for which, name in enumerate((_("Time by pixels"), _("Time by polygons"))):
        growth = [each for each in measures.growth.values() if _points(each, which)]
        if growth:
            blocks += [Heading(name), _growth(growth, which)]
    return Derivation(title, blocks, paper_inks())


def _told(run: MethodRun) -> str:
    n = int(run.different.sum())
    if not n:
        return _("{title} ({space}), which is taken as the truth:").format(
            title=title_of(run.method), space=_(space_of(run.method))
        )
    said = _("{title} ({space}): {n:,} of {all:,} pixels are wrong, crossed out here.")
    return said.format(title=title_of(run.method), space=_(space_of(run.method)), n=n, all=run.seen.size)


def _picture(run: MethodRun, device: DeviceTriangles) -> Drawing:
    """The pixels by the colours of their objects, row by row, and crosses on those that are wrong."""
    height, width = run.seen.shape
    items: list[Item] = []
    for y in range(height):
        row = run.seen[y]
        things = np.where(row >= 0, device.objects[np.maximum(row, 0)], -1)
        starts = [0, *(np.flatnonzero(np.diff(things)) + 1).tolist(), width]
        for start, end in pairwise(starts):
            if things[start] >= 0:
                ring = [(start, y), (end, y), (end, y + 1), (start, y + 1)]
                items.append(Region(np.array(ring) - 0.5, f"data{int(things[start]) % 6 + 1}"))  # type: ignore[arg-type]
    ys, xs = np.nonzero(run.different)
    items += [Spot(float(x), float(y), "error", "cross", "small") for x, y in zip(xs, ys, strict=True)]
    return Drawing((-0.5, -0.5, width - 0.5, height - 0.5), items, _PICTURE_PT)


def _growth(growth: list[Growth], which: int) -> Drawing:
    """Both axes logarithmic, a line for each method with its name and power at its end."""
    lines = [(each, np.log10(np.array(_points(each, which)))) for each in growth]
    every = np.concatenate([points for _each, points in lines])
    (x_low, y_low), (x_high, y_high) = np.floor(every.min(axis=0)), np.ceil(every.max(axis=0))
    items: list[Item] = [
        Arrow(np.array([(x_low, y_low), (x_high + 0.3, y_low)]), "muted"),
        Arrow(np.array([(x_low, y_low), (x_low, y_high + 0.3)]), "muted"),
    ]
    unit = "p" if which == 0 else "n"
    items.append(Word(unit, x_high + 0.3, y_low, "muted", 1, 0))
    for power in range(int(x_low), int(x_high) + 1):
        items.append(Word(f"10^{power}", float(power), y_low, "muted", 0, -1))
    for power in range(int(y_low), int(y_high) + 1):
        items.append(Word(f"10^{{{power}}}", x_low, float(power), "muted", -1, 0))
    items.append(Word(_("s"), x_low, y_high + 0.3, "muted", 1, 0))
    for k, (_each, points) in enumerate(lines):
        ink = f"data{k % 6 + 1}"
        items.append(Stroke(points, ink, "medium", "solid" if k < 6 else "dash"))  # type: ignore[arg-type]
        items += [Spot(float(x), float(y), ink, "dot", "medium") for x, y in points]  # type: ignore[arg-type]
    # Names from top to bottom, as the lines end
    order = sorted(range(len(lines)), key=lambda k: -float(lines[k][1][-1, 1]))
    for place, k in enumerate(order):
        each, exponent = lines[k][0], lines[k][0].exponents[which]
        told = title_of(each.method)
        if exponent is not None:
            told += f": {unit}^{{{exponent:.2f}}}"
        y = y_high - (y_high - y_low) * place / max(len(order) - 1, 1)
        items.append(Word(told, x_high + 0.6, y, f"data{k % 6 + 1}", 1, 0))  # type: ignore[arg-type]
    right = x_high + (x_high - x_low) * 0.7 + 1.0
    return Drawing((x_low, y_low - 0.9, right, y_high + 0.4), items, _PLOT_PT)


def _points(growth: Growth, which: int) -> list[tuple[float, float]]:
    points = growth.by_polygons if which else growth.by_pixels
    return [(max(n, 1), max(seconds, 1e-7)) for n, seconds in points]
