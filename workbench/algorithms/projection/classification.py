"""What kind of projection a 4 x 4 matrix is, read off its rows.

x, y and w of the picture are rows 1, 2 and 4: only they decide what falls on what. The one point that they
send to 0, 0, 0 is the centre of projection; when its w is 0 it is a direction, and projectors are parallel.

L1          length in the picture of a line one unit long, perpendicular to the view plane
f           foreshortenings: how long a unit along each world axis is in an orthographic picture
"""

import math
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.numerals import with_minus
from workbench.algorithms.projection.vanishing import Place, checked, vanishing_points

Matrix = NDArray[np.float64]
Vector = NDArray[np.float64]
Triple = tuple[float, float, float]

Name = Literal[
    "no picture",
    "parallel",
    "orthographic",
    "isometric",
    "dimetric",
    "trimetric",
    "cavalier",
    "cabinet",
    "oblique",
    "one-point perspective",
    "two-point perspective",
    "three-point perspective",
]

_CRUMB = 1e-12
_EQUAL = 1e-9
_IN_PICTURE = [0, 1, 3]
_PERSPECTIVES: tuple[Name, ...] = (
    "one-point perspective",
    "two-point perspective",
    "three-point perspective",
)
_AXES = "xyz"
_TIMES = ("no", "one", "two", "three")


class Classification(NamedTuple):
    """What ``classify`` finds.

    ``centre`` is a point of the world with w = 1, or with w = 0 the unit direction of the projectors, in
    which of its two senses is left open; None when there is no picture. ``mirrored`` and ``stretched`` (x and
    y of the view plane scaled unequally, or sheared) are false where no view tells.
    """

    name: Name
    centre: tuple[float, float, float, float] | None
    vanishing: tuple[Place | None, Place | None, Place | None]
    keeps_depth: bool
    foreshortenings: Triple | None
    mirrored: bool
    stretched: bool

    @property
    def words(self) -> str:
        """All of it in sentences."""
        return with_minus(" ".join(_sentences(self)))


def classify(matrix: ArrayLike, view: ArrayLike | None = None) -> Classification:
    """Tell what projection ``matrix`` is; with ``view`` also how the projectors meet the view plane.

    Args: (4, 4), homogeneous, from the world to the picture, for points as columns; the world's (4, 4) view,
    into coordinates whose z is perpendicular to the view plane. Raises: ValueError for other shapes, numbers
    that are not finite, or a view that cannot be undone.
    """
    m = checked(matrix)
    eye = None if view is None else checked(view)
    if eye is not None and abs(np.linalg.det(eye)) == 0.0:
        raise ValueError("The view cannot be undone: it takes space to a plane.")
    centre = _centre(m)
    if centre is None:
        return Classification("no picture", None, (None, None, None), False, None, False, False)
    vanishing = vanishing_points(m)
    keeps_depth = bool(abs(m[2] @ centre) > _CRUMB * np.linalg.norm(m[2]) * np.linalg.norm(centre))
    mirrored = eye is not None and _mirrored(m, eye)
    stretched = eye is not None and _stretched(m, eye)
    name: Name = "parallel"
    foreshortenings = None
    if centre[3] != 0.0:
        name = _PERSPECTIVES[sum(point is not None for point in vanishing) - 1]
    elif eye is not None and not stretched and not any(vanishing):
        name, foreshortenings = _parallel(centre[:3], eye)
    x, y, z, w = (float(value) for value in centre)
    return Classification(name, (x, y, z, w), vanishing, keeps_depth, foreshortenings, mirrored, stretched)


def _centre(m: Matrix) -> Vector | None:
    """The point that rows 1, 2 and 4 send to nothing, or None when they send more than that to nothing."""
    rows = m[_IN_PICTURE]
    # A unit of length in which near and far weigh alike
    far, near = np.linalg.norm(rows[:, 3]), np.linalg.norm(rows[:, :3])
    unit = far / near if far > 0.0 and near > 0.0 else 1.0
    rows = rows * np.array([unit, unit, unit, 1.0])
    lengths = np.linalg.norm(rows, axis=1)
    if lengths.min() == 0.0:
        return None
    rows = rows / lengths[:, None]
    null = np.array([(-1) ** k * np.linalg.det(np.delete(rows, k, axis=1)) for k in range(4)])
    if np.linalg.norm(null) <= _CRUMB:
        return None
    if abs(null[3]) > _CRUMB * np.linalg.norm(null[:3]):
        return np.asarray(np.append(null[:3] * unit / null[3], 1.0)) + 0.0
    return np.asarray(np.append(null[:3] / np.linalg.norm(null[:3]), 0.0)) + 0.0


def _parallel(projectors: Vector, view: Matrix) -> tuple[Name, Triple | None]:
    """The name of a parallel projection, and the foreshortenings of an orthographic one."""
    x, y, z = view[:3, :3] @ projectors
    aside = math.hypot(x, y)
    if abs(z) <= _CRUMB * aside:
        return "parallel", None
    L1 = aside / abs(z)
    if L1 > _EQUAL:
        for name, length in (("cavalier", 1.0), ("cabinet", 0.5)):
            if abs(L1 - length) <= _EQUAL:
                return name, None  # type: ignore[return-value]
        return "oblique", None
    f_x, f_y, f_z = (math.hypot(*np.delete(projectors, axis)) for axis in range(3))
    if min(f_x, f_y, f_z) <= _EQUAL:
        return "orthographic", (f_x, f_y, f_z)
    equal = sum(abs(a - b) <= _EQUAL for a, b in ((f_x, f_y), (f_y, f_z), (f_z, f_x)))
    names: tuple[Name, ...] = ("trimetric", "dimetric", "isometric", "isometric")
    return names[equal], (f_x, f_y, f_z)


def _mirrored(m: Matrix, view: Matrix) -> bool:
    """Whether what turns left in the world turns right in the picture, far along the line of sight."""
    plane = m @ np.linalg.inv(view)
    depth = 2 if abs(plane[3, 2]) > _CRUMB * np.abs(plane[3]).max() else 3
    turn = np.linalg.det(plane[np.ix_(_IN_PICTURE, [0, 1, depth])]) * plane[3, depth]
    return bool(turn * np.linalg.det(view[:3, :3]) > 0.0)


def _stretched(m: Matrix, view: Matrix) -> bool:
    """Whether a square of the view plane is no square in the picture."""
    (a, b), (c, d) = (m @ np.linalg.inv(view))[:2, :2]
    size = a * a + b * b + c * c + d * d
    return bool(max(abs(a * b + c * d), abs(a * a + c * c - b * b - d * d)) > _EQUAL * size)


def _sentences(found: Classification) -> list[str]:
    if found.centre is None:
        return ["No picture: rows 1, 2 and 4 depend on one another, so space falls on a line or a point."]
    place = "({:.4g}, {:.4g}, {:.4g})".format(*found.centre[:3])
    sentences = []
    if found.centre[3] == 0.0:
        sentences.append(f"Parallel projection: all projectors run along {place}.")
        sentences += _kind(found)
    else:
        sentences.append(f"Perspective projection: all projectors meet at {place}, the centre of projection.")
    points = [point for point in found.vanishing if point is not None]
    axes = [axis for axis, point in zip(_AXES, found.vanishing, strict=True) if point is not None]
    if points:
        where = ", ".join("({:.4g}, {:.4g})".format(*point) for point in points)
        noun = "vanishing point" if len(points) == 1 else "vanishing points"
        sentences.append(f"It has {_TIMES[len(points)]} principal {noun}, of {', '.join(axes)}, at {where}.")
    if found.stretched:
        sentences.append("The picture is stretched: x and y of the view plane are not scaled alike.")
    if found.mirrored:
        sentences.append("The picture is mirrored: left and right, or up and down, are exchanged.")
    sentences.append(
        "Row 3 keeps depth, so hidden surfaces can be found."
        if found.keeps_depth
        else "Row 3 flattens depth, so hidden surfaces cannot be found."
    )
    return sentences


def _kind(found: Classification) -> list[str]:
    """How parallel projectors meet the view plane."""
    match found.name:
        case "orthographic":
            return ["Orthographic: they are perpendicular to the view plane, and one axis is seen end on."]
        case "isometric" | "dimetric" | "trimetric":
            f = "{:.4g}, {:.4g} and {:.4g}".format(*(found.foreshortenings or ()))
            return [
                f"Axonometric and {found.name}: perpendicular to the view plane, x, y and z shortened to {f}."
            ]
        case "cavalier":
            return ["Oblique and cavalier: lines perpendicular to the view plane keep their length."]
        case "cabinet":
            return ["Oblique and cabinet: lines perpendicular to the view plane are half as long."]
        case "oblique":
            return ["Oblique: they meet the view plane at an angle."]
    return []
