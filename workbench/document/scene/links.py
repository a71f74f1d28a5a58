"""The links of a chain of transforms in space, named as those in the plane are; angles are degrees."""

import math
from functools import cached_property
from typing import Annotated

import msgspec
import numpy as np

from workbench.algorithms import transforms
from workbench.algorithms.transforms import Matrix
from workbench.document.fields import Number
from workbench.document.numbers import coordinate, factor, matrix_entry
from workbench.document.transforms.chains import matrix_of
from workbench.document.transforms.links import Elementary, Link
from workbench.language import _


def _component(label: str, symbol: str) -> Number:
    return coordinate(label, symbol, "")


class Link3D(Link, frozen=True):
    """What all links in space share; its matrix is (4, 4)."""

    def unfolded(self) -> tuple[Elementary, ...]:
        """Itself."""
        return (Elementary(type(self).__name__, (), self.matrix),)


class Translate3D(Link3D, frozen=True, tag="translate", kw_only=True):
    """Moves by (tx, ty, tz)."""

    tx: Annotated[float, coordinate(_("translation in x"), "t_x")] = 0.0
    ty: Annotated[float, coordinate(_("translation in y"), "t_y")] = 0.0
    tz: Annotated[float, coordinate(_("translation in z"), "t_z")] = 0.0

    def _matrix(self) -> Matrix:
        return transforms.translation_3d(self.tx, self.ty, self.tz)


class AboutPivot3D(Link3D, frozen=True, kw_only=True):
    """A link that keeps its pivot where it is."""

    x_pivot: Annotated[float, coordinate(_("x of the pivot"), "x_p")] = 0.0
    y_pivot: Annotated[float, coordinate(_("y of the pivot"), "y_p")] = 0.0
    z_pivot: Annotated[float, coordinate(_("z of the pivot"), "z_p")] = 0.0

    @property
    def pivot(self) -> tuple[float, float, float]:
        """Where it is, world."""
        return self.x_pivot, self.y_pivot, self.z_pivot


class Rotate3D(AboutPivot3D, frozen=True, tag="rotate", kw_only=True):
    """Turns by ``angle``, degrees, about the axis through the pivot along (x_axis, y_axis, z_axis).

    Counter-clockwise when one looks along the axis towards the pivot; the y axis by default.
    """

    angle: Annotated[float, coordinate(_("angle"), "θ", "°")] = 0.0
    x_axis: Annotated[float, _component(_("x of the axis"), "a_x")] = 0.0
    y_axis: Annotated[float, _component(_("y of the axis"), "a_y")] = 1.0
    z_axis: Annotated[float, _component(_("z of the axis"), "a_z")] = 0.0

    @property
    def second(self) -> tuple[float, float, float]:
        """The point of the axis after the pivot."""
        x, y, z = self.pivot
        return x + self.x_axis, y + self.y_axis, z + self.z_axis

    def _matrix(self) -> Matrix:
        return transforms.rotation_about_axis(math.radians(self.angle), self.pivot, self.second)

    def unfolded(self) -> tuple[Elementary, ...]:
        """The seven steps of the course."""
        steps = transforms.axis_steps(math.radians(self.angle), self.pivot, self.second)
        return tuple(Elementary(step.name, (), step.matrix) for step in steps)


class Scale3D(AboutPivot3D, frozen=True, tag="scale", kw_only=True):
    """Makes sx times as wide, sy times as high and sz times as deep, from the pivot."""

    sx: Annotated[float, factor(_("scale factor in x"), "s_x")] = 1.0
    sy: Annotated[float, factor(_("scale factor in y"), "s_y")] = 1.0
    sz: Annotated[float, factor(_("scale factor in z"), "s_z")] = 1.0

    def _matrix(self) -> Matrix:
        return transforms.scaling_about_3d(self.sx, self.sy, self.sz, *self.pivot)


class Reflect3D(AboutPivot3D, frozen=True, tag="reflect", kw_only=True):
    """Reflects in the plane through the pivot with the normal (x_normal, y_normal, z_normal), first x = 0."""

    x_normal: Annotated[float, _component(_("x of the normal"), "n_x")] = 1.0
    y_normal: Annotated[float, _component(_("y of the normal"), "n_y")] = 0.0
    z_normal: Annotated[float, _component(_("z of the normal"), "n_z")] = 0.0

    def _matrix(self) -> Matrix:
        return transforms.reflection_3d(*self.pivot, self.x_normal, self.y_normal, self.z_normal)


class Shear3D(Link3D, frozen=True, tag="shear", kw_only=True):
    """x' = x + sh_xy (y - y_ref) + sh_xz (z - z_ref), and y' and z' likewise."""

    sh_xy: Annotated[float, factor(_("shear in x by y"), "sh_xy")] = 0.0
    sh_xz: Annotated[float, factor(_("shear in x by z"), "sh_xz")] = 0.0
    sh_yx: Annotated[float, factor(_("shear in y by x"), "sh_yx")] = 0.0
    sh_yz: Annotated[float, factor(_("shear in y by z"), "sh_yz")] = 0.0
    sh_zx: Annotated[float, factor(_("shear in z by x"), "sh_zx")] = 0.0
    sh_zy: Annotated[float, factor(_("shear in z by y"), "sh_zy")] = 0.0
    x_ref: Annotated[float, coordinate(_("x of the base line"), "x_ref")] = 0.0
    y_ref: Annotated[float, coordinate(_("y of the base line"), "y_ref")] = 0.0
    z_ref: Annotated[float, coordinate(_("z of the base line"), "z_ref")] = 0.0

    def _matrix(self) -> Matrix:
        factors = (self.sh_xy, self.sh_xz, self.sh_yx, self.sh_yz, self.sh_zx, self.sh_zy)
        return transforms.shear_3d(*factors, self.x_ref, self.y_ref, self.z_ref)


class Affine3D(Link3D, frozen=True, tag="matrix", kw_only=True):
    """x' = m11 x + m12 y + m13 z + m14, and y' and z' likewise; the last row of its matrix is 0 0 0 1."""

    m11: Annotated[float, matrix_entry(1, 1)] = 1.0
    m12: Annotated[float, matrix_entry(1, 2)] = 0.0
    m13: Annotated[float, matrix_entry(1, 3)] = 0.0
    m14: Annotated[float, matrix_entry(1, 4)] = 0.0
    m21: Annotated[float, matrix_entry(2, 1)] = 0.0
    m22: Annotated[float, matrix_entry(2, 2)] = 1.0
    m23: Annotated[float, matrix_entry(2, 3)] = 0.0
    m24: Annotated[float, matrix_entry(2, 4)] = 0.0
    m31: Annotated[float, matrix_entry(3, 1)] = 0.0
    m32: Annotated[float, matrix_entry(3, 2)] = 0.0
    m33: Annotated[float, matrix_entry(3, 3)] = 1.0
    m34: Annotated[float, matrix_entry(3, 4)] = 0.0

    def _matrix(self) -> Matrix:
        rows = [[getattr(self, f"m{row}{column}") for column in range(1, 5)] for row in range(1, 4)]
        return np.array([*rows, [0.0, 0.0, 0.0, 1.0]])


AnyLink3D = Translate3D | Rotate3D | Scale3D | Reflect3D | Shear3D | Affine3D


class Transformed3D(msgspec.Struct, frozen=True, kw_only=True, dict=True):
    """What has a chain of transforms in space; its first link acts first on the points, in the world."""

    transforms: tuple[AnyLink3D, ...] = ()

    @cached_property
    def matrix(self) -> Matrix | None:
        """The matrix (4, 4) of its chain, world to world; None where nothing is transformed."""
        return matrix_of(self.transforms) if self.transforms else None
