"""The runs of a curve's own texts: its construction at one u, its samples, its chain of chords; device."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.curves.pieces import (
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
from workbench.rendering.mapping import Call, figure_map

_SAMPLES_PER_SPAN = 8


def construction_of(curve: Curve, chosen: str = "") -> str:
    """Slug of the text that is stepped: ``chosen`` where it can be run on the curve, else the construction
    that belongs to the curve's kind.
    """
    if chosen and not construction_fault(curve, chosen):
        return chosen
    if curve.spline == "nurbs":
        return "de_boor_rational"
    return "de_boor" if curve.spline in B_SPLINES else "de_casteljau"


def construction_fault(curve: Curve, slug: str) -> str:
    """The sentence that says why a text cannot be run on a curve; empty where it can."""
    takes = catalogue.get(slug).parameter_names
    if "knots" in takes and curve.spline not in B_SPLINES:
        return _("This curve is not a B-spline and has no knots; step de Casteljau's construction instead.")
    if curve.spline == "nurbs" and "weights" not in takes and np.ptp(weights_of(curve)) > 0:
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
    given: dict[str, Any]
    if "knots" in entry.parameter_names:
        points, knots, weights = b_spline_of(curve)
        given = {
            "points": figure_map(sheet, curve).points(points),
            "weights": weights if curve.spline == "nurbs" else np.ones(len(points)),
            "knots": knots,
            "degree": curve.degree,
            "u": u,
            "samples": _SAMPLES_PER_SPAN * (len(points) - curve.degree) + 1,
        }
    else:
        piece, v = place_of(pieces_of(curve).knots, u)
        controls: NDArray[np.float64] = np.ascontiguousarray(device_pieces(sheet, curve).controls[piece])
        given = {"points": controls, "u": v, "tolerance": curve.tolerance_px}
    return [Call(entry, tuple(given[name] for name in entry.parameter_names))]
