"""Transformations of the plane and of space: matrices, and the texts that multiply by them."""

from workbench.algorithms.transforms.axis import axis_steps, rotation_about_axis, rotation_by_quaternion
from workbench.algorithms.transforms.chain import (
    Matrix,
    inverse,
    inverse_of_chain,
    is_affine,
    product,
    transform_points,
)
from workbench.algorithms.transforms.decomposition import Loss, Parts, decomposed, recomposed
from workbench.algorithms.transforms.matrix_product import matrix_product
from workbench.algorithms.transforms.plane import (
    reflection,
    rotation,
    rotation_about,
    scaling,
    scaling_about,
    shear,
    translation,
)
from workbench.algorithms.transforms.rotate_about_axis import rotate_about_axis
from workbench.algorithms.transforms.space import (
    reflection_3d,
    rotation_x,
    rotation_y,
    rotation_z,
    scaling_3d,
    scaling_about_3d,
    shear_3d,
    translation_3d,
)
from workbench.algorithms.transforms.transform_point import transform_point

__all__ = [
    "Loss",
    "Matrix",
    "Parts",
    "axis_steps",
    "decomposed",
    "inverse",
    "inverse_of_chain",
    "is_affine",
    "matrix_product",
    "product",
    "recomposed",
    "reflection",
    "reflection_3d",
    "rotate_about_axis",
    "rotation",
    "rotation_about",
    "rotation_about_axis",
    "rotation_by_quaternion",
    "rotation_x",
    "rotation_y",
    "rotation_z",
    "scaling",
    "scaling_3d",
    "scaling_about",
    "scaling_about_3d",
    "shear",
    "shear_3d",
    "transform_point",
    "transform_points",
    "translation",
    "translation_3d",
]
