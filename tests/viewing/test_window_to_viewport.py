"""The window-to-viewport matrix: the course's example, and what must hold for any two rectangles."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.transforms import transform_points
from workbench.algorithms.viewing import (
    Mode,
    normalised_to_viewport,
    origin_to_viewport,
    scale_factors,
    window_scaling,
    window_to_normalised,
    window_to_origin,
    window_to_viewport,
)

Rectangle = tuple[float, float, float, float]
coordinates = st.floats(-1e6, 1e6)
sides = st.floats(1e-3, 1e6)
rectangles = st.builds(lambda x, y, w, h: (x, y, x + w, y + h), coordinates, coordinates, sides, sides)


def mapped(matrix: np.ndarray, x: float, y: float) -> tuple[float, float]:
    px, py, w = matrix @ (x, y, 1.0)
    assert w == 1.0
    return float(px), float(py)


def test_the_example_of_the_course() -> None:
    matrix = window_to_viewport((1, 1, 4, 4), (3, 2, 6, 6))
    assert matrix[0, 0] == 1
    assert matrix[1, 1] == 4 / 3
    points = [(1, 1), (1, 2), (2, 2), (3, 4)]
    expected = [(3, 2), (3, 10 / 3), (4, 10 / 3), (5, 6)]
    for point, place in zip(points, expected, strict=True):
        assert mapped(matrix, *point) == pytest.approx(place, abs=1e-12)


def test_a_window_on_its_own_viewport_is_the_identity() -> None:
    for keep_aspect in (False, True):
        matrix = window_to_viewport((-0.5, -0.5, 39.5, 27.5), (-0.5, -0.5, 39.5, 27.5), keep_aspect)
        assert np.array_equal(matrix, np.eye(3))


@given(window=rectangles, viewport=rectangles)
def test_corners_go_to_corners(window: Rectangle, viewport: Rectangle) -> None:
    matrix = window_to_viewport(window, viewport)
    scale = max(matrix[0, 0], matrix[1, 1], 1.0)
    close = 1e-9 * scale * 1e6
    assert math.isfinite(close)
    for corner in ((0, 1), (2, 1), (2, 3), (0, 3)):
        x, y = mapped(matrix, window[corner[0]], window[corner[1]])
        assert abs(x - viewport[corner[0]]) <= close
        assert abs(y - viewport[corner[1]]) <= close


@given(window=rectangles, viewport=rectangles)
def test_keeping_the_aspect_scales_alike_fits_and_centres(window: Rectangle, viewport: Rectangle) -> None:
    matrix = window_to_viewport(window, viewport, keep_aspect=True)
    assert matrix[0, 0] == matrix[1, 1] > 0
    low, high = mapped(matrix, *window[:2]), mapped(matrix, *window[2:])
    close = 1e-9 * max(matrix[0, 0], 1.0) * 1e6
    for axis in (0, 1):
        below = low[axis] - viewport[axis]
        above = viewport[axis + 2] - high[axis]
        assert below >= -close
        assert above >= -close
        assert abs(below - above) <= 2 * close


@pytest.mark.parametrize(
    "bad", [(0, 0, 0, 1), (0, 0, 1, 0), (1, 0, 0, 1), (0, 0, math.nan, 1), (0, 0, math.inf, 1)]
)
def test_a_rectangle_without_area_is_refused_by_name(bad: Rectangle) -> None:
    with pytest.raises(ValueError, match="window"):
        window_to_viewport(bad, (0, 0, 1, 1))
    with pytest.raises(ValueError, match="viewport"):
        window_to_viewport((0, 0, 1, 1), bad)


def corners(rectangle: Rectangle) -> np.ndarray:
    xmin, ymin, xmax, ymax = rectangle
    return np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)], float)


def test_fit_and_fill_as_the_course_has_them() -> None:
    window, viewport = (0, 0, 4, 3), (0, 0, 100, 100)
    fit, fill = (window_to_viewport(window, viewport, mode) for mode in ("fit", "fill"))
    assert fit.tolist() == [[25, 0, 0], [0, 25, 12.5], [0, 0, 1]]
    np.testing.assert_allclose(fill, [[33.3333, 0, -16.6667], [0, 33.3333, 0], [0, 0, 1]], atol=5e-5)
    assert np.array_equal(window_to_viewport(window, viewport, True), fit)
    assert np.array_equal(
        window_to_viewport(window, viewport, "stretch"), window_to_viewport(window, viewport)
    )


@pytest.mark.parametrize("mode", ["fit", "fill"])
@given(window=rectangles, viewport=rectangles)
def test_neither_fit_nor_fill_distorts_and_the_middle_stays_in_the_middle(
    mode: Mode, window: Rectangle, viewport: Rectangle
) -> None:
    matrix = window_to_viewport(window, viewport, mode)
    assert matrix[0, 0] == matrix[1, 1] > 0
    assert matrix[0, 1] == matrix[1, 0] == 0
    close = 1e-9 * max(matrix[0, 0], 1.0) * 1e6
    image = transform_points(matrix, corners(window))
    np.testing.assert_allclose(image.mean(axis=0), corners(viewport).mean(axis=0), atol=close)
    low, high = image[0], image[2]
    beyond = np.concatenate([np.subtract(viewport[:2], low), np.subtract(high, viewport[2:])])
    if mode == "fit":
        assert (beyond <= close).all()
    else:
        assert (beyond >= -close).all()
    # One pair of sides agrees, so that it is the largest that fits or the smallest that fills
    assert np.abs(beyond[[0, 2]]).max() <= close or np.abs(beyond[[1, 3]]).max() <= close


@pytest.mark.parametrize("mode", ["stretch", "fit", "fill"])
@given(window=rectangles, viewport=rectangles)
def test_the_three_factors_are_the_matrix(mode: Mode, window: Rectangle, viewport: Rectangle) -> None:
    moved_to, scaled, moved_on = (
        window_to_origin(window),
        window_scaling(window, viewport, mode),
        origin_to_viewport(window, viewport, mode),
    )
    assert np.array_equal(moved_on @ scaled @ moved_to, window_to_viewport(window, viewport, mode))
    assert mapped(moved_to, *window[:2]) == (0, 0)
    assert scaled.tolist() == np.diag([*scale_factors(window, viewport, mode), 1]).tolist()
    assert np.array_equal(moved_on[:2, :2], np.eye(2))
    if mode == "stretch":
        assert mapped(moved_on, 0, 0) == viewport[:2]


@given(window=rectangles, viewport=rectangles)
def test_normalised_coordinates_lie_between(window: Rectangle, viewport: Rectangle) -> None:
    normalised = window_to_normalised(window)
    close = 1e-9 * max(1.0, normalised[0, 0], normalised[1, 1]) * 1e3
    np.testing.assert_allclose(
        transform_points(normalised, corners(window)), corners((0, 0, 1, 1)), atol=close, rtol=0
    )
    to_viewport = normalised_to_viewport(viewport)
    np.testing.assert_allclose(
        transform_points(to_viewport, corners((0, 0, 1, 1))), corners(viewport), rtol=1e-12, atol=1e-9
    )
    direct = window_to_viewport(window, viewport)
    np.testing.assert_allclose((to_viewport @ normalised)[:2, :2], direct[:2, :2], rtol=1e-12)
    sizes = np.abs(to_viewport) @ np.abs(normalised)
    assert (np.abs(to_viewport @ normalised - direct) <= 1e-12 * (sizes + np.abs(direct)) + 1e-300).all()
