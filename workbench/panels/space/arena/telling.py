"""What is told of methods on one scene: pictures with the wrong pixels marked, sentences, a table."""

from collections.abc import Iterable, Mapping

import numpy as np

from workbench.algorithms import catalogue
from workbench.document.scene.model import Scene
from workbench.exchange.tables import Table
from workbench.language import _, ngettext
from workbench.panels.space.arena.tile import MethodTile, Pixels
from workbench.panels.space.visibility.picture import paint_surfaces
from workbench.panels.stage.picture import data_colours, packed
from workbench.rendering.scene.arena import TRUTH, MethodRun
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.scene.spaces import NOT_YET, fails_where, title_of
from workbench.rendering.subjects.visibility import visible_objects
from workbench.widgets.look.tokens import tokens

_VALUES = 5


def picture_of(run: MethodRun, device: DeviceTriangles, marked: bool) -> Pixels:
    """(h, w), 0xRRGGBB: the surfaces in their colours; if ``marked``, wrong pixels are checked."""
    now = tokens()
    themed = data_colours(now)
    colours = np.array([themed.get(each, each) for each in device.colours.tolist()], np.uint32)
    paper = np.full(run.seen.shape, packed(now.canvas), np.uint32)
    paint_surfaces(paper, run.seen, colours, 1.0)
    if marked:
        rows, columns = np.nonzero(run.different)
        checks = np.where((rows + columns) % 2, packed(now.error), packed(now.canvas))
        paper[rows, columns] = checks.astype(np.uint32)
    return paper


def sentence_of(run: MethodRun) -> str:
    """Whether a method is right, and if not, why not."""
    title, wrong = title_of(run.method), int(run.different.sum())
    if run.method == TRUTH:
        said = _("{title} compares all surfaces at each pixel: the others are checked against it.")
        return said.format(title=title)
    if not wrong:
        return _("{title} shows at every pixel what ray casting shows.").format(title=title)
    return ngettext(
        "{title} shows another surface at {n:,} pixel: where {reason}.",
        "{title} shows another surface at {n:,} pixels: where {reason}.",
        wrong,
    ).format(title=title, n=wrong, reason=fails_where(run.method))


def describe(runs: Mapping[str, MethodRun], scene: Scene, device: DeviceTriangles, x: int, y: int) -> str:
    """What ray casting shows at a pixel, and who shows something else."""
    truth = runs.get(TRUTH)
    if truth is None:
        return f"({x}, {y})"

    def name(run: MethodRun) -> str:
        triangle = int(run.seen[y, x])
        if triangle < 0:
            return _("nothing")
        thing = visible_objects(scene)[int(device.objects[triangle])]
        return _("{name}, triangle {n}").format(name=thing.name or thing.id, n=triangle)

    said = [_("({x}, {y}) {surface} by ray casting").format(x=x, y=y, surface=name(truth))]
    said += [
        _("{title}: {surface}").format(title=title_of(run.method), surface=name(run))
        for run in runs.values()
        if run.different[y, x]
    ]
    return "; ".join(said)


def table_of(tiles: Iterable[MethodTile]) -> Table:
    """A row for each method."""
    columns = _("method"), _("space"), _("tests"), _("time"), _("divides"), _("keeps"), _("differs")
    rows = [
        (
            title_of(tile.method),
            _(catalogue.get(tile.method).works_in),
            *(tile.values() or (NOT_YET,) * _VALUES),
        )
        for tile in tiles
    ]
    return Table(columns, rows, formulas=False)
