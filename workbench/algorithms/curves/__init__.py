"""Curves: Bézier, B-splines and NURBS, and splines that pass through their points."""

from workbench.algorithms.curves.b_spline_curve import b_spline_curve
from workbench.algorithms.curves.b_spline_sum import b_spline_sum
from workbench.algorithms.curves.bernstein_curve import bernstein_curve
from workbench.algorithms.curves.closest_point import closest_point
from workbench.algorithms.curves.de_boor import de_boor
from workbench.algorithms.curves.de_boor_rational import de_boor_rational
from workbench.algorithms.curves.de_casteljau import de_casteljau
from workbench.algorithms.curves.flatten_bezier import flatten_bezier
from workbench.algorithms.curves.hermite_blend import hermite_blend
from workbench.algorithms.curves.natural_cubic_system import natural_cubic_system
from workbench.geometry.curves.arc_length import arc_length
from workbench.geometry.curves.at_length import at_length, equal_lengths
from workbench.geometry.curves.basis_functions import (
    b_spline_point,
    basis_functions,
    basis_table,
    knot_spans,
    nurbs_point,
)
from workbench.geometry.curves.bernstein import (
    bernstein,
    bezier_point,
    elevate_degree,
    subdivide,
)
from workbench.geometry.curves.blossom import b_spline_to_bezier, elevate_b_spline
from workbench.geometry.curves.cardinal import cardinal
from workbench.geometry.curves.catmull_rom import catmull_rom
from workbench.geometry.curves.continuity import Continuity, continuity, joints
from workbench.geometry.curves.convex_hull import convex_hull
from workbench.geometry.curves.cubic_pieces import to_cubic_pieces
from workbench.geometry.curves.cubic_spline import clamped_cubic, natural_cubic, periodic_cubic
from workbench.geometry.curves.curvature import curvature, curvature_comb, osculating_circle
from workbench.geometry.curves.degree_lowering import lower_b_spline, lower_degree
from workbench.geometry.curves.derivatives import derivatives, piece_derivative
from workbench.geometry.curves.distances import closest_place, distances
from workbench.geometry.curves.extrema import bounding_box, extrema
from workbench.geometry.curves.fitting import fit_pieces
from workbench.geometry.curves.hermite import hermite
from workbench.geometry.curves.inflections import inflections
from workbench.geometry.curves.knot_insertion import insert_knot, split_b_spline
from workbench.geometry.curves.knot_removal import Removal, remove_knot
from workbench.geometry.curves.knots import (
    Counting,
    closed_b_spline,
    counting,
    multiplicity,
    open_uniform_knots,
    uniform_knots,
)
from workbench.geometry.curves.kochanek_bartels import kochanek_bartels
from workbench.geometry.curves.pieces import Pieces, in_rows, located, piece_points
from workbench.geometry.curves.polyline import chord_counts, polyline, polylines
from workbench.geometry.curves.rational import Nurbs, circle, gap_between, homogeneous, projected
from workbench.geometry.curves.rational_polyline import nurbs_to_polyline
from workbench.geometry.curves.self_intersections import self_intersections, self_meetings, self_overlaps
from workbench.geometry.curves.waviness import Overshoot, Wiggle, overshoot, wiggle

__all__ = [
    "Continuity",
    "Counting",
    "Nurbs",
    "Overshoot",
    "Pieces",
    "Removal",
    "Wiggle",
    "arc_length",
    "at_length",
    "b_spline_curve",
    "b_spline_point",
    "b_spline_sum",
    "b_spline_to_bezier",
    "basis_functions",
    "basis_table",
    "bernstein",
    "bernstein_curve",
    "bezier_point",
    "bounding_box",
    "cardinal",
    "catmull_rom",
    "chord_counts",
    "circle",
    "clamped_cubic",
    "closed_b_spline",
    "closest_place",
    "closest_point",
    "continuity",
    "convex_hull",
    "counting",
    "curvature",
    "curvature_comb",
    "de_boor",
    "de_boor_rational",
    "de_casteljau",
    "derivatives",
    "distances",
    "elevate_b_spline",
    "elevate_degree",
    "equal_lengths",
    "extrema",
    "fit_pieces",
    "flatten_bezier",
    "gap_between",
    "hermite",
    "hermite_blend",
    "homogeneous",
    "in_rows",
    "inflections",
    "insert_knot",
    "joints",
    "knot_spans",
    "kochanek_bartels",
    "located",
    "lower_b_spline",
    "lower_degree",
    "multiplicity",
    "natural_cubic",
    "natural_cubic_system",
    "nurbs_point",
    "nurbs_to_polyline",
    "open_uniform_knots",
    "osculating_circle",
    "overshoot",
    "periodic_cubic",
    "piece_derivative",
    "piece_points",
    "polyline",
    "polylines",
    "projected",
    "remove_knot",
    "self_intersections",
    "self_meetings",
    "self_overlaps",
    "split_b_spline",
    "subdivide",
    "to_cubic_pieces",
    "uniform_knots",
    "wiggle",
]
