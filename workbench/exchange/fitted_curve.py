"""A curve for a sheet that is fitted to points."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves import fit_pieces
from workbench.document.model import Curve, Sheet
from workbench.document.storage.content import Progress, silent
from workbench.exchange.svg_figures import MOST_PIECES, path_of
from workbench.rendering.mapping import device_map

Array = NDArray[np.float64]


def fitted(
    sheet: Sheet, points: Array, tolerance_px: float, colour: int, progress: Progress = silent
) -> tuple[Curve, float]:
    """The Bézier path that passes device ``points`` (n, 2) within ``tolerance_px``, and its error, pixels.

    Raises: ValueError where the points are in one place, or take more pieces than a curve has.
    """
    pieces, error = fit_pieces(points, tolerance_px, most_pieces=MOST_PIECES, progress=progress)
    closed = bool((points[0] == points[-1]).all())
    return path_of(np.round(device_map(sheet).world(pieces.controls), 6), closed, colour), error
