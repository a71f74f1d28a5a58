"""The plainest link that does what a matrix does, so that a chain reads as a person would have built it."""

import math

import numpy as np

from workbench.algorithms.transforms import Matrix
from workbench.document.transforms.links import Affine, AnyLink, Reflect, Rotate, Scale, Shear, Translate

_CLOSE = 1e-9
_DECIMALS = 9
_IDENTITY = np.eye(2)


def link_of(matrix: Matrix) -> AnyLink:
    """The link without an id that has an affine ``matrix`` (3, 3), world: a translation, rotation,
    reflection, scaling or shear where it is one, else its six numbers.
    """
    for link in _candidates(matrix):
        if np.allclose(link.matrix, matrix, rtol=_CLOSE, atol=_CLOSE):
            return link
    return Affine.of("", matrix)


def _candidates(matrix: Matrix) -> list[AnyLink]:
    (a, b), (c, d) = matrix[:2, :2].tolist()
    tx, ty = matrix[:2, 2].tolist()
    if a == d == 1.0 and b == c == 0.0:
        return [Translate("", tx=tx, ty=ty)]
    # What stays where it is, as far as anything does: the pivot.
    x, y = (_tidy(part) for part in _fixed_point(matrix))
    degrees = _tidy(math.degrees(math.atan2(c, a)))
    return [
        Rotate("", angle=degrees, x_pivot=x, y_pivot=y),
        Reflect("", angle=degrees / 2, x_pivot=x, y_pivot=y),
        Scale("", sx=a, sy=d, x_pivot=x, y_pivot=y),
        Shear("", sh_x=b, y_ref=y),
        Shear("", sh_y=c, x_ref=x),
    ]


def _fixed_point(matrix: Matrix) -> tuple[float, float]:
    x, y = np.linalg.lstsq(_IDENTITY - matrix[:2, :2], matrix[:2, 2], rcond=1e-12)[0].tolist()
    return x, y


def _tidy(value: float) -> float:
    """Without what rounding has left in it, so that one turn after another is about the same pivot."""
    return round(value, _DECIMALS) + 0.0
