"""Curves joined at their ends, reversed, and their points aligned and mirrored."""

import math
from collections.abc import Iterable

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.addresses import Address, figure_with, parse, point_with
from workbench.document.building import Edit, checked, numbered, remembering, with_changed, with_figures
from workbench.document.curves.changes import changing, curve_with
from workbench.document.curves.conversions import converted
from workbench.document.curves.edits import move_curve_points
from workbench.document.curves.knots import refitted, with_knot_rule
from workbench.document.curves.paths import (
    Place,
    is_path,
    joints_of,
    place,
    points_from,
    refuse_waiting,
    sound,
)
from workbench.document.curves.pieces import ends_steer, goes_round, knots_of, pieces_of, points_of
from workbench.document.errors import DocumentError
from workbench.document.model import B_SPLINES, THROUGH, Curve, CurvePoint, Document, Knot
from workbench.document.transforms.chains import inverse_of
from workbench.document.transforms.expressing import expressed
from workbench.geometry.curves.rounding import nothing_beside
from workbench.language import _

Array = NDArray[np.float64]


@checked
def join(first: str, second: str) -> Edit:
    """Join two open curves where their ends are nearest; the figure is the ``first`` one, points keep ids.

    The chain is that of the first, under which the second looks as before. Two B-splines of one degree and
    two paths stay what they are, two curves of one kind through all of their points go on by its rule; all
    others become one path. Ends apart are bridged by a straight piece; ``joined`` tells how far it is off.
    """

    def edit(document: Document) -> Document:
        one, other = curve_with(document, first), curve_with(document, second)
        if first == second:
            raise DocumentError(
                first, _("These are the two ends of one curve; close it instead, or choose another curve.")
            )
        try:
            made, _error = joined(one, other)
        except ValueError as problem:
            raise DocumentError(first, str(problem)) from problem
        sheet = figure_with(document, second)[0]
        kept = tuple(figure for figure in sheet.figures if figure.id != second)
        after = remembering(document, with_figures(document, sheet, kept))
        return with_changed(after, [numbered(document, made)])

    return edit


def joined(one: Curve, other: Curve) -> tuple[Curve, float]:
    """The curve along both, from ``one`` to ``other``, reversed as needed, and how far at most it is off.

    It has the chain of ``one``, and the error is in world units before that. Raises: ValueError.
    """
    if goes_round(one) or goes_round(other):
        raise ValueError(_("A closed curve has no end to join; open it first."))
    for curve in (one, other):
        refuse_waiting(curve)
    other, error = _in_frame_of(one, other)
    turned = [(a, b) for a in (one, reversed_curve(one)) for b in (other, reversed_curve(other))]
    one, other = min(turned, key=lambda pair: math.dist(_ends(pair[0])[1], _ends(pair[1])[0]))
    goes_on = one.spline == other.spline and one.spline in THROUGH
    if goes_on and not (ends_steer(one) or ends_steer(other)):
        rest = other.points_world[1:] if _meet(one, other) else other.points_world
        points = (*one.points_world, *rest)
        made = replace(one, points_world=points, knot_rule="open_uniform", knots=())
        return made, error + _off(made, one, other)
    plain = one.spline in B_SPLINES and one.degree == other.degree
    if plain and one.spline == other.spline and _clamped(one) and _clamped(other):
        return _joined_b_splines(one, other), error
    (first, first_off), (second, second_off) = (converted(curve, "bezier_path") for curve in (one, other))
    return _joined_paths(first, second), max(first_off, error + second_off)


def _in_frame_of(one: Curve, other: Curve) -> tuple[Curve, float]:
    """``other`` with points that the chain of ``one`` takes where its own took them, and how far it is off.
    Raises: ValueError.
    """
    if one.matrix is None and other.matrix is None:
        return other, 0.0
    own, back = (np.eye(3) if curve.matrix is None else curve.matrix for curve in (other, one))
    matrix = inverse_of(back) @ own
    placed = expressed(other, matrix)
    if isinstance(placed, Curve):
        return placed, 0.0
    path, error = converted(other, "bezier_path")
    placed = expressed(path, matrix)
    assert isinstance(placed, Curve)  # a path goes with its points
    return placed, error * float(np.linalg.norm(matrix[:2, :2], 2))


def _off(made: Curve, one: Curve, other: Curve) -> float:
    """How far at most the pieces of a curve are off that begins as ``one`` and ends as ``other``."""
    controls, before, after = (pieces_of(curve).controls for curve in (made, one, other))
    ways = np.concatenate([controls[: len(before)] - before, controls[-len(after) :] - after])
    return float(np.hypot(ways[..., 0], ways[..., 1]).max())


def _meet(one: Curve, other: Curve) -> bool:
    """Whether the last point of the one is the first of the other, beside the size of both."""
    both = np.concatenate([points_of(one), points_of(other)])
    return math.dist(place(one.points_world[-1]), place(other.points_world[0])) <= nothing_beside(both)


def _ends(curve: Curve) -> tuple[Place, Place]:
    controls = pieces_of(curve).controls
    (x0, y0), (x1, y1) = controls[0, 0].tolist(), controls[-1, -1].tolist()
    return (x0, y0), (x1, y1)


def _clamped(curve: Curve) -> bool:
    """Whether the curve begins and ends at its outer points, however its knots are made."""
    knots, degree = knots_of(curve), curve.degree
    return bool(knots[1] == knots[degree] and knots[-2] == knots[-degree - 1])


def _joined_b_splines(one: Curve, other: Curve) -> Curve:
    """Both, with the knot between them as often as the degree; a gap is bridged by one more piece."""
    degree = one.degree
    first, second = with_knot_rule(one, "free"), with_knot_rule(other, "free")
    end, begin = first.points_world[-1], second.points_world[0]
    pull = end.weight / begin.weight if one.spline == "nurbs" else 1.0
    after = [replace(p, weight=p.weight * pull) for p in second.points_world]
    apart = not _meet(one, other)
    bridge = [
        CurvePoint(
            "",
            end.x + (begin.x - end.x) * k / degree,
            end.y + (begin.y - end.y) * k / degree,
            weight=end.weight,
        )
        for k in range(1, degree)
        if apart
    ]
    points = (*first.points_world, *bridge, *(after if apart else after[1:]))
    here = first.knots[-1].u
    shift = here + (1.0 if apart else 0.0) - second.knots[degree].u
    knots = [*first.knots[:-1]]
    knots += [Knot("", here + 1.0)] * (degree if apart else 0)
    knots += [replace(knot, u=knot.u + shift) for knot in second.knots[degree + 1 :]]
    return replace(first, points_world=points, knots=tuple(knots))


def _joined_paths(one: Curve, other: Curve) -> Curve:
    first, second = joints_of(one)[0], joints_of(other)[0]
    end, begin = first[-1], second[0]
    if _meet(one, other):
        joints = [*first[:-1], sound(end._replace(after=begin.after)), *second[1:]]
        return refitted(replace(one, points_world=points_from(joints, False)))
    thirds = [
        CurvePoint("", a.x + (b.x - a.x) / 3.0, a.y + (b.y - a.y) / 3.0)
        for a, b in ((end.at, begin.at), (begin.at, end.at))
    ]
    joints = [*first[:-1], sound(end._replace(after=thirds[0]))]
    joints += [sound(begin._replace(before=thirds[1])), *second[1:]]
    return refitted(replace(one, points_world=points_from(joints, False)))


@checked
def reverse(figure: str) -> Edit:
    """Let a curve run the other way; it looks the same."""
    return changing(figure, reversed_curve)


def reversed_curve(curve: Curve) -> Curve:
    """``curve`` from its end to its begin; the points keep their ids. A closed one begins where it did."""
    whole, waiting = curve.points_world, curve.points_world[:0]
    if is_path(curve):
        waiting = joints_of(curve)[1]
        whole = whole[: len(whole) - len(waiting)]
    points = [
        replace(point, tangent_x=0.0 - point.tangent_x, tangent_y=0.0 - point.tangent_y)
        for point in reversed(whole)
    ]
    knots = curve.knots
    if knots:
        both = knots[0].u + knots[-1].u
        knots = tuple(replace(knot, u=both - knot.u) for knot in reversed(knots))
    if goes_round(curve) and points:
        knotted = curve.knots and curve.spline in B_SPLINES
        points = _turned(points, curve.degree if knotted else 1)
    return replace(curve, points_world=(*points, *waiting), knots=knots, bias=0.0 - curve.bias)


def _turned(points: list[CurvePoint], degree: int) -> list[CurvePoint]:
    """Reversed points of a closed curve, over its knots reversed; with degree 1 the first stays first."""
    count = len(points)
    return [points[(count - degree + i) % count] for i in range(count)]


ALIGNMENTS = ("left", "centre", "right", "bottom", "middle", "top")


def aligned(curve: Curve, points: Iterable[str], how: str) -> dict[str, Place]:
    """Where points, by id, go when they are put under one another or side by side. Raises: ValueError."""
    if how not in ALIGNMENTS:
        raise ValueError(_("Choose one of {choices}.").format(choices=", ".join(ALIGNMENTS)))
    chosen = [point_with(curve, identity) for identity in points]
    if not chosen:
        return {}
    across = how in ALIGNMENTS[:3]
    values = [point.x if across else point.y for point in chosen]
    low, high = min(values), max(values)
    to = {"left": low, "bottom": low, "right": high, "top": high}.get(how, (low + high) / 2.0)
    return {point.id: (to, point.y) if across else (point.x, to) for point in chosen}


@checked
def align(addresses: Iterable[Address | str], how: str) -> Edit:
    """Align control points of one curve: left, centre, right (in x), bottom, middle, top (in y)."""
    chosen = [parse(text) for text in addresses]

    def edit(document: Document) -> Document:
        if not chosen:
            return document
        curve = curve_with(document, chosen[0].figure)
        try:
            places = aligned(curve, [where.point for where in chosen], how)
        except ValueError as problem:
            raise DocumentError(curve.id, str(problem)) from problem
        return move_curve_points({_address(chosen[0], point): at for point, at in places.items()})(document)

    return edit


def _address(where: Address, point: str) -> Address:
    return replace(where, point=point, attribute="x")
