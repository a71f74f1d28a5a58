"""Surfaces: Bézier and B-spline patches, rational ones too, and their triangles."""

from workbench.algorithms.surfaces.examples import EXAMPLES, cylinder, sphere, torus
from workbench.algorithms.surfaces.patches import Patches, b_spline_patch, bezier_patch
from workbench.algorithms.surfaces.revolution import revolved
from workbench.algorithms.surfaces.tessellation import tessellate

__all__ = [
    "EXAMPLES",
    "Patches",
    "b_spline_patch",
    "bezier_patch",
    "cylinder",
    "revolved",
    "sphere",
    "tessellate",
    "torus",
]
