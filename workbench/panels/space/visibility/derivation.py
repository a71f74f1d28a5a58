"""The depth buffer at a step as a page: the device picture, the depths along its row, and the arithmetic."""

import re

import numpy as np

from workbench.algorithms.marks import Region, Spot, Stroke, Word, closed
from workbench.exchange.diagrams import Arrow, Axes, Block, Derivation, Drawing, Heading, Item, Sentence
from workbench.exchange.formulas.terms import displayed
from workbench.language import _
from workbench.panels.space.visibility.cost_view import gains_and_costs
from workbench.panels.space.visibility.depth_run import DepthRun
from workbench.rendering.scene.depth_measures import DepthMeasures
from workbench.rendering.scene.fragments import NOTHING
from workbench.widgets.formulas.paper import paper_inks

_PICTURE_PT, _ROW_PT = 250.0, 130.0
_HIGH = 0.28
_MOST_NAMED = 6
_TAGS = re.compile(r"<[^>]+>")


def derivation(run: DepthRun, measures: DepthMeasures | None) -> Derivation:
    """The page of a run as far as it is stepped, with what was measured of it, if anything was."""
    title = _("Depth buffer")
    blocks: list[Block] = [
        Heading(_("{title}, step {n} of {all}").format(title=title, n=run.reached, all=len(run.fragments))),
        _picture(run),
        Sentence(
            _("1. The depth buffer starts with $z_max$ = {z}, the frame buffer with the background.").format(
                z=displayed(run.farthest)
            )
        ),
        Sentence(_("2. For each polygon, for each pixel $(x, y)$ that it covers: find its depth $z$ there.")),
        Sentence(
            _("3. If $z <$ depth$[y, x]$, depth$[y, x] = z$ and frame$[y, x]$ = its colour; else nothing.")
        ),
    ]
    if run.now is not None:
        blocks += _now(run, run.now)
    for part, rows in () if measures is None else gains_and_costs(run, measures):
        blocks.append(Heading(part))
        blocks += [Sentence(f"{head}. {_plain(text)}") for head, text in rows]
    return Derivation(title, blocks, paper_inks())


def _ink(run: DepthRun, triangle: int) -> str:
    return f"data{int(run.device.objects[triangle]) % 6 + 1}"


def _picture(run: DepthRun) -> Drawing:
    """The polygons on the device, the pixels that each has won so far, the current row and pixel."""
    width, height = run.size
    items: list[Item] = [Axes("x", "y")]
    seen = run.so_far.seen(run.size)
    for triangle in np.unique(seen[seen != NOTHING]).tolist():
        items += [
            _cells(seen == triangle, _ink(run, triangle), row)
            for row in range(height)
            if (seen[row] == triangle).any()
        ]
    named: set[int] = set()
    for number, corners in enumerate(run.device.corners[run.device.triangles]):
        ring = corners[:, :2].copy()
        items.append(Stroke(closed(ring), _ink(run, number), "thin"))  # type: ignore[arg-type]
        thing = int(run.device.objects[number])
        if thing not in named and len(named) < _MOST_NAMED:
            named.add(thing)
            x, y = ring[ring[:, 1].argmax()].tolist()
            items.append(Word(run.object_name(number), x, y, "text", 0, 1))
    if run.now is not None:
        x, y = int(run.fragments.x[run.now]), int(run.fragments.y[run.now])
        frame = np.array([(-0.5, y - 0.5), (width - 0.5, y - 0.5), (width - 0.5, y + 0.5), (-0.5, y + 0.5)])
        items += [
            Stroke(closed(frame), "text", "hair"),
            Spot(float(x), float(y), "text", "ring", "large"),
            Word(f"({x}, {y})", float(x), float(y), "text", 1, 1),
        ]
    return Drawing((-0.5, -0.5, width - 0.5, height - 0.5), items, _PICTURE_PT)


def _cells(own: np.ndarray, ink: str, row: int) -> Region:
    """The pixels of a row that are ``own``, as one region of runs."""
    columns = np.flatnonzero(own[row])
    breaks = np.flatnonzero(np.diff(columns) > 1)
    ends = [*columns[breaks].tolist(), int(columns[-1])]
    starts = [int(columns[0]), *columns[breaks + 1].tolist()]
    low, high = row - 0.5, row + 0.5
    ring: list[tuple[float, float]] = []
    for start, end in zip(starts, ends, strict=True):
        ring += [(start - 0.5, low), (start - 0.5, high), (end + 0.5, high), (end + 0.5, low)]
    return Region(np.array(ring), ink)  # type: ignore[arg-type]


def _now(run: DepthRun, number: int) -> list[Block]:
    """The current fragment: its plane, its depth against the stored one, and the row that it is in."""
    fragments = run.fragments
    x, y, surface = (int(column[number]) for column in (fragments.x, fragments.y, fragments.surface))
    A, B, C, D = run.plane_of(surface)
    z, stored = float(fragments.z[number]), float(fragments.stored[number])
    sign, word = ("<", _("it wins")) if fragments.won[number] else ("≥", _("it loses"))
    return [
        Heading(_("Row {y}, pixel ({x}, {y})").format(x=x, y=y)),
        _row(run, number),
        Sentence(
            _(
                "{name}: $A x + B y + C z + D = 0$ with $A = {A}$, $B = {B}$, $C = {C}$, $D = {D}$, "
                "of the device (pixels, pixels, z)."
            ).format(
                name=run.name_of(surface), A=displayed(A), B=displayed(B), C=displayed(C), D=displayed(D)
            )
        ),
        Sentence(
            _(
                "$z = -(A x + B y + D) / C = {z}$; one pixel further along the row it changes by "
                "$-A/C = {step}$."
            ).format(z=displayed(z), step=displayed(-A / C))
        ),
        Sentence(
            _("${z} {sign} {stored}$, the depth stored there: {word}.").format(
                z=displayed(z), sign=sign, stored=displayed(stored), word=word
            )
        ),
    ]


def _row(run: DepthRun, number: int) -> Drawing:
    """Depth over x along the current row: what is stored, and the surface that is drawn now."""
    fragments = run.fragments
    y, surface = int(fragments.y[number]), int(fragments.surface[number])
    own = np.flatnonzero((fragments.surface == surface) & (fragments.y == y))
    before = fragments.upto(int(own[0]))
    stored = before.depths(run.size, run.farthest)[y]
    written = before.writes(run.size)[y] > 0
    depths = np.concatenate([fragments.z[own], stored[written]])
    low, high = float(depths.min()), float(depths.max())
    width = run.size[0]
    scale = _HIGH * width / max(high - low, 1e-12)

    def up(z: float) -> float:
        return (z - low) * scale

    top = _HIGH * width
    items: list[Item] = [
        Arrow(np.array([(-0.5, -1.0), (width - 0.5, -1.0)]), "muted"),
        Arrow(np.array([(-0.5, -1.0), (-0.5, top + 1.5)]), "muted"),
        Word("x", width - 0.5, -1.0, "muted", -1, -1),
        Word(_("z, far"), -0.5, top + 1.5, "muted", 1, 0),
        Word(displayed(high), -0.5, top, "muted", -1, 0),
        Word(displayed(low), -0.5, 0.0, "muted", -1, 0),
    ]
    items += [
        Spot(float(x), up(float(stored[x])), "text", "dot", "small") for x in np.flatnonzero(written).tolist()
    ]
    if written.any():
        last = int(np.flatnonzero(written)[-1])
        items.append(Word(_("stored"), float(last), up(float(stored[last])), "text", 1, 0))
    for k in own.tolist():
        shape = "square" if fragments.won[k] else "ring"
        if k <= number or not run.hidden:
            ink = _ink(run, surface) if k <= number else "muted"
            items.append(Spot(float(fragments.x[k]), up(float(fragments.z[k])), ink, shape, "medium"))  # type: ignore[arg-type]
    x = float(fragments.x[number])
    items.append(Stroke(np.array([(x, -1.0), (x, top + 1.0)]), "text", "hair", "dot"))
    return Drawing((-0.5, -1.0, width - 0.5, top + 1.5), items, _ROW_PT)


def _plain(text: str) -> str:
    """A sentence of rich text as it is written in one line."""
    return _TAGS.sub("", text.replace("<sup>", "^"))
