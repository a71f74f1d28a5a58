"""How far figures reach, against dense points of them."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.model import Circle, Curve, CurvePoint, Ellipse, Line, Sheet, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.document.transforms.links import Affine
from workbench.rendering import figure_map
from workbench.rendering.extents import extent_of, extent_of_points

SHEET = blank_sheet(64, 48).sheets[0]
entry = st.floats(-3, 3)


@settings(max_examples=50)
@given(entry, entry, entry, entry, st.booleans())
def test_a_round_figure_reaches_as_far_as_its_points(
    a: float, b: float, c: float, d: float, circle: bool
) -> None:
    chain = (Affine("t1", m11=a, m12=b, m13=4.0, m21=c, m22=d, m23=-2.0),)
    at = (WorldPoint("p1", 300.0, 20.0),)  # beyond the sheet
    figure: Circle | Ellipse = Circle("f1", at, "midpoint_circle", transforms=chain, radius_world=5.0)
    radii = 5.0, 5.0
    if not circle:
        radii = 7.0, 2.0
        figure = Ellipse(
            "f1", at, "midpoint_ellipse", transforms=chain, radius_x_world=7.0, radius_y_world=2.0
        )
    angles = np.linspace(0, 2 * np.pi, 4001)
    ring = np.array([300.0, 20.0]) + np.stack([np.cos(angles), np.sin(angles)], 1) * radii
    points = figure_map(SHEET, figure).points(ring)
    extent = extent_of(SHEET, [figure])
    assert extent is not None
    np.testing.assert_allclose(extent, [*points.min(axis=0), *points.max(axis=0)], atol=1e-4)


def sheet_extent(sheet: Sheet, *figures: Line | Curve) -> tuple[float, ...] | None:
    return extent_of(sheet, figures)


def test_what_is_hidden_or_not_finite_does_not_count() -> None:
    line = Line("f1", (WorldPoint("p1", 1.0, 2.0), WorldPoint("p2", 90.0, -7.0)), "bresenham_line")
    hidden = replace(line, id="f2", points_world=(WorldPoint("p3", 500.0, 0.0),), visible=False)
    assert sheet_extent(SHEET, line, hidden) == (1.0, -7.0, 90.0, 2.0)
    assert sheet_extent(SHEET, hidden) is None
    assert sheet_extent(SHEET) is None
    assert extent_of_points(np.array([[np.inf, 0.0], [1.0, 2.0]])) == (1.0, 2.0, 1.0, 2.0)
    assert extent_of_points(np.array([[np.nan, 0.0]])) is None


def test_a_curve_reaches_as_far_as_it_goes_and_not_its_control_points() -> None:
    points = tuple(
        CurvePoint(f"p{k}", x, y) for k, (x, y) in enumerate([(0.0, 0.0), (10.0, 20.0), (20.0, 0.0)])
    )
    curve = Curve("f1", points, "bresenham_line", spline="bezier")
    extent = sheet_extent(SHEET, curve)
    assert extent is not None
    np.testing.assert_allclose(extent, (0, 0, 20, 10), atol=0.3)
    assert sheet_extent(SHEET, replace(curve, points_world=points[:1])) == (0.0, 0.0, 0.0, 0.0)
