"""How surfaces are lit, and how light or normals of corners are spread over them."""

from workbench.algorithms.shading.fast_phong import fast_phong
from workbench.algorithms.shading.flat_shading import flat_shading
from workbench.algorithms.shading.gouraud import gouraud
from workbench.algorithms.shading.illuminate import illuminate
from workbench.algorithms.shading.phong import phong

__all__ = ["fast_phong", "flat_shading", "gouraud", "illuminate", "phong"]
