"""The window-to-viewport matrix: the course's example, and what must hold for any two rectangles."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.viewing import window_to_viewport

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
