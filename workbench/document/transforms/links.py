"""The links of a chain of transforms, each with an id, a switch and numbers of its own.

Angles are degrees, as they are typed, shown and saved, so that a quarter turn is exactly one; whatever is
computed takes radians.
"""

import math
from functools import cached_property
from operator import attrgetter
from typing import Annotated, Any, ClassVar, NamedTuple

import msgspec
import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix
from workbench.document.fields import Choice
from workbench.document.numbers import coordinate, factor, matrix_entry
from workbench.language import _

MIRRORS = ("line", "point")


_PER_DEGREE = math.pi / 180
_ANGLE = coordinate(_("angle"), "θ", "°")


class Elementary(NamedTuple):
    """One elementary transformation: the name of a function of ``algorithms.transforms``, angles in radians,
    and its matrix (3, 3)."""

    name: str
    arguments: tuple[float, ...]
    matrix: Matrix


def _elementary(name: str, *arguments: float) -> Elementary:
    return Elementary(name, arguments, getattr(transforms, name)(*arguments))


class Link(
    msgspec.Struct,
    frozen=True,
    forbid_unknown_fields=True,
    omit_defaults=True,
    tag_field="kind",
    cache_hash=True,
    dict=True,  # where the matrix is kept
):
    """What all links share; one that is not ``on`` does nothing. Its id begins with ``letter`` by habit."""

    letter: ClassVar[str] = "t"

    id: str
    on: bool = True

    @cached_property
    def matrix(self) -> Matrix:
        """(3, 3), homogeneous, for points as columns, world; read-only, and the same when switched off."""
        matrix = self._matrix()
        matrix.setflags(write=False)
        return matrix

    def _matrix(self) -> Matrix:
        raise NotImplementedError

    def unfolded(self) -> tuple[Elementary, ...]:
        """The elementary transformations of which it is made, in the order in which they act."""
        raise NotImplementedError


class PlaneLink(Link, frozen=True):
    """A link whose matrix comes of the ``numbers`` with these names."""

    numbers: ClassVar[tuple[str, ...]]

    def _matrix(self) -> Matrix:
        return self.matrices(*attrgetter(*self.numbers)(self))

    def matrices(self, *numbers: Any) -> Matrix:
        """What a link like this one does that has these numbers (3, 3), or (n, 3, 3) of arrays (n,)."""
        raise NotImplementedError


class Translate(PlaneLink, frozen=True, tag="translate", kw_only=True):
    """Moves by (tx, ty)."""

    numbers = "tx", "ty"

    tx: Annotated[float, coordinate(_("translation in x"), "t_x")] = 0.0
    ty: Annotated[float, coordinate(_("translation in y"), "t_y")] = 0.0

    def matrices(self, *numbers: Any) -> Matrix:
        """By (tx, ty)."""
        return transforms.translation(*numbers)

    def unfolded(self) -> tuple[Elementary, ...]:
        """Itself."""
        return (_elementary("translation", self.tx, self.ty),)


class AboutPivot(PlaneLink, frozen=True, kw_only=True):
    """A link that keeps its pivot where it is."""

    x_pivot: Annotated[float, coordinate(_("x of the pivot"), "x_p")] = 0.0
    y_pivot: Annotated[float, coordinate(_("y of the pivot"), "y_p")] = 0.0

    def unfolded(self) -> tuple[Elementary, ...]:
        """The pivot to the origin, the link about the origin, and back; itself where the pivot is there."""
        return _about(self.x_pivot, self.y_pivot, self._at_origin())

    def _at_origin(self) -> Elementary:
        raise NotImplementedError


def _about(x: float, y: float, at_origin: Elementary) -> tuple[Elementary, ...]:
    if x == 0.0 and y == 0.0:
        return (at_origin,)
    return _elementary("translation", -x, -y), at_origin, _elementary("translation", x, y)


class Rotate(AboutPivot, frozen=True, tag="rotate", kw_only=True):
    """Turns by ``angle``, degrees, counter-clockwise, about the pivot."""

    numbers = "angle", "x_pivot", "y_pivot"

    angle: Annotated[float, _ANGLE] = 0.0

    def matrices(self, *numbers: Any) -> Matrix:
        """By an angle about (x, y)."""
        angle, x, y = numbers
        return transforms.rotation_about(angle * _PER_DEGREE, x, y)

    def _at_origin(self) -> Elementary:
        return _elementary("rotation", math.radians(self.angle))


class Scale(AboutPivot, frozen=True, tag="scale", kw_only=True):
    """Makes sx times as wide and sy times as high, from the pivot."""

    numbers = "sx", "sy", "x_pivot", "y_pivot"

    sx: Annotated[float, factor(_("scale factor in x"), "s_x")] = 1.0
    sy: Annotated[float, factor(_("scale factor in y"), "s_y")] = 1.0

    def matrices(self, *numbers: Any) -> Matrix:
        """By (sx, sy) about (x, y)."""
        return transforms.scaling_about(*numbers)

    def _at_origin(self) -> Elementary:
        return _elementary("scaling", self.sx, self.sy)


class Reflect(AboutPivot, frozen=True, tag="reflect", kw_only=True):
    """Reflects in the line through the pivot that makes ``angle``, degrees, with the x axis, or in the pivot.

    The line is the x axis by default, and the y axis at 90 degrees.
    """

    numbers = "x_pivot", "y_pivot", "angle"

    mirror: Annotated[str, Choice(MIRRORS)] = MIRRORS[0]
    angle: Annotated[float, _ANGLE] = 0.0

    def matrices(self, *numbers: Any) -> Matrix:
        """In the line through (x, y) at an angle, or in (x, y)."""
        x, y, angle = numbers
        if self.mirror == "point":
            return transforms.scaling_about(-1.0, -1.0, x, y)
        return transforms.reflection(x, y, angle * _PER_DEGREE)

    def _at_origin(self) -> Elementary:
        if self.mirror == "point":
            return _elementary("scaling", -1.0, -1.0)
        return _elementary("reflection", 0.0, 0.0, math.radians(self.angle))


class Shear(PlaneLink, frozen=True, tag="shear", kw_only=True):
    """x' = x + sh_x (y - y_ref), y' = y + sh_y (x - x_ref), with the base lines x = x_ref and y = y_ref."""

    numbers = "sh_x", "sh_y", "x_ref", "y_ref"

    sh_x: Annotated[float, factor(_("shear in x"), "sh_x")] = 0.0
    sh_y: Annotated[float, factor(_("shear in y"), "sh_y")] = 0.0
    x_ref: Annotated[float, coordinate(_("x of the base line"), "x_ref")] = 0.0
    y_ref: Annotated[float, coordinate(_("y of the base line"), "y_ref")] = 0.0

    def matrices(self, *numbers: Any) -> Matrix:
        """By (sh_x, sh_y), with the base lines at (x_ref, y_ref)."""
        return transforms.shear(*numbers)

    def unfolded(self) -> tuple[Elementary, ...]:
        """The base lines to the axes, the shear, and back; itself where they are the axes."""
        return _about(self.x_ref, self.y_ref, _elementary("shear", self.sh_x, self.sh_y))


class Affine(PlaneLink, frozen=True, tag="matrix", kw_only=True):
    """x' = m11 x + m12 y + m13, y' = m21 x + m22 y + m23; the last row of its matrix is 0 0 1."""

    numbers = "m11", "m12", "m13", "m21", "m22", "m23"

    m11: Annotated[float, matrix_entry(1, 1)] = 1.0
    m12: Annotated[float, matrix_entry(1, 2)] = 0.0
    m13: Annotated[float, matrix_entry(1, 3)] = 0.0
    m21: Annotated[float, matrix_entry(2, 1)] = 0.0
    m22: Annotated[float, matrix_entry(2, 2)] = 1.0
    m23: Annotated[float, matrix_entry(2, 3)] = 0.0

    @classmethod
    def of(cls, identity: str, matrix: Matrix) -> "Affine":
        """That of a matrix (3, 3) whose last row is 0 0 1."""
        (m11, m12, m13), (m21, m22, m23) = matrix[:2].tolist()
        return cls(identity, m11=m11, m12=m12, m13=m13, m21=m21, m22=m22, m23=m23)

    @property
    def entries(self) -> tuple[float, ...]:
        """The first row, and then the second."""
        return self.m11, self.m12, self.m13, self.m21, self.m22, self.m23

    def matrices(self, *numbers: Any) -> Matrix:
        """With these entries, row by row."""
        matrices = np.zeros((*np.shape(numbers[0]), 3, 3))
        for place, entry in enumerate(numbers):
            matrices[..., place // 3, place % 3] = entry
        matrices[..., 2, 2] = 1.0
        return matrices

    def unfolded(self) -> tuple[Elementary, ...]:
        """Itself."""
        return (Elementary("matrix", self.entries, self.matrix),)


AnyLink = Translate | Rotate | Scale | Reflect | Shear | Affine
