"""Cardinal splines: each tangent is parallel to the chord between the two neighbours.

Source: Hearn and Baker, Computer Graphics, C Version, section 10-7.
"""

import numpy as np
from numpy.typing import ArrayLike

from workbench.geometry.curves.hermite import hermite_pieces, parameters
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.sections import Ends, with_neighbours


def cardinal(points: ArrayLike, tension: float = 0.0, ends: Ends = "inner") -> Pieces:
    """The cardinal spline with tangents (1 - tension) / 2 (P_{k+1} - P_{k-1}).

    Args: points (n, k); tension, 1 for straight lines, below 0 for wider bows; ``ends`` (see ``sections``):
    as the course writes it, the curve goes from P_1 to P_{n-1}. Returns: one piece for each section, from 0
    to 1, 1 to 2 and so on. Raises: ValueError for too few points.
    """
    if not np.isfinite(tension):
        raise ValueError(f"The tension is {tension}; it must be a finite number.")
    around = with_neighbours(points, ends)
    tangents = 0.5 * (1.0 - tension) * (around[2:] - around[:-2])
    through = around[1:-1]
    return hermite_pieces(through, tangents[:-1], tangents[1:], parameters(len(through), None))
