"""Where a curve crosses, touches or runs along itself, each told once: as marks, and in words."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.algorithms.marks import Word
from workbench.language import _, ngettext
from workbench.panels.curves.shape import Array
from workbench.rendering.curves import Same
from workbench.widgets.canvas.drawing import Drawn, Marker, PenStroke

MOST_PIECES = 300
MOST_CROSSINGS = 100
_ALONG = 33


class Crossings(NamedTuple):
    """``places`` (k, 2) at which a curve meets itself, and the stretches of u on which it runs along itself.

    ``more`` tells that there may be more of them.
    """

    places: Array
    stretches: list[tuple[float, float]]
    more: bool


def crossings_of(pieces: Pieces) -> Crossings | None:
    """The crossings of a curve, device coordinates; None of very many pieces, as each may cross each."""
    return _crossings(Same(pieces)) if len(pieces.controls) <= MOST_PIECES else None


@lru_cache(maxsize=4)
def _crossings(key: Same) -> Crossings:
    pieces = key.pieces
    size = float(np.ptp(pieces.controls.reshape(-1, 2), axis=0).max())
    tolerance = max(1e-9, 1e-7 * size)
    crossings, shared = curves.self_meetings(pieces, tolerance, MOST_CROSSINGS)
    places: list[Array] = []
    for _u, _v, at in crossings:  # where three branches meet three pairs of them do
        if all(np.abs(at - other).max() > 8.0 * tolerance for other in places):
            places.append(at)
    stretches = _joined(sorted({stretch.u for stretch in shared}))
    more = max(len(crossings), len(shared)) >= MOST_CROSSINGS
    return Crossings(np.reshape(places, (-1, 2)), stretches, more)


def _joined(stretches: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Stretches in the order of u, those that overlap or go on from each other in one."""
    whole: list[tuple[float, float]] = []
    for begin, end in stretches:
        if whole and begin <= whole[-1][1]:
            whole[-1] = whole[-1][0], max(end, whole[-1][1])
        else:
            whole.append((begin, end))
    return whole


def crossing_marks(pieces: Pieces) -> list[Drawn]:
    """A cross at each place, a dashed line along each stretch, and the word for these once."""
    crossings = crossings_of(pieces)
    if crossings is None:
        return []
    lines = [_line(pieces, *stretch) for stretch in crossings.stretches]
    drawn: list[Drawn] = [PenStroke(line, "data2", 3.0, "dash") for line in lines]
    if lines:
        longest = max(lines, key=lambda line: float(np.ptp(line, axis=0).max()))
        x, y = longest[_ALONG // 2].tolist()
        drawn.append(Word(_("runs along itself"), x, y, "text", 1, 1, carded=True))
    return [*drawn, *(Marker(x, y, "data2", "cross", 11) for x, y in crossings.places.tolist())]


def _line(pieces: Pieces, begin: float, end: float) -> Array:
    """The curve from one u to another as a line (n, 2)."""
    return curves.piece_points(pieces, np.linspace(begin, end, _ALONG))


def crossing_words(pieces: Pieces) -> str:
    """At how many places a curve meets itself, and from where to where it runs along itself."""
    crossings = crossings_of(pieces)
    if crossings is None:
        return _("not searched for above {most} pieces").format(most=MOST_PIECES)
    count, stretches = len(crossings.places), crossings.stretches
    if crossings.more:
        return _("{most} or more").format(most=MOST_CROSSINGS)
    said = [ngettext("{n} place", "{n} places", count).format(n=count)] if count or not stretches else []
    if len(stretches) == 1:
        begin, end = stretches[0]
        said.append(_("along itself from u = {begin:.4g} to {end:.4g}").format(begin=begin, end=end))
    elif stretches:
        said.append(_("along itself on {n} stretches").format(n=len(stretches)))
    return ", ".join(said)
