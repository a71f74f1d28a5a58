"""The same points through several kinds of curves, measured beside each other, as rows of a table."""

import math
from functools import lru_cache

from msgspec.structs import replace

from workbench.algorithms import curves
from workbench.document.curves.pieces import ends_steer, fault_of, goes_round
from workbench.document.curves.shaping import AGREEMENT
from workbench.document.model import THROUGH, Curve, Sheet
from workbench.language import _
from workbench.panels.curves.joints import MOST_JOINTS
from workbench.panels.curves.names import is_handle, look_of, spline_title
from workbench.panels.curves.shape import Array, device_pieces, device_points
from workbench.widgets.canvas.drawing import Pattern
from workbench.widgets.tables.measure_table import Measure, Measured, Value

# What stands in the table while no other kind is shown beside the curve.
USUAL = ("natural_cubic", "catmull_rom", "bezier", "b_spline")
MOST_POINTS = 200
# Above it the roots of the polynomials that are measured take longer to find than a person waits.
MEASURED_DEGREE = 24
# Where one point moves the whole curve.
_GLOBAL = ("bezier", "natural_cubic", "clamped_cubic", "periodic_cubic")
# A curve that passes a point this near, in pixels, passes through it.
_ON = 1e-6


def compared(curve: Curve) -> tuple[str, ...]:
    """The kinds that are compared: that of the curve, then those beside it, or else the usual ones."""
    return (curve.spline, *(kind for kind in curve.beside or USUAL if kind != curve.spline))


def measures() -> list[Measure]:
    """What is measured of each kind."""
    return [
        Measure(_("through the points"), "", _("Interpolation passes through every point")),
        Measure(_("farthest point"), "px", _("How far the farthest point is from the curve"), "least"),
        Measure(_("mean distance"), "px", _("How far the points are from the curve on average"), "least"),
        Measure(_("overshoot"), "px", _("How far the curve swings out beyond its points"), "least"),
        Measure(_("overshoot between"), "px", _("The same between two neighbouring points"), "least"),
        Measure(_("turning"), "°", _("How much the direction turns in all: wiggle"), "least"),
        Measure(
            _("inflections"), "", _("How often the curve changes the side towards which it bends"), "least"
        ),
        Measure(_("length"), "px", _("Arc length of the curve"), "least"),
        Measure(_("one point moves"), "", _("How much of the curve follows a point that is moved")),
        Measure(_("smoothness"), "", _("The worst joint of the curve: parametric, geometric")),
        Measure(
            _("degree"),
            "",
            _("The degree of each piece; above {most} nothing else is measured").format(most=MEASURED_DEGREE),
        ),
    ]


@lru_cache(maxsize=4)
def _rows(sheet: Sheet, curve: Curve) -> tuple[Measured, ...]:
    points = _through(sheet, curve)
    found = []
    for kind in compared(curve):
        pieces = device_pieces(sheet, curve, kind)
        if pieces is None or not len(points):
            continue
        low = pieces.degree <= MEASURED_DEGREE
        values = _values(replace(curve, spline=kind), pieces, points) if low else (None,) * 10
        ink, pattern = _look_beside(curve, kind)
        found.append(Measured(spline_title(kind), ink, (*values, str(pieces.degree)), pattern))
    return tuple(found)


def _values(curve: Curve, pieces: curves.Pieces, points: Array) -> tuple[Value, ...]:
    """The measures but the degree, of a curve of these pieces over these points."""
    away = curves.distances(pieces, points)
    swing = curves.overshoot(pieces, points)
    turns = curves.wiggle(pieces, points)
    return (
        (curve.spline in THROUGH and not ends_steer(curve)) or float(away.max()) < _ON,
        float(away.max()),
        float(away.mean()),
        swing.box,
        None if math.isnan(swing.between) else swing.between,
        math.degrees(turns.turning),
        float(turns.inflections),
        float(curves.arc_length(pieces)),
        _("all of it") if curve.spline in _GLOBAL else _("a part of it"),
        _smoothness(pieces, goes_round(curve)),
    )


def rows(sheet: Sheet, curve: Curve) -> tuple[Measured, ...]:
    """A row for each kind that there is over these points; none for very many points."""
    return () if len(curve.points_world) > MOST_POINTS else _rows(sheet, curve)


def why_none(curve: Curve | None) -> str:
    """The sentence that stands in place of ``rows`` where there is none."""
    if curve is None:
        return _("Select a curve to measure it beside other kinds.")
    if len(curve.points_world) > MOST_POINTS:
        return _("Curves of more than {most} points are not compared.").format(most=MOST_POINTS)
    return fault_of(curve)


def _look_beside(curve: Curve, kind: str) -> tuple[str, Pattern]:
    """Ink and pattern of a kind's line on the canvas; no ink where it is not there."""
    if kind == curve.spline:
        return "accent", "solid"
    return look_of(kind) if kind in curve.beside else ("", "solid")


def _through(sheet: Sheet, curve: Curve) -> Array:
    """The points that a curve is measured against: all, but the handles of a path."""
    kept = [k for k in range(len(curve.points_world)) if not is_handle(curve, k)]
    return device_points(sheet, curve)[kept]


def _smoothness(pieces: curves.Pieces, closed: bool) -> str:
    found = curves.joints(pieces, closed, AGREEMENT)[:MOST_JOINTS]
    if not found:
        return "C\N{INFINITY}"
    worst = [min(_order(getattr(joint, name)) for joint in found) for name in ("parametric", "geometric")]
    return ", ".join(
        f"{letter}{order}" if order >= 0 else _("gap") for letter, order in zip("CG", worst, strict=True)
    )


def _order(name: str) -> int:
    return int(name[1]) if name else -1
