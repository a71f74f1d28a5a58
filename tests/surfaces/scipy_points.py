"""Points of patches by SciPy's polynomials, one pair of parameters after the other."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import BPoly

from workbench.algorithms.surfaces import Patches


def patch_points(patches: Patches, u: ArrayLike, v: ArrayLike) -> NDArray[np.float64]:
    """The points (..., 3) at each u and v, which are broadcast together."""
    us, vs = np.broadcast_arrays(np.asarray(u, float), np.asarray(v, float))
    along_u = BPoly(patches.nets.transpose(2, 0, 1, 3, 4), patches.u_knots)
    whole = np.array(
        [BPoly(along_u(a).swapaxes(0, 1), patches.v_knots)(b) for a, b in zip(us.flat, vs.flat, strict=True)]
    )
    return (whole[:, :3] / whole[:, 3:]).reshape(*us.shape, 3)
