"""The runs of a curve's own texts: its construction at one u, its samples, its chain of chords; device."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import knot_spans
from workbench.document.curve_pieces import (
    b_spline_of,
    fault_of,
    parameter_at,
    pieces_of,
    place_of,
    weights_of,
)
from workbench.document.model import B_SPLINES, Curve, Sheet
from workbench.language import _
from workbench.rendering.curves import device_pieces
from workbench.rendering.mapping import Call, device_map

_OF_B_SPLINES = ("de_boor", "de_boor_rational", "b_spline_curve")
_SAMPLES_PER_SPAN = 8
_MOST_TOLD_APART = 64


def construction_of(curve: Curve) -> str:
    """Slug of the construction that belongs to a curve's kind."""
    if curve.spline == "nurbs":
        return "de_boor_rational"
    return "de_boor" if curve.spline in B_SPLINES else "de_casteljau"


def construction_fault(curve: Curve, slug: str) -> str:
    """The sentence that says why a text cannot be run on a curve; empty where it can."""
    if slug in _OF_B_SPLINES and curve.spline not in B_SPLINES:
        return _("This curve is no B-spline, so it has no knots; step de Casteljau's construction instead.")
    if curve.spline == "nurbs" and slug != "de_boor_rational" and np.ptp(weights_of(curve)) > 0:
        return _("This takes no weights, and those of the curve differ; step its own construction instead.")
    return fault_of(curve)


def curve_calls(sheet: Sheet, curve: Curve, slug: str, share: float) -> list[Call]:
    """The run of a curve's text ``slug`` (empty: the construction of its kind), in device coordinates.

    ``share``, 0 to 1, tells where in the range of u. Of a curve in several pieces de Casteljau's construction
    and the chain of chords are those of the piece there. None where ``construction_fault`` says why. Raises
    LookupError when the catalogue has no such algorithm.
    """
    entry = catalogue.get(slug or construction_of(curve))
    if construction_fault(curve, entry.slug):
        return []
    u = parameter_at(curve, share)
    if entry.slug in _OF_B_SPLINES:
        points, knots, weights = b_spline_of(curve)
        device = device_map(sheet).points(points)
        spans = len(points) - curve.degree
        if entry.slug == "de_boor_rational":
            pulls = weights if curve.spline == "nurbs" else np.ones(len(points))
            return [Call(entry, (device, pulls, knots, curve.degree, u))]
        last: float | int = u if entry.slug == "de_boor" else _SAMPLES_PER_SPAN * spans + 1
        return [Call(entry, (device, knots, curve.degree, last))]
    piece, v = place_of(pieces_of(curve).knots, u)
    controls: NDArray[np.float64] = np.ascontiguousarray(device_pieces(sheet, curve).controls[piece])
    return [Call(entry, (controls, v if entry.slug == "de_casteljau" else curve.tolerance_px))]


def construction_levels(sheet: Sheet, curve: Curve, share: float) -> list[NDArray[np.float64]]:
    """The points (k, 2) of each level of a curve's construction at a share of its parameter, device.

    The control points that matter come first, the point of the curve is the last one alone; what lies between
    is what the text emits. None where there is no curve, or where nobody could tell its points apart.
    """
    calls = curve_calls(sheet, curve, "", share)
    if not calls:
        return []
    function, (controls, *rest) = calls[0].entry.function, calls[0].arguments
    if construction_of(curve) != "de_casteljau":
        *_weights, knots, degree, u = rest
        span = int(knot_spans(knots, degree, u))
        controls = controls[span - degree : span + 1]
    if len(controls) > _MOST_TOLD_APART:
        return []
    made = np.array(list(function(*calls[0].arguments))).reshape(-1, 2)
    ends = np.cumsum(np.arange(len(controls) - 1, 0, -1))
    return [controls, *np.split(made, ends[:-1])]
