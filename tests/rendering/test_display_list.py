"""From a sheet to strokes: curves within tolerance, clipping to the viewport, and what cannot be shown."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.document.views import seen_through
from tests.rendering.test_frame_buffer import line, points, sheet
from workbench.document.model import Circle, Ellipse, Polyline, Rectangle, SeedFill
from workbench.rendering import display_list, unshown
from workbench.rendering.limits import clip_segments


def test_a_line_is_one_unrounded_stroke() -> None:
    (stroke,) = display_list(sheet(line((1.25, 2.5), (20.75, 9.0))))
    assert stroke[:4] == (1.25, 2.5, 20.75, 9.0)
    assert (stroke.colour, stroke.figure) == (0xFF0000, 0)


@given(st.floats(0.2, 14.0), st.floats(0.2, 14.0), st.sampled_from([0.5, 0.05, 0.01]))
def test_chords_stay_within_the_tolerance(rx: float, ry: float, flatness: float) -> None:
    figure = Ellipse("e", points((19.5, 14.5)), "midpoint_ellipse", radius_x_world=rx, radius_y_world=ry)
    strokes = display_list(sheet(figure), flatness)
    assert strokes[0][:2] == strokes[-1][2:4] or math.isclose(strokes[0][0], strokes[-1][2])
    for before, after in itertools.pairwise(strokes):
        assert before[2:4] == after[:2]
    for x0, y0, x1, y1, *_ in strokes:
        u, v = ((x0 + x1) / 2 - 19.5) / rx, ((y0 + y1) / 2 - 14.5) / ry
        # In the frame where the ellipse is a unit circle the sagitta shrinks by at least its radius.
        assert (1.0 - math.hypot(u, v)) * min(rx, ry) <= flatness * (1 + 1e-9)


@given(st.floats(-400, 400), st.floats(-400, 400), st.floats(0.2, 500.0), st.floats(0.2, 500.0))
def test_no_visible_part_of_a_large_ellipse_is_missing(xc: float, yc: float, rx: float, ry: float) -> None:
    figure = Ellipse("e", points((xc, yc)), "midpoint_ellipse", radius_x_world=rx, radius_y_world=ry)
    strokes = display_list(sheet(figure), 0.05)
    ends = np.array([stroke[:4] for stroke in strokes]).reshape(-1, 4)
    for k in range(2000):
        x = xc + rx * math.cos(2 * math.pi * k / 2000)
        y = yc + ry * math.sin(2 * math.pi * k / 2000)
        if 0 <= x <= 39 and 0 <= y <= 29:
            line = np.linspace(ends[:, :2], ends[:, 2:], 200)
            assert np.hypot(line[..., 0] - x, line[..., 1] - y).min() < 0.2


@pytest.mark.parametrize("radius", [1e3, 1e6])
@pytest.mark.parametrize("viewport", [40.0, 1e6])
@pytest.mark.parametrize("window", [1e-3, 1.0])
def test_a_circle_has_as_many_strokes_as_there_is_room_for(
    radius: float, viewport: float, window: float
) -> None:
    circle = Circle("c", points((radius, 0)), "midpoint_circle", radius_world=radius)
    large = seen_through(
        sheet(circle, window=(-window, -window, window, window)),
        viewport_device=Rectangle(-viewport, -viewport, viewport, viewport),
    )
    strokes = display_list(large)
    assert 0 < len(strokes) < 3000


def test_a_circle_under_unequal_scale_is_flattened_as_an_ellipse() -> None:
    circle = Circle("c", points((10, 15)), "midpoint_circle", radius_world=5.0)
    strokes = display_list(sheet(circle, window=(-0.5, -0.5, 19.5, 29.5)))
    xs, ys = [s.x0 for s in strokes], [s.y0 for s in strokes]
    assert math.isclose(max(xs) - min(xs), 20.0, rel_tol=1e-3)
    assert math.isclose(max(ys) - min(ys), 10.0, rel_tol=1e-3)


def test_strokes_end_at_the_viewport() -> None:
    (stroke,) = display_list(sheet(line((-50, 10), (90, 10))))
    assert stroke[:4] == (-0.5, 10.0, 39.5, 10.0)
    assert display_list(sheet(line((-50, -10), (90, -10)))) == []


@given(*(st.floats(-50, 50) for _ in range(4)))
def test_clipping_keeps_points_on_the_segment_and_in_the_box(x0, y0, x1, y1) -> None:
    parts, kept = clip_segments(np.array([[x0, y0, x1, y1]]), (-10.0, -5.0, 10.0, 5.0))
    assert len(parts) == kept.sum()
    seen = parts[0].tolist() if kept[0] else None
    samples = [(x0 + k / 200 * (x1 - x0), y0 + k / 200 * (y1 - y0)) for k in range(201)]
    inside = [(x, y) for x, y in samples if -10 < x < 10 and -5 < y < 5]
    if seen is None:
        assert not inside
        return
    for x, y in (seen[:2], seen[2:]):
        assert -10 - 1e-9 <= x <= 10 + 1e-9
        assert -5 - 1e-9 <= y <= 5 + 1e-9
        assert abs((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) < 1e-9 * (
            1 + math.hypot(x1 - x0, y1 - y0) ** 2
        )
    low, high = sorted((seen[0], seen[2]))
    assert all(low - 1e-9 <= x <= high + 1e-9 for x, _ in inside)


def test_a_fill_cannot_be_shown_and_says_so() -> None:
    box = Polyline("b", points((5, 5), (15, 5), (15, 12)), "bresenham_line", closed=True)
    fill = SeedFill("f", points((13, 7)), "boundary_fill_4", colour=2, boundary=1)
    one = sheet(box, fill)
    assert len(display_list(one)) == 3
    ((identity, sentence),) = unshown(one)
    assert identity == "f"
    assert "vector tube" in sentence
