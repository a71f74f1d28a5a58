"""How surfaces are lit, and how the light of corners is spread over them."""

from workbench.algorithms.shading.gouraud import gouraud
from workbench.algorithms.shading.illuminate import illuminate

__all__ = ["gouraud", "illuminate"]
