"""What is drawn of a curve that is made a chain of points: the chain so far, and where it goes on."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke
from workbench.algorithms.recorded import is_recorded


def chain_marks(
    _arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The points so far, from one to the next, the last one ringed."""
    if not len(emitted):
        return
    chain = np.asarray(emitted[:, :2], np.float64)
    yield Stroke(chain, "data2", "medium")
    if len(chain) <= MOST_SPOTS:
        for x, y in chain.tolist():
            yield Spot(x, y, "data2", "dot", "small")
    if not ended:
        x, y = chain[-1].tolist()
        yield Spot(x, y, "accent", "ring", "large")


def flattening_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The chain so far, and the control polygons of the pieces that wait, the one on top with its chord."""
    top = -1 if ended or not is_recorded(now.get("stack")) else now.get("top", -1)
    for piece in range(top):
        yield Stroke(now["stack"][piece].copy(), "muted", "hair", "dash")
    if top >= 0:
        piece_on_top = now["stack"][top].copy()
        yield Stroke(piece_on_top, "data4", "thin")
        yield Stroke(piece_on_top[[0, -1]], "data4", "thin", "dot")
    yield from chain_marks(arguments, now, emitted, ended)
