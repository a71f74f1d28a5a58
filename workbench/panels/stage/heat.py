"""How often each pixel was touched, as colours from pale to full and as numbers."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Word
from workbench.panels.stage.picture import Pixels, packed
from workbench.widgets.look.tokens import Tokens


def heated(shown: Pixels, counts: NDArray[np.int64], now: Tokens) -> Pixels:
    """``shown`` with the tested pixels coloured by how often, from pale to full."""
    most = int(counts.max())
    if most == 0:
        return shown
    share = np.where(counts > 0, 0.2 + 0.8 * counts / most, 0.0)
    low, high = packed(now.canvas), packed(now.data[1])
    made = shown.copy()
    tested = counts > 0
    mixed = np.zeros(int(tested.sum()), np.uint32)
    for shift in (16, 8, 0):
        a, b = (low >> shift) & 0xFF, (high >> shift) & 0xFF
        mixed |= (a + share[tested] * (b - a)).astype(np.uint32) << np.uint32(shift)
    made[tested] = mixed
    return made


def heat_words(counts: NDArray[np.int64]) -> tuple[Word, ...]:
    """The numbers in the cells; none where there are too many to be read."""
    ys, xs = np.nonzero(counts)
    if len(xs) > MOST_SPOTS:
        return ()
    return tuple(Word(str(counts[y, x]), float(x), float(y), "text") for y, x in zip(ys, xs, strict=True))
