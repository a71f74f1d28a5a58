"""Surfaces of revolution, exact as rational B-splines: a profile carried round the y axis on a circle.

Source: Piegl and Tiller, The NURBS Book, section 8.5.
"""

import numpy as np

from workbench.algorithms.surfaces.patches import Patches, b_spline_patch
from workbench.geometry.curves.rational import Nurbs, circle


def revolved(profile: Nurbs) -> Patches:
    """The surface of a profile (n, 2), points (r, y) with r >= 0 its distance from the axis.

    u goes round, counter-clockwise seen from above, from 0 to 4; v along the profile. Normals point outwards
    where the profile goes upwards. Raises: ValueError for a negative r, or a profile that is no curve.
    """
    r, y = np.asarray(profile.points, float).T
    if (r < 0).any():
        raise ValueError("A point of the profile has a distance below 0 from the axis; make it 0 or more.")
    round_it = circle(0.0, 0.0, 1.0)
    across, away = round_it.points.T
    net = np.stack(
        [across[:, None] * r, np.broadcast_to(y, (len(across), len(y))), -away[:, None] * r], axis=-1
    )
    weights = round_it.weights[:, None] * np.asarray(profile.weights, float)
    return b_spline_patch(net, round_it.knots, profile.knots, (round_it.degree, profile.degree), weights)
