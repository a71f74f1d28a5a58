"""The texts of a curve run in device coordinates: the last point of a construction is on the curve."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.document.curves.made_curves import curves
from tests.document.views import seen_through
from workbench.algorithms.curves import piece_points
from workbench.algorithms.marks import Spot, Stroke
from workbench.document.curves import edits as curve_edits
from workbench.document.curves.pieces import fault_of, parameter_at, pieces_of, share_at
from workbench.document.model import Curve, CurvePoint, Rectangle, Sheet
from workbench.document.samples.figures import document_of, line
from workbench.rendering import frame_buffer, why
from workbench.rendering.comparing import compare, distances
from workbench.rendering.curve_runs import (
    construction_fault,
    construction_of,
    curve_calls,
)
from workbench.rendering.curves import device_pieces
from workbench.rendering.mapping import device_points
from workbench.rendering.raster import emitted, figure_calls
from workbench.rendering.why_steps import why_steps


def sheet_with(*figures: Curve) -> Sheet:
    sheet = document_of("Curve", 80, 60, figures).sheets[0]
    return seen_through(sheet, window_world=Rectangle(-100.0, -120.0, 100.0, 80.0))


@settings(max_examples=150)
@given(curves(), st.floats(0, 1))
def test_the_last_point_of_a_construction_is_on_the_curve(curve: Curve, share: float) -> None:
    sheet = sheet_with(curve)
    (made,) = sheet.figures
    assert isinstance(made, Curve)
    constructions = ("de_casteljau", "de_boor", "de_boor_rational")
    for slug in ("", *constructions, "b_spline_sum", "bernstein_curve", "hermite_blend"):
        calls = curve_calls(sheet, made, slug, share)
        assert bool(calls) == (not construction_fault(made, slug or construction_of(made)))
        for call in calls:
            *_, last = call.entry.function(*call.arguments)
            there = piece_points(device_pieces(sheet, made), parameter_at(made, share))
            np.testing.assert_allclose(last, there, atol=1e-7)


@settings(max_examples=60)
@given(curves(), st.floats(0, 1))
def test_a_share_of_the_range_is_found_again(curve: Curve, share: float) -> None:
    if not fault_of(curve):
        knots = pieces_of(curve).knots
        expected = share if knots[0] < knots[-1] else 0.0
        assert share_at(curve, parameter_at(curve, share)) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("closed", [False, True])
def test_where_all_points_are_in_one_place_the_range_has_no_length_and_every_share_is_its_begin(
    closed: bool,
) -> None:
    points = tuple(CurvePoint("", 4.0, -2.0) for _ in range(4))
    curve = Curve("", points, "bresenham_line", spline="catmull_rom", closed=closed)
    assert not fault_of(curve)
    for share in (0.0, 0.3, 1.0):
        assert parameter_at(curve, share) == 0.0
        assert share_at(curve, 0.0) == 0.0
    sheet = sheet_with(curve)
    (drawn,) = sheet.figures
    assert isinstance(drawn, Curve)
    for call in curve_calls(sheet, drawn, "", 0.7):
        *_, last = call.entry.function(*call.arguments)
        assert last == pytest.approx(device_points(sheet, [drawn], [points])[0])


def a_curve(spline: str = "natural_cubic", **more: object) -> Curve:
    places = [(-90, -110), (-40, 60), (0, -40), (40, 60), (95, 75)]
    points = tuple(CurvePoint("", float(x), float(y)) for x, y in places)
    return Curve("", points, "bresenham_line", spline=spline, **more)  # type: ignore[arg-type]


def test_samples_and_chords_are_run_too() -> None:
    sheet = sheet_with(a_curve("b_spline"))
    (curve,) = sheet.figures
    assert isinstance(curve, Curve)
    (sampled,) = curve_calls(sheet, curve, "b_spline_curve", 0.5)
    assert len(list(sampled.entry.function(*sampled.arguments))) == 17
    (chain,) = curve_calls(sheet, curve, "flatten_bezier", 0.9)
    np.testing.assert_array_equal(chain.arguments[0], device_pieces(sheet, curve).controls[1])
    assert chain.arguments[1] == curve.tolerance_px


def test_the_system_of_a_natural_spline_gives_the_tangents_of_its_pieces() -> None:
    sheet = sheet_with(a_curve())
    (curve,) = sheet.figures
    assert isinstance(curve, Curve)
    (call,) = curve_calls(sheet, curve, "natural_cubic_system", 0.5)
    solved = np.array(list(call.entry.function(*call.arguments)))[::-1]
    controls = device_pieces(sheet, curve).controls
    np.testing.assert_allclose(solved[:-1, :2], controls[:, 0], atol=1e-9)
    np.testing.assert_allclose(solved[:-1, 2:], 3.0 * (controls[:, 1] - controls[:, 0]), atol=1e-9)
    assert (
        curve_calls(sheet_with(a_curve("catmull_rom")), a_curve("catmull_rom"), "natural_cubic_system", 0.5)
        == []
    )


def test_unequal_weights_have_a_construction_of_their_own() -> None:
    document = document_of("Curve", 80, 60, [a_curve("nurbs")])
    document = curve_edits.set_weights({"s1/f1/p2/*": 3.0})(document)
    curve = document.sheets[0].figures[0]
    assert isinstance(curve, Curve)
    (call,) = curve_calls(document.sheets[0], curve, "", 0.5)
    assert call.entry.slug == "de_boor_rational"
    assert curve_calls(document.sheets[0], curve, "de_boor", 0.5) == []
    assert construction_fault(curve, "de_boor").endswith(".")


def test_a_pixel_of_a_curve_says_why_and_its_algorithms_are_compared() -> None:
    sheet = sheet_with(a_curve(), a_curve("catmull_rom", colour=2))
    picture = frame_buffer(sheet)
    rows, columns = np.nonzero(picture == sheet.palette[1])
    for x, y in list(zip(columns.tolist(), rows.tolist(), strict=True))[::25]:
        last = [touch for touch in why(sheet, x, y) if touch.last]
        assert [touch.figure for touch in last] == [0]
        assert any(answer.stands and answer.figure == 0 for answer in why_steps(sheet, x, y))
    found = compare(sheet, sheet.figures[0], "bresenham_line", "dda_line")
    assert len(found.both) > 50
    assert len(distances(sheet, sheet.figures[0])) >= len(found.both)


def test_a_curve_is_drawn_as_its_chords_are() -> None:
    sheet = sheet_with(a_curve())
    (curve,) = sheet.figures
    chords = [call.arguments for call in figure_calls(sheet, curve)]
    lines = [line((x0, y0), (x1, y1)) for x0, y0, x1, y1 in chords]
    drawn = document_of("Chords", 80, 60, lines).sheets[0]
    np.testing.assert_array_equal(frame_buffer(drawn), frame_buffer(sheet))


@settings(max_examples=80)
@given(curves(), st.floats(0, 1))
def test_each_level_that_is_drawn_has_a_point_less_and_lies_on_the_legs_above(
    curve: Curve, share: float
) -> None:
    sheet = sheet_with(curve)
    (made,) = sheet.figures
    assert isinstance(made, Curve)
    calls = curve_calls(sheet, made, "", share)
    assert bool(calls) == (not fault_of(made))
    for entry, arguments, _limit in calls:
        drawn = list(entry.marks(arguments, {}, emitted(calls[0]), True))
        levels = [mark.points for mark in drawn if isinstance(mark, Stroke)]
        assert [len(level) for level in levels] == list(range(len(levels) + 1, 1, -1))
        for above, level in pairwise(levels):
            legs, along = np.diff(above, axis=0), level - above[:-1]
            size = 1.0 + np.abs(above).max()
            assert np.abs(legs[:, 0] * along[:, 1] - legs[:, 1] * along[:, 0]).max() <= 1e-9 * size * size
        (place,) = [mark for mark in drawn if isinstance(mark, Spot) and mark.size == "large"]
        there = piece_points(device_pieces(sheet, made), parameter_at(made, share))
        np.testing.assert_allclose((place.x, place.y), there, atol=1e-7)
