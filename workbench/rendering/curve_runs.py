"""The runs of a curve's own texts: its construction at one u, its samples, its chain of chords; device."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.curves import de_boor, de_boor_rational, de_casteljau
from workbench.document.curves.pieces import (
    b_spline_of,
    fault_of,
    parameter_at,
    pieces_of,
    place_of,
    points_of,
    weights_of,
)
from workbench.document.model import B_SPLINES, THROUGH, Curve, Sheet
from workbench.language import _
from workbench.rendering.curves import device_pieces
from workbench.rendering.mapping import Call, figure_map

_CUBIC = 3
_SAMPLES_PER_SPAN = 8
_DIVIDING = {"b_spline": de_boor.__name__, "nurbs": de_boor_rational.__name__}


def construction_of(curve: Curve, chosen: str = "") -> str:
    """Slug of the text that is stepped: ``chosen`` where it can be run on the curve, else the construction
    that belongs to the curve's kind.
    """
    slugs = _constructing(curve)
    return chosen if chosen in slugs and not construction_fault(curve, chosen) else slugs[0]


def constructions_of(curve: Curve) -> list[str]:
    """The slugs of the texts that can be run on a curve, what is usually stepped first."""
    return [slug for slug in _constructing(curve) if not construction_fault(curve, slug)]


def _constructing(curve: Curve) -> tuple[str, ...]:
    """What divides legs, as that is drawn beside the curve; then the other texts of the curve's own kind, and
    those of what it is made into: Bézier or, where cubic, Hermite pieces, or, where the weights are equal, a
    B-spline without any."""
    slugs = (
        _DIVIDING.get(curve.spline, de_casteljau.__name__),
        *catalogue.constructing(curve.spline),
        *catalogue.constructing("b_spline", "bezier", "hermite"),
    )
    return tuple(dict.fromkeys(slugs))


def construction_fault(curve: Curve, slug: str) -> str:
    """The sentence that says why a text cannot be run on a curve; empty where it can."""
    entry = catalogue.get(slug)
    takes = entry.parameter_names
    if "knots" in takes and curve.spline not in B_SPLINES and curve.spline not in entry.constructs:
        return _("This curve is not a B-spline and has no knots; step de Casteljau's construction instead.")
    if curve.spline == "nurbs" and "weights" not in takes and np.ptp(weights_of(curve)) > 0:
        return _(
            "This algorithm has no weights, but those of the curve differ; step the curve's "
            "own construction instead."
        )
    fault = fault_of(curve)
    if "tangents" in takes and not fault and pieces_of(curve).degree != _CUBIC:
        return _("The pieces of this curve are not cubic; step de Casteljau's construction instead.")
    return fault


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
    if curve.spline in entry.constructs and curve.spline in THROUGH and "knots" in entry.parameter_names:
        given = {
            "points": figure_map(sheet, curve).points(points_of(curve)),
            "knots": pieces_of(curve).knots,
        }
    elif "knots" in entry.parameter_names:
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
        if "tangents" in entry.parameter_names:
            given["points"] = np.ascontiguousarray(controls[[0, -1]])
            given["tangents"] = 3.0 * (controls[[1, -1]] - controls[[0, -2]])
    return [Call(entry, tuple(given[name] for name in entry.parameter_names))]
