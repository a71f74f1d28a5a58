"""What cannot be a curve is refused in words, at its place, by every reading."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from workbench.algorithms import curves
from workbench.engine import compiled
from workbench.geometry.curves.conditions import Fault, faults

POINTS = np.array([[0, 0], [1, 2], [3, 3], [5, 1]], float)
KNOTS = np.array([0, 0, 0, 1, 2, 2, 2], float)
NAN = np.array([[0, 0], [1, np.nan], [3, 3], [5, 1]])
BACK = np.array([0, 0, 0, 2, 1, 2, 2], float)
NO_LENGTH = np.array([0, 0, 1, 1, 1, 2, 2], float)

REFUSED: list[tuple[Callable[..., Any], tuple[Any, ...], str]] = [
    (curves.de_casteljau, (POINTS[:1], 0.5), "needs two points or more; add"),
    (curves.de_casteljau, (NAN, 0.5), "not a finite number; give it a value"),
    (curves.de_casteljau, (POINTS, np.inf), "not a finite number"),
    (curves.de_boor, (POINTS, KNOTS, 0, 1.0), "degree of a B-spline is 1 or more; raise"),
    (curves.de_boor, (POINTS[:2], KNOTS[:5], 2, 1.0), "fewer points than degree . 1; add points, or lower"),
    (curves.de_boor, (POINTS, KNOTS[:6], 2, 1.0), "must be degree . 1 more knots than points"),
    (curves.de_boor, (POINTS, BACK, 2, 1.0), "knots decrease; make each at least as large"),
    (curves.de_boor, (POINTS, NO_LENGTH, 2, 1.0), "no length in u: .* are equal; move them apart"),
    (curves.de_boor, (POINTS, KNOTS, 2, 2.5), "u is outside the curve; keep it"),
    (curves.de_boor, (POINTS, KNOTS, 2, np.nan), "u is outside the curve"),
    (curves.de_boor, (POINTS, np.where(KNOTS == 1, np.nan, KNOTS), 2, 1.0), "not a finite number"),
    (curves.de_boor_rational, (POINTS, np.ones(3), KNOTS, 2, 1.0), "one weight for each point; add weights"),
    (curves.de_boor_rational, (POINTS, np.array([1, 0, 1, 1.0]), KNOTS, 2, 1.0), "not a finite number above"),
    (curves.b_spline_curve, (POINTS, BACK, 2, 9), "knots decrease"),
    (curves.b_spline_curve, (POINTS, KNOTS, 2, 1), "needs two samples or more; ask"),
    (curves.flatten_bezier, (POINTS, 0.0), "tolerance must be above 0; give a larger"),
    (curves.closest_point, (KNOTS[:2], POINTS, np.ones(4), 0, 0.0, 0.0), "degree 1 or more; add some"),
    (
        curves.closest_point,
        (KNOTS[2:4], POINTS, np.ones(4), 2, 0.0, 0.0),
        "needs degree . 1 points",
    ),
    (curves.closest_point, (KNOTS[2:4], POINTS, np.ones(3), 3, 0.0, 0.0), "one weight for each point"),
    (curves.closest_point, (KNOTS[2:4], NAN, np.ones(4), 3, 0.0, 0.0), "not a finite number"),
    (curves.closest_point, (BACK[3:5], POINTS, np.ones(4), 3, 0.0, 0.0), "knots decrease"),
    (curves.closest_point, (KNOTS[2:4], POINTS, np.zeros(4), 3, 0.0, 0.0), "weight is not a finite number"),
    (curves.flatten_bezier, (POINTS[:0], 1.0), "needs two points or more"),
]


@pytest.mark.parametrize(("function", "values", "sentence"), REFUSED)
def test_a_text_refuses_at_the_door(
    function: Callable[..., Any], values: tuple[Any, ...], sentence: str
) -> None:
    for run in (
        lambda: list(function(*values)),
        lambda: compiled.collect(function, *values, flavour="interpreted"),
        lambda: compiled.collect(function, *values, flavour="checked"),
    ):
        with pytest.raises(ValueError, match=sentence):
            run()


@pytest.mark.parametrize(
    ("run", "sentence"),
    [
        (lambda: curves.nurbs_point(POINTS, [1, 0, 1, 1], KNOTS, 2, 1), "Weight 1 is 0; it must be"),
        (lambda: curves.nurbs_point(POINTS, [1, 1, -2, 1], KNOTS, 2, 1), "Weight 2 is -2; it must be"),
        (lambda: curves.basis_table(KNOTS, 2, 1, [1, 1, 0, 1]), "Weight 2 is 0; it must be"),
        (lambda: curves.nurbs_point(POINTS, [1, 1], KNOTS, 2, 1), "2 weights for 4 points; give each"),
        (lambda: curves.b_spline_point(POINTS, BACK, 2, 1), "Knot 4 is 1, less than knot 3, 2; raise it"),
        (
            lambda: curves.b_spline_point(POINTS, KNOTS, 2, [1, 3]),
            "u = 3 is outside the curve, 0 to 2; choose",
        ),
        (lambda: curves.b_spline_point(POINTS, KNOTS[1:], 2, 1), "6 knots, and 4 points .* need 7; add 1"),
        (
            lambda: curves.b_spline_point(POINTS, NO_LENGTH, 2, 1),
            "Knots 2 and 4, where .* are equal; part them",
        ),
        (lambda: curves.basis_functions([0, 1], 3, 0), "0 points, and 4 are needed; add 4"),
        (lambda: curves.natural_cubic(POINTS[:1]), "There is 1 point, and 2 are needed; add 1"),
        (lambda: curves.b_spline_point(POINTS, KNOTS[:1], 2, 1), "There is 1 knot, and 4 .* need 7; add 6"),
        (lambda: curves.bezier_point(NAN, 0), "Point 1 is not finite; give it numbers"),
        (lambda: curves.bezier_point([1, 2], 0), "not rows of coordinates; give each its x and y"),
        (lambda: curves.bernstein(-1, 0), "degree is -1; it must be"),
        (lambda: curves.insert_knot(POINTS, KNOTS, 2, 1, 2), "1 times, .* insert it 1 times at most"),
        (lambda: curves.insert_knot(POINTS, KNOTS, 2, 5), "u = 5 is outside the curve, 0 to 2"),
        (lambda: curves.split_b_spline(POINTS, KNOTS, 2, 2), "nothing to split; choose a u between the ends"),
        (lambda: curves.natural_cubic(POINTS, [0, 1, 1, 2]), "Knot 2 is 1, after 1; raise it, or part the"),
        (lambda: curves.natural_cubic(POINTS, [0, 1]), "2 knots for 4 points; give each point one"),
        (lambda: curves.periodic_cubic(POINTS[:2]), "2 points, and 3 are needed; add 1"),
        (lambda: curves.hermite(POINTS, POINTS[:2]), "2 tangents for 4 points; give each point one"),
        (lambda: curves.cardinal(POINTS[:3]), "3 points, and 4 are needed; add 1"),
        (lambda: curves.cardinal(POINTS, np.nan), "tension is nan; it must be a finite number"),
        (lambda: curves.catmull_rom(POINTS, 1.5), "Alpha is 1.5; choose it from 0 to 1"),
        (lambda: curves.catmull_rom(POINTS, 0.5, "open"), "'open' is not a choice .* inner, through, closed"),
        (lambda: curves.kochanek_bartels(POINTS, bias=[1, 2, 3]), "one finite number, or 2 of them"),
        (lambda: curves.closed_b_spline(POINTS[:2], 3), "2 points, and 3 are needed; add 1"),
        (lambda: curves.circle(0, 0, 0), "radius is 0; choose a finite one above 0"),
    ],
)
def test_a_plain_function_says_what_where_and_what_to_do(run: Callable[[], Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        run()


def test_every_fault_is_found_with_its_place() -> None:
    found = faults(NAN, BACK, 2, [1, -1, 0, 1])
    assert [(fault.what, fault.number) for fault in found] == [
        ("points", 1),
        ("weights", 1),
        ("weights", 2),
        ("knots", 4),
    ]
    assert faults(POINTS, KNOTS, 2, np.ones(4)) == []
    assert all(isinstance(fault, Fault) and fault.sentence.endswith(".") for fault in found)
