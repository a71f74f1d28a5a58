"""Curves: Bézier, B-splines and NURBS, and splines that pass through their points."""

from workbench.algorithms.curves.basis_functions import (
    b_spline_point,
    basis_functions,
    basis_table,
    knot_spans,
    nurbs_point,
)
from workbench.algorithms.curves.de_boor import de_boor
from workbench.algorithms.curves.de_casteljau import de_casteljau

__all__ = [
    "b_spline_point",
    "basis_functions",
    "basis_table",
    "de_boor",
    "de_casteljau",
    "knot_spans",
    "nurbs_point",
]
