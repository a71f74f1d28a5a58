"""Transformations of the plane and of space, as matrices."""

from workbench.algorithms.transforms.chain import (
    Matrix,
    inverse,
    inverse_of_chain,
    is_affine,
    product,
    transform_points,
)
from workbench.algorithms.transforms.plane import (
    reflection,
    rotation,
    rotation_about,
    scaling,
    scaling_about,
    shear,
    translation,
)
from workbench.algorithms.transforms.space import (
    axis_steps,
    reflection_3d,
    rotation_about_axis,
    rotation_x,
    rotation_y,
    rotation_z,
    scaling_3d,
    scaling_about_3d,
    shear_3d,
    translation_3d,
)

__all__ = [
    "Matrix",
    "axis_steps",
    "inverse",
    "inverse_of_chain",
    "is_affine",
    "product",
    "reflection",
    "reflection_3d",
    "rotation",
    "rotation_about",
    "rotation_about_axis",
    "rotation_x",
    "rotation_y",
    "rotation_z",
    "scaling",
    "scaling_3d",
    "scaling_about",
    "scaling_about_3d",
    "shear",
    "shear_3d",
    "transform_points",
    "translation",
    "translation_3d",
]
